// What the lattice made of the numbers that a user typed.
#pragma once

#include <string>

#include "core/document/settings/request.hpp"
#include "core/geometry/ball_set.hpp"

namespace alphascope {

// By how much (Å) the solvent radius of a request is rounded on the lattice that was computed on.
double solvent_rounding_angstrom(const Request& request, const Lattice& lattice);

// A sentence for people where the solvent radius acts otherwise than it was typed; else empty.
// Alpha is never rounded.
std::string rounding_note(const Request& request, const Lattice& lattice);

}  // namespace alphascope
