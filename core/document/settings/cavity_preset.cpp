// SPDX-License-Identifier: GPL-3.0-or-later
// Sets the options of the body that compare with CASTp's, and lists the differences of other
// options.
#include "core/document/settings/cavity_preset.hpp"

#include "core/document/settings/open_options.hpp"
#include "core/document/settings/request.hpp"
#include "core/geometry/shortest_number.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/radii/radii_set.hpp"
#include "core/selection/provenance.hpp"

namespace alphascope {

BallOptions cavity_body(const BallOptions& options, bool file_has_radii) {
  BallOptions body;
  body.radii = file_has_radii ? RadiiSet::file : RadiiSet::castp;
  body.user_radii = options.user_radii;  // copied so that the table is read only once; it is not
                                         // used here
  body.ligands = false;
  body.ions = false;
  body.treated = options.treated;
  return body;
}

void use_cavity_preset(OpenOptions& open, Request& request, bool file_has_radii) {
  open.balls = cavity_body(open.balls, file_has_radii);
  request.alpha_angstrom2 = 0;
  request.solvent_radius_angstrom = kCavitySolventAngstrom;
}

std::vector<std::string> differences_from_castp(const BallOptions& balls,
                                                const SelectionReport& report,
                                                const Request& request) {
  std::vector<std::string> differences;
  const auto add = [&](bool differs, const std::string& text) {
    if (differs) differences.push_back(text);
  };
  add(report.radii != RadiiSet::castp, "radii " + std::string(radii_set_info(report.radii).name));
  add(!balls.treated.empty(), "kinds of residues are set by hand");
  add(report.guessed_residues > 0,
      report.guessed_residues == 1
          ? "the kind of 1 residue is guessed"
          : "the kinds of " + std::to_string(report.guessed_residues) + " residues are guessed");
  add(!balls.overrides.empty(), "radii changed by hand");
  add(balls.hydrogens == HydrogenRule::keep, "hydrogens are in the body");
  add(balls.waters, "waters are in the body");
  add(balls.ions, "ions are in the body");
  add(balls.ligands, "ligands are in the body");
  add(balls.dummies, "dummy atoms are in the body");
  add(!balls.polymers, "proteins and nucleic acids are left out");
  add(balls.altlocs == AltlocRule::all, "all alternative locations");
  add(balls.model == kAllModels, "all models as one");
  add(balls.model > 0, "model " + model_text(balls.model));
  add(!balls.chains.empty() || !balls.without_chains.empty(), "not all chains");
  add(!balls.selection.empty(), "a selection of atoms");
  add(request.solvent_radius_angstrom != kCavitySolventAngstrom,
      "solvent radius " + shortest_number(request.solvent_radius_angstrom) + " Å instead of 1.4 Å");
  add(request.alpha_angstrom2 != 0,
      "alpha " + shortest_number(request.alpha_angstrom2) + " Å² instead of 0 Å²");
  return differences;
}

}  // namespace alphascope
