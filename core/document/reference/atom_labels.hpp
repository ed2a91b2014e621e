// SPDX-License-Identifier: GPL-3.0-or-later
// Labels of atoms in the picture: atoms with labels, their texts, and their positions.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/document/reference/atom_set.hpp"
#include "core/document/reference/ref_set.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

class BallReferences;

// address: "A:HIS 87:NE2". residue: "HIS 87", once for all its atoms. radius: radius of the ball
// without solvent and alpha, Å. b_factor: Å².
enum class LabelText : std::uint8_t { name, residue, address, element, radius, b_factor };
// Ids in commands and files.
const std::vector<std::pair<LabelText, std::string_view>>& label_text_ids();

struct AtomLabels {
  LabelText text = LabelText::name;
  AtomSet atoms;
  friend bool operator==(const AtomLabels&, const AtomLabels&) = default;
};
using LabelGroups = std::vector<AtomLabels>;  // an atom is in at most one; none is empty

// More labels would be unreadable, and slow down frames.
inline constexpr std::size_t kMostLabels = 1000;

// Sets the label of these atoms; without `text` it is removed.
void set_labels(LabelGroups& labels, const AtomSet& atoms, std::optional<LabelText> text);

// Number of labels of atoms in this molecule. Counting stops at `most` + 1.
std::size_t label_count(const Molecule& molecule, const LabelGroups& labels,
                        std::size_t most = kMostLabels);

// The text of the thing's label: of an atom, or of the atoms of a simplex, with commas between
// them. Empty: no atom has one, such as a B factor that the file lacks.
std::string label_text(const BallReferences& atoms, const Ref& of, LabelText text);

struct PlacedText {
  RealPoint at_angstrom;  // coordinates of the file; for a residue the mean of its atoms
  std::string text;
};
// Labels of the atoms that are drawn, by index into the molecule's atoms; at most kMostLabels.
std::vector<PlacedText> placed_labels(const BallReferences& atoms, const LabelGroups& labels,
                                      const std::function<bool(std::size_t)>& is_drawn);

}  // namespace alphascope
