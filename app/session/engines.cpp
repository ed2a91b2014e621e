// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the engines that this build has.
#include "app/session/engines.hpp"

#include <chrono>
#include <stdexcept>
#include <utility>

#include "app/session/gpu_engines.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/internal_error.hpp"
#include "core/triangulation/triangulation_maker.hpp"
#include "core/tuples/tuple_engine.hpp"

namespace alphascope {
namespace {

EngineOptions engine_options(const EngineSettings& settings) {
  EngineOptions options;
  options.threads = settings.threads;
  options.shared = settings.shared;
  return options;
}

MadeEngine make_on_gpu(const std::shared_ptr<const BallSet>& balls, const EngineOptions& options) {
  MadeEngine made;
  std::string why_not;
  made.engine = GpuEngines::of_program().make_engine(balls, options, why_not);
  if (!made.engine) {
    throw EngineUnavailable("The GPU engine cannot be used. " + why_not +
                            " Choose the engine \"cpu\" or \"auto\" instead.");
  }
  return made;
}

MadeEngine make_automatic(const std::shared_ptr<const BallSet>& balls,
                          const EngineOptions& options) {
  MadeEngine made;
  made.engine = GpuEngines::of_program().make_engine(balls, options, made.note);
  if (made.engine) return {std::move(made.engine), {}};
  made.engine = make_cpu_engine(balls, options);
  return made;
}

MadeEngine make_tuples_on_gpu(std::shared_ptr<const BallSet> balls, const TupleOptions& tuples) {
  MadeEngine made;
  std::string why_not;
  made.engine = GpuEngines::of_program().make_tuple_engine(std::move(balls), tuples, why_not);
  if (!made.engine) {
    throw EngineUnavailable("The tuple engine cannot be used on the GPU. " + why_not +
                            " Choose the engine \"tuples-cpu\" instead.");
  }
  return made;
}

}  // namespace

void wait_for_engine_device(const CancelToken& cancel) {
  constexpr std::chrono::milliseconds kMost{50};
  GpuEngines::of_program().triangulations()->wait_until_idle(kMost, cancel);
}

bool is_engine_memory_unused() {
  return GpuEngines::of_program().is_memory_unused();
}

void free_unused_engine_memory() {
  GpuEngines::of_program().free_unused_memory();
}

MadeEngine make_engine(EngineChoice choice, std::shared_ptr<const BallSet> balls,
                       const EngineSettings& settings) {
  const EngineOptions options = engine_options(settings);
  switch (choice) {
    case EngineChoice::automatic:
      return make_automatic(balls, options);
    case EngineChoice::gpu:
      return make_on_gpu(balls, options);
    case EngineChoice::cpu:
      return {make_cpu_engine(balls, options), {}};
    case EngineChoice::tuples_gpu:
      return make_tuples_on_gpu(balls, settings.tuples);
    case EngineChoice::tuples_cpu:
      return {make_tuple_engine(balls, options, settings.tuples), {}};
    case EngineChoice::cgal:
      return {make_cgal_engine(balls, options), {}};
  }
  throw InternalError("There is no such engine.");
}

}  // namespace alphascope
