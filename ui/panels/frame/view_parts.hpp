// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the 3-D view, for its own sources only. `corner` and `size` of the view are in pixels,
// as are heights from its top.
#pragma once

#include <imgui.h>

namespace alphascope {

struct PanelContext;

// --- view_mouse.cpp

// Collects the events of the mouse for the renderer.
void take_view_mouse(PanelContext& ctx, ImVec2 corner, ImVec2 size);

// --- view_caption.cpp

// Writes the complex on screen, and the pending one, at the top left.
void draw_view_caption(PanelContext& ctx, ImVec2 corner, ImVec2 size);

// --- view_notes.cpp

// Says that atoms are hidden, since the picture lacks them. The note is below the caption and the
// pending complex, and below `top` (pixels of the view). Returns the y of its lower end.
float hidden_note(PanelContext& ctx, ImVec2 corner, float top);
// Explains a view that shows nothing, which would look broken. Placed below `top`, pixels of the
// view.
void view_problem_note(PanelContext& ctx, ImVec2 corner, ImVec2 size, float top);
// Names the opened one of several dropped files, above the legends.
void drop_note(PanelContext& ctx, ImVec2 corner, ImVec2 size, float legends_height);
// Says below the caption that the picture belongs to older settings.
void outdated_note(PanelContext& ctx, ImVec2 corner);
// Shows why alpha has no complex, in the place of outdated_note(). The two never meet, since an
// older picture means that a newer computation runs. Returns the y of its lower end, pixels of the
// view.
float compute_error_note(PanelContext& ctx, ImVec2 corner, ImVec2 size);
// Says which parts are missing from the picture for lack of memory.
void not_drawn_note(PanelContext& ctx, ImVec2 corner, ImVec2 size, float legends_height);

// Says that the selection left no atom. Returns whether it does.
bool no_atoms_note(PanelContext& ctx, ImVec2 corner, ImVec2 size);

// --- start_page.cpp

// Offers ways to begin while no molecule is open.
void draw_start_page(PanelContext& ctx, ImVec2 corner, ImVec2 size);

}  // namespace alphascope
