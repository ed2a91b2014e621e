// What a file's own column for elements says: a symbol, perhaps with a charge, or something else.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/molecule/element.hpp"

namespace alphascope {

enum class Statement : std::uint8_t {
  none,          // nothing
  element,       // "C", "zn", "Zn2+", "O2-", "N1+", "Na+"
  placeholder,   // "X": of no known element
  virtual_site,  // "EP", "LP", "VS", "DU": no atom at all
  other          // what is no element, such as "C12" or "OA"
};

struct StatedElement {
  Statement what = Statement::none;
  Element element = kUnknownElement;
};

// Of a text without blanks around it.
StatedElement stated_element(std::string_view text);

// "Zn2+", "O2-", "Na+", "Fe+3": an element with its charge; kUnknownElement for anything else.
Element charged_symbol(std::string_view text);

}  // namespace alphascope
