// SPDX-License-Identifier: GPL-3.0-or-later
// Decides what column 21 of a PDB file is. It is the fourth letter of a residue name (CHARMM), or
// the first of two letters of a chain (big structures). One line does not show it, so the whole
// file is read.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace alphascope {

class PdbChainColumns {
 public:
  explicit PdbChainColumns(std::string_view text) : text_(text) {}

  // The chain of a line: no letter, one or two.
  std::string_view chain_of(std::string_view line);

  // True when chains of two letters were found; for a note.
  bool found_chains() const { return !chains_.empty(); }

 private:
  // True when both letters in columns 21 and 22 of the line belong to the chain. They do if
  // standard residues of the file have this pair of letters. In a file with any such pair, the two
  // letters of other residues belong to the chain as well, unless some residue of the file has a
  // name of four letters.
  bool is_chain(std::string_view line);
  void look_at_file();

  std::string_view text_;
  bool looked_ = false, four_letters_ = false;
  std::map<std::string, std::set<std::string>, std::less<>> chains_;  // standard residues by pair
};

}  // namespace alphascope
