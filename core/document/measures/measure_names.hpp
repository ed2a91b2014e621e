// Areas and volumes in words.
#pragma once

#include <cstdint>
#include <string>

#include "core/document/settings/request.hpp"

namespace alphascope {

// What areas and volumes are told of. The order is that of the command line's --per.
enum class MeasuredPer : std::uint8_t { all, atom, residue, chain, component };

// What the surface of all balls is at this alpha and solvent radius: "van der Waals surface",
// "solvent-accessible surface, probe of 1.4 Å", "surface of balls with radii sqrt((r + 1.4)² + 5)".
// The first two are what these words mean when radii are those of atoms.
std::string surface_name(const Request& request);

}  // namespace alphascope
