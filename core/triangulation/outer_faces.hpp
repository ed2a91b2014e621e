// The faces of tetrahedra that no other tetrahedron has: the outside of what they fill.
#pragma once

#include <cstdint>

#include "core/complex/alpha_complex.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// Which face of which tetrahedron: 4 × its place in the list + the place in it of the vertex that
// the face lacks.
using FaceCode = std::uint32_t;
constexpr FaceCode face_code(std::size_t tetrahedron, std::size_t opposite) {
  return static_cast<FaceCode>(4 * tetrahedron + opposite);
}
constexpr std::size_t tetrahedron_of(FaceCode face) {
  return face / 4;
}

// The vertices of a face, ascending.
inline std::array<BallIndex, 3> face_vertices(const Simplices<4>& tetrahedra, FaceCode face) {
  const auto& t = tetrahedra[tetrahedron_of(face)];
  const std::size_t k = face % 4;
  return {t[k == 0 ? 1 : 0], t[k <= 1 ? 2 : 1], t[k <= 2 ? 3 : 2]};
}

// In lexicographic order of the faces' vertices; the same for any number of threads. Throws
// Cancelled, and std::length_error for more tetrahedra than can be counted.
//
// Of a whole complex its regular triangles, whose tetrahedra are looked up: nothing is sorted. So
// the classes must be those in this complex, or it says std::invalid_argument; of a part of another
// complex, take the tetrahedra alone.
ResultArray<FaceCode> outer_faces(const AlphaComplex& complex, const CancelToken& cancel = {});
// Of tetrahedra alone, whose faces are sorted.
ResultArray<FaceCode> outer_faces(const Simplices<4>& tetrahedra, const CancelToken& cancel = {});

}  // namespace alphascope
