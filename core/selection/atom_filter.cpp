// SPDX-License-Identifier: GPL-3.0-or-later
// Applies the options of a selection to atoms.
#include "core/selection/atom_filter.hpp"

#include "core/molecule/altlocs.hpp"

namespace alphascope {

AtomFilter::AtomFilter(const Molecule& molecule, const BallOptions& options, AtomRange range,
                       bool drop_hydrogens)
    : molecule_(molecule), options_(options), range_(range), drop_hydrogens_(drop_hydrogens) {
  if (options.selection.find_first_not_of(" \t\r\n") != std::string::npos) {
    selection_ = SelectionExpression::parse(options.selection).bind(molecule);
  }
  choose_chains();
  const auto picked = [this](const Atom& atom) { return !reason_not_selected(atom); };
  if (options.altlocs == AltlocRule::best && options.model != kAllModels) {
    minor_ = minor_altlocs(molecule, range.begin, range.end, picked);
  } else if (options.altlocs == AltlocRule::best) {
    for (const ModelRange& model : molecule.models) {
      const std::vector<bool> part = minor_altlocs(molecule, model.begin, model.end, picked);
      minor_.insert(minor_.end(), part.begin(), part.end());
    }
  }
}

std::optional<DropReason> AtomFilter::reason_to_drop(std::size_t i) const {
  const Atom& atom = molecule_.atoms[i];
  if (const auto reason = reason_not_selected(atom)) return reason;
  switch (atom.kind) {
    case ResidueKind::dummy:
      if (!options_.dummies) return DropReason::dummy;
      break;
    case ResidueKind::water:
      if (!options_.waters) return DropReason::water;
      break;
    case ResidueKind::ion:
      if (!options_.ions) return DropReason::ion;
      break;
    case ResidueKind::ligand:
      if (!options_.ligands) return DropReason::ligand;
      break;
    case ResidueKind::polymer:
      if (!options_.polymers) return DropReason::polymer;
      break;
  }
  if (drop_hydrogens_ && atom.element == kHydrogen) return DropReason::hydrogen;
  if (is_minor_location(i)) return DropReason::altloc;
  return std::nullopt;
}

std::optional<DropReason> AtomFilter::reason_not_selected(const Atom& atom) const {
  if (!chains_.empty() && !chains_[atom.chain]) return DropReason::chain;
  if (selection_ && !(*selection_)(atom)) return DropReason::selection;
  return std::nullopt;
}

void AtomFilter::choose_chains() {
  if (options_.chains.empty() && options_.without_chains.empty()) return;
  chains_.assign(molecule_.names.size(), options_.chains.empty());
  const auto mark = [this](const std::vector<std::string>& chains, bool keep) {
    for (const std::string& chain : chains) {
      const NameId id = molecule_.names.find(chain);
      // A chain that does not exist must not match the atoms without a chain (id 0).
      if (id != 0 || chain.empty()) chains_[id] = keep;
    }
  };
  mark(options_.chains, true);
  mark(options_.without_chains, false);
}

}  // namespace alphascope
