// Areas and volumes where the engine is that made the complex: on its device, or on the CPU.
#pragma once

#include <optional>
#include <string>

#include "core/engine/engine.hpp"
#include "core/measure/union_measures.hpp"

namespace alphascope {

// With what measured and how.
struct MeasuredUnion {
  UnionMeasures measures;
  std::string device;  // "NVIDIA H200", "CPU, 2 threads"
  std::string route;   // on a device: "the complex was still on the device"; else empty
  std::string note;    // why the engine's device did not measure; a sentence, or empty
  double milliseconds = 0;
};

// On the CPU, in the caller's task arena. Throws what measure_union() does.
MeasuredUnion measure_here(const BallSet& balls, const AlphaComplex& complex,
                           const RunContext& context, UnionDerivatives* derivatives = nullptr);

// On these threads of the CPU. Throws what measure_union() does.
MeasuredUnion measure_on_cpu(const BallSet& balls, const AlphaComplex& complex,
                             WorkThreads& threads, const RunContext& context,
                             UnionDerivatives* derivatives = nullptr);

// By the engine's device; on the CPU, with a note, where that fails or has no room. Nothing when
// the engine has no device. Throws what Engine::measure() does.
std::optional<MeasuredUnion> measure_on_device(Engine& engine, const BallSet& balls,
                                               const AlphaComplex& complex, WorkThreads& threads,
                                               const RunContext& context);

}  // namespace alphascope
