// SPDX-License-Identifier: GPL-3.0-or-later
// The window Tasks: all that runs, with a button that cancels it, and the last messages below.
#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "core/document/commands/commands.hpp"
#include "ui/calls.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/frame/task_state.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/running_job.hpp"
#include "ui/theme.hpp"
#include "ui/time_left_text.hpp"
#include "ui/widgets/key_focus.hpp"
#include "ui/widgets/keys.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

constexpr float kWidth = 520, kHeight = 380, kMargin = 12;  // pixels at scale 1
constexpr float kCancelWidth = 26;

struct TasksMemory {
  std::string shown;      // the messages, broken into lines
  std::size_t noted = 0;  // of these messages
  float width = 0;        // of the lines, in pixels
  // Of the display when the window was placed, in pixels.
  float placed_width = 0, placed_height = 0, placed_scale = 0;
};

// "kernel II  ·  45 %  ·  12 s left"
std::string state_text(const RunningJob& job) {
  if (job.waits) return "waits for its turn";
  std::string text = job.step;
  const auto add = [&text](const std::string& more) {
    text += (text.empty() ? "" : "  ·  ") + more;
  };
  if (job.share >= 0) add(number_text(job.share * 100, 0) + " %");
  const bool told = job.step.find(" left") != std::string::npos;
  const bool whole = job.step.empty() || job.id == JobId::fetching || job.id == JobId::benchmark;
  if (job.seconds_left >= 0 && !told) {
    add(time_left_text(job.seconds_left) + (whole ? "" : " in this step"));
  } else if (!told && job.id != JobId::deriving) {
    add("for " + number_text(job.seconds, 1) + " s");
  }
  return text;
}

void cancel(PanelContext& ctx, const RunningJob& job) {
  if (job.id == JobId::deriving) {
    ctx.calls.jobs.cancel_result(job.result);
  } else {
    ctx.calls.jobs.cancel(job.id);
  }
}

void draw_task(PanelContext& ctx, const RunningJob& job, std::size_t n) {
  const std::string number = std::to_string(n);
  const float room = ImGui::GetContentRegionAvail().x - ctx.px(kCancelWidth + 8);
  const float left = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(fitted_text(job.title, room).c_str());
  record(ctx, ("tasks.title." + number).c_str());
  ImGui::SameLine(left + room + ctx.px(8));
  if (button(ctx, ("tasks.cancel." + number).c_str(), "×", {ctx.px(kCancelWidth), 0})) {
    cancel(ctx, job);
  }
  tooltip(ctx, ("Cancels: " + job.title).c_str());
  ImGui::PushFont(ctx.fonts.small);
  const std::string state = state_text(job);
  muted_text(ctx, fitted_text(state.empty() ? "running" : state, room));
  record(ctx, ("tasks.state." + number).c_str());
  ImGui::PopFont();
  if (job.share < 0) return;
  ImGui::ProgressBar(static_cast<float>(std::clamp(job.share, 0.0, 1.0)), {room, ctx.px(4)}, "");
}

void draw_tasks_list(PanelContext& ctx) {
  const RunningJobs& jobs = ctx.state.jobs;
  if (jobs.empty()) {
    muted_text(ctx, "Nothing is running.");
    return record(ctx, "tasks.none");
  }
  for (std::size_t n = 0; n < jobs.size(); ++n) {
    ImGui::PushID(static_cast<int>(n));
    draw_task(ctx, jobs[n], n);
    ImGui::PopID();
  }
}

const char* word_for(Message::Kind kind) {
  return kind == Message::Kind::error     ? "Error: "
         : kind == Message::Kind::warning ? "Warning: "
                                          : "";
}

// A message with paragraphs becomes one.
std::string line_of(const Message& message) {
  std::string line = message.time + "  " + word_for(message.kind);
  for (const char c : message.text) {
    const char added = c == '\n' ? ' ' : c;
    if (added != ' ' || !line.ends_with(' ')) line += added;
  }
  return line;
}

// All messages as they are copied, in the order of time.
std::string copied_text(const TaskState& tasks) {
  std::string text;
  for (auto message = tasks.messages.rbegin(); message != tasks.messages.rend(); ++message) {
    text += line_of(*message) + "\n";
  }
  return text;
}

