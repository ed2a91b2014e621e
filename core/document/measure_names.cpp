#include "core/document/measure_names.hpp"

#include <cstdio>

namespace alphascope {
namespace {

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace

std::string surface_name(const Request& request) {
  const double solvent = request.solvent_radius_angstrom, alpha = request.alpha_angstrom2;
  if (alpha != 0) {
    const std::string radius = solvent == 0 ? "r²" : "(r + " + number(solvent) + ")²";
    return "surface of balls with radii sqrt(" + radius + (alpha < 0 ? " - " : " + ") +
           number(alpha < 0 ? -alpha : alpha) + ")";
  }
  if (solvent == 0) return "van der Waals surface";
  return "solvent-accessible surface, probe of " + number(solvent) + " Å";
}

}  // namespace alphascope
