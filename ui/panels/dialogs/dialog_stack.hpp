// The one owner of the dialogs: which are open, and which is above which. ImGui replaces a modal
// window by the next that is opened beside it; here each is opened inside the one below.
#pragma once

#include "ui/widgets/widgets.hpp"

namespace alphascope {

// Between begin_dialog() and end_dialog(): the dialog's contents. False: draw nothing, and do not
// end it. `size` in pixels; {0, 0} fits the contents.
// At the top: without a title bar.
enum class DialogPlace : std::uint8_t { centre, top };
bool begin_dialog(PanelContext& ctx, const char* title, ImVec2 size = {0, 0},
                  DialogPlace place = DialogPlace::centre);
void end_dialog(PanelContext& ctx);  // closes it when the state no longer wants it

// Keys belong to the topmost dialog.
bool on_top(const PanelContext& ctx);
// On top, and nothing in it has the keys: no list is open, and no text is typed, which Escape takes
// back first and Enter confirms.
bool has_keys(const PanelContext& ctx);
bool escape_pressed(const PanelContext& ctx);
bool enter_pressed(const PanelContext& ctx);

// At the right end of a line that is `width` pixels wide: what does nothing at the left, what does
// something at the right, in every dialog. Enter confirms, Escape cancels. `entered`: Enter was
// pressed in a field. While a number of the dialog is wrong, nothing is confirmed.
enum class DialogAnswer : std::uint8_t { none, cancel, confirm };
struct DialogButton {
  const char* name;
  const char* label;
};
DialogAnswer dialog_buttons(PanelContext& ctx, float width, DialogButton cancel,
                            DialogButton confirm, bool can_confirm = true, bool entered = false);
bool close_button(PanelContext& ctx, float width, DialogButton close);

// All dialogs that are wanted; what was wanted last is on top.
void draw_dialogs(PanelContext& ctx);

// The dialogs themselves.
void draw_benchmark_page(PanelContext& ctx);
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
