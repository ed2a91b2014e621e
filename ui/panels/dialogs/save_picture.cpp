// SPDX-License-Identifier: GPL-3.0-or-later
// The dialog that saves a picture.
#include <imgui.h>

#include "core/files/output_ending.hpp"
#include "core/run/cancel_token.hpp"
#include "ui/calls.hpp"
#include "ui/panels/dialogs/dialog_stack.hpp"
#include "ui/panels/dialogs/dialog_state.hpp"
#include "ui/panels/dialogs/fields/picture_fields.hpp"
#include "ui/panels/dialogs/fields/typed_path.hpp"
#include "ui/panels/dialogs/picture_requests.hpp"
#include "ui/panels/dialogs/save_target.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/window_settings.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {

void draw_save_picture(PanelContext& ctx) {
  constexpr float kWidth = 464;  // pixels at scale 1
  ViewState& s = ctx.state;
  DialogState& m = s.dialogs;
  constexpr const char* kTitle = "Save a picture";
  propose_file(ctx, kTitle, "save", m.save_path, name_of_file(ctx, kPictureEnding));
  if (!begin_dialog(ctx, kTitle)) return;
  const bool entered = file_row(ctx, "save", m.save_path);
  const std::filesystem::path path = path_to_save(m.save_path, kPictureEnding);
  const bool can_save = save_target(ctx, "save", {path}, fault_of_ending(path, {kPictureEnding}));
  use_fields(ctx, "save", s.window.picture);
  size_fields(ctx, "save", s.window.picture);
  background_fields(ctx, "save", s.window.picture);
  marks_fields(ctx, "save", s.window.picture);
  ImGui::PushFont(ctx.fonts.small);
  row_label(ctx, "");
  muted_text(ctx, "The PNG file also records file, selection, radii, alpha and hash.");
  ImGui::PopFont();
  row_label(ctx, "");
  const bool copied = button(ctx, "save.copy", "Copy to the clipboard instead");
  if (copied) ctx.calls.jobs.save_picture({{}, s.window.picture});
  ImGui::Dummy({0, ctx.px(6)});
  ImGui::NewLine();
  const DialogAnswer answer = dialog_buttons(ctx, ctx.px(kWidth), {"save.cancel", "Cancel"},
                                             {"save.ok", "Save"}, can_save, entered);
  const bool confirmed = answer == DialogAnswer::confirm;
  if (confirmed) ctx.calls.jobs.save_picture({path, s.window.picture});
  if (confirmed || copied || answer == DialogAnswer::cancel) {
    note_file(ctx, "save", m.save_path);
    m.show_save = false;
  }
  end_dialog(ctx);
}

}  // namespace alphascope
