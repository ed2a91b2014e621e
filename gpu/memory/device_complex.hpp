// An alpha complex and its balls as they lie on the device. Plain C++.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/complex/face_class.hpp"
#include "core/geometry/ball_set.hpp"

namespace alphascope::gpu {

// Device memory. Simplices of N vertices: N indices of balls each, sorted as in an AlphaComplex.
struct DeviceSimplices {
  const BallIndex* vertices = nullptr;
  const SimplexClass* classes = nullptr;  // not of tetrahedra: these are interior
  std::size_t count = 0;
};

struct DeviceComplex {
  Lattice lattice;
  LatticeAlpha alpha_on_lattice;
  // x, y, z and radius of each on the lattice; those that are in no simplex may have any radius.
  const std::int32_t* balls = nullptr;  // 16 bytes each, aligned to that
  std::size_t ball_count = 0;
  DeviceSimplices vertices, edges, triangles, tetrahedra;
};

}  // namespace alphascope::gpu
