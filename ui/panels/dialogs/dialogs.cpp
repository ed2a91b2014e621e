// SPDX-License-Identifier: GPL-3.0-or-later
// The dialogs for errors, for “About”, and for the question whether to expand a large assembly.
#include <imgui.h>

#include <algorithm>

#include "core/document/commands/commands.hpp"
#include "core/document/settings/open_options.hpp"
#include "core/document/store/key.hpp"
#include "core/molecule/assembly.hpp"
#include "ui/panels/dialogs/dialog_stack.hpp"
#include "ui/panels/dialogs/dialog_state.hpp"
#include "ui/panels/dialogs/session_problem.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

constexpr float kWidth = 440;  // width of most dialogs, in pixels at scale 1

}  // namespace

void draw_about(PanelContext& ctx) {
  bool& show = ctx.state.dialogs.show_about;
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
  wrapped_text(
      "There may not be enough free memory. If there is not, the system may end the program.");
  ImGui::PopStyleColor();
  record(ctx, "assembly.too_large");
}

}  // namespace

void draw_confirm_assembly(PanelContext& ctx) {
  ViewState& s = ctx.state;
  std::string& id = s.dialogs.confirm_assembly;
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
  if (answer == DialogAnswer::confirm) s.settings.open.assembly = id;
  if (answer != DialogAnswer::none) id.clear();
  end_dialog(ctx);
}

void draw_error(PanelContext& ctx) {
  ViewState& s = ctx.state;
  const std::string title =
      (s.error_title.empty() ? "The action failed" : s.error_title) + "###error";
  if (!begin_dialog(ctx, title.c_str())) return;
  begin_dialog_body(ctx, ctx.px(kWidth));
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + ctx.px(kWidth));  // wraps long paths
  ImGui::TextUnformatted(broken_lines(s.error, ctx.px(kWidth)).c_str());
  ImGui::PopTextWrapPos();
  end_dialog_body();
  ImGui::Dummy({0, ctx.px(6)});
  if (button(ctx, "error.copy", "Copy text", {ctx.px(100), 0})) {
    ImGui::SetClipboardText(s.error.c_str());
  }
  if (close_button(ctx, ctx.px(kWidth), {"error.ok", "OK"})) s.close_error();
  end_dialog(ctx);
}

}  // namespace alphascope
