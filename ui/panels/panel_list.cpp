// SPDX-License-Identifier: GPL-3.0-or-later
// The list of all panels, in the order in which the window shows them.
#include "ui/panels/panel_list.hpp"

#include <stdexcept>
#include <string>

namespace alphascope {

// A panel's source has the name of its function, if not said otherwise. This file alone calls them.
std::unique_ptr<Panel> molecule_panel();
std::unique_ptr<Panel> alpha_panel();
std::unique_ptr<Panel> objects_panel();
std::unique_ptr<Panel> display_panel();
std::unique_ptr<Panel> look_panel();  // in display_panel.cpp
std::unique_ptr<Panel> clip_panel();
std::unique_ptr<Panel> engine_panel();
std::unique_ptr<Panel> timings_panel();
std::unique_ptr<Panel> cavities_panel();
std::unique_ptr<Panel> channels_panel();
std::unique_ptr<Panel> structure_panel();
std::unique_ptr<Panel> measures_panel();
std::unique_ptr<Panel> contacts_panel();
std::unique_ptr<Panel> curves_panel();
std::unique_ptr<Panel> signature_panel();
std::unique_ptr<Panel> why_panel();
std::unique_ptr<Panel> steps_panel();
std::unique_ptr<Panel> sandbox_panel();
std::unique_ptr<Panel> details_panel();
std::unique_ptr<Panel> lessons_panel();
std::unique_ptr<Panel> guide_panel();
std::unique_ptr<Panel> tasks_panel();

namespace {

constexpr PanelSpec kPanels[] = {
    {kPinnedSection, "Alpha", PanelPlace::left, alpha_panel},
    {"molecule", "Molecule", PanelPlace::left, molecule_panel,
     "radii set radius hydrogens altloc chains only expression filter assembly biological units"},
    {"objects", "Objects", PanelPlace::left, objects_panel,
     "cartoon ribbon sticks ball-and-stick points representation ligand eye opacity"},
    {"display", "Display", PanelPlace::left, display_panel, "colours opacity size"},
    {"look", "Light", PanelPlace::left, look_panel, "shadows lines fog quality"},
    {"clip", "Clip", PanelPlace::left, clip_panel},
    {"engine", "Engine", PanelPlace::left, engine_panel, "GPU CPU threads"},
    {"timings", "Timings", PanelPlace::bottom, timings_panel, "time speed stages"},
    {"cavities", "Cavities", PanelPlace::bottom, cavities_panel, "cavity pocket void hole"},
    {"channels", "Channels", PanelPlace::bottom, channels_panel, "tunnel pore"},
    {"structure", "Structure", PanelPlace::bottom, structure_panel,
     "tree sequence chains residues ligands"},
    {"measures", "Measures", PanelPlace::bottom, measures_panel, "volume area surface"},
    {"contacts", "Contacts", PanelPlace::bottom, contacts_panel, "interface chains touch"},
    {"curves", "Curves", PanelPlace::bottom, curves_panel, "chart Betti lives"},
    {"signature", "Signature", PanelPlace::bottom, signature_panel},
    {"why", "Why?", PanelPlace::bottom, why_panel, "explain reason"},
    {"steps", "Steps", PanelPlace::bottom, steps_panel, "algorithm"},
    {"sandbox", "Sandbox", PanelPlace::bottom, sandbox_panel},
    {"details", "Details", PanelPlace::bottom, details_panel, "label distance angle"},
    {"lessons", "Lessons", PanelPlace::right, lessons_panel},
    {"guide", "User guide", PanelPlace::over, guide_panel},
    {"tasks", "Tasks", PanelPlace::over, tasks_panel},
};

}  // namespace

std::span<const PanelSpec> panels() {
  return kPanels;
}

PanelSet::PanelSet() {
  for (const PanelSpec& spec : kPanels) panels_.push_back(spec.make());
}

void PanelSet::add_commands(Commands& commands, ViewState& state) {
  for (const auto& panel : panels_) panel->add_commands(commands, state);
}

Panel& PanelSet::of(std::string_view id) {
  for (std::size_t k = 0; k < panels_.size(); ++k) {
    if (kPanels[k].id == id) return *panels_[k];
  }
  throw std::logic_error("No panel is called " + std::string(id) + ".");
}

}  // namespace alphascope
