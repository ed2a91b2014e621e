// SPDX-License-Identifier: GPL-3.0-or-later
// Checks known results, counts their bytes, and answers by thresholds of them.
#include "core/engines/answers_from_known.hpp"

#include <cmath>
#include <stdexcept>

#include "core/complex/triangulation.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {
namespace {

std::uint64_t bytes_of(const Filtration& filtration) {
  return filtration.top_bytes() + filtration.level_bytes();
}

AlphaComplex threshold_of(const Filtration& filtration, const LatticeAlpha& alpha,
                          const AlphaRequest& request, const char* route, StageTimer& timer) {
  AlphaComplex complex = threshold(filtration, alpha, request.tetrahedra_only);
  complex.engine.route = route;
  timer.lap(stage::kThreshold);
  return complex;
}

}  // namespace

std::uint64_t bytes_of(const ResultsForAllAlphas& of_all) {
  const std::uint64_t bytes = of_all.triangulation ? bytes_of(*of_all.triangulation) : 0;
  return bytes + (of_all.filtration ? bytes_of(*of_all.filtration) : 0);
}

std::uint64_t bytes_of(const KnownResults& known) {
  std::uint64_t bytes = bytes_of(static_cast<const ResultsForAllAlphas&>(known));
  if (known.complex) bytes += bytes_of(*known.complex);
  if (known.below) bytes += bytes_of(*known.below);
  return bytes;
}

void require_known_of(const BallSet& balls, const KnownResults& known) {
  const bool any = known || known.complex || known.below;
  if (any && known.balls.get() != &balls) {
    throw std::invalid_argument("the known results are of other balls");
  }
  for (const auto& filtration : {known.filtration, known.below}) {
    if (filtration && &filtration->balls() != &balls) {
      throw std::invalid_argument("the filtration is of other balls");
    }
  }
  if (known.filtration && !std::isinf(known.filtration->alpha_max_on_lattice().below)) {
    throw std::invalid_argument("the filtration is not of all simplices");
  }
  if (known.triangulation &&
      known.triangulation->vertices.size() + known.triangulation->hidden.size() != balls.size()) {
    throw std::invalid_argument("the triangulation is of other balls");
  }
}

std::optional<AlphaComplex> threshold_of_filtration(const BallSet& balls,
                                                    const AlphaRequest& request,
                                                    KnownResults& known, const RunContext& context,
                                                    StageTimer& timer) {
  if (!known.filtration) return std::nullopt;
  known.forget_complex();  // the filtration contains it
  context.report(stage::kThreshold, 0);
  context.cancel.throw_if_cancelled();
  return threshold_of(*known.filtration, balls.lattice.alpha_on_lattice(request.alpha_angstrom2),
                      request, kThresholdRoute, timer);
}

std::optional<AlphaComplex> threshold_of_complex(const BallSet& balls, const AlphaRequest& request,
                                                 KnownResults& known, const RunContext& context,
                                                 StageTimer& timer) {
  const LatticeAlpha alpha = balls.lattice.alpha_on_lattice(request.alpha_angstrom2);
  const bool is_new = known.complex && alpha <= known.complex->alpha_on_lattice;
  if (is_new) {
    known.below = std::make_shared<const Filtration>(known.balls, known.complex, context);
    known.complex = nullptr;
    timer.lap(stage::kClassification, true);
  }
  if (!known.below || !(alpha <= known.below->alpha_max_on_lattice())) return std::nullopt;
  return threshold_of(
      *known.below, alpha, request,
      is_new ? "filtration of cached complex, then threshold" : "threshold of cached filtration",
      timer);
}

}  // namespace alphascope
