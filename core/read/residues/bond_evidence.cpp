// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the residues of the atoms that recorded bonds name.
#include "core/read/residues/bond_evidence.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "core/read/residues/recorded_atoms.hpp"

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
  std::map<AtomKey, std::uint32_t> wanted;
  for (const NamedBond& bond : bonds) {
    if (!bond.may_make_chain) continue;
    for (const BondedAtom* atom : {&bond.a, &bond.b}) {
      if (const auto key = atom_key(molecule_.names, *atom)) wanted[*key] = kNoIndex;
    }
  }
  // Takes the first of alternative locations, since all have the same bonds.
  for (std::size_t i = model.begin; i < model.end; ++i) {
    const auto found = wanted.find(atom_key(molecule_.atoms[i]));
    if (found != wanted.end() && found->second == kNoIndex) {
      found->second = static_cast<std::uint32_t>(i);
    }
  }
  const auto atom_of = [&](const BondedAtom& atom) {
    const auto key = atom_key(molecule_.names, atom);
    return key ? wanted[*key] : kNoIndex;
  };
  for (const NamedBond& bond : bonds) {
    if (!bond.may_make_chain) continue;
    const std::uint32_t first = atom_of(bond.a), second = atom_of(bond.b);
    note(first, second);
    note(second, first);
  }
}

void BondEvidence::note_numbered(const ModelRange& model, const RecordedBonds::Numbered& bonds) {
  const AtomsBySerial atoms(molecule_, model);
  for (const NumberedBond& bond : bonds) {
    const std::uint32_t first = atoms.atom(bond.a), second = atoms.atom(bond.b);
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
