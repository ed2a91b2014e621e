// SPDX-License-Identifier: GPL-3.0-or-later
// The selected cavities: shapes for the picture, lining and contents, as one derived result of
// table and selection.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/complex/simplices.hpp"
#include "core/document/reference/ref_set.hpp"
#include "core/geometry/real_point.hpp"
#include "core/selection/drop_reason.hpp"

namespace alphascope {

template <class T>
struct Definition;
struct CavityLines;
struct CavityTable;
struct DrawnCavityParts;
struct FillingSphere;

struct SelectedCavity {
  std::size_t row = 0;  // of the table
  Simplices<3> surface;
  Simplices<4> tetrahedra;
  std::vector<FillingSphere> spheres;
  Simplices<2> rims;         // rims of its mouths
  RealPoint place_angstrom;  // a point inside it, for its number
};

// Residues of one chain, "HIS 87, VAL 93". `chain` is empty for atoms without a chain.
struct ChainLining {
  std::string chain, residues;
  std::size_t count = 0;
};

// An atom of a ligand, ion or water inside a cavity. Or an atom of a ligand or ion that belongs to
// the body and lines the cavity.
struct ContainedAtom {
  std::uint32_t atom = 0;                // index in Molecule::atoms
  DropReason kind = DropReason::ligand;  // or ion, water
  bool in_body = false;
  friend auto operator<=>(const ContainedAtom&, const ContainedAtom&) = default;
};

struct SelectedCavities {
  std::shared_ptr<const CavityTable> table;
  std::vector<SelectedCavity> of;  // in the order of rows
  std::vector<Ref> atoms;          // lining atoms of all selected cavities, each once; at most
                                   // Selection::kMostItems
  std::vector<ChainLining> residues;
  std::vector<ContainedAtom> held;  // atoms of whole residues, each once, ascending
};

// Shapes and lining of the cavities with these deepest sinks (ascending). Sinks that are not in the
// table are skipped. `key` must differ for other arguments and not be 0. Requires Inputs::atoms.
using CavitySinks = std::vector<std::array<BallIndex, 4>>;
Definition<SelectedCavities> selected_cavities(const CavitySinks& sinks,
                                               const DrawnCavityParts& parts, std::uint64_t key);

// Rows, ascending, of cavities selected by these deepest sinks, now or in an earlier table. A
// cavity that has merged into another is represented by that one.
struct SelectedRows {
  std::vector<std::size_t> rows;
  std::vector<std::size_t> merged_into;  // subset of `rows` into which a selected cavity has merged
};
SelectedRows rows_of_cavities(const CavityLines& lines, const RefSet& cavities);

}  // namespace alphascope
