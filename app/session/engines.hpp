// Choosing and making an engine by name.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/complex/engine.hpp"

namespace alphascope {

// automatic: the GPU when it can be used, else the CPU.
enum class EngineChoice { automatic, cpu, cgal, gpu };

std::string_view engine_id(EngineChoice choice);  // "auto", "cpu", "cgal", "gpu"
std::optional<EngineChoice> engine_from_id(std::string_view id);

// The chosen engine cannot work here; what() says why and what to choose instead.
struct EngineUnavailable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct MadeEngine {
  std::unique_ptr<Engine> engine;
  bool uses_gpu = false;
  std::string note;  // why `automatic` did not take the GPU; empty when it did or was not asked
};

// threads = 0: as many as the machine has.
using EngineFactory = std::function<MadeEngine(
    EngineChoice choice, std::shared_ptr<const BallSet> balls, int threads)>;

// The factory of the program. Throws EngineUnavailable (never for automatic, cpu and cgal).
MadeEngine make_engine(EngineChoice choice, std::shared_ptr<const BallSet> balls, int threads);

}  // namespace alphascope
