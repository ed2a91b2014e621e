// SPDX-License-Identifier: GPL-3.0-or-later
// The rows for size, legend, scale bar and caption of a picture.
#include "ui/panels/dialogs/picture_fields.hpp"

#include <imgui.h>

#include "core/document/picture/picture_options.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/number_field.hpp"

namespace alphascope {
namespace {

struct Size {
  int width, height;
};

void size_preset(PanelContext& ctx, const std::string& dialog, const char* name, const char* label,
                 Size size, PictureOptions& options) {
  if (button(ctx, (dialog + "." + name).c_str(), label)) {
    for (const char* side : {".width", ".height"}) forget_typing(ctx, dialog + side);
    options.width = size.width;
    options.height = size.height;
  }
  ImGui::SameLine(0, ctx.px(4));
}

}  // namespace

void size_fields(PanelContext& ctx, const std::string& dialog, PictureOptions& options) {
  row_label(ctx, "Size");
  ImGui::SetNextItemWidth(ctx.px(80));
  number_field(ctx, (dialog + ".width").c_str(), options.width, kPictureSizeRule);
  ImGui::SameLine(0, ctx.px(6));
  ImGui::TextUnformatted("×");
  ImGui::SameLine(0, ctx.px(6));
  ImGui::SetNextItemWidth(ctx.px(80));
  number_field(ctx, (dialog + ".height").c_str(), options.height, kPictureSizeRule);
  ImGui::SameLine(0, ctx.px(6));
  ImGui::TextUnformatted("pixels");
  row_label(ctx, "");
  const ViewportInfo& view = ctx.state.viewport;
  size_preset(ctx, dialog, "as_view", "as the view", {view.width, view.height}, options);
  size_preset(ctx, dialog, "hd", "1920 × 1080", {1920, 1080}, options);
  size_preset(ctx, dialog, "4k", "3840 × 2160", {3840, 2160}, options);
  ImGui::NewLine();
}

void marks_fields(PanelContext& ctx, const std::string& dialog, PictureOptions& options) {
  const bool has_legend = !ctx.state.viewport.legends.empty();
  row_label(ctx, "With");
  ImGui::BeginDisabled(!has_legend);
  bool legend = has_legend && options.legend;
  if (checkbox(ctx, (dialog + ".legend").c_str(), "Colour legend", legend)) options.legend = legend;
  ImGui::EndDisabled();
  tooltip(ctx, has_legend ? "Draws the legend of the colours."
                          : "Available when colours have a meaning, not for a single colour.");
  ImGui::SameLine(0, ctx.px(18));
  checkbox(ctx, (dialog + ".scale_bar").c_str(), "Scale bar", options.scale_bar);
  tooltip(ctx,
          "Draws a bar of a round length in Å. With perspective, the length is right at the "
          "depth of the centre of rotation.");
  ImGui::SameLine(0, ctx.px(18));
  bool caption = options.caption.any();
  if (checkbox(ctx, (dialog + ".caption").c_str(), "Caption", caption)) {
    options.caption = caption ? usual_caption() : CaptionParts();
  }
  tooltip(ctx, "Writes facts at the top left, such as file and alpha.");
  // Greyed instead of hidden, else the dialog would jump.
  ImGui::BeginDisabled(!options.caption.any());
  caption_parts_fields(ctx, dialog, options);
  ImGui::EndDisabled();
}

}  // namespace alphascope
