// The parts of the window that are not in panel_list.hpp. Each draws from the state and writes
// controls and requests into it.
#pragma once

#include "ui/panels/widgets.hpp"

namespace alphascope {

void draw_menu_bar(PanelContext& ctx);
void draw_status_bar(PanelContext& ctx);
void draw_viewport(PanelContext& ctx);
// Over its picture, once that is drawn: words would lag behind a picture that turns.
void draw_view_labels(PanelContext& ctx);

// Parts of the molecule panel: where the atoms come from, which are used, how large they are.
void draw_source_rows(PanelContext& ctx);  // assembly and models
void draw_selection_rows(PanelContext& ctx);
void draw_radii_rows(PanelContext& ctx);
void draw_provenance(PanelContext& ctx);

// What is in the view, in one line: molecule, alpha, and why there is nothing of the complex.
std::string caption_text(const Answer& answer);
std::string hidden_text(std::size_t atoms);  // "1,234 atoms hidden"

// Stages as bars, one below the other on one time axis, of both engines.
void draw_waterfall(PanelContext& ctx, float height);

}  // namespace alphascope
