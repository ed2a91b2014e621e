// SPDX-License-Identifier: GPL-3.0-or-later
// Collects rows of struct_conn and keeps the bonds.
#include "core/read/mmcif/mmcif_bonds.hpp"

#include <charconv>
#include <utility>

#include "core/text/letter_case.hpp"

namespace alphascope {
namespace {

using Row = std::map<std::string, std::string, std::less<>>;

std::string value(const Row& row, const std::string& column) {
  const auto found = row.find(column);
  return found == row.end() ? std::string() : found->second;
}

std::string value(const Row& row, const std::string& first, const std::string& second) {
  const std::string text = value(row, first);
  return text.empty() ? value(row, second) : text;
}

// partner: "ptnr1" or "ptnr2". Takes the author's names where they are given, as for atoms.
BondedAtom bonded_atom(const Row& row, const std::string& partner) {
  BondedAtom atom;
  atom.chain = value(row, partner + "_auth_asym_id", partner + "_label_asym_id");
  atom.name = value(row, partner + "_auth_atom_id", partner + "_label_atom_id");
  const std::string number = value(row, partner + "_auth_seq_id", partner + "_label_seq_id");
  std::from_chars(number.data(), number.data() + number.size(), atom.residue_number);
  const std::string code = value(row, "pdbx_" + partner + "_pdb_ins_code");
  if (!code.empty()) atom.insertion_code = code.front();
  return atom;
}

BondOrder bond_order(std::string_view text) {
  if (text == "sing") return BondOrder::one;
  if (text == "doub") return BondOrder::two;
  return text == "trip" ? BondOrder::three : BondOrder::unknown;
}

}  // namespace

void MmcifBondTable::add(int block, std::string_view tag, std::string_view value) {
  if (!tag.starts_with(kTable)) return;  // the loop mixes tables
  Block& here = blocks_[block];
  const std::string column(tag.substr(kTable.size()));
  if (here.row.contains(column)) take(here);
  here.row.emplace(column, value);
}

void MmcifBondTable::take(Block& block) {
  const Row row = std::move(block.row);
  block.row.clear();
  // The type is "covale", "covale_base" or similar; hydrogen bonds and salt bridges are no bonds
  // here. Both atoms must be of the same asymmetric unit.
  const std::string type = lower_case(value(row, "conn_type_id"));
  const bool covalent = type.starts_with("covale");
  const bool bond = covalent || type == "disulf" || type == "metalc";
  if (!bond || value(row, "ptnr1_symmetry") != value(row, "ptnr2_symmetry")) return;
  NamedBond named{bonded_atom(row, "ptnr1"), bonded_atom(row, "ptnr2"),
                  bond_order(lower_case(value(row, "pdbx_value_order"))), covalent};
  if (type == "disulf") named.order = BondOrder::one;
  block.bonds.add(std::move(named));
}

void MmcifBondTable::finish(int block, RecordedBonds& bonds) {
  const auto found = blocks_.find(block);
  if (found == blocks_.end()) return;
  take(found->second);
  bonds = std::move(found->second.bonds);
}

}  // namespace alphascope
