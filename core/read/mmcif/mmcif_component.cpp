// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a molecule of a chemical component.
#include "core/read/mmcif/mmcif_component.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/geometry/lattice_alpha.hpp"
#include "core/read/residues/stated_element.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {

std::size_t MmcifComponent::column(std::string_view name) const {
  const std::string tag = std::string(kTable) + std::string(name);
  return static_cast<std::size_t>(std::find(tags_.begin(), tags_.end(), tag) - tags_.begin());
}

std::string_view MmcifComponent::text(std::size_t row, std::size_t column) const {
  return column < tags_.size() ? plain_cif(value(row, column).raw) : std::string_view();
}

bool MmcifComponent::is_whole(const std::array<std::size_t, 3>& place) const {
  for (std::size_t row = 0; row < rows(); ++row) {
    for (const std::size_t column : place) {
      if (text(row, column).empty()) return false;
    }
  }
  return rows() > 0;
}

void MmcifComponent::take(MoleculeBuilder& builder, AtomGuesser& guesser) const {
  NameTable& names = builder.molecule().names;
  const std::string before[] = {"model_cartn_", "pdbx_model_cartn_"}, behind[] = {"", "_ideal"};
  for (std::size_t k = 0; k < 2; ++k) {
    std::array<std::size_t, 3> place{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      place[axis] = column(before[k] + "xyz"[axis] + behind[k]);
    }
    if (!is_whole(place)) continue;
    for (std::size_t row = 0; row < rows(); ++row) {
      std::array<Decimal, 3> position;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        position[axis] =
            cif_coordinate(builder.molecule().source, value(row, place[axis]), "xyz"[axis]);
      }
      Atom atom;
      atom.source_line = static_cast<std::uint32_t>(value(row, 0).line);
      atom.hetero = true;
      atom.serial = static_cast<std::int32_t>(row + 1);
      atom.residue_number = 1;
      atom.name = names.intern(text(row, column("atom_id")));
      atom.residue_name = names.intern(text(row, column("comp_id")));
      const StatedElement stated = stated_element(trimmed(text(row, column("type_symbol"))));
      atom.kind = residue_kind(guesser.identify(atom, stated, NamePlace::free, names), true);
      builder.add(atom, position);
    }
    builder.molecule().notes.push_back(
        std::string("The file describes a chemical component; its ") +
        (k == 0 ? "model" : "ideal") + " coordinates are read");
    return;
  }
}

}  // namespace alphascope
