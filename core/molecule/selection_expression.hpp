// A small language that picks atoms:
//   chain A,B     resi 10-20,35,-3,12A     resn ALA,G*     name CA,C?     element C,Zn     altloc A
//   polymer  water  ligand  ion  hydrogen  hetero  all  none
//   not X    X and Y    X or Y    ( … )
// Words may be in any case ("residue" and "!", "&", "|" are understood too), names are compared as
// they are in the file; * and ? stand for any characters; names with blanks go into double quotes.
// A residue number without a letter means all its insertion codes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/molecule/molecule.hpp"
#include "core/molecule/printable.hpp"

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

// Why an expression cannot be understood; nothing when it can.
std::optional<SelectionError> fault_of_selection(std::string_view text);

class SelectionExpression {
 public:
  // Throws SelectionError. A blank expression selects all.
  static SelectionExpression parse(std::string_view text);

  // The expression for one molecule, its names looked up once; the molecule must stay alive.
  class Bound {
   public:
    bool operator()(const Atom& atom) const;

   private:
    friend class SelectionExpression;
    struct Node;
    std::shared_ptr<const std::vector<Node>> nodes_;
  };
  Bound bind(const Molecule& molecule) const;

 private:
  friend class SelectionParser;
  enum class Kind : std::uint8_t {
    all,
    none,
    chain,
    residue_number,
    residue_name,
    atom_name,
    element,
    altloc,
    polymer,
    water,
    ligand,
    ion,
    hydrogen,
    hetero,
    negation,       // of the value so far
    jump_if_false,  // behind the left side of "and": to the end of the chain
    jump_if_true    // behind the left side of "or"
  };
  struct ResidueRange {
    std::int32_t first, last;
    char insertion_code;  // ' ' = any
  };
  struct Node {
    Kind kind = Kind::all;
    std::vector<std::string> names;
    std::vector<ResidueRange> ranges;
    std::vector<Element> elements;
    std::size_t target = 0;  // of a jump: the node to go on with
  };
  // A program with one value, run from the first node to the last: tests set it, negation turns it,
  // jumps skip what cannot change it any more. So no expression, however long, needs a deep stack.
  std::vector<Node> nodes_;
};

}  // namespace alphascope
