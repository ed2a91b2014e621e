// SPDX-License-Identifier: GPL-3.0-or-later
// The reference engine. It makes CGAL's triangulation once, and takes every alpha from it while the
// caller keeps it. cgal_triangulation.cpp makes the triangulation, filtration.hpp the alpha values.
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "core/complex/count_limits.hpp"
#include "core/engine/engine.hpp"
#include "core/engines/answers_from_known.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/run/parallel.hpp"
#include "core/triangulation/cgal_triangulation.hpp"
#include "core/triangulation/filtration.hpp"

namespace alphascope {
namespace {

// CGAL's own route to the tetrahedra of K_alpha: all cells with ortho-radius <= alpha.
void filter_tetrahedra(const BallSet& balls, const Triangulation& triangulation,
                       AlphaComplex& complex) {
  const Simplices<4>& cells = triangulation.tetrahedra;
  std::vector<char> in(cells.size());
  constexpr std::size_t kGrain = 1024;
  parallel_ranges(0, cells.size(), kGrain, [&](std::size_t first, std::size_t end) {
    for (std::size_t c = first; c != end; ++c) {
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
      : balls_(std::move(balls)), threads_(options.work_threads()) {}

  AlphaComplex compute(const AlphaRequest& request, KnownResults& known,
                       const RunContext& context) override {
    if (std::isnan(request.alpha_angstrom2.nearest()))
      throw std::invalid_argument("alpha is not a number");
    require_known_of(*balls_, known);
    AlphaComplex complex;
    StageTimes times;
    threads_->run([&] {
      StageTimer timer(times);
      auto answer = threshold_of_filtration(*balls_, request, known, context, timer);
      complex = answer ? *std::move(answer) : triangulated(request, known, context, timer);
      timer.finish();
    });
    complex.timings = std::move(times);
    complex.engine.name = "CGAL triangulation";
    complex.engine.device = threads_->text();
    complex.engine.rests_on_cgal = true;
    return complex;
  }

 private:
  AlphaComplex triangulated(const AlphaRequest& request, KnownResults& known,
                            const RunContext& context, StageTimer& timer) const {
    const LatticeAlpha alpha = balls_->lattice.alpha_on_lattice(request.alpha_angstrom2);
    const std::string route = next_route(request, known);
    known.balls = balls_;
    if (!known.triangulation) {
      known.triangulation = std::make_shared<const Triangulation>(
          make_triangulation(*balls_, threads_->asked(), context));
      timer.lap(stage::kTriangulation, true);
    }
    if (!request.tetrahedra_only) {
      known.filtration = std::make_shared<const Filtration>(balls_, known.triangulation, context);
      known.forget_complex();  // the filtration contains it
      timer.lap(stage::kClassification, true);
    }
    context.report(stage::kThreshold, 0);
    context.cancel.throw_if_cancelled();
    AlphaComplex complex = request.tetrahedra_only
                               ? filtered_tetrahedra(*known.triangulation, alpha)
                               : threshold(*known.filtration, alpha, false);
    complex.engine.route = route;
    timer.lap(stage::kThreshold);
    return complex;
  }

  // The route of the next call of triangulated().
  static std::string next_route(const AlphaRequest& request, const KnownResults& known) {
    if (request.tetrahedra_only) {
      return known.triangulation ? "threshold of the whole triangulation"
                                 : "regular triangulation, then threshold";
    }
    return known.triangulation ? "filtration of the whole triangulation, then threshold"
                               : "regular triangulation, filtration, then threshold";
  }

  AlphaComplex filtered_tetrahedra(const Triangulation& triangulation,
                                   const LatticeAlpha& alpha) const {
    AlphaComplex complex;
    complex.lattice = balls_->lattice;
    complex.alpha_on_lattice = alpha;
    complex.tetrahedra_only = true;
    filter_tetrahedra(*balls_, triangulation, complex);
    complex.hash = complex_hash(complex);
    return complex;
  }

  std::shared_ptr<const BallSet> balls_;
  std::shared_ptr<WorkThreads> threads_;
};

}  // namespace

std::unique_ptr<Engine> make_cgal_engine(std::shared_ptr<const BallSet> balls,
                                         EngineOptions options) {
  require_balls(balls->size());
  return std::make_unique<CgalEngine>(std::move(balls), options);
}

}  // namespace alphascope
