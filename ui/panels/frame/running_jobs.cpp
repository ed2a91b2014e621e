// SPDX-License-Identifier: GPL-3.0-or-later
// One line for each job: title, share done, step, and a button that cancels it.
#include "ui/panels/frame/running_jobs.hpp"

#include <algorithm>
#include <cmath>

#include "ui/calls.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/running_job.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

void begin_overlay(PanelContext& ctx, const char* id, ImVec2 position, ImVec2 pivot) {
  ImGui::SetNextWindowPos(position, ImGuiCond_Always, pivot);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ctx.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, to_imgui(ctx.palette.panel_raised, 0.96f));
  ImGui::Begin(id, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
}

void end_overlay() {
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
}

namespace {

// Returns the seconds after which a job is listed. Short work would flicker. A comparison is listed
// late, because nothing waits for it.
double listed_after(JobId id) {
  if (delays_picture(id)) return 0.25;
  if (id == JobId::comparing) return 2;
  return id == JobId::listing ? 0.5 : 0;
}

const char* cancel_button(JobId id) {
  if (delays_picture(id)) return "view.cancel";
  if (id == JobId::fetching) return "view.cancel_fetch";
  if (id == JobId::comparing) return "view.cancel_comparison";
  if (id == JobId::benchmark) return "view.cancel_benchmark";
  return id == JobId::listing ? "view.cancel_listing" : "view.cancel_save";
}

// Draws progress of work whose share done is unknown. A piece moves to and fro, so it does not look
// like a share.
void busy_bar(PanelContext& ctx, float width, double seconds) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight(), piece = width / 5;
  constexpr double kPeriod = 2;  // seconds, to and fro
  const double phase = std::fmod(seconds, kPeriod) / kPeriod;
  const float at = static_cast<float>(1 - std::fabs(2 * phase - 1)) * (width - piece);
  const float rounding = ImGui::GetStyle().FrameRounding;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(corner, {corner.x + width, corner.y + height}, to_u32(ctx.palette.field),
                      rounding);
  draw->AddRectFilled({corner.x + at, corner.y + ctx.px(2)},
                      {corner.x + at + piece, corner.y + height - ctx.px(2)},
                      to_u32(ctx.palette.accent, 0.55f), rounding);
  const std::string text = number_text(seconds, 1) + " s";
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  draw->AddText({corner.x + (width - size.x) / 2, corner.y + (height - size.y) / 2},
                to_u32(ctx.palette.text), text.c_str());
  ImGui::Dummy({width, height});
  record(ctx, "view.busy_bar");
}

// Draws a line of a fixed width, so the list does not jump with each step.
void line(PanelContext& ctx, const RunningJob& job) {
  const float width = ctx.px(220), left = ImGui::GetCursorPosX();
  const bool fetches = job.id == JobId::fetching;
  const bool saves = !delays_picture(job.id) && job.id != JobId::comparing && !fetches;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(fitted_text(job.title, width).c_str());
  if (saves) record(ctx, "view.saving");
  ImGui::SameLine(left + width + ctx.px(8));
  if (button(ctx, cancel_button(job.id), "Cancel")) ctx.calls.jobs.cancel(job.id);
  if (fetches) tooltip(ctx, "No incomplete file is left. The open molecule stays.");
  if (saves) tooltip(ctx, "No incomplete file is left. An existing file does not change.");
  std::string step = job.step;
  if (step.empty()) step = number_text(job.seconds, 1) + " s";
  // The share stands beside the bar, because text on the bar's colour is hard to read.
  if (job.share >= 0) step += "  " + number_text(job.share * 100, 0) + " %";
  if (job.share < 0 && delays_picture(job.id)) {
    if (!job.step.empty()) muted_text(ctx, fitted_text(job.step, width));
    return busy_bar(ctx, width, job.seconds);
  }
  muted_text(ctx, fitted_text(step, width));
  if (saves) record(ctx, "view.saving_step");
  ImGui::ProgressBar(static_cast<float>(std::max(0.0, job.share)), {width, ctx.px(4)}, "");
}

}  // namespace

// Draws the list. Derived results are in the window Tasks only. Jobs that the picture waits for
// come last, because they come and go with each move of alpha.
void draw_running_jobs(PanelContext& ctx, ImVec2 corner) {
  std::vector<const RunningJob*> listed;
  for (const bool awaited : {false, true}) {
    for (const RunningJob& job : ctx.state.jobs) {
      const bool wanted = delays_picture(job.id) == awaited && job.id != JobId::deriving &&
                          job.seconds >= listed_after(job.id);
      if (wanted) listed.push_back(&job);
    }
  }
  if (listed.empty()) return;
  begin_overlay(ctx, "##jobs", corner, {1, 0});
  for (const RunningJob* const job : listed) {
    ImGui::PushID(static_cast<int>(job->id));
    line(ctx, *job);
    ImGui::PopID();
  }
  end_overlay();
}

}  // namespace alphascope
