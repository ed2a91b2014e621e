// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the clipping kernels for one set of balls and any alphas. Results arrive in pinned host
// memory. gpu_engine.cu has the engine, fallbacks and the test of the device.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "core/complex/alpha_complex.hpp"
#include "core/complex/simplex_hash.hpp"
#include "core/geometry/lattice.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/run/cancel_token.hpp"
#include "gpu/memory/device_complex.hpp"

namespace alphascope::gpu {

// Limits set by the kernels' 32-bit numbers. kMaxBalls: a grid has up to eight cells for each ball,
// and some more. kMaxSimplices, for each dimension in a run: a triangle takes three words.
inline constexpr std::size_t kMaxBalls = (std::size_t{1} << 28) - 128;
inline constexpr std::size_t kMaxSimplices = std::size_t{1} << 30;
inline bool are_countable(std::span<const std::size_t> counts) {
  return std::all_of(counts.begin(), counts.end(),
                     [](std::size_t count) { return count <= kMaxSimplices; });
}

// In lexicographic order; values and classes are empty for tetrahedra only.
template <int N>
struct HostSimplices {
  std::span<std::array<BallIndex, N>> simplices;
  std::span<float> values;
  std::span<SimplexClass> classes;
};

struct PipelineResult {
  std::shared_ptr<void> memory;  // owner of the memory of all simplices
  HostSimplices<1> vertices;
  HostSimplices<2> edges;
  HostSimplices<3> triangles;
  HostSimplices<4> tetrahedra;
  HashSums hash;
  std::uint32_t exact_balls = 0;  // number of balls that went through kernel III
  int attempts = 1;               // number of runs until there was room for all simplices
  bool fits = true;               // false: the request is beyond the kernels' limits
};

// Balls in device memory. One that another with the same centre hides has radius -1.
struct DeviceBalls {
  const void* balls = nullptr;  // int4 each: x, y, z and radius, lattice units
  std::size_t count = 0;
  LatticePoint low, high;  // corners of the box around all centres
  std::int32_t max_radius = 1;
  Lattice lattice;
};

class DualEdgePipeline {
 public:
  // Without balls. load() must come before run().
  DualEdgePipeline();
  // Copies the balls to pinned memory. `chunks`: number of chunks of every run, at most kMaxChunks;
  // 0: the fastest. Throws std::bad_alloc and DeviceError.
  explicit DualEdgePipeline(const BallSet& balls, int chunks = 0);
  ~DualEdgePipeline();

  // Takes other balls, which stay where they are until the next load(). Memory is kept, and the
  // room that earlier runs needed is the first guess. Throws std::bad_alloc and DeviceError.
  void load(const DeviceBalls& balls);
  // The same for balls on the host, as the constructor.
  void load(const BallSet& balls);

  // Limits the number of runs until there is room for all simplices. A request that needs more does
  // not fit.
  static constexpr int kMostAttempts = 12;
  void set_most_attempts(int attempts);

  // Computes a result. Stages are timed with CUDA events if `times` is given (a few microseconds
  // each). Throws Cancelled, std::bad_alloc and DeviceError.
  PipelineResult run(const LatticeAlpha& alpha_on_lattice, bool tetrahedra_only,
                     const CancelToken& cancel, StageTimes* times);

  // The result of the last run on the device, if it was of the whole complex. Valid until the next
  // run or the end of the pipeline. Empty: there is none.
  std::optional<DeviceComplex> on_device() const;

  // The tetrahedra of the last run on the device; none if it did not fit. Valid until the next run
  // or the end of the pipeline.
  DeviceSimplices tetrahedra_on_device() const;

  // Frees the pinned memory that is kept for later results; the next run reserves it again. Waits
  // for the device.
  void release_memory();

  struct State;  // for the pipeline's own sources

 private:
  std::unique_ptr<State> state_;
};

}  // namespace alphascope::gpu
