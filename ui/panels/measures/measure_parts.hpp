// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that the sources of the page of areas and volumes share.
#pragma once

namespace alphascope {

class BallReferences;
struct MeasureState;
struct PanelContext;

// Whether the complex on screen, the inputs and the references belong to the same balls.
bool shows_these_balls(const PanelContext& ctx);

// Draws the table of MeasureState::rows. `atoms` is null while the rows do not belong to the
// picture; then clicks do nothing.
void draw_measure_table(PanelContext& ctx, MeasureState& memory, const BallReferences* atoms);

// Draws buttons that copy and save the listed rows.
void measure_save_buttons(PanelContext& ctx, MeasureState& memory);
// Copies the rows as soon as their text is made. To be called while MeasureState::copying is set.
void copy_measures_when_there(PanelContext& ctx, MeasureState& memory);

}  // namespace alphascope
