// SPDX-License-Identifier: GPL-3.0-or-later
// Makes an engine by its name.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "core/engine/engine.hpp"
#include "core/engine/engine_choice.hpp"
#include "core/run/cancel_token.hpp"
#include "core/tuples/tuple_options.hpp"

namespace alphascope {

// The chosen engine cannot run here. what() gives the reason and an alternative.
struct EngineUnavailable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct MadeEngine {
  std::unique_ptr<Engine> engine;
  std::string note;  // why `automatic` did not choose the GPU; otherwise empty
};

struct EngineSettings {
  int threads = 0;                           // 0: all threads of the machine
  TupleOptions tuples;                       // for the tuple engines only
  std::shared_ptr<WorkThreads> shared = {};  // as EngineOptions::shared
};

using EngineFactory = std::function<MadeEngine(
    EngineChoice choice, std::shared_ptr<const BallSet> balls, const EngineSettings& settings)>;

// The program's own factory. Throws EngineUnavailable, for gpu and tuples_gpu only.
MadeEngine make_engine(EngineChoice choice, std::shared_ptr<const BallSet> balls,
                       const EngineSettings& settings);

// Waits while the engines' device makes a triangulation, or what follows from one, but not for
// long. Throws Cancelled.
void wait_for_engine_device(const CancelToken& cancel);

// Whether freed results have left memory that no engine will use again. Quick; any thread may call
// it.
bool is_engine_memory_unused();
// Frees this memory. Takes time, so not for the main thread.
void free_unused_engine_memory();

}  // namespace alphascope
