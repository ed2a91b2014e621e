// SPDX-License-Identifier: GPL-3.0-or-later
// Names of surfaces, and the groups for which areas and volumes are listed.
#pragma once

#include <cstdint>
#include <string>

namespace alphascope {

struct Request;

// Groups for which areas and volumes are listed. The order is that of the command line's --per.
enum class MeasureGrouping : std::uint8_t { all, atom, residue, chain, component };

// Name of the surface of all balls at this alpha and solvent radius: "van der Waals surface",
// "solvent-accessible surface, probe of 1.4 Å", "surface of balls with radii sqrt((r + 1.4)² + 5)".
// The first two names are correct if the radii are those of atoms.
std::string surface_name(const Request& request);

}  // namespace alphascope
