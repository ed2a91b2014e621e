// SPDX-License-Identifier: GPL-3.0-or-later
// Tables with one number per element, written as lists of elements and numbers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/molecule/element.hpp"

namespace alphascope {

using ElementTable = std::array<std::int16_t, kHeaviestElement + 1>;  // 10^-3 Å; 0: no value

struct ElementEntry {
  Element element;
  std::int16_t milliangstrom;
};

template <std::size_t N>
constexpr ElementTable make_element_table(const ElementEntry (&entries)[N]) {
  ElementTable table{};
  for (const ElementEntry& e : entries) table[e.element] = e.milliangstrom;
  return table;
}

}  // namespace alphascope
