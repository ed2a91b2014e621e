// SPDX-License-Identifier: GPL-3.0-or-later
// The program of a selection expression. The parser writes it and SelectionExpression runs it. No
// other code needs it.
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
  negation,       // negates the value so far
  jump_if_false,  // after the left side of "and": jumps to the end of the chain
  jump_if_true    // after the left side of "or"
};

enum class NumberTest : std::uint8_t { less, at_most, equal, at_least, greater };

// A program with one value, run from the first node to the last. Tests set the value, negation
// inverts it, and jumps skip nodes that cannot change it any more. So even a very long expression
// needs no deep stack.
struct SelectionNode {
  struct Range {
    std::int32_t first, last;
    char insertion_code;  // ' ': any
  };
  SelectionTest test = SelectionTest::all;
  std::size_t column = 1;  // column of its word, from 1
  std::vector<std::string> names = {};
  std::vector<Range> ranges = {};
  std::vector<Element> elements = {};
  NumberTest comparison = NumberTest::equal;
  float number = 0;                // for b_factor (Å²) and occupancy; float, as read from files
  std::int64_t microangstrom = 0;  // for within
  std::shared_ptr<const std::vector<SelectionNode>> inner = {};  // for within, by_residue, by_chain
  std::size_t target = 0;                                        // for a jump: the next node
};

using SelectionProgram = std::vector<SelectionNode>;

// Throws SelectionError.
SelectionProgram parse_selection(std::string_view text);

}  // namespace alphascope
