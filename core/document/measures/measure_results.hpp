// Areas and volumes of the complex on screen, as derived results.
#pragma once

#include <memory>
#include <vector>

#include "core/document/store/derived.hpp"
#include "core/measure/engine_measures.hpp"
#include "core/molecule/molecule.hpp"

namespace alphascope {

struct MeasuredComplex {
  std::shared_ptr<const MeasuredUnion> by;  // the measures, and what measured
  Components components;
  std::vector<double> free_area_angstrom2;  // of each ball's whole grown sphere

  const UnionMeasures& measures() const { return by->measures; }
};
// `by` is null where the CPU is to measure, in the caller's task arena. Throws what measure_union()
// does.
MeasuredComplex measure_complex(const BallSet& balls, const AlphaComplex& complex,
                                std::shared_ptr<const MeasuredUnion> by, const RunContext& context);

// Of each ball, how much of its whole sphere is on the surface of all, 0 to 1; or of its residue's
// spheres. 0 where a ball is empty.
std::vector<float> exposed_shares(const UnionMeasures& measures, const BallSet& balls,
                                  const LatticeAlpha& alpha_on_lattice);
std::vector<float> exposed_shares_of_residues(const UnionMeasures& measures, const BallSet& balls,
                                              const LatticeAlpha& alpha_on_lattice,
                                              const Molecule& molecule,
                                              const std::vector<std::uint32_t>& atom_of_ball);

// Made anew at each alpha; not of tetrahedra alone.
const Definition<MeasuredComplex>& union_measures();

// Only for those who ask: twice the work.
const Definition<UnionDerivatives>& union_derivatives();

}  // namespace alphascope