void break_lines(TasksMemory& m, const TaskState& tasks, float width) {
  if (m.noted == tasks.noted && m.width == width) return;
  m.noted = tasks.noted;
  m.width = width;
  m.shown.clear();
  for (const Message& message : tasks.messages) {
    m.shown += (m.shown.empty() ? "" : "\n") + broken_lines(line_of(message), width);
  }
}

// A field that cannot be changed, since its text can be selected.
void draw_messages(PanelContext& ctx, TasksMemory& m) {
  const TaskState& tasks = ctx.state.tasks;
  ImGui::AlignTextToFramePadding();
  strong_text(ctx, "Messages");
  const float copy = button_width("Copy");
  ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - copy);
  ImGui::BeginDisabled(tasks.messages.empty());
  if (button(ctx, "tasks.copy", "Copy")) ctx.calls.files.copy(copied_text(tasks));
  ImGui::EndDisabled();
  tooltip(ctx, "Copies all messages, the latest last.");
  if (tasks.messages.empty()) {
    muted_text(ctx, "There are no messages yet.");
    return record(ctx, "tasks.no_messages");
  }
  const ImGuiStyle& style = ImGui::GetStyle();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  break_lines(m, tasks, room.x - 2 * style.FramePadding.x - style.ScrollbarSize - ctx.px(4));
  // ImGui does not write into a field that is read only.
  ImGui::InputTextMultiline("##messages", m.shown.data(), m.shown.size() + 1,
                            {-1, std::max(room.y, ctx.px(60))}, ImGuiInputTextFlags_ReadOnly);
  record(ctx, "tasks.messages");
}

// Places the window at the bottom right, above the status bar, when display or scale have changed.
void begin_tasks(PanelContext& ctx, TasksMemory& m) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float margin = ctx.px(kMargin), bar = ctx.px(27);  // of the status bar
  const ImVec2 size{std::min(ctx.px(kWidth), display.x - 2 * margin),
                    std::min(ctx.px(kHeight), display.y - bar - 3 * margin)};
  ImGui::SetNextWindowSizeConstraints(
      {std::min(ctx.px(300), size.x), std::min(ctx.px(200), size.y)}, {display.x, display.y});
  if (m.placed_width != display.x || m.placed_height != display.y || m.placed_scale != ctx.scale) {
    ImGui::SetNextWindowSize(size);
    ImGui::SetNextWindowPos({display.x - margin, display.y - bar - margin}, ImGuiCond_Always,
                            {1, 1});
    m.placed_width = display.x;
    m.placed_height = display.y;
    m.placed_scale = ctx.scale;
  }
  if (std::exchange(ctx.state.tasks.to_front, false)) ImGui::SetNextWindowFocus();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ctx.px(6));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::Begin("Tasks", &ctx.state.tasks.shown,
               ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar(2);
}

void draw_tasks(PanelContext& ctx, TasksMemory& m) {
  if (!ctx.state.tasks.shown) return;
  begin_tasks(ctx, m);
  const bool in_front = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) &&
                        !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
  if (in_front && ImGui::IsKeyPressed(key::kEscape, false)) ctx.state.tasks.shown = false;
  ctx.state.keys.reading |= in_front && ctx.state.tasks.shown;
  draw_tasks_list(ctx);
  ImGui::Dummy({0, ctx.px(2)});
  ImGui::Separator();
  draw_messages(ctx, m);
  ImGui::End();
}

void add_tasks_commands(Commands& commands, ViewState& state, TasksMemory&) {
  commands.add({.id = "tasks.show",
                .title = "Tasks and messages",
                .help = "Shows or hides all that runs, and the last messages",
                .synonyms = {{"jobs progress cancel log notices errors warnings"}},
                .menu = "View",
                .line_above = true,
                .checked = [&state] { return state.tasks.shown; },
                .run =
                    [&state](const Arguments&) {
                      state.tasks.shown = state.tasks.to_front = !state.tasks.shown;
                      return Outcome();
                    }});
}

}  // namespace

std::unique_ptr<Panel> tasks_panel() {
  return panel_of(draw_tasks, add_tasks_commands);
}

}  // namespace alphascope
