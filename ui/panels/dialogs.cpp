// Error, about, and saving a picture.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <tuple>

#include "ui/panels/dialog_stack.hpp"
#include "ui/panels/format.hpp"
#include "ui/panels/number_field.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/picture_path.hpp"
#include "ui/panels/save_target.hpp"

namespace alphascope {
namespace {

constexpr float kWidth = 440;  // pixels at scale 1, of most dialogs

}  // namespace

void draw_about(PanelContext& ctx) {
  bool& show = ctx.state.memory.show_about;
  if (!begin_dialog(ctx, "About Alphascope")) return;
  ImGui::PushFont(ctx.fonts.large);
  ImGui::TextUnformatted(("Alphascope " + ctx.state.version).c_str());
  ImGui::PopFont();
  ImGui::PushTextWrapPos(ctx.px(440));
  ImGui::TextUnformatted(
      "The exact alpha complex of a molecule, recomputed as you move alpha, and compared with CGAL "
      "simplex by simplex.");
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
  muted_text(ctx, "Free software under the GNU GPL, version 3 or later.");
  muted_text(ctx, "Built on CGAL, VTK, Dear ImGui, GLFW, oneTBB and gemmi. Font: Inter.");
  ImGui::Dummy({ctx.px(kWidth), ctx.px(6)});
  ImGui::NewLine();
  if (close_button(ctx, ctx.px(kWidth), {"about.close", "Close"})) show = false;
  end_dialog(ctx);
}

namespace {

void assembly_facts(PanelContext& ctx, const AssemblyInfo& a) {
  const auto number = [](std::uint64_t n) { return with_separators(static_cast<long long>(n)); };
  const auto bytes = [](std::uint64_t n) { return bytes_text(static_cast<std::size_t>(n)); };
  const auto fact = [&ctx](const char* what, const std::string& value) {
    muted_text(ctx, what);
    ImGui::SameLine(ctx.px(250));
    ImGui::TextUnformatted(value.c_str());
  };
  const auto [least, most] = assembly_memory(a.atoms);
  const std::uint64_t free = ctx.state.free_bytes;
  fact("Assembly", a.id + (a.details.empty() ? "" : " (" + a.details + ")"));
  fact("Copies", number(a.copies));
  fact("Atoms", number(a.atoms));
  fact("Memory for the atoms", "about " + bytes(a.memory_bytes));
  fact("With complex and picture", bytes(least) + " at alpha 0");
  fact("", "to " + bytes(most) + " with solvent");
  if (free > 0) fact("Free on this machine", bytes(free));
  if (free == 0 || most <= free) return;
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.warning));
  wrapped_text("That may not be enough: the system may end the program.");
  ImGui::PopStyleColor();
  record(ctx, "assembly.too_large");
}

}  // namespace

void draw_confirm_assembly(PanelContext& ctx) {
  ViewState& s = ctx.state;
  std::string& id = s.memory.confirm_assembly;
  const auto& list = s.molecule.assemblies;
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const AssemblyInfo& a) { return a.id == id; });
  if (found == list.end()) id.clear();
  if (!begin_dialog(ctx, "Expand a large assembly?")) return;
  ImGui::Dummy({ctx.px(kWidth), 0});
  if (found != list.end()) assembly_facts(ctx, *found);
  ImGui::Dummy({0, ctx.px(6)});
  muted_wrapped(
      ctx, "You can cancel at any time. The present molecule stays until the copies are made.");
  ImGui::Dummy({0, ctx.px(6)});
  ImGui::NewLine();
  const DialogAnswer answer = dialog_buttons(ctx, ctx.px(kWidth), {"assembly.cancel", "Cancel"},
                                             {"assembly.expand", "Expand"});
  if (answer == DialogAnswer::confirm) s.open.assembly = id;
  if (answer != DialogAnswer::none) id.clear();
  end_dialog(ctx);
}

