// SPDX-License-Identifier: GPL-3.0-or-later
// A complex as a mesh for finite elements: Medit's text format, read by Gmsh, MMG, TetGen and CGAL.
#pragma once

#include "core/complex/alpha_complex.hpp"
#include "core/files/atomic_file.hpp"
#include "core/run/cancel_token.hpp"
#include "core/write/write_complex.hpp"

namespace alphascope {

// Writes the vertices of the complex (Å, all digits), its edges and triangles where they were
// computed, and its tetrahedra. Corners are counted from 1 among the written vertices. The
// reference of a vertex is the number of its ball, from 1. That of a simplex is its class in
// `complex`: 1 singular, 2 regular, 3 interior; 1 where no classes were computed. All tetrahedra
// have positive volume. Does not commit the file. Throws WriteError and Cancelled.
void write_medit(const BallSet& balls, const AlphaComplex& complex, const ComplexHeader& header,
                 AtomicFile& file, const RunContext& context);

}  // namespace alphascope
