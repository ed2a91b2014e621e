// The faces of tetrahedra that no other tetrahedron has: the outside of what they fill.
#pragma once

#include "core/complex/alpha_complex.hpp"
#include "core/complex/face_code.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// In lexicographic order of the faces' vertices; the same for any number of threads. Throws
// Cancelled, and std::length_error for more tetrahedra than can be counted.
//
// Of a whole complex its regular triangles, whose tetrahedra are looked up: nothing is sorted. So
// the classes must be those in this complex, or it says std::invalid_argument; of a part of another
// complex, take the tetrahedra alone. Where a device has looked them up (AlphaComplex::outside),
// these are they.
ResultArray<FaceCode> outer_faces(const AlphaComplex& complex, const CancelToken& cancel = {});
// Of tetrahedra alone, whose faces are sorted.
ResultArray<FaceCode> outer_faces(const Simplices<4>& tetrahedra, const CancelToken& cancel = {});

}  // namespace alphascope
