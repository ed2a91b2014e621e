// What every engine promises. An engine is made once per set of balls (setup) and then asked for
// one alpha after another.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/complex/alpha_complex.hpp"
#include "core/engine/known_of_balls.hpp"
#include "core/run/cancel_token.hpp"
#include "core/run/work_threads.hpp"

namespace alphascope {

struct UnionMeasures;

struct AlphaRequest {
  Alpha alpha_angstrom2;         // any but NaN
  bool tetrahedra_only = false;  // the thesis' sub-complex
};

// EngineInfo::route of an engine that looked nothing up: smaller alphas may be thresholds of it.
inline constexpr const char* kClippingRoute = "dual edge clipping";
// And of one that had the filtration of all balls, and did nothing else.
inline constexpr const char* kThresholdRoute = "threshold of the whole filtration";

// How a device measured a complex, if it did.
struct DeviceMeasuring {
  std::string device;   // "NVIDIA H200"; empty: none did
  std::string route;    // "the complex was still on the device"
  std::string why_not;  // of an engine that has a device which could not: a sentence without its
                        // full stop
};

class Engine {
 public:
  virtual ~Engine() = default;

  // The exact alpha complex, the same on every engine. May answer from what is known of its balls,
  // and adds there what it makes of them, also when it throws. Engines that are there to compute
  // (on the GPU, tuples) do not look at it. Setup work done by this call (the first one, or one
  // that knew less) is marked in the timings. Throws Cancelled; std::bad_alloc when memory is short
  // (the engine stays usable); std::invalid_argument for a NaN alpha and for what is known of other
  // balls. Not to be called from two threads at once.
  virtual AlphaComplex compute(const AlphaRequest& request, KnownOfBalls& known,
                               const RunContext& context) = 0;
  // The same where nothing is known, and nobody asks for another alpha.
  AlphaComplex compute(const AlphaRequest& request, const RunContext& context) {
    KnownOfBalls nothing;
    return compute(request, nothing, context);
  }

  // Areas and volumes of a complex of its balls (core/measure/union_measures.hpp) by its device,
  // which may still have the complex; `to` is left alone where none can. Throws what
  // measure_union() does; when the device fails or its memory is short, that is the answer.
  virtual DeviceMeasuring measure(const AlphaComplex&, UnionMeasures&, const RunContext&) {
    return {};
  }

  // The outside of its last result by its device, for AlphaComplex::outside: so it need not be
  // looked for on the CPU. Nothing where no device has the complex, or it fails. By compute()'s
  // rules.
  virtual std::optional<SharedFaces> find_outside(const AlphaComplex&) { return std::nullopt; }

  // Another engine is asked from now on: gives back what this one keeps for its next results alone.
  // May wait for a device; compute() may be called again at any time. By compute()'s rules.
  virtual void rest() {}
};

// threads = 0: as many as the machine has.
struct EngineOptions {
  int threads = 0;
  // To work on, shared with others; null: threads of its own, as many as said above.
  std::shared_ptr<WorkThreads> shared = {};

  std::shared_ptr<WorkThreads> work_threads() const {
    return shared ? shared : std::make_shared<WorkThreads>(threads);
  }
};

// Each of these throws std::length_error for more balls than can be handled (count_limits.hpp).

// Dual edge clipping for small alpha; hands over to CGAL's triangulation where that is faster, and
// answers from a filtration where one is known. (core/engines/cpu_engine.cpp)
std::unique_ptr<Engine> make_cpu_engine(std::shared_ptr<const BallSet> balls,
                                        EngineOptions options = {});

// CGAL's Regular_triangulation_3 (its parallel code from 3 threads on), then classification.
// The reference that the other engines are compared with. (core/engines/cgal_engine.cpp)
std::unique_ptr<Engine> make_cgal_engine(std::shared_ptr<const BallSet> balls,
                                         EngineOptions options = {});

}  // namespace alphascope
