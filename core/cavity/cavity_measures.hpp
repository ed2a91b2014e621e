// Areas and volumes of cavities as CASTp defines them (T. A. Binkowski et al., Nucleic Acids Res.
// 31, 2003): of the region of probe centres, and of the region that the probe reaches.
#pragma once

#include <span>
#include <vector>

#include "core/cavity/cavities.hpp"

namespace alphascope {

struct MouthMeasures {
  double area_angstrom2 = 0;   // of its triangles, outside the balls
  double length_angstrom = 0;  // of the rim of that
};

// SA: the region of the probe's centre, outside all grown balls; by angle-weighted
// inclusion-exclusion over the simplices of K_alpha in each tetrahedron (H. Edelsbrunner, M.
// Facello, P. Fu, J. Liang, Measuring proteins and voids in proteins, HICSS 1995). Exact for voids.
// Of a pocket it is not the volume of the tetrahedra outside the balls where a ball pokes through a
// mouth; it can even be negative, which is not hidden.
// MS: that region with everything within the solvent radius of it, as offsets of its patches, arcs
// and corners; what offsets share counts twice. Around an arc of a radius below the solvent radius
// the offset meets itself; CASTp's area counts that part as positive, Steiner's formula as
// negative. A ball that alpha has made smaller than the solvent radius is filled up to its centre,
// and so are the segments and triangles between its centre and others; there is nothing beyond.
struct CavityMeasures {
  double volume_sa_angstrom3 = 0, area_sa_angstrom2 = 0;
  double volume_ms_angstrom3 = 0, area_ms_angstrom2 = 0;
  double area_ms_steiner_angstrom2 = 0;
  double volume_of_tetrahedra_angstrom3 = 0;
  double arc_length_angstrom = 0;     // where two balls meet
  std::size_t corners = 0;            // where three balls meet
  std::vector<MouthMeasures> mouths;  // as Cavity::mouths
  // Atoms of whose spheres a part lies in the tetrahedra; ascending.
  std::vector<BallIndex> lining;

  MouthMeasures all_mouths() const;
};

// What the membership was made of: balls grown by the solvent radius, then by alpha.
struct CavityScale {
  LatticeAlpha alpha_on_lattice;  // square lattice units
  double solvent_on_lattice = 0;  // lattice units
};

// One for each of cavities.cavities. Works in the caller's task arena; the same bits for any number
// of threads, and in whatever order the balls are listed. Throws Cancelled.
std::vector<CavityMeasures> measure_cavities(const CavityGround& ground,
                                             const Membership& membership, const Cavities& cavities,
                                             const CavityScale& scale,
                                             const CancelToken& cancel = {});

// What of the tetrahedra of a cavity is exactly outside all balls. Takes about 20 microseconds a
// tetrahedron.
struct ClippedMeasures {
  double volume_sa_angstrom3 = 0, area_sa_angstrom2 = 0;
};

// Of cavities.cavities[n] for each n of `which`, in that order. As measure_cavities().
std::vector<ClippedMeasures> clip_cavities(const CavityGround& ground, const Cavities& cavities,
                                           std::span<const std::uint32_t> which,
                                           const LatticeAlpha& alpha_on_lattice,
                                           const RunContext& context = {});

// Indices of cavities by falling SA volume, as CASTp numbers them; equal ones by the centres of
// their deepest sinks.
std::vector<std::uint32_t> by_falling_volume(const CavityGround& ground, const Cavities& cavities,
                                             const std::vector<CavityMeasures>& measures);

}  // namespace alphascope
