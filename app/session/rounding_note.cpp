// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the typed solvent radius with that on the lattice.
#include "app/session/rounding_note.hpp"

#include <cmath>
#include <cstdio>

#include "core/geometry/lattice_alpha.hpp"

namespace alphascope {
namespace {

std::string text_of(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", number);
  return text;
}

}  // namespace

double solvent_rounding_angstrom(const Request& request, const Lattice& lattice) {
  const double asked = request.solvent_radius_angstrom;
  if (lattice.holds(asked)) return 0;
  // Rounds to 12 decimals: 1.4 - 1 as a double has wrong last digits.
  return std::round(std::fabs(solvent_on_lattice(lattice, asked) - asked) * 1e12) / 1e12;
}

std::string rounding_note(const Request& request, const Lattice& lattice) {
  std::string text;
  const std::string unit = text_of(lattice.unit_angstrom()) + " Å";
  const double solvent = request.solvent_radius_angstrom;
  if (solvent_rounding_angstrom(request, lattice) > 0) {
    text = "The solvent radius of " + text_of(solvent) + " Å is rounded to " +
           text_of(solvent_on_lattice(lattice, solvent)) +
           " Å: the finest lattice for these balls has units of " + unit + ".";
  }
  return text;
}

}  // namespace alphascope
