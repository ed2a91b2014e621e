// The parts of the window that are not in panel_list.hpp. Each draws from the state and writes
// controls and requests into it.
#pragma once

#include "ui/widgets/widgets.hpp"

namespace alphascope {

struct MoleculeMemory;  // molecule_memory.hpp

void draw_menu_bar(PanelContext& ctx);
// As the menu runs it: a failure is told; a refusal is a line in the status bar, but no news where
// the menu greys the command already.
void run_command(PanelContext& ctx, const CommandSpec& spec,
                 const std::vector<std::string>& words = {});
void draw_status_bar(PanelContext& ctx);
void draw_viewport(PanelContext& ctx);
// Over its picture, once that is drawn: words would lag behind a picture that turns.
void draw_view_labels(PanelContext& ctx);

// Of the right mouse button, in the view.
void draw_context_menu(PanelContext& ctx);

// Parts of the molecule panel: where the atoms come from, which are used, how large they are.
void draw_source_rows(PanelContext& ctx);  // assembly and models
void draw_selection_rows(PanelContext& ctx, MoleculeMemory& memory);
void draw_radii_rows(PanelContext& ctx, MoleculeMemory& memory);
void draw_residue_rows(PanelContext& ctx,
                       MoleculeMemory& memory);  // what each residue was taken for
void draw_provenance(PanelContext& ctx);

// What is in the view, in one line: molecule, alpha, and why there is nothing of the complex.
std::string caption_text(const Answer& answer);
std::string hidden_text(std::size_t atoms);  // "1,234 atoms hidden"

// Measured distances and angles: buttons in the present line, and the list below.
void draw_measured_list(PanelContext& ctx);

// Stages as bars, one below the other on one time axis, of both engines.
void draw_waterfall(PanelContext& ctx, bool cold, float height);

}  // namespace alphascope
