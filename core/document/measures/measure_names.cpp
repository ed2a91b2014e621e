// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the name of a surface from alpha and solvent radius, and has the names of groups.
#include "core/document/measures/measure_names.hpp"

#include "core/document/settings/request.hpp"
#include "core/text/short_number.hpp"

namespace alphascope {

std::string surface_name(const Request& request) {
  const double solvent = request.solvent_radius_angstrom, alpha = request.alpha_angstrom2;
  if (alpha != 0) {
    const std::string radius = solvent == 0 ? "r²" : "(r + " + short_number(solvent) + ")²";
    return "surface of balls with radii sqrt(" + radius + (alpha < 0 ? " - " : " + ") +
           short_number(alpha < 0 ? -alpha : alpha) + ")";
  }
  if (solvent == 0) return "van der Waals surface";
  return "solvent-accessible surface, probe of " + short_number(solvent) + " Å";
}

}  // namespace alphascope
