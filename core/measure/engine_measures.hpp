// SPDX-License-Identifier: GPL-3.0-or-later
// Areas and volumes, measured where the engine has the complex: on its device or on the CPU.
#pragma once

#include <optional>
#include <string>

#include "core/measure/union_measures.hpp"

namespace alphascope {

class Engine;
class WorkThreads;

// Measures with the device that made them, and how.
struct MeasuredUnion {
  UnionMeasures measures;
  std::string device;  // "NVIDIA H200", "CPU, 2 threads"
  std::string route;   // on a device: "the complex was still on the device"; else empty
  std::string note;    // why the engine's device did not measure; a sentence, or empty
  double milliseconds = 0;
};

// Measures on the CPU, in the caller's task arena. Throws as measure_union() does.
MeasuredUnion measure_on_calling_threads(const BallSet& balls, const AlphaComplex& complex,
                                         const RunContext& context,
                                         UnionDerivatives* derivatives = nullptr);

// Measures on these threads of the CPU. Throws as measure_union() does.
MeasuredUnion measure_on_cpu(const BallSet& balls, const AlphaComplex& complex,
                             WorkThreads& threads, const RunContext& context,
                             UnionDerivatives* derivatives = nullptr);

// Measures on the engine's device. If the device fails or has too little memory, measures on the
// CPU and sets the reason. Returns nothing if the engine has no device. Throws as Engine::measure()
// does.
std::optional<MeasuredUnion> measure_on_device(Engine& engine, const BallSet& balls,
                                               const AlphaComplex& complex, WorkThreads& threads,
                                               const RunContext& context);

}  // namespace alphascope
