// SPDX-License-Identifier: GPL-3.0-or-later
// Collects rows of struct_conn and chem_comp_bond, and keeps the bonds.
#include "core/read/mmcif/mmcif_bonds.hpp"

#include <charconv>
#include <utility>

#include "core/read/mmcif/mmcif_row.hpp"
#include "core/text/letter_case.hpp"

namespace alphascope {
namespace {

// partner: "ptnr1" or "ptnr2". Takes the author's names where they are given, as for atoms.
BondedAtom bonded_atom(const MmcifRow& row, const std::string& partner) {
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
  if (text == "arom" || text == "delo") return BondOrder::aromatic;
  return text == "trip" ? BondOrder::three : BondOrder::unknown;
}

}  // namespace

void MmcifBondTable::add(int block, std::string_view tag, std::string_view value) {
  if (!wants(tag)) return;  // the loop mixes tables
  Block& here = blocks_[block];
  const bool component = tag.starts_with(kComponents);
  const std::string column(tag.substr(component ? kComponents.size() : kTable.size()));
  Row& row = component ? here.component_row : here.row;
  if (row.contains(column)) component ? take_component(here) : take(here);
  row.emplace(column, value);
}

void MmcifBondTable::take_component(Block& block) {
  const MmcifRow row = std::move(block.component_row);
  block.component_row.clear();
  ComponentBond bond{value(row, "comp_id"), value(row, "atom_id_1"), value(row, "atom_id_2"),
                     bond_order(lower_case(value(row, "value_order")))};
  if (lower_case(value(row, "pdbx_aromatic_flag")) == "y") bond.order = BondOrder::aromatic;
  if (!bond.residue.empty() && !bond.a.empty() && !bond.b.empty()) block.bonds.add(std::move(bond));
}

void MmcifBondTable::take(Block& block) {
  const MmcifRow row = std::move(block.row);
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
  take_component(found->second);
  bonds = std::move(found->second.bonds);
}

}  // namespace alphascope
