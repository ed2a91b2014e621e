// SPDX-License-Identifier: GPL-3.0-or-later
// Names the settings that differ, for "Undo" and "Redo".
#include "core/document/settings/settings.hpp"

#include <vector>

#include "core/document/settings/display_fields.hpp"

namespace alphascope {
namespace {

bool same_radii(const OpenOptions& a, const OpenOptions& b) {
  return a.balls.radii == b.balls.radii && a.balls.user_radii == b.balls.user_radii &&
         a.radii_table == b.radii_table && a.balls.overrides == b.balls.overrides;
}

// Whether all else is equal: everything but radii, assembly, model and balls set by hand.
bool same_atoms(OpenOptions a, const OpenOptions& b) {
  a.balls.radii = b.balls.radii;
  a.balls.user_radii = b.balls.user_radii;
  a.balls.overrides = b.balls.overrides;
  a.balls.model = b.balls.model;
  a.radii_table = b.radii_table;
  a.assembly = b.assembly;
  a.sandbox = b.sandbox;
  return a == b;
}

}  // namespace

std::string difference_text(const Settings& a, const Settings& b) {
  std::vector<const char*> parts;
  const auto note = [&parts](bool same, const char* what) {
    if (!same) parts.push_back(what);
  };
  const Request &r = a.request, &q = b.request;
  note(r.alpha_angstrom2 == q.alpha_angstrom2, "alpha");
  note(r.solvent_radius_angstrom == q.solvent_radius_angstrom, "solvent radius");
  note(r.tetrahedra_only == q.tetrahedra_only, "tetrahedra only");
  note(same_engine(r, q), "engine");
  note(a.open.assembly == b.open.assembly, "assembly");
  note(a.open.balls.model == b.open.balls.model, "model");
  note(same_radii(a.open, b.open), "radii");
  note(same_atoms(a.open, b.open), "choice of atoms");
  note(a.open.sandbox == b.open.sandbox, "balls");
  const std::string display = difference_of(a.display, b.display);
  note(display.empty(), display.c_str());
  note(a.objects == b.objects, "objects");
  note(a.clip == b.clip, "clip");
  note(a.clips == b.clips, "saved clips");
  note(a.views == b.views, "saved cameras");
  note(a.appearance.hidden == b.appearance.hidden, "hidden atoms");
  note(a.appearance.colours == b.appearance.colours, "colours of atoms");
  note(a.annotations.labels == b.annotations.labels, "labels");
  note(a.annotations.measurements == b.annotations.measurements, "measured distances and angles");
  note(a.annotations.marks == b.annotations.marks &&
           a.annotations.power_diagram == b.annotations.power_diagram,
       "marks");
  note(a.selection == b.selection, "selection");
  note(a.cavity_settings == b.cavity_settings, "networks of cavities");
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text += i + 1 == parts.size() ? " and " : ", ";
    text += parts[i];
  }
  return text;
}

}  // namespace alphascope
