// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels for areas and volumes: one pass over the simplices of each dimension, with the bodies of
// core/measure. The sums of balls are integers. So threads may add to them in any order, and the
// bits are the same each time.
#pragma once

#include <cuda_runtime.h>

#include <cstdint>

#include "core/geometry/lattice_point.hpp"
#include "core/measure/ball_sums.hpp"
#include "core/measure/find_in_row.hpp"
#include "core/measure/simplex_terms.hpp"
#include "gpu/memory/device_complex.hpp"

namespace alphascope::gpu {

inline constexpr int kMeasureThreads = 128;
// Number of simplices of a block, which it sorts by kind.
inline constexpr int kMeasurePart = 1024;
inline constexpr unsigned kMeasureWarps = kMeasureThreads / 32;

struct alignas(16) QuantityValues {
  PerQuantity<double> of;
};
struct alignas(16) QuantitySums {
  PerQuantity<unsigned long long> of;  // as FixedSum
};
// Edges [begin, end) of a lower ball that has any; undefined for other balls.
struct alignas(8) EdgeRow {
  std::uint32_t begin, end;
};

// Arrays with one element per ball.
struct MeasureInput {
  GrownBall* balls;
  QuantityValues* scales;
  QuantitySums* sums;
  EdgeRow* rows;
  std::uint8_t* open;  // 1: in the complex, and not interior
};

class DeviceSink {
 public:
  static constexpr bool kDerivatives = false;
  __device__ explicit DeviceSink(const MeasureInput& scene) : scene_(scene) {}

  ALPHASCOPE_INLINE const GrownBall& ball(BallIndex i) const { return scene_.balls[i]; }
  // For host and device, as the terms are, but called only on the device.
  ALPHASCOPE_INLINE void add(MeasuredQuantity q, BallIndex i, double x) {
    add(&scene_.sums[i].of[q], fixed_term(x, scene_.scales[i].of[q]));
  }

