// SPDX-License-Identifier: GPL-3.0-or-later
// The dialog that writes a complex for another program. The ending of the name decides the format,
// and choosing a format changes the ending.
#include <imgui.h>

#include "core/document/export/complex_export.hpp"
#include "core/run/cancel_token.hpp"
#include "core/text/as_sentence.hpp"
#include "ui/calls.hpp"
#include "ui/panels/dialogs/dialog_stack.hpp"
#include "ui/panels/dialogs/dialog_state.hpp"
#include "ui/panels/dialogs/fields/typed_path.hpp"
#include "ui/panels/dialogs/save_target.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

constexpr float kWidth = 464;  // pixels at scale 1

const char* format_name(const ExportFormatInfo* format) {
  return format == nullptr ? "by the name's ending" : format->name;
}

void format_choice(PanelContext& ctx, const ExportFormatInfo* chosen) {
  DialogState& m = ctx.state.dialogs;
  row_label(ctx, "Format");
  ImGui::SetNextItemWidth(ctx.px(200));
  if (list_field(ctx, "export.format", format_name(chosen), ImGuiComboFlags_HeightLarge)) {
    for (const ExportFormatInfo& format : export_formats()) {
      if (ImGui::Selectable(format.name, chosen == &format)) {
        m.export_path = fs::path(m.export_path).replace_extension(format.id).string();
      }
      record(ctx, ("export." + std::string(format.id)).c_str());
      tooltip(ctx, (std::string(".") + format.id + ": " + format.what).c_str());
    }
    ImGui::EndCombo();
  }
  ImGui::PushFont(ctx.fonts.small);
  row_label(ctx, "");
  if (chosen == nullptr) {
    ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.error));
    ImGui::TextUnformatted("No format has this ending. Choose one here.");
    ImGui::PopStyleColor();
    record(ctx, "export.no_format");
  } else {
    muted_text(ctx, as_sentence(chosen->what));
  }
  ImGui::PopFont();
}

void colour_choice(PanelContext& ctx, const ExportFormatInfo* format) {
  row_label(ctx, "Colours");
  ImGui::BeginDisabled(format == nullptr || !format->colours);
  int chosen = static_cast<int>(ctx.state.dialogs.export_colours);
  if (choice(ctx, "export.colours", {"Element", "Chain", "Solid"}, chosen, ctx.px(240))) {
    ctx.state.dialogs.export_colours = static_cast<ExportColours>(chosen);
  }
  ImGui::EndDisabled();
  tooltip(ctx,
          "Colours of the boundary's vertices. A solid is a set of tetrahedra connected "
          "through triangles.");
}

}  // namespace

void draw_export(PanelContext& ctx) {
  ViewState& s = ctx.state;
  DialogState& m = s.dialogs;
  constexpr const char* kTitle = "Export the complex";
  propose_file(ctx, kTitle, "export", m.export_path, name_of_file(ctx, ".glb"));
  if (!begin_dialog(ctx, kTitle)) return;
  const bool entered = file_row(ctx, "export", m.export_path);
  const fs::path path = typed_path(m.export_path);
  const ExportFormatInfo* const format = export_format_of(path);
  const std::vector<fs::path> files =
      format == nullptr ? std::vector{path} : export_files(*format, path);
  const bool can_export = save_target(ctx, "export", files) && format != nullptr && s.result;
  format_choice(ctx, format);
  colour_choice(ctx, format);
  ImGui::PushFont(ctx.fonts.small);
  row_label(ctx, "");
  muted_text(ctx, files.size() > 1
                      ? "Also written: " + files[1].filename().string() + ", " +
                            files[2].filename().string() + "."
                      : std::string("The complex on screen is exported. Lengths are in Å."));
  ImGui::PopFont();
  ImGui::Dummy({0, ctx.px(6)});
  ImGui::NewLine();
  const DialogAnswer answer = dialog_buttons(ctx, ctx.px(kWidth), {"export.cancel", "Cancel"},
                                             {"export.ok", "Export"}, can_export, entered);
  const bool confirmed = answer == DialogAnswer::confirm;
  if (confirmed) ctx.calls.jobs.export_complex(ExportRequest{path, m.export_colours});
  if (confirmed || answer == DialogAnswer::cancel) {
    note_file(ctx, "export", m.export_path);
    m.show_export = false;
  }
  end_dialog(ctx);
}

}  // namespace alphascope
