// SPDX-License-Identifier: GPL-3.0-or-later
// Codes that name a face of a tetrahedron by one 32-bit number.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/complex/simplices.hpp"
#include "core/geometry/host_device.hpp"

namespace alphascope {

// The code of a face: 4 × the index of its tetrahedron + the index in it of the vertex opposite to
// the face.
using FaceCode = std::uint32_t;
constexpr FaceCode face_code(std::size_t tetrahedron, std::size_t opposite) {
  return static_cast<FaceCode>(4 * tetrahedron + opposite);
}
constexpr std::size_t tetrahedron_of(FaceCode face) {
  return face / 4;
}

// The index in its tetrahedron of vertex `k` of a face, k < 3, in ascending order.
ALPHASCOPE_HOST_DEVICE constexpr std::size_t face_corner(FaceCode face, std::size_t k) {
  return k < face % 4 ? k : k + 1;
}

// The vertices of a face, ascending.
inline std::array<BallIndex, 3> face_vertices(const Simplices<4>& tetrahedra, FaceCode face) {
  const auto& t = tetrahedra[tetrahedron_of(face)];
  return {t[face_corner(face, 0)], t[face_corner(face, 1)], t[face_corner(face, 2)]};
}

}  // namespace alphascope
