// SPDX-License-Identifier: GPL-3.0-or-later
// The rows for size, legend, scale bar and caption of a picture.
#include "ui/panels/dialogs/fields/picture_fields.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "core/document/picture/picture_options.hpp"
#include "core/document/picture/picture_preset.hpp"
#include "core/document/settings/display.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/rgb8.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/colour_field.hpp"
#include "ui/widgets/number_field.hpp"

namespace alphascope {
namespace {

struct Size {
  int width, height;
};

void forget_sizes(PanelContext& ctx, const std::string& dialog) {
  for (const char* field : {".width", ".height", ".mm_across", ".mm_down", ".dpi"}) {
    forget_typing(ctx, dialog + field);
  }
}

void size_preset(PanelContext& ctx, const std::string& dialog, const char* name, const char* label,
                 Size size, PictureOptions& options) {
  if (button(ctx, (dialog + "." + name).c_str(), label)) {
    forget_sizes(ctx, dialog);
    options.width = size.width;
    options.height = size.height;
  }
  ImGui::SameLine(0, ctx.px(4));
}

int in_bounds(int pixels) {
  return std::clamp(pixels, static_cast<int>(kPictureSizeRule.least),
                    static_cast<int>(kPictureSizeRule.most));
}

// A length in mm. Typing it sets the pixels.
void length_field(PanelContext& ctx, const std::string& name, int& pixels, int dpi) {
  const NumberRule rule{"The size", std::ceil(100 * millimetres(16, dpi)) / 100,
                        std::floor(100 * millimetres(16384, dpi)) / 100, "mm"};
  double length = std::round(10 * millimetres(pixels, dpi)) / 10;
  ImGui::SetNextItemWidth(ctx.px(60));
  if (number_field(ctx, name.c_str(), length, rule)) pixels = in_bounds(pixels_of(length, dpi));
}

// Size in print and resolution. Another resolution keeps the size in print.
void print_fields(PanelContext& ctx, const std::string& dialog, PictureOptions& options) {
  row_label(ctx, "In print");
  length_field(ctx, dialog + ".mm_across", options.width, options.dpi);
  ImGui::SameLine(0, ctx.px(6));
  ImGui::TextUnformatted("×");
  ImGui::SameLine(0, ctx.px(6));
  length_field(ctx, dialog + ".mm_down", options.height, options.dpi);
  ImGui::SameLine(0, ctx.px(6));
  ImGui::TextUnformatted("mm at");
  ImGui::SameLine(0, ctx.px(6));
  ImGui::SetNextItemWidth(ctx.px(52));
  int dpi = options.dpi;
  if (number_field(ctx, (dialog + ".dpi").c_str(), dpi, kDpiRule)) {
    for (int* const pixels : {&options.width, &options.height}) {
      *pixels = in_bounds(pixels_of(millimetres(*pixels, options.dpi), dpi));
    }
    options.dpi = dpi;
  }
  tooltip(ctx, "Dots per inch, which the PNG file states. Journals often want 300 or 600.");
  ImGui::SameLine(0, ctx.px(6));
  ImGui::TextUnformatted("dpi");
}

}  // namespace

void use_fields(PanelContext& ctx, const std::string& dialog, PictureOptions& options) {
  row_label(ctx, "For");
  DisplaySettings& display = ctx.state.settings.display;
  for (const DisplayPreset preset : kDisplayPresets) {
    if (!is_for_use(preset)) continue;
    const DisplayPresetInfo& info = preset_info(preset);
    const bool on =
        options == with_preset(options, preset) && display == with_preset(display, preset);
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, to_imgui(ctx.palette.accent, 0.30f));
    if (button(ctx, (dialog + ".for." + info.id).c_str(), info.title)) {
      forget_sizes(ctx, dialog);
      forget_typing(ctx, dialog + ".letters");
      options = with_preset(options, preset);
      display = with_preset(display, preset);
    }
    if (on) ImGui::PopStyleColor();
    tooltip(ctx, (std::string(info.help) + ". Undo takes light and lines back.").c_str());
    ImGui::SameLine(0, ctx.px(4));
  }
  ImGui::NewLine();
}

void background_fields(PanelContext& ctx, const std::string& dialog, PictureOptions& options) {
  constexpr struct {
    const char *word, *label;
  } kChoices[] = {
      {"theme", "theme"}, {"white", "white"}, {"black", "black"}, {"transparent", "none"}};
  row_label(ctx, "Background");
  const std::string now = background_text(options.background);
  for (const auto& [word, label] : kChoices) {
    const bool on = now == word;
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, to_imgui(ctx.palette.accent, 0.30f));
    if (button(ctx, (dialog + "." + word).c_str(), label)) {
      options.background = *read_background(word);
    }
    if (on) ImGui::PopStyleColor();
    ImGui::SameLine(0, ctx.px(4));
  }
  Colour shown =
      options.background.colour ? to_colour(*options.background.colour) : ctx.palette.scene;
  ImGui::SetNextItemWidth(ctx.px(104));
  if (colour_field(ctx, dialog + ".background", shown)) {
    options.background = {false, to_rgb8(shown)};
  }
  tooltip(ctx, "Any colour: click on the patch to choose, or type hexadecimal digits.");
}

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
  print_fields(ctx, dialog, options);
}

void marks_fields(PanelContext& ctx, const std::string& dialog, PictureOptions& options) {
  row_label(ctx, "Letters");
  ImGui::SetNextItemWidth(ctx.px(60));
  number_field(ctx, (dialog + ".letters").c_str(), options.letters, kLettersRule);
  tooltip(ctx,
          "Size of the letters of legend, scale bar, caption and labels. With 1 they are as in a "
          "window of 960 × 600 pixels.");
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
