// The cavities that are chosen: their shapes for the picture, and what lines them, as one derived
// result of the table and the choice.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/cavity_shape/filling_spheres.hpp"
#include "core/document/cavities/cavity_contents.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

// Of what is chosen, what is to be drawn.
struct CavityParts {
  bool surfaces = true, tetrahedra = false, spheres = false, rims = true, numbers = false;
  friend bool operator==(const CavityParts&, const CavityParts&) = default;
};

struct ChosenCavity {
  std::size_t row = 0;  // of the table
  Simplices<3> surface;
  Simplices<4> tetrahedra;
  std::vector<FillingSphere> spheres;
  Simplices<2> rims;         // of its mouths
  RealPoint place_angstrom;  // within it: where its number belongs
};

// Residues of one chain, "HIS 87, VAL 93"; without a chain, of atoms that have none.
struct ChainLining {
  std::string chain, residues;
  std::size_t count = 0;
};

// Of a ligand, an ion or a water that a cavity holds; or of a ligand or an ion that is part of the
// body and lines it.
struct HeldAtom {
  std::uint32_t atom = 0;                // of Molecule::atoms
  DropReason kind = DropReason::ligand;  // or ion, water
  bool in_body = false;
  friend auto operator<=>(const HeldAtom&, const HeldAtom&) = default;
};

struct ChosenCavities {
  std::shared_ptr<const CavityTable> table;
  std::vector<ChosenCavity> of;  // by rows
  std::vector<Ref> atoms;        // that line any of them, each once; at most Selection::kMostItems
  std::vector<ChainLining> residues;
  std::vector<HeldAtom> held;  // of whole residues, each once, ascending
};

// `sinks`: the deepest ones of cavities, ascending; those that the table has not are left out.
// `key`: another number for other arguments, never 0. Not without Inputs::atoms.
using CavitySinks = std::vector<std::array<BallIndex, 4>>;
Definition<ChosenCavities> chosen_cavities(const CavitySinks& sinks, const CavityParts& parts,
                                           std::uint64_t key);

// The rows of the cavities that have been chosen by these deepest sinks, now or in a table before,
// and of those that they have merged into: ascending.
struct ChosenRows {
  std::vector<std::size_t> rows;
  std::vector<std::size_t> merged_into;  // of them, those that a chosen one has merged into
};
ChosenRows rows_of_cavities(const CavityLines& lines, const RefSet& cavities);

}  // namespace alphascope
