// SPDX-License-Identifier: GPL-3.0-or-later
// The faces that belong to one tetrahedron only: the outer boundary of a set of tetrahedra.
#pragma once

#include "core/complex/alpha_complex.hpp"
#include "core/complex/face_code.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// Outer faces in lexicographic order of their vertices. The result does not depend on the number of
// threads. Throws Cancelled, and std::length_error for more tetrahedra than can be counted.
//
// In a whole complex the outer faces are its regular triangles. Their tetrahedra are looked up, and
// nothing is sorted. So the classes must be those in this complex, else std::invalid_argument. For
// a part of another complex, pass the tetrahedra alone. If a device has found the faces already
// (AlphaComplex::outside), those are returned.
ResultArray<FaceCode> outer_faces(const AlphaComplex& complex, const CancelToken& cancel = {});
// Outer faces of tetrahedra alone, by sorting their faces.
ResultArray<FaceCode> outer_faces(const Simplices<4>& tetrahedra, const CancelToken& cancel = {});

}  // namespace alphascope
