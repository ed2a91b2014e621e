// SPDX-License-Identifier: GPL-3.0-or-later
// The CPU engine. It clips dual edges while alpha is small, and uses the whole triangulation where
// that is faster (route.hpp). Where a filtration is known, it takes a threshold.

#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/complex/count_limits.hpp"
#include "core/dual_edge/cpu_dual_edges.hpp"
#include "core/engine/engine.hpp"
#include "core/engines/answers_from_known.hpp"
#include "core/engines/by_triangulation.hpp"
#include "core/engines/route.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/neighbours/coincident.hpp"

namespace alphascope {
namespace {

class CpuEngine : public Engine {
 public:
  CpuEngine(std::shared_ptr<const BallSet> balls, EngineOptions options)
      : balls_(std::move(balls)),
        triangulations_(std::move(options.triangulations)),
        threads_(options.work_threads()) {}

  AlphaComplex compute(const AlphaRequest& request, KnownResults& known,
                       const RunContext& context) override {
    if (std::isnan(request.alpha_angstrom2.nearest()))
      throw std::invalid_argument("alpha is not a number");
    require_known_of(*balls_, known);
    known.wants_complex = false;
    AlphaComplex complex;
    StageTimes times;
    threads_->run([&] {
      StageTimer timer(times);
      complex = answered(request, known, context, timer);
      timer.finish();
    });
    complex.timings = std::move(times);
    complex.engine.name = "dual-edge engine";
    complex.engine.device = threads_->text();
    return complex;
  }

 private:
  AlphaComplex answered(const AlphaRequest& request, KnownResults& known, const RunContext& context,
                        StageTimer& timer) {
    if (auto complex = threshold_of_filtration(*balls_, request, known, context, timer)) {
      return *std::move(complex);
    }
    if (auto complex = threshold_of_complex(*balls_, request, known, context, timer)) {
      return *std::move(complex);
    }
    return computed(request, known, context, timer);
  }

  AlphaComplex computed(const AlphaRequest& request, KnownResults& known, const RunContext& context,
                        StageTimer& timer) {
    const LatticeAlpha alpha = balls_->lattice.alpha_on_lattice(request.alpha_angstrom2);
    if (!hidden_) {
      hidden_ = coincident_hidden(*balls_);
      timer.lap(stage::kCoincident, true);
    }
    context.report(stage::kGrid, 0);
    if (!std::isfinite(alpha.below)) return triangulated(request, known, context, timer);
    const UniformGrid grid = make_uniform_grid(*balls_, alpha, *hidden_);
    const Route route =
        choose_route(grid, {threads_->used(), request.tetrahedra_only,
                            known.triangulation != nullptr || triangulations_ != nullptr});
    timer.lap(stage::kGrid);
    if (route == Route::triangulate) return triangulated(request, known, context, timer);
    AlphaComplex complex = clipped(grid, alpha, request.tetrahedra_only, context, timer);
    if (!request.tetrahedra_only) {
      known.balls = balls_;
      known.forget_complex();  // it is of a smaller alpha
      known.wants_complex = true;
    }
    return complex;
  }

  AlphaComplex clipped(const UniformGrid& grid, const LatticeAlpha& alpha, bool tetrahedra_only,
                       const RunContext& context, StageTimer& timer) const {
    AlphaComplex complex;
    complex.lattice = balls_->lattice;
    complex.alpha_on_lattice = alpha;
    complex.tetrahedra_only = tetrahedra_only;
    compute_by_dual_edges(*balls_, grid, context, timer, complex);
    complex.hash = complex_hash(complex);
    complex.engine.route = kClippingRoute;
    timer.lap(stage::kHash);
    return complex;
  }

  AlphaComplex triangulated(const AlphaRequest& request, KnownResults& known,
                            const RunContext& context, StageTimer& timer) const {
    return compute_by_triangulation({balls_, triangulations_, threads_->asked()}, request, known,
                                    context, timer);
  }

  std::shared_ptr<const BallSet> balls_;
  std::shared_ptr<TriangulationMaker> triangulations_;
  std::shared_ptr<WorkThreads> threads_;
  std::optional<std::vector<bool>> hidden_;
};

}  // namespace

std::unique_ptr<Engine> make_cpu_engine(std::shared_ptr<const BallSet> balls,
                                        EngineOptions options) {
  require_balls(balls->size());
  return std::make_unique<CpuEngine>(std::move(balls), options);
}

}  // namespace alphascope
