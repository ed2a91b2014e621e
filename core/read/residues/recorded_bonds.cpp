// SPDX-License-Identifier: GPL-3.0-or-later
// Reads LINK and CONECT records of PDB files.
#include "core/read/residues/recorded_bonds.hpp"

#include <algorithm>

#include "core/files/line_reader.hpp"
#include "core/read/pdb/pdb_numbers.hpp"
#include "core/read/pdb/pdb_records.hpp"

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

}  // namespace

void RecordedBonds::take_link(std::string_view line, PdbChainColumns& chain_columns) {
  if (trimmed(columns(line, 60, 65)) != trimmed(columns(line, 67, 72))) return;
  constexpr std::size_t kSecond = 30;
  add(linked_atom(line, 0, chain_columns), linked_atom(line, kSecond, chain_columns));
}

void RecordedBonds::take_conect(std::string_view line) {
  constexpr std::size_t kWidth = 5;
  const std::int32_t atom = parse_pdb_number(columns(line, 7, 11), kWidth);
  for (std::size_t first = 12; first <= 27; first += kWidth) {
    add(atom, parse_pdb_number(columns(line, first, first + kWidth - 1), kWidth));
  }
}

}  // namespace alphascope
