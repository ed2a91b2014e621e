// SPDX-License-Identifier: GPL-3.0-or-later
// Definitions of measures and derivatives with their memory, and shares of exposed area.
#include "core/document/measures/measure_results.hpp"

#include "core/complex/alpha_complex.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/engine/known_results.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/selection/atom_groups.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {
namespace {

// Bytes for each ball: the quantities, whole area and component. While they are made: the grown
// ball, scales, a private sum for each of up to 16 threads, and a row of edges.
MemoryNeed measures_memory(std::size_t balls) {
  constexpr std::uint64_t kHeld = 12 + 8 * kMeasuredQuantities,
                          kPeak = 100 + 16 * 8 * kMeasuredQuantities;
  return {kHeld * balls, kPeak * balls};
}
MemoryNeed derivatives_memory(std::size_t balls) {
  constexpr std::uint64_t kHeld = 64, kPeak = 160 + 16 * 8 * (7 + kMeasuredQuantities);
  return {kHeld * balls, kPeak * balls};
}

float share(double part, double whole) {
  return static_cast<float>(whole > 0 ? part / whole : 0);
}

}  // namespace

MeasuredComplex measure_complex(const BallSet& balls, const AlphaComplex& complex,
                                std::shared_ptr<const MeasuredUnion> by,
                                const RunContext& context) {
  MeasuredComplex measured;
  measured.by = by ? std::move(by)
                   : std::make_shared<const MeasuredUnion>(
                         measure_on_calling_threads(balls, complex, context));
  context.cancel.throw_if_cancelled();
  measured.components = components(balls.size(), complex);
  measured.free_area_angstrom2 = free_areas_angstrom2(balls, complex.alpha_on_lattice);
  return measured;
}

std::vector<float> exposed_shares(const UnionMeasures& measures, const BallSet& balls,
                                  const LatticeAlpha& alpha_on_lattice) {
  const std::vector<double> whole = free_areas_angstrom2(balls, alpha_on_lattice);
  std::vector<float> shares;
  shares.reserve(whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    shares.push_back(share(measures.ball_area_angstrom2()[i], whole[i]));
  }
  return shares;
}

std::vector<float> exposed_shares_of_residues(const UnionMeasures& measures, const BallSet& balls,
                                              const LatticeAlpha& alpha_on_lattice,
                                              const Molecule& molecule,
                                              const std::vector<std::uint32_t>& atom_of_ball) {
  const AtomGroups residues = atom_groups(molecule, atom_of_ball, AtomGrouping::residue);
  const std::vector<double> areas = sums_by_group(measures.ball_area_angstrom2(), residues.of_ball,
                                                  residues.size()),
                            whole = sums_by_group(free_areas_angstrom2(balls, alpha_on_lattice),
                                                  residues.of_ball, residues.size());
  std::vector<float> shares;
  shares.reserve(balls.size());
  for (const std::uint32_t r : residues.of_ball) shares.push_back(share(areas[r], whole[r]));
  return shares;
}

const Definition<MeasuredComplex>& union_measures() {
  static const Definition<MeasuredComplex> definition{
      {.id = "measures",
       .title = "Areas and volumes",
       .key = key_of_complex,
       .memory = [](const Inputs& in) { return measures_memory(in.balls->size()); },
       .lane = Lane::interactive},
      [](const Inputs& in, const RunContext& context) {
        return std::make_shared<const MeasuredComplex>(
            measure_complex(*in.balls, *in.complex, in.measures, context));
      }};
  return definition;
}

const Definition<UnionDerivatives>& union_derivatives() {
  static const Definition<UnionDerivatives> definition{
      {.id = "measures.derivatives",
       .title = "Derivatives of area and volume",
       .key = key_of_complex,
       .memory = [](const Inputs& in) { return derivatives_memory(in.balls->size()); },
       .lane = Lane::interactive},
      [](const Inputs& in, const RunContext& context) {
        auto derivatives = std::make_shared<UnionDerivatives>();
        measure_union(*in.balls, *in.complex, {0, derivatives.get()}, context);
        return std::shared_ptr<const UnionDerivatives>(std::move(derivatives));
      }};
  return definition;
}

}  // namespace alphascope
