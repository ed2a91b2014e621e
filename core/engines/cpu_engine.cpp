// The CPU engine: dual edges while alpha is small, CGAL's triangulation where that is faster,
// and a threshold of what it already knows where it can.
#include <tbb/task_arena.h>

#include <cmath>
#include <new>
#include <optional>
#include <stdexcept>

#include "core/complex/count_limits.hpp"
#include "core/dual_edge/cpu_dual_edges.hpp"
#include "core/engine/engine.hpp"
#include "core/neighbours/coincident.hpp"
#include "core/run/cpu_threads.hpp"
#include "core/triangulation/filtration.hpp"

namespace alphascope {
namespace {

// Microseconds of one thread per ball: a fit to 1K4C (16,068 balls, alpha 0 to 14 and
// solvent 1.4: 5.8 to 88 neighbours a ball) on one core of an AMD EPYC. Only the choice of a route
// depends on it, never a result.
double clipping_cost(const NeighbourMoments& m, bool tetrahedra_only) {
  return tetrahedra_only ? 0.1 + 0.085 * m.mean + 0.0034 * m.mean_square
                         : 0.1 + 0.2 * m.mean + 0.0025 * m.mean_square;
}
constexpr std::size_t kCostSamples = 256;
// The same for the triangulation and, for a whole complex, its alpha values.
double triangulation_cost(bool tetrahedra_only) {
  return tetrahedra_only ? 3.7 : 8.2;
}
// Clipping scales with the threads; the triangulation does so less.
double triangulation_speed_up(int threads) {
  return std::pow(threads, 0.75);
}

class CpuEngine : public Engine {
 public:
  CpuEngine(std::shared_ptr<const BallSet> balls, EngineOptions options)
      : balls_(std::move(balls)),
        options_(options),
        arena_(options.threads > 0 ? options.threads : tbb::task_arena::automatic) {}

  AlphaComplex compute(const AlphaRequest& request, const RunContext& context) override {
    if (std::isnan(request.alpha_angstrom2)) throw std::invalid_argument("alpha is not a number");
    const double alpha = balls_->lattice.alpha_on_lattice(request.alpha_angstrom2);
    AlphaComplex complex;
    StageTimes times;
    arena_.execute([&] {
      StageTimer timer(times);
      complex = routed(alpha, request, context, timer);
      timer.finish();
    });
    complex.timings = std::move(times);
    complex.engine.name = "dual-edge engine";
    complex.engine.device = cpu_text(arena_);
    return complex;
  }

 private:
  AlphaComplex routed(double alpha, const AlphaRequest& request, const RunContext& context,
                      StageTimer& timer) {
    const bool tetrahedra_only = request.tetrahedra_only;
    if (triangulation_) return triangulated(request, context, timer);
    const bool make_filtration = top_ && alpha <= top_->alpha_on_lattice;
    if (make_filtration) {
      context.report(stage::kClassification, 0);
      filtration_.emplace(balls_, top_, context);
      top_.reset();
      timer.lap(stage::kClassification, true);
    }
    if (filtration_ && alpha <= filtration_->alpha_max_on_lattice()) {
      AlphaComplex complex = threshold(*filtration_, alpha, tetrahedra_only);
      complex.engine.route = make_filtration ? "filtration of cached complex, then threshold"
                                             : "threshold of cached filtration";
      timer.lap(stage::kThreshold);
      return complex;
    }
    if (!hidden_) {
      hidden_ = coincident_hidden(*balls_);
      timer.lap(stage::kCoincident, true);
    }
    context.report(stage::kGrid, 0);
    if (!std::isfinite(alpha)) return triangulated(request, context, timer);
    const UniformGrid grid = make_uniform_grid(*balls_, alpha, *hidden_);
    // A search of everything against everything is never worth it, whatever a sample says.
    const double search_cost = grid.search_cost();
    const bool local = search_cost < 2000.0 * static_cast<double>(grid.size()) + 1e6 &&
                       2 * largest_reach(grid) < kMaxClippingReach;
    const int threads = threads_used(arena_);
    const bool clip =
        local && clipping_cost(sample_neighbours(grid, kCostSamples), tetrahedra_only) / threads <
                     triangulation_cost(tetrahedra_only) / triangulation_speed_up(threads);
    timer.lap(stage::kGrid);
    return clip ? clipped(grid, alpha, tetrahedra_only, context, timer)
                : triangulated(request, context, timer);
  }

  AlphaComplex clipped(const UniformGrid& grid, double alpha, bool tetrahedra_only,
                       const RunContext& context, StageTimer& timer) {
    AlphaComplex complex;
    complex.lattice = balls_->lattice;
    complex.alpha_on_lattice = alpha;
    complex.tetrahedra_only = tetrahedra_only;
    compute_by_dual_edges(*balls_, grid, context, timer, complex);
    complex.hash = complex_hash(complex);
    complex.engine.route = kClippingRoute;
    if (options_.cache && !tetrahedra_only) keep(complex);
    timer.lap(stage::kHash);
    return complex;
  }

  // For smaller alphas to come; a result is worth more than its copy when memory is short.
  void keep(const AlphaComplex& complex) {
    filtration_.reset();
    try {
      top_ = std::make_shared<AlphaComplex>(complex);
    } catch (const std::bad_alloc&) {
      top_.reset();
    }
  }

  // CGAL's engine keeps its triangulation, so every later alpha is a threshold too.
  AlphaComplex triangulated(const AlphaRequest& request, const RunContext& context,
                            StageTimer& timer) {
    top_.reset();
    filtration_.reset();
    if (!triangulation_) triangulation_ = make_cgal_engine(balls_, options_);
    AlphaComplex complex = triangulation_->compute(request, context);
    timer.adopt(complex.timings);
    if (!options_.cache) triangulation_.reset();
    return complex;
  }

  // Beyond this reach (lattice units) differences of neighbours may leave the clipping kernels'
  // range.
  static constexpr double kMaxClippingReach = 1 << 29;
  static double largest_reach(const UniformGrid& grid) {
    double largest = 0;
    for (const float reach : grid.reach) largest = std::max(largest, static_cast<double>(reach));
    return largest;
  }

  std::shared_ptr<const BallSet> balls_;
  const EngineOptions options_;
  tbb::task_arena arena_;
  std::optional<std::vector<bool>> hidden_;
  // At most one of the two: a whole complex not yet made a filtration, or the filtration.
  std::shared_ptr<const AlphaComplex> top_;
  std::optional<Filtration> filtration_;
  std::unique_ptr<Engine> triangulation_;
};

}  // namespace

std::unique_ptr<Engine> make_cpu_engine(std::shared_ptr<const BallSet> balls,
                                        EngineOptions options) {
  require_balls(balls->size());
  return std::make_unique<CpuEngine>(std::move(balls), options);
}

}  // namespace alphascope
