// SPDX-License-Identifier: GPL-3.0-or-later
// Two dialogs on sessions: one saves a session, and one asks what to do if its files are missing or
// have changed.
#include <imgui.h>

#include <algorithm>
#include <string>

#include "core/files/output_ending.hpp"
#include "core/run/cancel_token.hpp"
#include "ui/calls.hpp"
#include "ui/panels/dialogs/browser_state.hpp"
#include "ui/panels/dialogs/dialog_stack.hpp"
#include "ui/panels/dialogs/dialog_state.hpp"
#include "ui/panels/dialogs/fields/typed_path.hpp"
#include "ui/panels/dialogs/save_target.hpp"
#include "ui/panels/dialogs/session_problem.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/running_job.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

constexpr float kWidth = 464;  // pixels at scale 1

}  // namespace

void draw_save_session(PanelContext& ctx) {
  ViewState& s = ctx.state;
  DialogState& m = s.dialogs;
  constexpr const char* kTitle = "Save the session";
  propose_file(ctx, kTitle, "save_session", m.session_path, name_of_file(ctx, kSessionEnding));
  if (!begin_dialog(ctx, kTitle)) return;
  const bool entered = file_row(ctx, "save_session", m.session_path);
  const std::filesystem::path path = path_to_save(m.session_path, kSessionEnding);
  const bool can_save =
      save_target(ctx, "save_session", {path}, fault_of_ending(path, {kSessionEnding}));
  ImGui::PushFont(ctx.fonts.small);
  row_label(ctx, "");
  muted_text(ctx, "A session stores the molecule's file name and all settings, but no atoms.");
  row_label(ctx, "");
  muted_text(ctx, "Keep the molecule's file as well.");
  ImGui::PopFont();
  ImGui::Dummy({0, ctx.px(6)});
  ImGui::NewLine();
  const DialogAnswer answer = dialog_buttons(ctx, ctx.px(kWidth), {"save_session.cancel", "Cancel"},
                                             {"save_session.ok", "Save"}, can_save, entered);
  const bool confirmed = answer == DialogAnswer::confirm;
  if (confirmed) ctx.calls.files.save_session(path);
  if (confirmed || answer == DialogAnswer::cancel) {
    note_file(ctx, "save_session", m.session_path);
    m.show_save_session = false;
  }
  end_dialog(ctx);
}

namespace {

// Offers to fetch the molecule anew. The dialog stays until its file is there.
void fetch_row(PanelContext& ctx, const std::string& id) {
  const auto& jobs = ctx.state.jobs;
  const auto at = std::find_if(jobs.begin(), jobs.end(),
                               [](const RunningJob& job) { return job.id == JobId::fetching; });
  if (at != jobs.end()) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted((at->title + "…").c_str());
    record(ctx, "session.fetching");
    return;
  }
  const bool clicked =
      button(ctx, "session.fetch", ("Fetch " + id).c_str(), {ctx.px(150), 0}, ButtonKind::primary);
  if (clicked || enter_pressed(ctx)) ctx.calls.files.fetch_for_session();
}

}  // namespace

void draw_session_problem(PanelContext& ctx) {
  ViewState& s = ctx.state;
  if (!begin_dialog(ctx, "A file of the session is missing or has changed###session_problem"))
    return;
  const SessionProblem problem = s.session_problem.value_or(SessionProblem());
  ImGui::Dummy({ctx.px(kWidth), 0});
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + ctx.px(kWidth));  // wraps long paths
  muted_text(ctx, problem.session);
  ImGui::TextUnformatted(broken_lines(problem.text, ctx.px(kWidth)).c_str());
  ImGui::PopTextWrapPos();
  record(ctx, "session.problem");
  ImGui::Dummy({0, ctx.px(6)});
  if (button(ctx, "session.cancel", "Cancel", {ctx.px(100), 0}) || escape_pressed(ctx)) {
    ctx.calls.files.abandon_session();
    s.session_problem.reset();
  }
  ImGui::SameLine();
  ImGui::BeginDisabled(!problem.can_open);
  if (button(ctx, "session.anyway", "Open it anyway", {ctx.px(150), 0})) {
    ctx.calls.files.continue_session({});
    s.session_problem.reset();
  }
  ImGui::EndDisabled();
  tooltip(ctx, problem.can_open ? "Use the file as it is now. Numbers and picture may differ from "
                                  "those that were saved."
                                : "The files of the session do not exist.");
  ImGui::SameLine();
  ImGui::BeginDisabled(!problem.molecule);
  const bool by_id = !problem.id.empty();
  const bool choose = button(ctx, "session.choose", "Choose the file…", {ctx.px(150), 0},
                             by_id ? ButtonKind::normal : ButtonKind::primary);
  if (choose || (problem.molecule && !by_id && enter_pressed(ctx))) {
    open_browser(s, BrowserPurpose::session_molecule);
  }
  ImGui::EndDisabled();
  if (by_id) fetch_row(ctx, problem.id);
  end_dialog(ctx);
}

}  // namespace alphascope