namespace {

void size_preset(PanelContext& ctx, const char* name, const char* label, int width, int height) {
  if (button(ctx, name, label)) {
    ctx.state.memory.save.width = width;
    ctx.state.memory.save.height = height;
  }
  ImGui::SameLine(0, ctx.px(4));
}

void save_size(PanelContext& ctx) {
  PanelMemory& m = ctx.state.memory;
  row_label(ctx, "Size");
  ImGui::SetNextItemWidth(ctx.px(80));
  number_field(ctx, "save.width", m.save.width, kPictureSizeRule);
  ImGui::SameLine(0, ctx.px(6));
  ImGui::TextUnformatted("×");
  ImGui::SameLine(0, ctx.px(6));
  ImGui::SetNextItemWidth(ctx.px(80));
  number_field(ctx, "save.height", m.save.height, kPictureSizeRule);
  ImGui::SameLine(0, ctx.px(6));
  ImGui::TextUnformatted("pixels");
  row_label(ctx, "");
  size_preset(ctx, "save.as_view", "as the view", ctx.state.viewport.width,
              ctx.state.viewport.height);
  size_preset(ctx, "save.hd", "1920 × 1080", 1920, 1080);
  size_preset(ctx, "save.4k", "3840 × 2160", 3840, 2160);
  ImGui::NewLine();
}

// What is drawn over the molecule.
void save_marks(PanelContext& ctx) {
  PanelMemory& m = ctx.state.memory;
  const bool has_legend = ctx.state.viewport.legend.has_value();
  row_label(ctx, "With");
  ImGui::BeginDisabled(!has_legend);
  bool legend = has_legend && m.save.legend;
  if (checkbox(ctx, "save.legend", "Colour legend", legend)) m.save.legend = legend;
  ImGui::EndDisabled();
  tooltip(ctx, has_legend ? "Shows which colour stands for which value."
                          : "Available when colours are of alpha values or exposed areas.");
  ImGui::SameLine(0, ctx.px(18));
  checkbox(ctx, "save.scale_bar", "Scale bar", m.save.scale_bar);
  tooltip(ctx,
          "A bar of a round length in Å. The view is in perspective, so the length is right at the "
          "depth of the point that the view turns about.");
}

}  // namespace

void draw_save_picture(PanelContext& ctx) {
  ViewState& s = ctx.state;
  PanelMemory& m = s.memory;
  if (m.save_path.empty()) m.save_path = "alphascope.png";
  if (!begin_dialog(ctx, "Save a picture")) return;
  row_label(ctx, "File");
  ImGui::SetNextItemWidth(ctx.px(340));
  const bool entered =
      ImGui::InputText("##path", &m.save_path, ImGuiInputTextFlags_EnterReturnsTrue);
  record(ctx, "save.path");
  const bool can_save =
      save_target(ctx, "save", {picture_path(m.save_path)}) && !m.save_path.empty();
  save_size(ctx);
  row_label(ctx, "");
  checkbox(ctx, "save.transparent", "Transparent background", m.save.transparent);
  save_marks(ctx);
  ImGui::PushFont(ctx.fonts.small);
  row_label(ctx, "");
  muted_text(ctx, "The PNG file also records file, selection, radii, alpha and hash.");
  ImGui::PopFont();
  ImGui::Dummy({0, ctx.px(6)});
  ImGui::NewLine();
  const DialogAnswer answer = dialog_buttons(ctx, ctx.px(kWidth + 24), {"save.cancel", "Cancel"},
                                             {"save.ok", "Save"}, can_save);
  if (answer == DialogAnswer::confirm || (entered && can_save)) {
    s.requests.screenshot = {picture_path(m.save_path), m.save};
    m.show_save = false;
  }
  if (answer == DialogAnswer::cancel) m.show_save = false;
  end_dialog(ctx);
}

void draw_error(PanelContext& ctx) {
  ViewState& s = ctx.state;
  const std::string title =
      (s.error_title.empty() ? "That did not work" : s.error_title) + "###error";
  if (!begin_dialog(ctx, title.c_str())) return;
  ImGui::Dummy({ctx.px(kWidth), 0});
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + ctx.px(kWidth));  // for long paths
  ImGui::TextUnformatted(broken_lines(s.error, ctx.px(kWidth)).c_str());
  ImGui::PopTextWrapPos();
  ImGui::Dummy({0, ctx.px(6)});
  if (button(ctx, "error.copy", "Copy text", {ctx.px(100), 0})) {
    ImGui::SetClipboardText(s.error.c_str());
  }
  if (close_button(ctx, ctx.px(kWidth), {"error.ok", "OK"})) {
    s.error_title.clear();
    s.error.clear();
    if (!s.more_errors.empty()) {
      std::tie(s.error_title, s.error) = s.more_errors.front();
      s.more_errors.pop_front();
    }
  }
  end_dialog(ctx);
}

}  // namespace alphascope
