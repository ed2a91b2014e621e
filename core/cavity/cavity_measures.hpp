// SPDX-License-Identifier: GPL-3.0-or-later
// Areas and volumes of cavities as CASTp defines them (T. A. Binkowski et al., Nucleic Acids Res.
// 31, 2003). They exist for the region of probe centres and for the region that the probe reaches.
#pragma once

#include <span>
#include <vector>

#include "core/cavity/cavities.hpp"
#include "core/geometry/lattice_alpha.hpp"

namespace alphascope {

struct CavityGround;
struct Membership;
class TriangulationMaker;

struct MouthMeasures {
  double area_angstrom2 = 0;   // area of its triangles outside the balls
  double length_angstrom = 0;  // length of that area's rim
};

// SA: the region of the probe's centre, outside all grown balls. It is measured by angle-weighted
// inclusion-exclusion over the simplices of K_alpha in each tetrahedron (H. Edelsbrunner, M.
// Facello, P. Fu, J. Liang, Measuring proteins and voids in proteins, HICSS 1995). The result is
// exact for voids. If a ball pokes through a pocket's mouth, the result differs from the volume of
// the tetrahedra outside the balls. It can even be negative and is then shown so.
//
// MS: that region with everything within the solvent radius of it, as offsets of its patches, arcs
// and corners. Regions that several offsets share count several times. Around an arc of a radius
// below the solvent radius the offset meets itself. CASTp's area counts that part as positive,
// Steiner's formula as negative. A ball that alpha made smaller than the solvent radius is filled
// up to its centre. So are the segments and triangles between its centre and others. Nothing beyond
// is filled.
struct CavityMeasures {
  double volume_sa_angstrom3 = 0, area_sa_angstrom2 = 0;
  double volume_ms_angstrom3 = 0, area_ms_angstrom2 = 0;
  double area_ms_steiner_angstrom2 = 0;
  double volume_of_tetrahedra_angstrom3 = 0;
  double arc_length_angstrom = 0;     // of the arcs in which two spheres meet
  std::size_t corners = 0;            // points in which three spheres meet
  std::vector<MouthMeasures> mouths;  // one for each of Cavity::mouths
  // Atoms with a part of their sphere in the tetrahedra; ascending.
  std::vector<BallIndex> lining;

  MouthMeasures all_mouths() const;
};

// The growth of the balls for which the membership was made: by the solvent radius, then by alpha.
struct CavityScale {
  LatticeAlpha alpha_on_lattice;  // square lattice units
  double solvent_on_lattice = 0;  // lattice units
};

// Measures each of cavities.cavities. Works in the caller's task arena. The same bits for any
// number of threads and for any order of the balls, with and without a device. `maker`: whose
// device helps, if there is one. Throws Cancelled.
std::vector<CavityMeasures> measure_cavities(const CavityGround& ground,
                                             const Membership& membership, const Cavities& cavities,
                                             const CavityScale& scale,
                                             const CancelToken& cancel = {},
                                             TriangulationMaker* maker = nullptr);

// Volume and area exactly outside all balls, within the tetrahedra of a cavity. Takes about 20
// microseconds per tetrahedron.
struct ExactCavityMeasures {
  double volume_sa_angstrom3 = 0, area_sa_angstrom2 = 0;
};

// Measures cavities.cavities[n] for each n of `which`, in that order. Otherwise as
// measure_cavities().
std::vector<ExactCavityMeasures> measure_cavities_exactly(const CavityGround& ground,
                                                          const Cavities& cavities,
                                                          std::span<const std::uint32_t> which,
                                                          const LatticeAlpha& alpha_on_lattice,
                                                          const RunContext& context = {});

// Indices of cavities by falling SA volume, as CASTp numbers them. Equal ones are ordered by the
// centres of their deepest sinks.
std::vector<std::uint32_t> by_falling_volume(const CavityGround& ground, const Cavities& cavities,
                                             const std::vector<CavityMeasures>& measures);

}  // namespace alphascope
