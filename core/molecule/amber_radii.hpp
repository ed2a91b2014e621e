// AMBER's van der Waals radii R* (parm99) of protein and nucleic acid atoms, for RadiiSet::amber.
#pragma once

#include <string_view>

#include "core/molecule/element.hpp"

namespace alphascope {

// 10^-3 Å; 0 when AMBER has no value for the element.
int amber_radius_milliangstrom(std::string_view residue, std::string_view atom, Element element);

}  // namespace alphascope
