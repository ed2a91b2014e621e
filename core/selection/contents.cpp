// SPDX-License-Identifier: GPL-3.0-or-later
// Counts the atoms of a molecule by chain and kind.
#include "core/selection/contents.hpp"

#include <limits>

#include "core/molecule/element.hpp"
#include "core/molecule/molecule.hpp"
#include "core/selection/treatments.hpp"
#include "core/text/grouped_number.hpp"

namespace alphascope {

MoleculeContents contents_of(const Molecule& molecule) {
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  MoleculeContents contents;
  std::vector<std::size_t> index(molecule.names.size(), kNone);
  for (const Atom& atom : molecule.atoms) {
    std::size_t& chain = index[atom.chain];
    if (chain == kNone) {
      chain = contents.chains.size();
      contents.chains.push_back({std::string(molecule.text(atom.chain)), 0, {}});
    }
    const auto kind = static_cast<std::size_t>(atom.kind);
    ++contents.chains[chain].atoms;
    ++contents.chains[chain].kinds[kind];
    ++contents.kinds[kind];
    contents.kinds_with_names[kind] += atom.residue_name != 0;
    contents.hydrogens += atom.element == kHydrogen;
    contents.with_altloc += atom.altloc != ' ';
  }
  return contents;
}

std::string kinds_text(const KindCounts& counts) {
  std::string text;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (counts[k] == 0) continue;
    text += (text.empty() ? "" : " · ") + std::string(kind_name(static_cast<ResidueKind>(k))) +
            " " + grouped(counts[k]);
  }
  return text;
}

}  // namespace alphascope
