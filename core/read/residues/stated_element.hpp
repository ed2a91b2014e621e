// SPDX-License-Identifier: GPL-3.0-or-later
// The meaning of a file's own element column: a symbol, perhaps with a charge, or something else.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/molecule/element.hpp"

namespace alphascope {

enum class ElementStatement : std::uint8_t {
  none,          // empty
  element,       // "C", "zn", "Zn2+", "O2-", "N1+", "Na+"
  placeholder,   // "X": no known element
  virtual_site,  // "EP", "LP", "VS", "DU": not an atom
  other          // not an element, such as "C12" or "OA"
};

struct StatedElement {
  ElementStatement what = ElementStatement::none;
  Element element = kUnknownElement;
};

// `text` has no blanks around it.
StatedElement stated_element(std::string_view text);

// The element of a symbol with a charge: "Zn2+", "O2-", "Na+", "Fe+3". kUnknownElement for other
// texts.
Element charged_symbol(std::string_view text);

}  // namespace alphascope
