// The CPU engine: facet clipping while alpha is small, CGAL's triangulation where that is faster, and
// a threshold of what it already knows where it can.
#include <tbb/task_arena.h>

#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/complex/cpu_facets.hpp"
#include "core/complex/engine.hpp"
#include "core/complex/filtration.hpp"
#include "core/geometry/coincident.hpp"

namespace alphascope {
namespace {

// Microseconds of one thread per ball with m expected neighbours: a fit to 1K4C (16,068 balls, alpha 0
// to 5 and solvent 1.4; m = 4.6, 9.0, 14.7, 22.4, 26.7) on one core of an AMD EPYC. Only the choice of a route depends
// on them, never a result.
double facet_cost(double m, bool tetrahedra_only) {
  return tetrahedra_only ? 0.15 + 0.05 * m + 0.0085 * m * m : 0.2 + 0.16 * m + 0.0105 * m * m;
}
// The same for the triangulation and, for a whole complex, its alpha values.
double triangulation_cost(bool tetrahedra_only) { return tetrahedra_only ? 3.7 : 8.2; }
// Facets scale with the threads; the triangulation does so less.
double triangulation_speed_up(int threads) { return std::pow(threads, 0.75); }

// Neighbours per ball, from the candidates in the 27 cells around it: the share of their volume that
// lies within reach, for balls spread evenly and of similar size.
double expected_neighbours(const UniformGrid& grid) {
  if (grid.size() == 0) return 0;
  double mean_reach = 0;
  for (const float reach : grid.reach) mean_reach += reach;
  mean_reach /= static_cast<double>(grid.size());
  const double ratio = 2 * mean_reach / grid.cell_width;
  return grid.search_cost() / static_cast<double>(grid.size()) * (4.18879 / 27) * ratio * ratio * ratio;
}

class FacetEngine : public Engine {
 public:
  FacetEngine(std::shared_ptr<const BallSet> balls, EngineOptions options)
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
    const int threads = arena_.max_concurrency();
    complex.engine.name = "facet engine";
    complex.engine.device = "CPU, " + std::to_string(threads) + (threads == 1 ? " thread" : " threads");
    return complex;
  }

 private:
  AlphaComplex routed(double alpha, const AlphaRequest& request, const RunContext& context,
                      StageTimer& timer) {
    const bool tetrahedra_only = request.tetrahedra_only;
    if (triangulation_) return triangulated(request, context, timer);
    if (top_ && alpha <= top_->alpha_on_lattice) {
      context.report(stage::kClassification, 0);
      filtration_.emplace(balls_, std::move(top_));
      top_.reset();
      timer.lap(stage::kClassification, true);
    }
    if (filtration_ && alpha <= filtration_->alpha_max_on_lattice()) {
      AlphaComplex complex = threshold(*filtration_, alpha, tetrahedra_only);
      complex.engine.route = "threshold of cached filtration";
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
    const double facets = facet_cost(expected_neighbours(grid), tetrahedra_only) / arena_.max_concurrency();
    const double triangulation = triangulation_cost(tetrahedra_only) / triangulation_speed_up(arena_.max_concurrency());
    // A search of everything against everything is never worth it, whatever the averages say.
    const bool search_is_local = grid.search_cost() < 2000.0 * static_cast<double>(grid.size()) + 1e6;
    timer.lap(stage::kGrid);
    if (facets > triangulation || !search_is_local || 2 * largest_reach(grid) >= kMaxFacetReach) {
      return triangulated(request, context, timer);
    }
    return clipped(grid, alpha, tetrahedra_only, context, timer);
  }

  AlphaComplex clipped(const UniformGrid& grid, double alpha, bool tetrahedra_only,
                       const RunContext& context, StageTimer& timer) {
    AlphaComplex complex;
    complex.lattice = balls_->lattice;
    complex.alpha_on_lattice = alpha;
    complex.tetrahedra_only = tetrahedra_only;
    compute_facets(*balls_, grid, context, timer, complex);
    complex.hash = complex_hash(complex);
    complex.engine.route = "facet clipping";
    if (options_.cache && !tetrahedra_only) {
      top_ = std::make_shared<AlphaComplex>(complex);
      filtration_.reset();
    }
    timer.lap(stage::kHash);
    return complex;
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

  // Beyond this reach (lattice units) differences of neighbours may leave the facet kernels' range.
  static constexpr double kMaxFacetReach = 1 << 29;
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

std::unique_ptr<Engine> make_cpu_engine(std::shared_ptr<const BallSet> balls, EngineOptions options) {
  return std::make_unique<FacetEngine>(std::move(balls), options);
}

}  // namespace alphascope
