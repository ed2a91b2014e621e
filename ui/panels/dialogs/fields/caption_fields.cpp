// SPDX-License-Identifier: GPL-3.0-or-later
// The check boxes for the parts of a picture's caption, and the caption that they make.
#include <string>

#include "core/document/picture/picture_options.hpp"
#include "core/document/store/answer.hpp"
#include "core/selection/prepare_balls.hpp"
#include "ui/caption.hpp"
#include "ui/panels/dialogs/fields/picture_fields.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {

void caption_parts_fields(PanelContext& ctx, const std::string& dialog, PictureOptions& options) {
  constexpr int kOnOneLine = 4;
  int column = 0;
  for (const CaptionPartInfo& info : caption_parts()) {
    if (column++ % kOnOneLine == 0) {
      row_label(ctx, "");
    } else {
      ImGui::SameLine(0, ctx.px(12));
    }
    bool wanted = options.caption.has(info.part);
    const std::string name = dialog + ".caption_" + info.id;
    if (checkbox(ctx, name.c_str(), info.title, wanted)) options.caption.set(info.part, wanted);
  }
  if (!ctx.state.result) return;
  std::string text;
  const Answer& answer = *ctx.state.result;
  const std::string radii = answer.prepared ? answer.prepared->report.radii_name : "";
  for (const std::string& word : caption_words(answer, *answer.molecule, radii, options.caption)) {
    text += (text.empty() ? "" : kCaptionGap) + word;
  }
  ImGui::PushFont(ctx.fonts.small);
  row_label(ctx, "");
  muted_text(ctx, fitted_text(text, ctx.px(350)));
  tooltip(ctx, text.c_str());
  ImGui::PopFont();
}

}  // namespace alphascope
