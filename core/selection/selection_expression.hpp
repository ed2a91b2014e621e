// A small language that picks atoms, with the words of other programs:
//   chain A,B     resi 10-20,35,-3,12A     resn ALA,G*     name CA,C?     element C,Zn     altloc A
//   residue HEM   residue 10-20            index 12,20-30  copy 2         b > 40  occupancy < 1
//   protein nucleic polymer backbone sidechain water ligand ion hydrogen hetero all none
//   selected  hidden
//   within 5 of X      byres X      bychain X      not X      X and Y      X or Y      ( … )
// "not", "within … of", "byres" and "bychain" take the next word or parenthesis; then comes "and",
// then "or". Words may be in any case ("!", "&", "|" and some words of PyMOL are understood too),
// names are compared as they are in the file; * and ? stand for any characters; names with blanks
// go into double quotes. A residue number without a letter means all its insertion codes. Atoms are
// counted from 1 in the file (index), and copies from 1 in the assembly.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/molecule/molecule.hpp"
#include "core/text/printable.hpp"

namespace alphascope {

// what() is the complete sentence, printable: "column 7: expected … after \"chain\"".
class SelectionError : public std::invalid_argument {
 public:
  SelectionError(std::size_t column, const std::string& reason)
      : std::invalid_argument("column " + std::to_string(column) + ": " + printable(reason)),
        column_(column) {}
  std::size_t column() const { return column_; }  // in the expression, from 1

 private:
  std::size_t column_;
};

// What "selected" and "hidden" mean: one value an atom of the molecule. Null: no picture is there
// that could say it, and the word is refused.
struct PictureAtoms {
  const std::vector<bool>* selected = nullptr;
  const std::vector<bool>* hidden = nullptr;
};

// Why an expression cannot be understood where there is no picture; nothing when it can.
std::optional<SelectionError> fault_of_selection(std::string_view text);

struct SelectionNode;

class SelectionExpression {
 public:
  // Throws SelectionError. A blank expression selects all.
  static SelectionExpression parse(std::string_view text);

  // The expression for one molecule, its names looked up once and its zones found; the molecule
  // must stay alive.
  class Bound {
   public:
    bool operator()(const Atom& atom) const;  // one of the molecule's atoms itself, no copy

   private:
    friend class SelectionExpression;
    struct Node;
    std::shared_ptr<const std::vector<Node>> nodes_;
    const Molecule* molecule_ = nullptr;
  };
  // Distances are compared exactly, between atoms of one model: the models of a file lie in the
  // same place. About 0.3 s for a zone in a million atoms, else a few milliseconds. Throws
  // SelectionError for words that `picture` does not explain.
  Bound bind(const Molecule& molecule, const PictureAtoms& picture = {}) const;

 private:
  using Program = std::vector<SelectionNode>;
  struct Binder;
  std::shared_ptr<const Program> program_;  // null: all
};

}  // namespace alphascope
