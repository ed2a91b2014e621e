// See the header.
#include "ui/panels/panel_list.hpp"

namespace alphascope {

// Each is defined in the source of its name, and called from here only.
void draw_molecule_panel(PanelContext& ctx);
void draw_alpha_panel(PanelContext& ctx);
void draw_display_panel(PanelContext& ctx);
void draw_look_panel(PanelContext& ctx);  // in display_panel.cpp
void draw_clip_panel(PanelContext& ctx);
void draw_engine_panel(PanelContext& ctx);
void draw_timings_panel(PanelContext& ctx);
void draw_cavities_panel(PanelContext& ctx);
void draw_channels_panel(PanelContext& ctx);
void draw_measures_panel(PanelContext& ctx);
void draw_curves_panel(PanelContext& ctx);
void draw_signature_panel(PanelContext& ctx);
void draw_why_panel(PanelContext& ctx);
void draw_steps_panel(PanelContext& ctx);
void draw_sandbox_panel(PanelContext& ctx);
void draw_details_panel(PanelContext& ctx);
void draw_lessons_panel(PanelContext& ctx);

namespace {

constexpr PanelSpec kPanels[] = {
    {"molecule", "Molecule", Place::left, draw_molecule_panel,
     "radii set radius hydrogens altloc chains only expression filter assembly biological units"},
    {"alpha", "Alpha", Place::left, draw_alpha_panel},
    {"display", "Display", Place::left, draw_display_panel, "colours opacity size"},
    {"look", "Light", Place::left, draw_look_panel, "shadows lines fog quality"},
    {"clip", "Clip", Place::left, draw_clip_panel},
    {"engine", "Engine", Place::left, draw_engine_panel, "GPU CPU threads"},
    {"timings", "Timings", Place::bottom, draw_timings_panel, "time speed stages"},
    {"cavities", "Cavities", Place::bottom, draw_cavities_panel, "cavity pocket void hole"},
    {"channels", "Channels", Place::bottom, draw_channels_panel, "tunnel pore"},
    {"measures", "Measures", Place::bottom, draw_measures_panel, "volume area surface"},
    {"curves", "Curves", Place::bottom, draw_curves_panel, "chart Betti lives"},
    {"signature", "Signature", Place::bottom, draw_signature_panel},
    {"why", "Why?", Place::bottom, draw_why_panel, "explain reason"},
    {"steps", "Steps", Place::bottom, draw_steps_panel, "algorithm"},
    {"sandbox", "Sandbox", Place::bottom, draw_sandbox_panel},
    {"details", "Details", Place::bottom, draw_details_panel, "label distance angle"},
    {"lessons", "Lessons", Place::right, draw_lessons_panel},
};

}  // namespace

std::span<const PanelSpec> panels() {
  return kPanels;
}

}  // namespace alphascope
