// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the residues of the atoms that recorded bonds name.
#include "core/read/residues/bond_evidence.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace alphascope {
namespace {

bool contains(const std::array<std::uint32_t, 2>& list, std::uint32_t atom) {
  return list[0] == atom || list[1] == atom;
}

}  // namespace

BondEvidence::BondEvidence(const Molecule& molecule, const ModelRange& model,
                           const ResidueTable& table, const RecordedBonds& bonds)
    : molecule_(molecule), table_(table) {
  if (bonds.named().empty() && bonds.numbered().empty()) return;
  sides_.resize(table.residues.size());
  if (!bonds.named().empty()) note_named(model, bonds.named());
  if (!bonds.numbered().empty()) note_numbered(model, bonds.numbered());
}

void BondEvidence::note_named(const ModelRange& model, const RecordedBonds::Named& bonds) {
  using Key = std::tuple<NameId, std::int32_t, char, NameId>;
  // Names that no atom has must not count as the empty name.
  const auto is_there = [&](const std::string& name) {
    return name.empty() || molecule_.names.find(name) != 0;
  };
  const auto key = [&](const BondedAtom& atom) {
    return Key{molecule_.names.find(atom.chain), atom.residue_number, atom.insertion_code,
               molecule_.names.find(atom.name)};
  };
  std::map<Key, std::uint32_t> wanted;
  for (const NamedBond& bond : bonds) {
    if (!bond.may_make_chain) continue;
    wanted[key(bond.a)] = kNoIndex;
    wanted[key(bond.b)] = kNoIndex;
  }
  // Takes the first of alternative locations, since all have the same bonds.
  for (std::size_t i = model.begin; i < model.end; ++i) {
    const Atom& atom = molecule_.atoms[i];
    const auto found =
        wanted.find({atom.chain, atom.residue_number, atom.insertion_code, atom.name});
    if (found != wanted.end() && found->second == kNoIndex) {
      found->second = static_cast<std::uint32_t>(i);
    }
  }
  const auto atom_of = [&](const BondedAtom& atom) {
    return is_there(atom.chain) && is_there(atom.name) ? wanted[key(atom)] : kNoIndex;
  };
  for (const NamedBond& bond : bonds) {
    if (!bond.may_make_chain) continue;
    const std::uint32_t first = atom_of(bond.a), second = atom_of(bond.b);
    note(first, second);
    note(second, first);
  }
}

void BondEvidence::note_numbered(const ModelRange& model, const RecordedBonds::Numbered& bonds) {
  std::vector<std::pair<std::int32_t, std::uint32_t>> atoms;
  atoms.reserve(model.size());
  for (std::size_t i = model.begin; i < model.end; ++i) {
    atoms.emplace_back(molecule_.atoms[i].serial, static_cast<std::uint32_t>(i));
  }
  std::sort(atoms.begin(), atoms.end());
  // A serial number of several atoms identifies none of them.
  const auto atom_of = [&](std::int32_t serial) {
    const auto at = std::lower_bound(atoms.begin(), atoms.end(), std::pair(serial, 0u));
    const bool one = at != atoms.end() && at->first == serial &&
                     (at + 1 == atoms.end() || (at + 1)->first != serial);
    return one ? at->second : kNoIndex;
  };
  for (const NumberedBond& bond : bonds) {
    const std::uint32_t first = atom_of(bond.a), second = atom_of(bond.b);
    note(first, second);
    note(second, first);
  }
}

void BondEvidence::note(std::uint32_t atom, std::uint32_t partner) {
  if (atom == kNoIndex || partner == kNoIndex) return;
  if (is_metal(molecule_.atoms[atom].element) || is_metal(molecule_.atoms[partner].element)) return;
  const std::uint32_t residue = residue_of(atom), other = residue_of(partner);
  if (residue == kNoIndex || other == kNoIndex || residue == other) return;
  const ResidueFacts& facts = table_.residues[other];
  if (!facts.chain_like) return;
  sides_[residue] |= kBound;
  if (contains(facts.c, partner) || contains(facts.o3, partner)) sides_[residue] |= kBehind;
  if (contains(facts.n, partner) || contains(facts.p, partner)) sides_[residue] |= kBefore;
}

std::uint32_t BondEvidence::residue_of(std::uint32_t atom) const {
  const auto behind =
      std::upper_bound(table_.pieces.begin(), table_.pieces.end(), atom,
                       [](std::uint32_t i, const ResiduePiece& piece) { return i < piece.begin; });
  if (behind == table_.pieces.begin()) return kNoIndex;
  const ResiduePiece& piece = *(behind - 1);
  return atom < piece.end ? piece.residue : kNoIndex;
}

}  // namespace alphascope
