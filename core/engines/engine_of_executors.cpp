// SPDX-License-Identifier: GPL-3.0-or-later
// An engine made of executors: the whole set, then slabs, then the CPU engine.
#include "core/engines/engine_of_executors.hpp"

#include <cmath>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/engine/slabs.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/cancel_token.hpp"
#include "core/triangulation/triangulation_maker.hpp"
#include "core/triangulation/triangulation_report.hpp"

namespace alphascope {
namespace {

// The number of slabs for the next request.
class SlabCount {
 public:
  explicit SlabCount(std::size_t balls) : balls_(balls) {}

  std::size_t operator()() const { return slabs_; }

  void begin(const AlphaRequest& request) {
    if (slabs_ > 1 && may_need_fewer(request)) slabs_ /= 2;
  }
  void answered() { ++answers_; }
  // Doubles the slabs. Returns false when more slabs would not help, because their halos would be
  // most of the work.
  bool refused(const AlphaRequest& request) {
    constexpr std::size_t kMostSlabs = 256;
    if (slabs_ >= kMostSlabs || slabs_ > balls_) return false;
    slabs_ *= 2;
    refused_alpha_ = request.alpha_angstrom2;
    refused_tetrahedra_only_ = request.tetrahedra_only;
    answers_ = 0;
    return true;
  }

 private:
  // True for a request smaller than the last one for which half as many slabs had no room. After
  // kAnswersBeforeTrial answers it is true for every request.
  bool may_need_fewer(const AlphaRequest& request) const {
    constexpr int kAnswersBeforeTrial = 8;
    return request.alpha_angstrom2 < refused_alpha_ ||
           (request.tetrahedra_only && !refused_tetrahedra_only_) ||
           answers_ >= kAnswersBeforeTrial;
  }

  std::size_t balls_;
  std::size_t slabs_ = 1;
  Alpha refused_alpha_;  // Å²; the last for which half as many slabs had no room
  bool refused_tetrahedra_only_ = false;
  int answers_ = 0;  // since refused_alpha_
};

class EngineOfExecutors : public Engine {
 public:
  EngineOfExecutors(std::shared_ptr<const BallSet> balls, EngineOptions options, MakeExecutor make)
      : balls_(std::move(balls)),
        options_(options),
        make_(std::move(make)),
        slabs_(balls_->size()) {}

  AlphaComplex compute(const AlphaRequest& request, KnownResults& known,
                       const RunContext& context) override {
    if (std::isnan(request.alpha_angstrom2.nearest()))
      throw std::invalid_argument("alpha is not a number");
    std::string why_cpu = "beyond the GPU kernels' limits";
    why_not_whole_.clear();
    try {
      if (std::optional<AlphaComplex> complex = by_executors(request, context)) {
        return *std::move(complex);
      }
    } catch (const ExecutorFailed& error) {
      whole_.reset();  // its memory may be in any state
      why_cpu = error.what();
    } catch (const std::bad_alloc&) {
      why_cpu = "the GPU's memory is full";
    }
    return by_cpu(request, known, context, why_cpu);
  }

  DeviceMeasuring measure(const AlphaComplex& complex, UnionMeasures& to,
                          const RunContext& context) override {
    DeviceMeasuring by;
    const std::string why_not = by_whole([&] { by = whole_->measure(complex, to, context); });
    return why_not.empty() ? by : DeviceMeasuring{{}, {}, why_not};
  }

  std::optional<SharedFaces> find_outer_faces(const AlphaComplex& complex) override {
    std::optional<SharedFaces> outside;
    if (whole_) by_whole([&] { outside = whole_->find_outer_faces(complex); });
    return outside;
  }

