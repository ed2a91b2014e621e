// Sets of van der Waals radii (Å) by element, each with its source.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/molecule/element.hpp"

namespace alphascope {

// automatic = the file's own radii when it has any, else Bondi.
enum class RadiiSet : std::uint8_t { automatic, file, bondi };

struct RadiiSetInfo {
  std::string_view id;    // "bondi": for the command line and for session files
  std::string_view name;  // "Bondi"
  std::string_view citation;
};

const RadiiSetInfo& radii_set_info(RadiiSet set);

// What an atom of unknown element gets.
inline constexpr int kUnknownRadiusMilliangstrom = 1800;

struct AssignedRadius {
  int milliangstrom = kUnknownRadiusMilliangstrom;
  bool guessed = true;  // the set has no value: another set's value for the element, or a default
};

// Radius of an element in a table by element (not for automatic and file).
AssignedRadius element_radius(RadiiSet set, Element element);

}  // namespace alphascope
