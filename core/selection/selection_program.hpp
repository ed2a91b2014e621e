// A selection expression as it is carried out: the parser writes it, SelectionExpression runs it.
// For these two only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/molecule/element.hpp"

namespace alphascope {

enum class SelectionTest : std::uint8_t {
  all,
  none,
  chain,
  residue,  // by number or by name
  atom_name,
  element,
  altloc,
  index,
  copy,
  b_factor,
  occupancy,
  polymer,
  protein,
  nucleic,
  backbone,
  sidechain,
  water,
  ligand,
  ion,
  hydrogen,
  hetero,
  selected,
  hidden,
  within,
  by_residue,
  by_chain,
  negation,       // of the value so far
  jump_if_false,  // behind the left side of "and": to the end of the chain
  jump_if_true    // behind the left side of "or"
};

enum class NumberTest : std::uint8_t { less, at_most, equal, at_least, greater };

// A program with one value, run from the first node to the last: tests set it, negation turns it,
// jumps skip what cannot change it any more. So no expression, however long, needs a deep stack.
struct SelectionNode {
  struct Range {
    std::int32_t first, last;
    char insertion_code;  // ' ' = any
  };
  SelectionTest test = SelectionTest::all;
  std::size_t column = 1;  // of its word, from 1
  std::vector<std::string> names = {};
  std::vector<Range> ranges = {};
  std::vector<Element> elements = {};
  NumberTest comparison = NumberTest::equal;
  float number = 0;  // b_factor (Å²), occupancy; as files are read, in one precision
  std::int64_t microangstrom = 0;                                // within
  std::shared_ptr<const std::vector<SelectionNode>> inner = {};  // of within, by_residue, by_chain
  std::size_t target = 0;  // of a jump: the node to go on with
};

using SelectionProgram = std::vector<SelectionNode>;

// Throws SelectionError.
SelectionProgram parse_selection(std::string_view text);

}  // namespace alphascope