  // An engine that needs slabs, or the CPU, begins anew.
  bool take(const std::shared_ptr<const BallSet>& balls) override {
    if (!whole_ || slabs_() > 1 || !why_not_whole_.empty()) return false;
    try {
      if (!whole_->take(balls)) return false;
    } catch (const ExecutorFailed&) {
      whole_.reset();
      return false;
    } catch (const std::bad_alloc&) {
      whole_.reset();
      return false;
    }
    balls_ = balls;
    slabs_ = SlabCount(balls_->size());
    cpu_.reset();
    return true;
  }

  void release_memory() override {
    if (whole_) whole_->release_memory();
  }

 private:
  // Lets the executor of the whole set do `task`, which uses the result of a computation. Returns
  // the reason if it could not, else an empty text. An executor that failed for this complex is not
  // tried again.
  template <class Task>
  std::string by_whole(const Task& task) {
    if (!why_not_whole_.empty()) return why_not_whole_;
    try {
      if (!whole_) whole_ = make_(balls_);
      holds_more_ = true;
      task();
      return {};
    } catch (const ExecutorFailed& error) {
      whole_.reset();
      return error.what();
    } catch (const std::bad_alloc&) {
      return "the GPU's memory is full";
    }
  }

  // The whole set at once, or as few slabs as the memory allows.
  std::optional<AlphaComplex> by_executors(const AlphaRequest& request, const RunContext& context) {
    slabs_.begin(request);
    for (;;) {
      try {
        std::optional<AlphaComplex> complex =
            slabs_() == 1 ? whole_set(request, context) : in_slabs(request, context);
        slabs_.answered();
        return complex;
      } catch (const std::bad_alloc&) {
        whole_.reset();
        const bool held_more = std::exchange(holds_more_, false);  // freed with whole_
        const bool kept = options_.triangulations && options_.triangulations->release_memory();
        if (!held_more && !kept && !slabs_.refused(request)) throw;
      }
    }
  }

  std::optional<AlphaComplex> whole_set(const AlphaRequest& request, const RunContext& context) {
    if (!whole_) whole_ = make_(balls_);
    return whole_->compute(request, context);
  }

  std::optional<AlphaComplex> in_slabs(const AlphaRequest& request, const RunContext& context) {
    struct BeyondLimits {};
    try {
      AlphaComplex complex = compute_in_slabs(
          *balls_, request, slabs_(), context, [&](std::shared_ptr<const BallSet> part) {
            std::optional<AlphaComplex> result = make_(std::move(part))->compute(request, context);
            if (!result) throw BeyondLimits{};
            return *std::move(result);
          });
      complex.engine.route += ", in " + std::to_string(slabs_()) + " slabs";
      why_not_whole_ = "the GPU has no room for the whole complex";
      return complex;
    } catch (const BeyondLimits&) {
      return std::nullopt;
    }
  }

  AlphaComplex by_cpu(const AlphaRequest& request, KnownResults& known, const RunContext& context,
                      const std::string& why) {
    release_memory();
    why_not_whole_ = why;
    if (!cpu_) cpu_ = make_cpu_engine(balls_, options_);
    const bool had_triangulation = known.triangulation != nullptr;
    AlphaComplex complex = cpu_->compute(request, known, context);
    const bool by_device =
        !had_triangulation && known.triangulation && made_by_device(*known.triangulation);
    complex.engine.route += (by_device ? " (the rest on the CPU: " : " (on the CPU: ") + why + ")";
    return complex;
  }

  std::shared_ptr<const BallSet> balls_;
  const EngineOptions options_;
  const MakeExecutor make_;
  SlabCount slabs_;
  std::unique_ptr<Executor> whole_;
  bool holds_more_ = false;    // `whole_` may hold memory for measures or the outside, too
  std::string why_not_whole_;  // why the last complex was not computed as a whole; empty: it was
  std::unique_ptr<Engine> cpu_;
};

}  // namespace

std::unique_ptr<Engine> make_engine_of_executors(std::shared_ptr<const BallSet> balls,
                                                 EngineOptions options, MakeExecutor make) {
  return std::make_unique<EngineOfExecutors>(std::move(balls), options, std::move(make));
}

}  // namespace alphascope
