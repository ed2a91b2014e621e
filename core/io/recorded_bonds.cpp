// See the header.
#include "core/io/recorded_bonds.hpp"

#include "core/io/line_reader.hpp"
#include "core/io/pdb_numbers.hpp"
#include "core/io/pdb_records.hpp"

namespace alphascope {
namespace {

// From the column on in which the atom's name begins; LINK has two of them.
BondedAtom linked_atom(std::string_view line, std::size_t first) {
  BondedAtom atom;
  atom.name = trimmed(columns(line, first, first + 3));
  atom.chain = trimmed(columns(line, first + 9, first + 9));
  atom.residue_number = parse_pdb_number(columns(line, first + 10, first + 13), 4);
  const std::string_view code = columns(line, first + 14, first + 14);
  if (!code.empty()) atom.insertion_code = code.front();
  return atom;
}

}  // namespace

void RecordedBonds::take_link(std::string_view line) {
  if (trimmed(columns(line, 60, 65)) != trimmed(columns(line, 67, 72))) return;
  add(linked_atom(line, 13), linked_atom(line, 43));
}

void RecordedBonds::take_conect(std::string_view line) {
  constexpr std::size_t kWidth = 5;
  const std::int32_t atom = parse_pdb_number(columns(line, 7, 11), kWidth);
  for (std::size_t first = 12; first <= 27; first += kWidth) {
    add(atom, parse_pdb_number(columns(line, first, first + kWidth - 1), kWidth));
  }
}

}  // namespace alphascope
