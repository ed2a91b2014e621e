// SPDX-License-Identifier: GPL-3.0-or-later
// The status bar: counts, Euler characteristic, hash, device and memory of the result on screen, in
// one line.
#include <algorithm>

#include <string>

#include "core/complex/alpha_complex.hpp"
#include "core/document/commands/commands.hpp"
#include "core/document/store/answer.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/panels/work_info.hpp"
#include "ui/running_job.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/key_focus.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

void item(PanelContext& ctx, const char* name, const char* label, const std::string& value,
          const char* help) {
  ImGui::BeginGroup();
  muted_text(ctx, label);
  ImGui::SameLine(0, ctx.px(5));
  ImGui::TextUnformatted(value.c_str());
  ImGui::EndGroup();
  record(ctx, name);
  tooltip(ctx, help);
  ImGui::SameLine(0, ctx.px(16));
}

void counts(PanelContext& ctx) {
  const AlphaComplex& c = ctx.state.result->complex;
  const std::string hash = hash_text(c.hash);
  const auto number = [](std::size_t n) { return with_separators(static_cast<long long>(n)); };
  if (!c.tetrahedra_only) {
    item(ctx, "status.vertices", "vertices", number(c.vertices.size()),
         "Balls that are in the complex.");
    item(ctx, "status.edges", "edges", number(c.edges.size()), "Edges of the complex.");
    item(ctx, "status.triangles", "triangles", number(c.triangles.size()),
         "Triangles of the complex.");
  }
  item(ctx, "status.tetrahedra", "tetrahedra", number(c.tetrahedra.size()),
       "Tetrahedra of the complex.");
  if (!c.tetrahedra_only) {
    item(ctx, "status.euler", "Euler χ", with_separators(c.euler_characteristic()),
         "Vertices − edges + triangles − tetrahedra = components − tunnels + voids.");
  }
  ImGui::BeginGroup();
  muted_text(ctx, "hash");
  ImGui::SameLine(0, ctx.px(5));
  ImGui::PushFont(ctx.fonts.mono);
  ImGui::TextUnformatted(hash.c_str());
  ImGui::PopFont();
  ImGui::EndGroup();
  record(ctx, "status.hash");
  tooltip(ctx,
          "Hash of the set of simplices: equal complexes have equal hashes, on every engine and on "
          "the command line. Click to copy.");
  if (ImGui::IsItemClicked()) ImGui::SetClipboardText(hash.c_str());
  ImGui::SameLine(0, ctx.px(16));
}

// Names the thing under the mouse, in the place of device and memory. Returns whether there is one.
bool under_mouse(PanelContext& ctx) {
  const std::string& line = ctx.state.viewport.under_mouse_line;
  if (line.empty()) return false;
  const float end = ImGui::GetWindowWidth() - ctx.px(12), start = ImGui::GetCursorPosX();
  const std::string text = fitted_text(line, end - start);
  ImGui::SetCursorPosX(std::max(start, end - ImGui::CalcTextSize(text.c_str()).x));
  ImGui::TextUnformatted(text.c_str());
  record(ctx, "status.under_mouse");
  return true;
}

// Makes the last text a button that shows or hides the window Tasks.
void tasks_button(PanelContext& ctx, const char* name) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImGui::SetCursorScreenPos(low);
  const std::string id = std::string("##") + name;
  if (ImGui::InvisibleButton(id.c_str(), {high.x - low.x, high.y - low.y})) {
    ctx.commands.run("tasks.show");
  }
  if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  record(ctx, name);
  key_stop(ctx, name);
}

// A job that has run for a while, as "Fetching pdb:1CRN 45 %"; empty: none.
std::string job_text(const ViewState& s) {
  constexpr double kWhile = 1;  // seconds
  for (const RunningJob& job : s.jobs) {
    if (job.seconds < kWhile) continue;
    return job.title + (job.share >= 0 ? " " + number_text(job.share * 100, 0) + " %" : "…");
  }
  return {};
}

}  // namespace

void draw_status_bar(PanelContext& ctx) {
  const ViewState& s = ctx.state;
  ImGui::PushFont(ctx.fonts.small);
  if (s.result) {
    counts(ctx);
  } else {
    muted_text(ctx, s.has_molecule() ? "No complex yet" : "No molecule");
    ImGui::SameLine(0, ctx.px(16));
  }
  if (!s.selected_count_text.empty()) {
    item(ctx, "status.selected", "selected", s.selected_count_text,
         "Atoms and simplices that are selected in the picture. Those that the present complex "
         "lacks stay selected and reappear with it.");
  }
  if (under_mouse(ctx)) {
    ImGui::PopFont();
    return;
  }
  const std::string memory = bytes_text(s.memory_bytes) + " memory";
  std::string right = s.device_text.empty() ? memory : s.device_text + "  ·  " + memory;
  const std::string running = job_text(s);
  const std::string& work = running.empty() ? s.background.text : running;
  if (!work.empty()) right = work + "  ·  " + right;
  const float end = ImGui::GetWindowWidth() - ctx.px(12);
  const float room = end - ImGui::GetCursorPosX();
  for (const std::string& shorter : {memory, bytes_text(s.memory_bytes)}) {
    if (ImGui::CalcTextSize(right.c_str()).x > room) right = shorter;
  }
  const float width = ImGui::CalcTextSize(right.c_str()).x;
  if (!s.notice.empty() && room > width + ctx.px(80)) {
    ImGui::TextUnformatted(fitted_text(s.notice, room - width - ctx.px(24)).c_str());
    tasks_button(ctx, "status.notice");
    tooltip(ctx, (s.notice + "\nClick: tasks and messages.").c_str());
    ImGui::SameLine();
  }
  if (width <= room) {
    ImGui::SetCursorPosX(end - width);
    muted_text(ctx, right);
    tasks_button(ctx, "status.device");
    tooltip(ctx, (s.background.detail + (s.background.detail.empty() ? "" : "\n") +
                  "Click: tasks and messages.")
                     .c_str());
  }
  ImGui::PopFont();
}

}  // namespace alphascope
