#include "core/engines/lent.hpp"

#include <cmath>
#include <stdexcept>

#include "core/complex/triangulation.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {

std::uint64_t bytes_of(const Lent& lent) {
  std::uint64_t bytes = lent.triangulation ? bytes_of(*lent.triangulation) : 0;
  if (lent.filtration) bytes += lent.filtration->top_bytes() + lent.filtration->level_bytes();
  return bytes;
}

void require_lent_of(const BallSet& balls, const Lent& lent) {
  if (lent.filtration && (&lent.filtration->balls() != &balls ||
                          !std::isinf(lent.filtration->alpha_max_on_lattice().below))) {
    throw std::invalid_argument("the filtration is of other balls, or not of all their simplices");
  }
  if (lent.triangulation &&
      lent.triangulation->vertices.size() + lent.triangulation->hidden.size() != balls.size()) {
    throw std::invalid_argument("the triangulation is of other balls");
  }
}

std::optional<AlphaComplex> threshold_of_lent(const BallSet& balls, const AlphaRequest& request,
                                              const RunContext& context, StageTimer& timer) {
  if (!request.lent.filtration) return std::nullopt;
  context.report(stage::kThreshold, 0);
  context.cancel.throw_if_cancelled();
  AlphaComplex complex =
      threshold(*request.lent.filtration, balls.lattice.alpha_on_lattice(request.alpha_angstrom2),
                request.tetrahedra_only);
  complex.engine.route = kThresholdRoute;
  timer.lap(stage::kThreshold);
  return complex;
}

}  // namespace alphascope
