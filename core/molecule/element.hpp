// Chemical elements as atomic numbers. Radii are in radii_set.hpp.
#pragma once

#include <cstdint>
#include <string_view>

namespace alphascope {

// Atomic number; 0 when the element is not known. Deuterium and tritium count as hydrogen.
using Element = std::uint8_t;

inline constexpr Element kUnknownElement = 0;
inline constexpr Element kHydrogen = 1;
inline constexpr Element kHeaviestElement = 118;

// "C", "Zn"; "X" for kUnknownElement and for numbers that are no element.
std::string_view element_symbol(Element element);

// The element of a symbol in any case, without blanks around it; kUnknownElement for anything else.
Element element_from_symbol(std::string_view symbol);

// Metals, metalloids excluded: what forms cations and is alone in its residue.
bool is_metal(Element element);
// F, Cl, Br and I: what forms halide ions.
bool is_halogen(Element element);

}  // namespace alphascope
