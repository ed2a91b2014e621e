// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the window that are not in panel_list.hpp. Each draws from the state, and writes
// settings and requests into it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace alphascope {

struct Answer;
struct CommandSpec;
struct PanelContext;

struct MoleculeState;  // molecule_state.hpp

void draw_menu_bar(PanelContext& ctx);
// Runs a command as the menu does. A failure opens a dialog. If the command refuses its arguments,
// the status bar says why. A command that is greyed in the menu does nothing.
void run_command(PanelContext& ctx, const CommandSpec& spec,
                 const std::vector<std::string>& words = {});
void draw_status_bar(PanelContext& ctx);
void draw_viewport(PanelContext& ctx);
// Draws labels in the view, after its picture. Before it they would lag behind a turning picture.
void draw_view_labels(PanelContext& ctx);

// The menu that the right mouse button opens in the view.
void draw_context_menu(PanelContext& ctx);

// Parts of the molecule panel: the origin of the atoms, their selection, and their radii.
void draw_source_rows(PanelContext& ctx);  // assembly and models
void draw_selection_rows(PanelContext& ctx, MoleculeState& memory);
void draw_radii_rows(PanelContext& ctx, MoleculeState& memory);
void draw_residue_rows(PanelContext& ctx,
                       MoleculeState& memory);  // the kind of each residue
void draw_provenance(PanelContext& ctx);

// Describes the complex in one line: molecule, alpha and, if there are no tetrahedra, why.
std::string caption_text(const Answer& answer);
std::string hidden_text(std::size_t atoms);  // "1,234 atoms hidden"

// Measured distances and angles: buttons in the present line, and a list below it.
void draw_measured_list(PanelContext& ctx);

// Stages of both engines as bars, one below the other on one time axis.
void draw_waterfall(PanelContext& ctx, bool cold, float height);

}  // namespace alphascope
