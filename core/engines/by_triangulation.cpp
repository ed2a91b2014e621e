// SPDX-License-Identifier: GPL-3.0-or-later
// Makes triangulation and filtration, and takes thresholds of them.
#include "core/engines/by_triangulation.hpp"

#include <string>
#include <vector>

#include "core/complex/triangulation.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/run/parallel.hpp"
#include "core/triangulation/cgal_triangulation.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/triangulation_maker.hpp"
#include "core/triangulation/triangulation_report.hpp"

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

AlphaComplex filtered_tetrahedra(const BallSet& balls, const Triangulation& triangulation,
                                 const LatticeAlpha& alpha) {
  AlphaComplex complex;
  complex.lattice = balls.lattice;
  complex.alpha_on_lattice = alpha;
  complex.tetrahedra_only = true;
  complex.engine.of_whole = true;
  complex.engine.rests_on_cgal = made_by_cgal(triangulation);
  filter_tetrahedra(balls, triangulation, complex);
  complex.hash = complex_hash(complex);
  return complex;
}

// Names the steps that were taken. `was_known`: the triangulation was.
std::string route_of(const AlphaRequest& request, bool was_known, const KnownResults& known) {
  const auto on = [](const std::string& device) {
    return device.empty() ? device : " on " + device;
  };
  const Triangulation& triangulation = *known.triangulation;
  std::string filtration;
  if (!request.tetrahedra_only) filtration = "filtration" + on(known.filtration->device());
  if (was_known) {
    return request.tetrahedra_only ? "threshold of the whole triangulation"
                                   : filtration + " of the whole triangulation, then threshold";
  }
  return "regular triangulation" +
         on(made_by_device(triangulation) ? triangulation.report->maker : std::string()) +
         (request.tetrahedra_only ? "" : ", " + filtration) + ", then threshold";
}

}  // namespace

AlphaComplex compute_by_triangulation(const TriangulatingEngine& engine,
                                      const AlphaRequest& request, KnownResults& known,
                                      const RunContext& context, StageTimer& timer) {
  const BallSet& balls = *engine.balls;
  const LatticeAlpha alpha = balls.lattice.alpha_on_lattice(request.alpha_angstrom2);
  const bool was_known = known.triangulation != nullptr;
  known.balls = engine.balls;
  if (!was_known) {
    known.triangulation = std::make_shared<const Triangulation>(
        engine.by_cgal ? make_cgal_triangulation(balls, engine.threads, context)
                       : make_triangulation_by(engine.maker, balls, engine.threads, context));
    timer.lap(stage::kTriangulation, true);
  }
  const std::shared_ptr<const Triangulation> triangulation = known.triangulation;
  if (!request.tetrahedra_only) {
    known.filtration = std::make_shared<const Filtration>(
        known.balls, triangulation, context, engine.by_cgal ? nullptr : engine.maker.get());
    known.forget_complex();  // the filtration contains it
    timer.lap(stage::kClassification, true);
  }
  context.report(stage::kThreshold, 0);
  context.cancel.throw_if_cancelled();
  AlphaComplex complex = request.tetrahedra_only ? filtered_tetrahedra(balls, *triangulation, alpha)
                                                 : threshold(*known.filtration, alpha, false);
  complex.engine.route = route_of(request, was_known, known);
  timer.lap(stage::kThreshold);
  return complex;
}

}  // namespace alphascope
