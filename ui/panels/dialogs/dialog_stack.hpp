// SPDX-License-Identifier: GPL-3.0-or-later
// The stack of dialogs: which are open, and in what order they lie. ImGui replaces a modal window
// by the next one that opens beside it. So each dialog is opened inside the one below it.
#pragma once

#include "ui/widgets/widgets.hpp"

namespace alphascope {

// The contents of a dialog are drawn between begin_dialog() and end_dialog(). If begin_dialog()
// returns false, draw nothing and do not call end_dialog(). `size` is in pixels; {0, 0} fits the
// contents. A dialog placed at the top has no title bar.
enum class DialogPlace : std::uint8_t { centre, top };
bool begin_dialog(PanelContext& ctx, const char* title, ImVec2 size = {0, 0},
                  DialogPlace place = DialogPlace::centre);
void end_dialog(PanelContext& ctx);  // also draws the dialogs above it

// The width that the contents of a dialog can have at most in the window, in pixels.
float dialog_room(const PanelContext& ctx);
// What is drawn between these scrolls if the window is too low for it, so that a row of buttons
// below it stays in the window. `width` is in pixels.
void begin_dialog_body(PanelContext& ctx, float width);
void end_dialog_body();

// Whether the present dialog is the topmost one, which alone gets keys.
bool on_top(const PanelContext& ctx);
// Whether the topmost dialog itself gets the keys. An open list or a field that is typed into takes
// keys first: Escape closes it, and Enter confirms it.
bool has_keys(const PanelContext& ctx);
bool escape_pressed(const PanelContext& ctx);
bool enter_pressed(const PanelContext& ctx);
// Whether Enter has just ended typing in a field of the topmost dialog for a number or a colour.
bool entered_field(const PanelContext& ctx);

// Draws the two buttons of a dialog at the right end of a line of `width` pixels. In every dialog
// cancel is at the left and confirm at the right. Enter confirms and Escape cancels. `entered`:
// Enter was pressed in a field for text. While a number in the dialog is invalid, nothing is
// confirmed.
enum class DialogAnswer : std::uint8_t { none, cancel, confirm };
struct DialogButton {
  const char* name;
  const char* label;
};
DialogAnswer dialog_buttons(PanelContext& ctx, float width, DialogButton cancel,
                            DialogButton confirm, bool can_confirm = true, bool entered = false);
bool close_button(PanelContext& ctx, float width, DialogButton close);

// Draws all dialogs that ViewState asks for. The latest is on top.
void draw_dialogs(PanelContext& ctx);

// The dialogs, each in a source of its own or in dialogs.cpp and session_dialogs.cpp.
void draw_benchmark_dialog(PanelContext& ctx);
void draw_fetch(PanelContext& ctx);
void draw_file_browser(PanelContext& ctx);
void draw_save_picture(PanelContext& ctx);
void draw_record(PanelContext& ctx);
void draw_save_table(PanelContext& ctx);
void draw_export(PanelContext& ctx);
void draw_confirm_assembly(PanelContext& ctx);
void draw_cheat_sheet(PanelContext& ctx);
void draw_about(PanelContext& ctx);
void draw_command_palette(PanelContext& ctx);
void draw_save_session(PanelContext& ctx);
void draw_session_problem(PanelContext& ctx);
void draw_error(PanelContext& ctx);

}  // namespace alphascope
