// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the measures on CPU or device, times them, and falls back to the CPU.
#include "core/measure/engine_measures.hpp"

#include <chrono>

#include "core/complex/alpha_complex.hpp"
#include "core/engine/engine.hpp"
#include "core/geometry/alpha.hpp"
#include "core/run/work_threads.hpp"

namespace alphascope {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace

MeasuredUnion measure_on_calling_threads(const BallSet& balls, const AlphaComplex& complex,
                                         const RunContext& context, UnionDerivatives* derivatives) {
  MeasuredUnion measured;
  const auto start = Clock::now();
  measured.measures = measure_union(balls, complex, {0, derivatives}, context);
  measured.milliseconds = milliseconds_since(start);
  measured.device = "CPU";
  return measured;
}

MeasuredUnion measure_on_cpu(const BallSet& balls, const AlphaComplex& complex,
                             WorkThreads& threads, const RunContext& context,
                             UnionDerivatives* derivatives) {
  MeasuredUnion measured;
  threads.run([&] { measured = measure_on_calling_threads(balls, complex, context, derivatives); });
  measured.device = threads.text();
  return measured;
}

std::optional<MeasuredUnion> measure_on_device(Engine& engine, const BallSet& balls,
                                               const AlphaComplex& complex, WorkThreads& threads,
                                               const RunContext& context) {
  MeasuredUnion measured;
  const auto start = Clock::now();
  const DeviceMeasuring by = engine.measure(complex, measured.measures, context);
  if (by.device.empty() && by.why_not.empty()) return std::nullopt;
  if (by.device.empty()) {
    measured = measure_on_cpu(balls, complex, threads, context);
    measured.note = "Areas and volumes were computed on the CPU: " + by.why_not + ".";
    return measured;
  }
  measured.milliseconds = milliseconds_since(start);
  measured.device = by.device;
  measured.route = by.route;
  return measured;
}

}  // namespace alphascope
