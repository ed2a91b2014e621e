// SPDX-License-Identifier: GPL-3.0-or-later
// An alpha complex and its balls in device memory. Plain C++.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/complex/face_class.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"

namespace alphascope::gpu {

// A list of simplices in device memory, sorted as in an AlphaComplex. It has N ball indices for
// each simplex of N vertices.
struct DeviceSimplices {
  const BallIndex* vertices = nullptr;
  const SimplexClass* classes = nullptr;  // unset for tetrahedra, which are interior
  std::size_t count = 0;
};

struct DeviceComplex {
  Lattice lattice;
  LatticeAlpha alpha_on_lattice;
  // x, y, z and radius of each ball on the lattice. Balls in no simplex may have any radius.
  const std::int32_t* balls = nullptr;  // 16 bytes each, aligned to 16
  std::size_t ball_count = 0;
  DeviceSimplices vertices, edges, triangles, tetrahedra;
};

}  // namespace alphascope::gpu
