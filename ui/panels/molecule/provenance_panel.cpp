// SPDX-License-Identifier: GPL-3.0-or-later
// Lists where the numbers come from, in full as a paper needs it. A button copies the list.
#include <algorithm>

#include "ui/panels/panels.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kHashDigitsShown = 16;

std::string as_text(const MoleculeInfo& m) {
  std::string text;
  for (const auto& [key, value] : m.provenance) text += key + ": " + value + "\n";
  return text;
}

void hash_value(PanelContext& ctx, const std::string& hash) {
  ImGui::PushFont(ctx.fonts.mono);
  ImGui::TextUnformatted((hash.substr(0, kHashDigitsShown) + "…").c_str());
  ImGui::PopFont();
  record(ctx, "provenance.sha256");
  tooltip(ctx,
          (hash + "\nSHA-256 of the file on disk (compressed, if it is). Click to copy.").c_str());
  if (ImGui::IsItemClicked()) {
    ImGui::SetClipboardText(hash.c_str());
    ctx.state.notice = "SHA-256 copied.";
  }
}

}  // namespace

void draw_provenance(PanelContext& ctx) {
  const MoleculeInfo& m = ctx.state.molecule;
  if (m.provenance.empty()) return;
  if (!disclosure(ctx, "molecule.provenance", "Provenance", ctx.palette.text_muted)) return;
  ImGui::Unindent();
  ImGui::PushFont(ctx.fonts.small);
  const float column = ctx.px(86);
  for (const auto& [key, value] : m.provenance) {
    muted_text(ctx, key);
    ImGui::SameLine(column);
    if (key == "SHA-256") {
      hash_value(ctx, value);
      continue;
    }
    if (key == "File") {
      const float room = ImGui::GetContentRegionAvail().x;
      ImGui::TextUnformatted(fitted_text(value, room).c_str());
      tooltip(ctx, value.c_str());
    } else {
      wrapped_text(value);
    }
  }
  if (button(ctx, "provenance.copy", "Copy these rows")) {
    ImGui::SetClipboardText(as_text(m).c_str());
    ctx.state.notice = "Provenance copied.";
  }
  ImGui::PopFont();
  ImGui::Indent();
  ImGui::TreePop();
}

}  // namespace alphascope
