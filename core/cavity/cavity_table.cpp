// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the table of all cavities of one K_alpha, and clips its pockets on request.
#include "core/cavity/cavity_table.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/split_networks.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/run/stage_timer.hpp"
#include "core/triangulation/membership.hpp"
#include "core/triangulation/triangulation_maker.hpp"

namespace alphascope {
namespace {

template <class Value>
double sum_over(const CavityTable& table, bool of_voids, const Value& value) {
  double sum = 0;
  for (std::size_t row = 0; row < table.size(); ++row) {
    if (table.cavity(row).is_void() == of_voids) sum += value(table.measure(row));
  }
  return sum;
}

Membership membership_of(const CavityGround& ground, const LatticeAlpha& alpha,
                         const CancelToken& cancel, TriangulationMaker* maker) {
  if (maker != nullptr) {
    if (auto made = maker->membership(ground.incidence, alpha, cancel)) return *std::move(made);
  }
  return membership(*ground.balls, *ground.triangulation, ground.incidence, ground.flow, alpha,
                    cancel);
}

}  // namespace

const std::array<BallIndex, 4>& CavityTable::sink(std::size_t row) const {
  return ground->triangulation->tetrahedra[cavity(row).deepest_sink];
}

double CavityTable::volume_sa_angstrom3(bool of_voids) const {
  return sum_over(*this, of_voids, [](const CavityMeasures& m) { return m.volume_sa_angstrom3; });
}

double CavityTable::area_sa_angstrom2(bool of_voids) const {
  return sum_over(*this, of_voids, [](const CavityMeasures& m) { return m.area_sa_angstrom2; });
}

std::vector<ExactCavityMeasures> measure_all_exactly(const CavityTable& table,
                                                     const RunContext& context) {
  const std::vector<Cavity>& cavities = table.found.cavities;
  std::vector<ExactCavityMeasures> all;
  std::vector<std::uint32_t> pockets;
  for (std::uint32_t c = 0; c < cavities.size(); ++c) {
    all.push_back({table.measures[c].volume_sa_angstrom3, table.measures[c].area_sa_angstrom2});
    if (!cavities[c].is_void()) pockets.push_back(c);
  }
  if (pockets.empty()) return all;
  const CavityGround& ground = *table.ground;
  const std::vector<ExactCavityMeasures> clipped = measure_cavities_exactly(
      ground, table.found, pockets,
      ground.balls->lattice.alpha_on_lattice(table.question.alpha_angstrom2), context);
  for (std::size_t n = 0; n < pockets.size(); ++n) all[pockets[n]] = clipped[n];
  return all;
}

bool differs_from_exact(double sa_angstrom3, double exact_angstrom3) {
  constexpr double kSmallAngstrom3 = 1, kFar = 0.1;
  return exact_angstrom3 < kSmallAngstrom3 ||
         std::fabs(sa_angstrom3 - exact_angstrom3) > kFar * exact_angstrom3;
}

CavityTable make_cavity_table(std::shared_ptr<const CavityGround> ground,
                              const CavityParameters& question, const RunContext& context,
                              TriangulationMaker* maker) {
  if (std::isnan(question.alpha_angstrom2.nearest()))
    throw std::invalid_argument("alpha is not a number");
  CavityTable table;
  table.ground = std::move(ground);
  table.question = question;
  const CavityGround& of = *table.ground;
  if (of.triangulation->dimension < 3) return table;
  const Lattice& lattice = of.balls->lattice;
  const LatticeAlpha alpha = lattice.alpha_on_lattice(question.alpha_angstrom2);
  context.report(stage::kCavities, 0);
  const Membership in = membership_of(of, alpha, context.cancel, maker);
  context.report(stage::kCavities, 0.4);
  table.found = find_cavities(of, in, question.rule, context.cancel);
  if (question.split_networks) {
    table.found = split_networks(of, in, std::move(table.found), question.alpha_angstrom2,
                                 question.rule, context.cancel, maker);
  }
  context.report(stage::kCavities, 0.6);
  table.measures = measure_cavities(
      of, in, table.found, {alpha, lattice.nearest_units(question.solvent_radius_angstrom)},
      context.cancel, maker);
  table.order = by_falling_volume(of, table.found, table.measures);
  for (const Cavity& cavity : table.found.cavities) {
    ++(cavity.is_void() ? table.voids : table.pockets);
    table.mouths += cavity.mouths.size();
  }
  return table;
}

}  // namespace alphascope
