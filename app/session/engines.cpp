#include "app/session/engines.hpp"

#include <stdexcept>
#include <utility>

#include "core/tuples/tuple_engine.hpp"
#ifdef ALPHASCOPE_HAS_GPU
#include "gpu/gpu_engine.hpp"
#include "gpu/tuples/tuple_engine.hpp"
#endif

namespace alphascope {
namespace {

EngineOptions engine_options(const EngineSettings& settings) {
  EngineOptions options;
  options.threads = settings.threads;
  options.shared = settings.shared;
  return options;
}

std::unique_ptr<Engine> try_gpu(const std::shared_ptr<const BallSet>& balls,
                                const EngineOptions& options, std::string& why_not) {
#ifdef ALPHASCOPE_HAS_GPU
  return make_gpu_engine(balls, options, &why_not);
#else
  static_cast<void>(balls);
  static_cast<void>(options);
  why_not = "This build has no GPU engine. The CPU engine gives the same results.";
  return nullptr;
#endif
}

MadeEngine make_tuples_on_gpu(std::shared_ptr<const BallSet> balls, const TupleOptions& tuples) {
  MadeEngine made;
  std::string why_not;
#ifdef ALPHASCOPE_HAS_GPU
  made.engine = make_gpu_tuple_engine(std::move(balls), tuples, &why_not);
#else
  static_cast<void>(balls);
  static_cast<void>(tuples);
  why_not = "This build has no GPU engine.";
#endif
  if (!made.engine) {
    throw EngineUnavailable("The tuple engine cannot be used on the GPU. " + why_not +
                            " Choose the engine \"tuples-cpu\" instead.");
  }
  return made;
}

}  // namespace

bool is_engine_memory_unused() {
#ifdef ALPHASCOPE_HAS_GPU
  return is_gpu_memory_unused();
#else
  return false;
#endif
}

void free_unused_engine_memory() {
#ifdef ALPHASCOPE_HAS_GPU
  free_unused_gpu_memory();
#endif
}

MadeEngine make_engine(EngineChoice choice, std::shared_ptr<const BallSet> balls,
                       const EngineSettings& settings) {
  const EngineOptions options = engine_options(settings);
  MadeEngine made;
  if (choice == EngineChoice::tuples_cpu) {
    made.engine = make_tuple_engine(std::move(balls), options, settings.tuples);
    return made;
  }
  if (choice == EngineChoice::tuples_gpu) {
    return make_tuples_on_gpu(std::move(balls), settings.tuples);
  }
  if (choice == EngineChoice::cgal) {
    made.engine = make_cgal_engine(std::move(balls), options);
    return made;
  }
  if (choice != EngineChoice::cpu) {
    std::string why_not;
    made.engine = try_gpu(balls, options, why_not);
    if (made.engine) return made;
    if (choice == EngineChoice::gpu) {
      throw EngineUnavailable("The GPU engine cannot be used. " + why_not +
                              " Choose the engine \"cpu\" or \"auto\" instead.");
    }
    made.note = why_not;
  }
  made.engine = make_cpu_engine(std::move(balls), options);
  return made;
}

}  // namespace alphascope
