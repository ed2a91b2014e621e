// Choosing and making an engine by name.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "core/engine/engine.hpp"
#include "core/engine/engine_choice.hpp"
#include "core/tuples/tuple_options.hpp"

namespace alphascope {

// The chosen engine cannot work here; what() says why and what to choose instead.
struct EngineUnavailable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct MadeEngine {
  std::unique_ptr<Engine> engine;
  std::string note;  // why `automatic` did not take the GPU; empty when it did or was not asked
};

struct EngineSettings {
  int threads = 0;                           // 0: as many as the machine has
  TupleOptions tuples;                       // of the tuple engines only
  std::shared_ptr<WorkThreads> shared = {};  // as EngineOptions::shared
};

using EngineFactory = std::function<MadeEngine(
    EngineChoice choice, std::shared_ptr<const BallSet> balls, const EngineSettings& settings)>;

// The factory of the program. Throws EngineUnavailable (only for gpu and tuples_gpu).
MadeEngine make_engine(EngineChoice choice, std::shared_ptr<const BallSet> balls,
                       const EngineSettings& settings);

// Memory of results that no engine will use any more, after the last of them is gone: is there any?
// Quick, from any thread.
bool is_engine_memory_unused();
// Frees it. Takes time: not for the main thread.
void free_unused_engine_memory();

}  // namespace alphascope
