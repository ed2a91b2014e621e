// The reference engine: CGAL's whole triangulation once, then every alpha from it. The
// triangulation itself is cgal_triangulation.cpp's, the alpha values filtration.hpp's.
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/complex/count_limits.hpp"
#include "core/engine/engine.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/run/cpu_threads.hpp"
#include "core/triangulation/cgal_triangulation.hpp"
#include "core/triangulation/filtration.hpp"

namespace alphascope {
namespace {

// CGAL's own route to the tetrahedra of K_alpha: all cells with ortho-radius <= alpha.
void filter_tetrahedra(const BallSet& balls, const Triangulation& triangulation,
                       AlphaComplex& complex) {
  const Simplices<4>& cells = triangulation.tetrahedra;
  std::vector<char> in(cells.size());
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, cells.size(), 1024), [&](const Range& range) {
    for (std::size_t c = range.begin(); c != range.end(); ++c) {
      in[c] = compare_ortho_radius(balls, cells[c], complex.alpha_on_lattice) <= 0;
    }
  });
  SimplexList<4>& list = complex.tetrahedra;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (in[c]) list.simplices.push_back(cells[c]);
  }
}

class CgalEngine : public Engine {
 public:
  CgalEngine(std::shared_ptr<const BallSet> balls, EngineOptions options)
      : balls_(std::move(balls)),
        arena_(options.threads > 0 ? options.threads : tbb::task_arena::automatic) {}

  AlphaComplex compute(const AlphaRequest& request, const RunContext& context) override {
    if (std::isnan(request.alpha_angstrom2)) throw std::invalid_argument("alpha is not a number");
    const double alpha = balls_->lattice.alpha_on_lattice(request.alpha_angstrom2);
    AlphaComplex complex;
    StageTimes times;
    StageTimer timer(times);
    const std::string route = next_route(request.tetrahedra_only);
    arena_.execute([&] {
      if (!filtration_) prepare(request.tetrahedra_only, context, timer);
      context.report(stage::kThreshold, 0);
      context.cancel.throw_if_cancelled();
      complex = filtration_ ? threshold(*filtration_, alpha, request.tetrahedra_only)
                            : filtered_tetrahedra(alpha);
      timer.lap(stage::kThreshold);
    });
    timer.finish();
    complex.timings = std::move(times);
    complex.engine = {"CGAL triangulation", cpu_text(arena_), route};
    complex.engine.rests_on_cgal = true;
    return complex;
  }

 private:
  // What compute() is about to do.
  std::string next_route(bool tetrahedra_only) const {
    if (filtration_) return "threshold of cached filtration";
    if (tetrahedra_only) {
      return triangulation_ ? "threshold of cached triangulation"
                            : "regular triangulation, then threshold";
    }
    return triangulation_ ? "filtration of cached triangulation, then threshold"
                          : "regular triangulation, filtration, then threshold";
  }

  // The filtration is built by the first request for a whole complex; it then replaces the
  // triangulation.
  void prepare(bool tetrahedra_only, const RunContext& context, StageTimer& timer) {
    if (!triangulation_) {
      triangulation_ = make_triangulation(*balls_, arena_.max_concurrency(), context);
      timer.lap(stage::kTriangulation, true);
    }
    if (tetrahedra_only) return;
    filtration_.emplace(balls_, *triangulation_, context);
    triangulation_.reset();
    timer.lap(stage::kClassification, true);
  }

  AlphaComplex filtered_tetrahedra(double alpha) const {
    AlphaComplex complex;
    complex.lattice = balls_->lattice;
    complex.alpha_on_lattice = alpha;
    complex.tetrahedra_only = true;
    filter_tetrahedra(*balls_, *triangulation_, complex);
    complex.hash = complex_hash(complex);
    return complex;
  }

  std::shared_ptr<const BallSet> balls_;
  tbb::task_arena arena_;
  std::optional<Triangulation> triangulation_;
  std::optional<Filtration> filtration_;
};

}  // namespace

std::unique_ptr<Engine> make_cgal_engine(std::shared_ptr<const BallSet> balls,
                                         EngineOptions options) {
  require_balls(balls->size());
  return std::make_unique<CgalEngine>(std::move(balls), options);
}

}  // namespace alphascope
