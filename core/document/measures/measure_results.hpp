// SPDX-License-Identifier: GPL-3.0-or-later
// Areas and volumes of the complex on screen, as derived results.
#pragma once

#include <memory>
#include <vector>

#include "core/document/store/derived.hpp"
#include "core/measure/engine_measures.hpp"

namespace alphascope {

struct Molecule;

struct MeasuredComplex {
  std::shared_ptr<const MeasuredUnion> by;  // the measures, and the device that computed them
  Components components;
  std::vector<double> free_area_angstrom2;  // area of each ball's whole grown sphere

  const UnionMeasures& measures() const { return by->measures; }
};
// If `by` is null, the CPU measures, in the caller's task arena. Throws as measure_union() does.
MeasuredComplex measure_complex(const BallSet& balls, const AlphaComplex& complex,
                                std::shared_ptr<const MeasuredUnion> by, const RunContext& context);

// For each ball: the share of its whole sphere that is on the surface of all balls, 0 to 1. Or the
// share of the spheres of its residue. 0 if a ball is empty.
std::vector<float> exposed_shares(const UnionMeasures& measures, const BallSet& balls,
                                  const LatticeAlpha& alpha_on_lattice);
std::vector<float> exposed_shares_of_residues(const UnionMeasures& measures, const BallSet& balls,
                                              const LatticeAlpha& alpha_on_lattice,
                                              const Molecule& molecule,
                                              const std::vector<std::uint32_t>& atom_of_ball);

// Measures of the complex on screen, made anew at each alpha. They need all simplices, not
// tetrahedra alone.
const Definition<MeasuredComplex>& union_measures();

// Derivatives double the work, so they are made only on request.
const Definition<UnionDerivatives>& union_derivatives();

}  // namespace alphascope
