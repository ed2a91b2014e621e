// The CPU engine: dual edges while alpha is small, CGAL's triangulation where that is faster
// (route.hpp), and a threshold of what it was lent or already knows where it can.

#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/complex/count_limits.hpp"
#include "core/dual_edge/cpu_dual_edges.hpp"
#include "core/engine/engine.hpp"
#include "core/engines/kept_complex.hpp"
#include "core/engines/lent.hpp"
#include "core/engines/route.hpp"
#include "core/neighbours/coincident.hpp"

namespace alphascope {
namespace {

class CpuEngine : public Engine {
 public:
  CpuEngine(std::shared_ptr<const BallSet> balls, EngineOptions options)
      : balls_(std::move(balls)),
        options_(options),
        threads_(options.work_threads()),
        kept_(balls_) {
    options_.shared = threads_;  // with the triangulation
  }

  AlphaComplex compute(const AlphaRequest& request, const RunContext& context) override {
    if (std::isnan(request.alpha_angstrom2.nearest()))
      throw std::invalid_argument("alpha is not a number");
    require_lent_of(*balls_, request.lent);
    const LatticeAlpha alpha = balls_->lattice.alpha_on_lattice(request.alpha_angstrom2);
    AlphaComplex complex;
    StageTimes times;
    threads_->run([&] {
      StageTimer timer(times);
      complex = answered(alpha, request, context, timer);
      timer.finish();
    });
    complex.timings = std::move(times);
    complex.engine.name = "dual-edge engine";
    complex.engine.device = threads_->text();
    return complex;
  }

  Lent take() override {
    if (!triangulation_) return {};
    Lent made = triangulation_->take();
    triangulation_.reset();
    return made;
  }

  std::uint64_t kept_bytes() const override {
    return kept_.bytes() + (triangulation_ ? triangulation_->kept_bytes() : 0);
  }

 private:
  AlphaComplex answered(const LatticeAlpha& alpha, const AlphaRequest& request,
                        const RunContext& context, StageTimer& timer) {
    if (auto complex = threshold_of_lent(*balls_, request, context, timer)) {
      kept_.forget();  // somebody else keeps all of it
      triangulation_.reset();
      return *std::move(complex);
    }
    if (triangulation_) return triangulated(request, context, timer);
    if (auto complex = kept_.answer(alpha, request.tetrahedra_only, context, timer)) {
      return *std::move(complex);
    }
    return computed(alpha, request, context, timer);
  }

  AlphaComplex computed(const LatticeAlpha& alpha, const AlphaRequest& request,
                        const RunContext& context, StageTimer& timer) {
    if (!hidden_) {
      hidden_ = coincident_hidden(*balls_);
      timer.lap(stage::kCoincident, true);
    }
    context.report(stage::kGrid, 0);
    if (!std::isfinite(alpha.below)) return triangulated(request, context, timer);
    const UniformGrid grid = make_uniform_grid(*balls_, alpha, *hidden_);
    const Route route = choose_route(
        grid, {threads_->used(), request.tetrahedra_only, request.lent.triangulation != nullptr});
    timer.lap(stage::kGrid);
    return route == Route::clip_dual_edges
               ? clipped(grid, alpha, request.tetrahedra_only, context, timer)
               : triangulated(request, context, timer);
  }

  AlphaComplex clipped(const UniformGrid& grid, const LatticeAlpha& alpha, bool tetrahedra_only,
                       const RunContext& context, StageTimer& timer) {
    AlphaComplex complex;
    complex.lattice = balls_->lattice;
    complex.alpha_on_lattice = alpha;
    complex.tetrahedra_only = tetrahedra_only;
    compute_by_dual_edges(*balls_, grid, context, timer, complex);
    complex.hash = complex_hash(complex);
    complex.engine.route = kClippingRoute;
    if (options_.cache && !tetrahedra_only) kept_.keep(complex);
    timer.lap(stage::kHash);
    return complex;
  }

  // CGAL's engine keeps its triangulation, so every later alpha is a threshold too.
  AlphaComplex triangulated(const AlphaRequest& request, const RunContext& context,
                            StageTimer& timer) {
    kept_.forget();
    if (!triangulation_) triangulation_ = make_cgal_engine(balls_, options_);
    AlphaComplex complex = triangulation_->compute(request, context);
    timer.adopt(complex.timings);
    if (!options_.cache) triangulation_.reset();
    return complex;
  }

  std::shared_ptr<const BallSet> balls_;
  EngineOptions options_;
  std::shared_ptr<WorkThreads> threads_;
  std::optional<std::vector<bool>> hidden_;
  KeptComplex kept_;
  std::unique_ptr<Engine> triangulation_;
};

}  // namespace

std::unique_ptr<Engine> make_cpu_engine(std::shared_ptr<const BallSet> balls,
                                        EngineOptions options) {
  require_balls(balls->size());
  return std::make_unique<CpuEngine>(std::move(balls), options);
}

}  // namespace alphascope
