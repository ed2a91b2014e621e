// What the lattice made of the numbers that a user typed.
#pragma once

#include <string>

#include "core/document/request.hpp"
#include "core/geometry/ball_set.hpp"

namespace alphascope {

// By how much (Å) the solvent radius of a request is rounded on the lattice that was computed on.
double solvent_rounding_angstrom(const Request& request, const Lattice& lattice);

// One or two sentences for people where solvent radius or alpha act otherwise than they were typed;
// else empty. Of alpha, changes below a billionth of it are not told: they are noise of the double
// that it is given as, or far below any file's digits.
std::string rounding_note(const Request& request, const Lattice& lattice);

}  // namespace alphascope
