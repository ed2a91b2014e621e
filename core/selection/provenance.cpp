// SPDX-License-Identifier: GPL-3.0-or-later
// Collects the provenance of a set of balls as texts.
#include "core/selection/provenance.hpp"
#include "core/files/fetched_file.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/radii/radii_set.hpp"
#include "core/text/printable.hpp"
#include "core/text/short_number.hpp"

#include <algorithm>
#include <cstdio>

namespace alphascope {
namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
  return text;
}

std::string radii_text(const BallOptions& options, const SelectionReport& report) {
  std::string text = report.radii_name;
  if (report.radii == RadiiSet::user && options.user_radii) {
    text += " " + options.user_radii->source;
    if (!options.user_radii->sha256.empty()) text += " (sha256 " + options.user_radii->sha256 + ")";
  }
  for (const GuessedRadius& given : report.overridden) {
    char radius[32];
    // All digits: radii have 10^-6 Å.
    std::snprintf(radius, sizeof radius, "%.8g", given.radius_angstrom);
    text += "; by hand " + given.atoms + " " + radius;
  }
  return text;
}

}  // namespace

std::string lattice_unit_text(const Lattice& lattice) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", std::max(0, lattice.digits), lattice.unit_angstrom());
  return text;
}

std::string model_text(int model) {
  return model == kAllModels ? "joined" : std::to_string(model + 1);
}

std::string options_text(const BallOptions& options) {
  std::string text;
  const auto add = [&](bool given, const std::string& words) {
    if (given) text += (text.empty() ? "--" : " --") + words;
  };
  add(options.hydrogens == HydrogenRule::keep, "hydrogens keep");
  add(options.hydrogens == HydrogenRule::drop, "hydrogens drop");
  add(options.altlocs == AltlocRule::all, "altlocs all");
  add(!options.chains.empty(), "chain " + joined(options.chains));
  add(!options.without_chains.empty(), "without-chain " + joined(options.without_chains));
  add(options.waters, "waters");
  add(options.dummies, "dummies");
  add(!options.ligands, "no-ligands");
  add(!options.ions, "no-ions");
  add(!options.polymers, "no-polymers");
  for (const std::string& treated : options.treated) add(true, "treat '" + treated + "'");
  return text;
}

Provenance provenance(const Molecule& molecule, const BallOptions& options,
                      const SelectionReport& report) {
  const auto from = fetched_from(molecule.source);
  Provenance entries{{"file", molecule.source.string()},
                     {"fetched", from ? from->text() : std::string()},
                     {"sha256", molecule.sha256},
                     {"format", molecule.format},
                     {"model", model_text(options.model)},
                     {"assembly", molecule.assembly_id},
                     {"options", options_text(options)},
                     {"selection_expression", options.selection},
                     {"selection", summary(report)},
                     {"radii", radii_text(options, report)},
                     {"lattice_unit_angstrom", lattice_unit_text(report.lattice)},
                     {"rounding_angstrom", short_number(molecule.rounding_angstrom)},
                     {"radius_rounding_angstrom", short_number(report.radius_rounding_angstrom)}};
  for (auto& [key, value] : entries) value = printable(value);
  return entries;
}

}  // namespace alphascope
