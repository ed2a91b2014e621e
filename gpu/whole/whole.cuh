// SPDX-License-Identifier: GPL-3.0-or-later
// A triangulation in device memory, with what kernels read and write of its faces. Arrays are as in
// Triangulation, Incidence, Flow and FiltrationParts.
#pragma once

#include <cuda_runtime.h>

#include <cmath>
#include <cstdint>

#include "core/complex/face_class.hpp"
#include "core/complex/face_code.hpp"
#include "core/geometry/ball_index.hpp"
#include "core/geometry/ordered_bits.hpp"
#include "core/predicates/lifted.hpp"
#include "gpu/wrapping/ball_tree.cuh"

namespace alphascope::gpu {

inline constexpr std::uint32_t kHullBit = 1u << 31;   // of Neighbour
inline constexpr std::uint32_t kNoTetrahedron = ~0u;  // Incidence::kOutside

__device__ inline std::uint32_t part(const uint4& of, unsigned k) {
  return k == 0 ? of.x : k == 1 ? of.y : k == 2 ? of.z : of.w;
}

struct WholeTriangulation {
  const int4* balls;  // centre and radius, lattice units
  const uint4* tetrahedra;
  const uint4* neighbours;
  std::uint32_t ball_count, tetrahedron_count, triangle_count, edge_count, vertex_count;

  // Does this tetrahedron stand for its face? The lower one of a pair does.
  __device__ bool owns(std::uint32_t t, unsigned face) const {
    const std::uint32_t across = part(neighbours[t], face);
    return (across & kHullBit) != 0 || across > t;
  }
};

// The balls of a simplex, as core/predicates/simplex_corners.hpp has them on the host.
struct DeviceCorners {
  const int4* balls;
  uint4 simplex;

  __device__ LiftedInt lifted(unsigned from, unsigned to) const {
    const int4 i = balls[part(simplex, from)], k = balls[part(simplex, to)];
    return lifted_vector(i, i.w, k, k.w);
  }
  __device__ std::int64_t weight(unsigned of) const {
    const std::int64_t radius = balls[part(simplex, of)].w;
    return radius * radius;
  }
};

// Alpha values, classes and levels of the faces of one dimension.
struct FaceValues {
  float *value, *regular_from, *interior_from;
  SimplexClass* classes;

  __device__ void set(std::uint32_t n, float own, const FaceLevels& levels) const {
    value[n] = own;
    regular_from[n] = levels.regular_from;
    interior_from[n] = levels.interior_from;
    classes[n] = class_at(levels, HUGE_VALF);
  }
};

// What cofaces have told about a face so far, as ordered bits: the least of their values, and the
// largest level from which one is interior. kNoValue there: never.
struct Told {
  std::uint32_t least, interior_from;

  __device__ FaceLevels levels() const {
    return {from_ordered_bits(least),
            interior_from == kNoValue ? kNever : from_ordered_bits(interior_from)};
  }
};

__global__ void forget_told(Told* told, std::uint32_t count) {
  const std::uint32_t n = grid_thread();
  if (n < count) told[n] = {kNoValue, 0};
}

// A load first saves most atomic operations.
__device__ inline void tell(Told* told, float coface_value, float coface_interior_from) {
  const std::uint32_t value = ordered_bits(coface_value),
                      interior = std::isnan(coface_interior_from)
                                     ? kNoValue
                                     : ordered_bits(coface_interior_from);
  const Told now = *told;
  if (value < now.least) atomicMin(&told->least, value);
  if (interior > now.interior_from) atomicMax(&told->interior_from, interior);
}

}  // namespace alphascope::gpu
