// What every engine promises. An engine is made once per set of balls (setup) and then asked for
// one alpha after another.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/complex/alpha_complex.hpp"
#include "core/run/cancel_token.hpp"
#include "core/run/work_threads.hpp"

namespace alphascope {

class Filtration;
struct Triangulation;
struct UnionMeasures;

// What has been made of all of an engine's balls already, by whomever. Either may be null.
struct Lent {
  std::shared_ptr<const Triangulation> triangulation;
  // Of the very BallSet that the engine has, and made of its triangulation: every alpha is a
  // threshold of it.
  std::shared_ptr<const Filtration> filtration;
};

struct AlphaRequest {
  Alpha alpha_angstrom2;         // any but NaN
  bool tetrahedra_only = false;  // the thesis' sub-complex
  // An engine may answer from this, and keeps no part of it. Engines that are there to compute
  // (on the GPU, tuples) do not look at it.
  Lent lent = {};
  // take() is called next: a triangulation that was made is kept for it, although the engine itself
  // needs it no more.
  bool handing_over = false;
};

// EngineInfo::route of the engine that keeps each whole complex for the smaller alphas to come.
inline constexpr const char* kClippingRoute = "dual edge clipping";
// And of one that was lent a filtration, and did nothing else.
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

  // The exact alpha complex, the same on every engine. Setup work done by this call (the first one,
  // or one that had to rebuild) is marked in the timings. Throws Cancelled; std::bad_alloc when
  // memory is short (the engine stays usable); std::invalid_argument for a NaN alpha
  // and for what was lent of other balls.
  // Not to be called from two threads at once.
  virtual AlphaComplex compute(const AlphaRequest& request, const RunContext& context) = 0;

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

  // Hands over what it has made of all balls on the way to its results, and no longer keeps it:
  // lent again, later answers are as fast as before. Nothing when it made nothing such.
  virtual Lent take() { return {}; }

  // Bytes of the CPU's memory that it keeps for later answers, as far as it can tell. By
  // compute()'s rules.
  virtual std::uint64_t kept_bytes() const { return 0; }
};

// threads = 0: as many as the machine has.
struct EngineOptions {
  int threads = 0;
  // Keep the last whole complex, so that a smaller alpha is only a threshold; costs its memory
  // again.
  bool cache = true;
  // To work on, shared with others; null: threads of its own, as many as said above.
  std::shared_ptr<WorkThreads> shared = {};

  std::shared_ptr<WorkThreads> work_threads() const {
    return shared ? shared : std::make_shared<WorkThreads>(threads);
  }
};

// Each of these throws std::length_error for more balls than can be handled (count_limits.hpp).

// Dual edge clipping for small alpha; hands over to CGAL's triangulation where that is faster, and
// answers from a cached filtration when it holds one. (core/engines/cpu_engine.cpp)
std::unique_ptr<Engine> make_cpu_engine(std::shared_ptr<const BallSet> balls,
                                        EngineOptions options = {});

// CGAL's Regular_triangulation_3 (its parallel code from 3 threads on), then classification.
// The reference that the other engines are compared with. (core/engines/cgal_engine.cpp)
std::unique_ptr<Engine> make_cgal_engine(std::shared_ptr<const BallSet> balls,
                                         EngineOptions options = {});

}  // namespace alphascope
