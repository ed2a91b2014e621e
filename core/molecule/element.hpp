// SPDX-License-Identifier: GPL-3.0-or-later
// Chemical elements as atomic numbers. Radii are in radii_set.hpp.
#pragma once

#include <cstdint>
#include <string_view>

namespace alphascope {

// Atomic number; 0 if the element is unknown. Deuterium and tritium count as hydrogen.
using Element = std::uint8_t;

inline constexpr Element kUnknownElement = 0;
inline constexpr Element kHydrogen = 1;
inline constexpr Element kHeaviestElement = 118;

// "C", "Zn"; "X" for kUnknownElement and for numbers above kHeaviestElement.
std::string_view element_symbol(Element element);

// The element of a symbol in any case, without blanks; kUnknownElement for any other text.
Element element_from_symbol(std::string_view symbol);

// Metals without metalloids: elements that form cations and stand alone in their residue.
bool is_metal(Element element);
// F, Cl, Br and I, which form halide ions.
bool is_halogen(Element element);

}  // namespace alphascope
