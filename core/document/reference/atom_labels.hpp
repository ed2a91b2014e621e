// Words beside atoms in the picture: which atoms have some, what they say, and where they stand.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/document/reference/atom_set.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

class BallReferences;

// address: "A:HIS 87:NE2". residue: "HIS 87", once for all atoms of it. radius: of the ball, Å,
// before solvent and alpha. b_factor: Å².
enum class LabelText : std::uint8_t { name, residue, address, element, radius, b_factor };
// The word for each, in commands and files.
const std::vector<std::pair<LabelText, std::string_view>>& label_text_ids();

struct AtomLabels {
  LabelText text = LabelText::name;
  AtomSet atoms;
  friend bool operator==(const AtomLabels&, const AtomLabels&) = default;
};
using LabelGroups = std::vector<AtomLabels>;  // no atom is in two of them, and none is empty

// More could not be read, and would make frames slow.
inline constexpr std::size_t kMostLabels = 1000;

// None: these atoms have no label any more.
void set_labels(LabelGroups& labels, const AtomSet& atoms, std::optional<LabelText> text);

// How many words they are, of atoms that the molecule has; at most `most` + 1 are counted.
std::size_t label_count(const Molecule& molecule, const LabelGroups& labels,
                        std::size_t most = kMostLabels);

struct PlacedText {
  RealPoint at_angstrom;  // coordinates of the file; of a residue, the mean of its atoms
  std::string text;
};
// Of those atoms that are drawn, by index into the molecule's; at most kMostLabels.
std::vector<PlacedText> placed_labels(const BallReferences& atoms, const LabelGroups& labels,
                                      const std::function<bool(std::size_t)>& is_drawn);

}  // namespace alphascope
