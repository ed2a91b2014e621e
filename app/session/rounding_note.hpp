// SPDX-License-Identifier: GPL-3.0-or-later
// Notes on typed numbers that the lattice has rounded.
#pragma once

#include <string>

#include "core/document/settings/request.hpp"
#include "core/geometry/ball_set.hpp"

namespace alphascope {

// Rounding error (Å) of the request's solvent radius on the lattice of the computation.
double solvent_rounding_angstrom(const Request& request, const Lattice& lattice);

// A sentence if the solvent radius was rounded; otherwise empty. Alpha is never rounded.
std::string rounding_note(const Request& request, const Lattice& lattice);

}  // namespace alphascope
