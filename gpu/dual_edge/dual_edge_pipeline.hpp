// Runs the clipping kernels for one set of balls, alpha after alpha, and leaves the simplices in
// pinned host memory. The engine face, fallbacks and device probing are gpu_engine.cu's business.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "core/complex/alpha_complex.hpp"
#include "core/complex/simplex_hash.hpp"
#include "core/run/cancel_token.hpp"
#include "gpu/memory/device_complex.hpp"

namespace alphascope::gpu {

// What 32-bit numbers of the kernels reach: up to eight cells of the grid for each ball and some
// more; of one run, simplices of each dimension, three words for each triangle.
inline constexpr std::size_t kMaxBalls = (std::size_t{1} << 28) - 128;
inline constexpr std::size_t kMaxSimplices = std::size_t{1} << 30;
inline bool are_countable(std::span<const std::size_t> counts) {
  return std::all_of(counts.begin(), counts.end(),
                     [](std::size_t count) { return count <= kMaxSimplices; });
}

// Lexicographic order; values and classes are empty for tetrahedra only.
template <int N>
struct HostSimplices {
  std::span<std::array<BallIndex, N>> simplices;
  std::span<float> values;
  std::span<SimplexClass> classes;
};

struct PipelineResult {
  std::shared_ptr<void> memory;  // of the simplices, which are there as long as this is
  HostSimplices<1> vertices;
  HostSimplices<2> edges;
  HostSimplices<3> triangles;
  HostSimplices<4> tetrahedra;
  HashSums hash;
  std::uint32_t exact_balls = 0;  // balls that went through kernel III
  int attempts = 1;               // until there was room for all that was found
  bool fits = true;               // false: this request is beyond the kernels' limits
};

class DualEdgePipeline {
 public:
  // Copies the balls to pinned memory. `chunks`: in how many every run goes through the balls, at
  // most kMaxChunks; 0: as is quickest. Throws std::bad_alloc, DeviceError.
  explicit DualEdgePipeline(const BallSet& balls, int chunks = 0);
  ~DualEdgePipeline();

  // Stages are timed with CUDA events when `times` is given (a few microseconds each).
  // Throws Cancelled, std::bad_alloc, DeviceError.
  PipelineResult run(const LatticeAlpha& alpha_on_lattice, bool tetrahedra_only,
                     const CancelToken& cancel, StageTimes* times);

  // The result of the last run, which was of the whole complex, as it still lies on the device:
  // until the next run or until the pipeline goes. Nothing when there is none.
  std::optional<DeviceComplex> on_device() const;

  // Gives back the pinned memory that is kept for later results, until the next run. Waits for the
  // device.
  void rest();

  struct State;  // for the pipeline's own sources

 private:
  std::unique_ptr<State> state_;
};

}  // namespace alphascope::gpu
