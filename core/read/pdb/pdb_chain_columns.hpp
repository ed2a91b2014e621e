// What column 21 of a PDB file is: the fourth letter of a residue name (CHARMM), or the first of
// two of a chain (big structures). One line does not tell, so the whole file is looked at.
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

  // The chain of a line: one letter, two or none.
  std::string_view chain_of(std::string_view line);

  // Whether lines were read so; for a note.
  bool found_chains() const { return !chains_.empty(); }

 private:
  // Of a line with letters in columns 21 and 22: whether both are of the chain. That is so for a
  // pair of letters beside which standard residues stand, and in a file with such pairs for any
  // other residue, if no residue of the file shows a name of four letters.
  bool is_chain(std::string_view line);
  void look_at_file();

  std::string_view text_;
  bool looked_ = false, four_letters_ = false;
  std::map<std::string, std::set<std::string>, std::less<>> chains_;  // with standard residues
};

}  // namespace alphascope
