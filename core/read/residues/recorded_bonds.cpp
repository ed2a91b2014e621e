// SPDX-License-Identifier: GPL-3.0-or-later
// Reads LINK, SSBOND and CONECT records of PDB files.
#include "core/read/residues/recorded_bonds.hpp"

#include <algorithm>

#include "core/read/pdb/pdb_numbers.hpp"
#include "core/read/pdb/pdb_records.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

// LINK names two atoms. Each has the columns of an atom record, `later` columns further right.
BondedAtom linked_atom(std::string_view line, std::size_t later, PdbChainColumns& chain_columns) {
  line.remove_prefix(std::min(later, line.size()));
  BondedAtom atom;
  atom.name = trimmed(columns(line, 13, 16));
  atom.chain = chain_columns.chain_of(line);
  atom.residue_number = parse_pdb_number(columns(line, 23, 26), 4);
  const std::string_view code = columns(line, 27, 27);
  if (!code.empty()) atom.insertion_code = code.front();
  return atom;
}

// The two symmetry operators in columns 60-65 and 67-72.
bool in_one_unit(std::string_view line) {
  return trimmed(columns(line, 60, 65)) == trimmed(columns(line, 67, 72));
}

}  // namespace

void RecordedBonds::take_link(std::string_view line, PdbChainColumns& chain_columns) {
  if (!in_one_unit(line)) return;
  constexpr std::size_t kSecond = 30;
  add({linked_atom(line, 0, chain_columns), linked_atom(line, kSecond, chain_columns)});
}

void RecordedBonds::take_disulphide(std::string_view line, PdbChainColumns& chain_columns) {
  if (!in_one_unit(line)) return;
  // `number` is the column where a residue number begins.
  const auto cysteine = [&](std::size_t number) {
    // PdbChainColumns asks for the columns of an atom: residue name in 18-20, chain in 21-22.
    std::string like_atom(17, ' ');
    like_atom += columns(line, number - 6, number - 2);
    BondedAtom atom;
    atom.name = "SG";
    atom.chain = chain_columns.chain_of(like_atom);
    atom.residue_number = parse_pdb_number(columns(line, number, number + 3), 4);
    const std::string_view code = columns(line, number + 4, number + 4);
    if (!code.empty()) atom.insertion_code = code.front();
    return atom;
  };
  add({cysteine(18), cysteine(32), BondOrder::one, false});
}

void RecordedBonds::take_conect(std::string_view line) {
  constexpr std::size_t kWidth = 5, kPartners = 4;
  const std::int32_t atom = parse_pdb_number(columns(line, 7, 11), kWidth);
  std::int32_t partners[kPartners];
  for (std::size_t k = 0; k < kPartners; ++k) {
    const std::size_t first = 12 + k * kWidth;
    partners[k] = parse_pdb_number(columns(line, first, first + kWidth - 1), kWidth);
  }
  for (std::size_t k = 0; k < kPartners; ++k) {
    if (std::find(partners, partners + k, partners[k]) != partners + k) continue;
    constexpr BondOrder kOrders[] = {BondOrder::unknown, BondOrder::unknown, BondOrder::two,
                                     BondOrder::three, BondOrder::unknown};
    const auto times = std::count(partners + k, partners + kPartners, partners[k]);
    add({atom, partners[k], kOrders[times]});
  }
}

}  // namespace alphascope
