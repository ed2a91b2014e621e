// SPDX-License-Identifier: GPL-3.0-or-later
// The interface that every engine implements. An engine is made once per set of balls (setup) and
// then asked for one alpha after another.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/complex/alpha_complex.hpp"
#include "core/engine/known_results.hpp"
#include "core/geometry/alpha.hpp"
#include "core/run/cancel_token.hpp"
#include "core/run/work_threads.hpp"

namespace alphascope {

struct RunContext;
struct UnionMeasures;
class TriangulationMaker;

struct AlphaRequest {
  Alpha alpha_angstrom2;         // Å²; any but NaN
  bool tetrahedra_only = false;  // only tetrahedra, as in the thesis
};

// EngineInfo::route of an answer for which dual edges were clipped, without any earlier result.
// Answers for smaller alphas may then be thresholds of this one: its simplices with alpha values up
// to the smaller alpha.
inline constexpr const char* kClippingRoute = "dual edge clipping";
// EngineInfo::route of an answer that is a threshold of the filtration of all balls.
inline constexpr const char* kThresholdRoute = "threshold of the whole filtration";

// The device that measured a complex, and how.
struct DeviceMeasuring {
  std::string device;  // "NVIDIA H200"; empty: no device measured
  std::string route;   // "the complex was still on the device"
  // Set where an engine's device could not measure: a sentence without its full stop.
  std::string why_not;
};

class Engine {
 public:
  virtual ~Engine() = default;

  // The exact alpha complex, the same from every engine. An engine may answer from `known`, and
  // adds to it the results that it makes, also when it throws. Engines on the GPU and tuple engines
  // ignore `known`. The timings mark set-up work. The first call does some, and so does a later
  // call that gets fewer known results. Throws Cancelled. Throws std::bad_alloc when memory is
  // short; the engine stays usable. Throws std::invalid_argument for a NaN alpha, and where `known`
  // belongs to other balls. Two threads must not call it at once.
  virtual AlphaComplex compute(const AlphaRequest& request, KnownResults& known,
                               const RunContext& context) = 0;
  // The same with nothing known, for callers that need one alpha only.
  AlphaComplex compute(const AlphaRequest& request, const RunContext& context) {
    KnownResults nothing;
    return compute(request, nothing, context);
  }

  // Areas and volumes of a complex of these balls (core/measure/union_measures.hpp), measured by
  // the engine's device. The device may still hold the complex. `to` is unchanged where no device
  // measures. Throws as measure_union() does. A failed device or too little memory is reported in
  // `why_not`.
  virtual DeviceMeasuring measure(const AlphaComplex&, UnionMeasures&, const RunContext&) {
    return {};
  }

  // The outer faces of this engine's last result, found by its device, for AlphaComplex::outside.
  // The CPU then need not find them. Nothing where no device holds the complex, or where it fails.
  // Two threads must not call it at once, nor together with compute().
  virtual std::optional<SharedFaces> find_outer_faces(const AlphaComplex&) { return std::nullopt; }

  // Takes other balls in place of its own, and keeps memory that a new engine would have to
  // reserve. Returns false if this engine cannot; it still has its own balls then. Two threads must
  // not call it at once, nor together with compute().
  virtual bool take(const std::shared_ptr<const BallSet>&) { return false; }

  // Called when another engine will be asked from now on. Frees memory that only serves this
  // engine's next results. May wait for a device. compute() may be called again at any time. Two
  // threads must not call it at once, nor together with compute().
  virtual void release_memory() {}
};

// threads = 0: as many as the machine has.
struct EngineOptions {
  int threads = 0;
  // Threads shared with others. Null: the engine makes `threads` threads of its own.
  std::shared_ptr<WorkThreads> shared = {};
  // Makes whole triangulations, for engines other than CGAL's. Null: the CPU makes them.
  std::shared_ptr<TriangulationMaker> triangulations = {};

  std::shared_ptr<WorkThreads> work_threads() const {
    return shared ? shared : std::make_shared<WorkThreads>(threads);
  }
};

// Both functions throw std::length_error for more balls than can be handled (count_limits.hpp).

// Clips dual edges for small alpha, and uses the whole triangulation where that is faster. Answers
// from a filtration where one is known. (core/engines/cpu_engine.cpp)
std::unique_ptr<Engine> make_cpu_engine(std::shared_ptr<const BallSet> balls,
                                        EngineOptions options = {});

// CGAL's Regular_triangulation_3 (its parallel code for three threads or more and some thousand
// balls), then classification. All other engines are compared with this one. It always uses CGAL
// for triangulations, and ignores EngineOptions::triangulations. (core/engines/cgal_engine.cpp)
std::unique_ptr<Engine> make_cgal_engine(std::shared_ptr<const BallSet> balls,
                                         EngineOptions options = {});

}  // namespace alphascope