 private:
  ALPHASCOPE_INLINE static void add(unsigned long long* to, FixedSum term) {
#if defined(__CUDA_ARCH__) || !defined(__CUDACC__)
    atomicAdd(to, static_cast<unsigned long long>(term));
#endif
  }
  const MeasureInput& scene_;
};

// Sets grown balls, and clears all sums.
__global__ void prepare_balls(DeviceComplex complex, MeasureInput scene) {
  const std::size_t i = std::size_t{blockIdx.x} * blockDim.x + threadIdx.x;
  if (i >= complex.ball_count) return;
  const int4 b = reinterpret_cast<const int4*>(complex.balls)[i];
  const GrownBall ball = grown_ball(LatticePoint{b.x, b.y, b.z}, b.w, complex.alpha_on_lattice);
  scene.balls[i] = ball;
  scene.scales[i] = {quantity_scales(ball)};
  scene.sums[i] = {};
  scene.open[i] = 0;
}

__global__ void add_vertices(DeviceSimplices vertices, MeasureInput scene) {
  const std::size_t v = std::size_t{blockIdx.x} * blockDim.x + threadIdx.x;
  if (v >= vertices.count || !is_open(vertices.classes[v])) return;
  const BallIndex i = vertices.vertices[v];
  scene.open[i] = 1;
  DeviceSink sink(scene);
  vertex_terms(i, sink);
}

// Must run after the vertices. Also sets where rows of edges begin and end.
__global__ void add_edges(DeviceSimplices edges, MeasureInput scene) {
  const std::size_t e = std::size_t{blockIdx.x} * blockDim.x + threadIdx.x;
  if (e >= edges.count) return;
  const BallIndex* at = edges.vertices + 2 * e;
  const BallIndex i[2] = {at[0], at[1]};
  if (e == 0 || at[-2] != i[0]) scene.rows[i[0]].begin = static_cast<std::uint32_t>(e);
  if (e + 1 == edges.count || at[2] != i[0]) {
    scene.rows[i[0]].end = static_cast<std::uint32_t>(e + 1);
  }
  const bool ends[2] = {scene.open[i[0]] != 0, scene.open[i[1]] != 0};
  if (!ends[0] && !ends[1]) return;
  DeviceSink sink(scene);
  edge_terms(i, ends, is_open(edges.classes[e]), sink);
}

// Sorts the simplices in the block's part of a list by kind(simplex). Kind 0 is listed from the
// beginning, kind 1 from the end backwards. So the threads of a warp do the same work. Other kinds
// are left out. `found`: numbers of both kinds.
template <class Kind>
__device__ inline std::uint32_t* sort_part(std::size_t count, std::uint32_t (&found)[2],
                                           const Kind& kind) {
  __shared__ std::uint32_t list[kMeasurePart];
  __shared__ std::uint32_t number[2];
  if (threadIdx.x < 2) number[threadIdx.x] = 0;
  __syncthreads();
  const std::size_t begin = std::size_t{blockIdx.x} * kMeasurePart;
  for (std::uint32_t n = threadIdx.x; n < kMeasurePart && begin + n < count; n += blockDim.x) {
    const int of = kind(begin + n);
    if (of < 0) continue;
    const std::uint32_t place = atomicAdd(&number[of], 1u);
    list[of == 0 ? place : kMeasurePart - 1 - place] = n;
  }
  __syncthreads();
  found[0] = number[0];
  found[1] = number[1];
  return list;
}

// Adds triangles with an open side.
__global__ void __launch_bounds__(kMeasureThreads)
    add_triangles(DeviceSimplices triangles, MeasureInput scene) {
  std::uint32_t found[2];
  const std::uint32_t* list = sort_part(triangles.count, found, [&](std::size_t f) {
    return open_sides(triangles.classes[f]) > 0 ? 0 : -1;
  });
  DeviceSink sink(scene);
  for (std::uint32_t n = threadIdx.x; n < found[0]; n += blockDim.x) {
    const std::size_t f = std::size_t{blockIdx.x} * kMeasurePart + list[n];
    const BallIndex* at = triangles.vertices + 3 * f;
    const BallIndex i[3] = {at[0], at[1], at[2]};
    triangle_terms(i, open_sides(triangles.classes[f]), sink);
  }
}

// Must run after the edges. Begins with tetrahedra without an open edge, which need no angles.
__global__ void __launch_bounds__(kMeasureThreads)
    add_tetrahedra(DeviceSimplices tetrahedra, DeviceSimplices edges, MeasureInput scene) {
  const auto balls_of = [&](std::size_t t) {
    return reinterpret_cast<const uint4*>(tetrahedra.vertices)[t];
  };
  std::uint32_t found[2];
  const std::uint32_t* list = sort_part(tetrahedra.count, found, [&](std::size_t t) {
    const uint4 b = balls_of(t);
    const int open = scene.open[b.x] + scene.open[b.y] + scene.open[b.z] + scene.open[b.w];
    return open > 1 ? 1 : 0;
  });
  const auto is_edge_open = [&](BallIndex a, BallIndex b) {
    const EdgeRow row = scene.rows[a];
    const std::size_t e = find_in_row(row.begin, row.end, b,
                                      [&](std::size_t at) { return edges.vertices[2 * at + 1]; });
    return is_open(edges.classes[e]);
  };
  DeviceSink sink(scene);
  for (std::uint32_t n = threadIdx.x; n < found[0] + found[1]; n += blockDim.x) {
    const std::uint32_t at = n < found[0] ? n : kMeasurePart - found[1] + (n - found[0]);
    const uint4 b = balls_of(std::size_t{blockIdx.x} * kMeasurePart + list[at]);
    const BallIndex i[4] = {b.x, b.y, b.z, b.w};
    const OpenFaces open = open_balls_and_edges(
        i, [&](BallIndex ball) { return scene.open[ball] != 0; }, is_edge_open);
    tetrahedron_terms(i, open, sink);
  }
}

__device__ inline double warp_sum(double value) {
  for (int by = 16; by > 0; by /= 2) value += __shfl_xor_sync(~0u, value, by);
  return value;
}

// Quantities in Å, Å² or Å³, and their sums over each block. The order of summation is always the
// same.
struct MeasureOutput {
  PerQuantity<double*> of_ball;
  double* of_block;  // all sums of the first block, then those of the next
  double unit;       // Å
};
__global__ void write_measures(std::size_t balls, MeasureInput scene, MeasureOutput out) {
  const std::size_t i = std::size_t{blockIdx.x} * blockDim.x + threadIdx.x;
  PerQuantity<double> value = {};
  if (i < balls) {
    const QuantityValues scales = scene.scales[i];
    const QuantitySums found = scene.sums[i];
    PerQuantity<double> sums;
    each_quantity([&](MeasuredQuantity q) { sums[q] = sum_value(found.of[q], scales.of[q]); });
    value = ball_measures(scene.balls[i].grown_radius, scene.open[i] != 0, sums);
    each_quantity([&](MeasuredQuantity q) {
      out.of_ball[q][i] = value[q] = in_angstrom(q, value[q], out.unit);
    });
  }
  __shared__ PerQuantity<double> of_warp[kMeasureWarps];
  each_quantity([&](MeasuredQuantity q) {
    value[q] = warp_sum(value[q]);
    if ((threadIdx.x & 31) == 0) of_warp[threadIdx.x / 32][q] = value[q];
  });
  __syncthreads();
  if (threadIdx.x != 0) return;
  each_quantity([&](MeasuredQuantity q) {
    double sum = of_warp[0][q];
    for (unsigned w = 1; w < kMeasureWarps; ++w) sum += of_warp[w][q];
    out.of_block[std::size_t{blockIdx.x} * kMeasuredQuantities + static_cast<int>(q)] = sum;
  });
}

}  // namespace alphascope::gpu
