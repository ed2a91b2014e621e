// SPDX-License-Identifier: GPL-3.0-or-later
// Engines made of executors, which compute on a device. Only this code decides what happens when an
// executor fails or its memory is short. First the set is cut into ever more slabs, then the CPU
// engine computes. That can still take whole triangulations from the device
// (EngineOptions::triangulations). An executor knows nothing of this. It computes its balls, or
// says that it cannot.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/engine/engine.hpp"
#include "core/engine/executor_failed.hpp"

namespace alphascope {

// Computes on a device with a memory of its own. Made for one set of balls at a time.
class Executor {
 public:
  virtual ~Executor() = default;
  // K_alpha, with its route and timings. Nothing when the request is beyond the executor's limits,
  // with any amount of memory. Throws std::bad_alloc when memory is short, and ExecutorFailed.
  // After either of them this object is not asked again. Throws Cancelled.
  virtual std::optional<AlphaComplex> compute(const AlphaRequest& request,
                                              const RunContext& context) = 0;
  // As Engine::measure(), but throws std::bad_alloc when memory is short, and stays usable then.
  // Throws ExecutorFailed.
  virtual DeviceMeasuring measure(const AlphaComplex&, UnionMeasures&, const RunContext&) {
    return {};
  }
  // As Engine::find_outer_faces(), but throws as measure() here does.
  virtual std::optional<SharedFaces> find_outer_faces(const AlphaComplex&) { return std::nullopt; }
  // As Engine::take(), but throws as compute() does.
  virtual bool take(const std::shared_ptr<const BallSet>&) { return false; }
  // As Engine::release_memory().
  virtual void release_memory() {}
};

// Makes the executor of the whole set or of a part. Throws as Executor::compute() does.
using MakeExecutor = std::function<std::unique_ptr<Executor>(std::shared_ptr<const BallSet> balls)>;

// An engine that answers every request, even where its executors cannot. It remembers how many
// slabs were needed. It tries fewer for smaller requests, and once in a while, because another
// program may have freed memory. EngineInfo::route tells how it was done: "..., in 4 slabs", "...
// (on the CPU: the GPU's memory is full)", "regular triangulation on NVIDIA H200, filtration, then
// threshold (the rest on the CPU: beyond the GPU kernels' limits)".
std::unique_ptr<Engine> make_engine_of_executors(std::shared_ptr<const BallSet> balls,
                                                 EngineOptions options, MakeExecutor make);

}  // namespace alphascope
