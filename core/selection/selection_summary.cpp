// SPDX-License-Identifier: GPL-3.0-or-later
// The one-line summary of what was used of a molecule.
#include <cstdio>

#include "core/selection/prepare_balls.hpp"

#include "core/text/grouped_number.hpp"

namespace alphascope {
std::vector<CountedReason> drop_reasons(const SelectionReport& report) {
  // A water without hydrogens is one atom and counted as a water. Otherwise water atoms are
  // counted.
  const bool one_atom_each = report.dropped_water_hydrogens == 0;
  const struct {
    DropReason reason;
    std::size_t count;
    const char *one, *many;
  } all[] = {
      {DropReason::chain, report.dropped_chains, "atom of another chain", "atoms of other chains"},
      {DropReason::selection, report.dropped_selection, "atom not selected", "atoms not selected"},
      {DropReason::dummy, report.dropped_dummies, "dummy atom", "dummy atoms"},
      {DropReason::water, report.dropped_waters, one_atom_each ? "water" : "water atom",
       one_atom_each ? "waters" : "water atoms"},
      {DropReason::ion, report.dropped_ions, "ion", "ions"},
      {DropReason::ligand, report.dropped_ligands, "ligand atom", "ligand atoms"},
      {DropReason::polymer, report.dropped_polymers, "polymer atom", "polymer atoms"},
      {DropReason::hydrogen, report.dropped_hydrogens, "hydrogen", "hydrogens"},
      {DropReason::altloc, report.dropped_altlocs, "alternative location", "alternative locations"},
      {DropReason::zero_radius, report.dropped_zero_radius, "atom of radius 0",
       "atoms of radius 0"},
      {DropReason::without_radius, report.dropped_without_radius, "atom without radius",
       "atoms without radius"},
  };
  std::vector<CountedReason> reasons;
  for (const auto& r : all) {
    if (r.count > 0) reasons.push_back({r.reason, r.count, counted(r.count, r.one, r.many)});
  }
  return reasons;
}

std::string summary(const SelectionReport& report) {
  std::string text =
      "used " + grouped(report.used) + " of " + counted(report.total, "atom", "atoms");
  const char* separator = "; dropped ";
  for (const CountedReason& reason : drop_reasons(report)) {
    text += separator + reason.text;
    separator = ", ";
  }
  text += "; radii " + report.radii_name;
  if (report.guessed_atoms > 0) text += "; " + grouped(report.guessed_atoms) + " guessed";
  if (report.overridden_atoms > 0) {
    text += "; " + grouped(report.overridden_atoms) + " set by hand";
  }
  if (report.rounded_radii > 0) {
    char angstrom[32];
    std::snprintf(angstrom, sizeof angstrom, "%.2g", report.radius_rounding_angstrom);
    text += "; " + counted(report.rounded_radii, "radius", "radii") + " rounded by up to " +
            angstrom + " Å";
  }
  if (report.coincident_centres > 0) {
    text += "; " + counted(report.coincident_centres, "coincident centre", "coincident centres");
  }
  return text;
}

}  // namespace alphascope
