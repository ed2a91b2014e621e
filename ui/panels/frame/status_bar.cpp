// SPDX-License-Identifier: GPL-3.0-or-later
// The status bar in one line: time, engine and badge of the last move, counts and hash of the
// complex on screen, and memory.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/document/commands/commands.hpp"
#include "core/document/store/answer.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/complex/shown_triangulation.hpp"
#include "ui/panels/complex/timings_text.hpp"
#include "ui/panels/frame/task_state.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/panels/work_info.hpp"
#include "ui/running_job.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/key_focus.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// Room at the right for memory, messages and the thing under the mouse, pixels at scale 1.
constexpr float kRightRoom = 190;
constexpr float kGap = 16, kAfterLabel = 5, kBeforeMemory = 24;

// A count with its label. `help` explains it.
struct Item {
  const char *name, *label;
  std::string value;
  const char* help;
  bool mono = false;
};

void draw_item(PanelContext& ctx, const Item& item) {
  ImGui::BeginGroup();
  muted_text(ctx, item.label);
  ImGui::SameLine(0, ctx.px(kAfterLabel));
  if (item.mono) ImGui::PushFont(ctx.fonts.mono);
  ImGui::TextUnformatted(item.value.c_str());
  if (item.mono) ImGui::PopFont();
  ImGui::EndGroup();
  record(ctx, item.name);
  tooltip(ctx, item.help);
  ImGui::SameLine(0, ctx.px(kGap));
}

float width_of(const PanelContext& ctx, const std::vector<Item>& items) {
  float width = 0;
  for (const Item& item : items) {
    if (item.mono) ImGui::PushFont(ctx.fonts.mono);
    width += ImGui::CalcTextSize(item.value.c_str()).x;
    if (item.mono) ImGui::PopFont();
    width += ImGui::CalcTextSize(item.label).x + ctx.px(kAfterLabel + kGap);
  }
  return width;
}

std::string number(std::size_t n) {
  return with_separators(static_cast<long long>(n));
}

// The counts of the complex in ever shorter forms. The last has none.
std::vector<std::vector<Item>> counts(const AlphaComplex& c) {
  const Item tetrahedra{"status.tetrahedra", "tetrahedra", number(c.tetrahedra.size()),
                        "Tetrahedra of the complex."};
  Item hash{"status.hash", "hash", hash_text(c.hash),
            "Hash of the set of simplices: equal complexes have equal hashes, on every engine and "
            "on the command line. Click to copy.",
            true};
  const Item all{"status.counts", "simplices",
                 number(c.vertices.size()) + " + " + number(c.edges.size()) + " + " +
                     number(c.triangles.size()) + " + " + number(c.tetrahedra.size()),
                 "Vertices, edges, triangles and tetrahedra of the complex."};
  const Item euler{"status.euler", "Euler χ", with_separators(c.euler_characteristic()),
                   "Vertices − edges + triangles − tetrahedra = components − tunnels + voids."};
  std::vector<std::vector<Item>> forms;
  if (!c.tetrahedra_only) {
    forms.push_back(
        {{"status.vertices", "vertices", number(c.vertices.size()),
          "Balls that are in the complex."},
         {"status.edges", "edges", number(c.edges.size()), "Edges of the complex."},
         {"status.triangles", "triangles", number(c.triangles.size()), "Triangles of the complex."},
         tetrahedra,
         euler,
         hash});
    forms.push_back({all, euler, hash});
    forms.push_back({all, hash});
  }
  forms.push_back({tetrahedra, hash});
  hash.value = hash.value.substr(0, 8) + "…";
  forms.push_back({tetrahedra, hash});
  forms.push_back({tetrahedra});
  forms.push_back({});
  return forms;
}

Colour badge_colour(const Palette& p, BadgeInfo::State state) {
  switch (state) {
    case BadgeInfo::State::identical:
      return p.success;
    case BadgeInfo::State::different:
      return p.error;
    case BadgeInfo::State::failed:
      return p.warning;
    case BadgeInfo::State::comparing:
    case BadgeInfo::State::not_compared:
      break;
  }
  return p.text_muted;
}

// Draws the last move as one button, with the badge in its colour.
void move_button(PanelContext& ctx, LastMove move) {
  const float room = ImGui::GetWindowWidth() - ImGui::GetCursorPosX() - ctx.px(12);
  const std::string badge = std::exchange(move.badge, {});
  const std::string between = "  ·  ";
  const float badge_width = ImGui::CalcTextSize((between + badge).c_str()).x;
  const std::string text = fitted_text(move.line(), room - badge_width) + between;
  const float text_width = ImGui::CalcTextSize(text.c_str()).x;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetTextLineHeight();
  const bool pressed =
      ImGui::InvisibleButton("##move", {text_width + ImGui::CalcTextSize(badge.c_str()).x, height});
  if (ImGui::IsItemHovered()) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    const ImVec2 end = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRectFilled({at.x - ctx.px(4), at.y - ctx.px(1)},
                                              {end.x + ctx.px(4), end.y + ctx.px(1)},
                                              to_u32(ctx.palette.field), ctx.px(3));
  }
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddText(at, to_u32(ctx.palette.text), text.c_str());
  draw->AddText({at.x + text_width, at.y}, to_u32(badge_colour(ctx.palette, ctx.state.badge.state)),
                badge.c_str());
  record(ctx, "status.move");
  key_stop(ctx, "status.move");
  tooltip(ctx, move.help.c_str());
  if (pressed) ctx.state.show_page("timings");
  ImGui::SameLine(0, ctx.px(kGap));
}

// The sentence that the bar shows now; empty: none.
std::string notice_text(const ViewState& s) {
  const std::string& cancelled = s.computing_cancelled;
  if (cancelled.empty() || s.notice.empty()) return cancelled + s.notice.text();
  return cancelled + "  ·  " + s.notice.text();
}

// What the bar needs at the right to show a notice whole, with the shortest text on memory.
float room_of_notice(const PanelContext& ctx, const std::string& notice) {
  if (notice.empty()) return 0;
  const ViewState& s = ctx.state;
  const std::string& selected = s.selected_count_text;
  return ImGui::CalcTextSize((notice + bytes_text(s.memory_bytes)).c_str()).x +
         ctx.px(kBeforeMemory) +
         (selected.empty() ? 0 : width_of(ctx, {{"", "selected", selected, ""}}));
}

// A job that has run for a while; null: none.
const RunningJob* shown_job(const ViewState& s) {
  constexpr double kWhile = 1;  // seconds
  const auto job = std::find_if(s.jobs.begin(), s.jobs.end(),
                                [](const RunningJob& j) { return j.seconds >= kWhile; });
  return job == s.jobs.end() ? nullptr : &*job;
}

// As "Fetching pdb:1CRN 45 %"; empty: none.
std::string job_text(const ViewState& s) {
  const RunningJob* const job = shown_job(s);
  if (job == nullptr) return {};
  return job->title + (job->share >= 0 ? " " + number_text(job->share * 100, 0) + " %" : "…");
}

// What the bar needs to show the job beside other texts. It does not change while the share grows.
float room_of_job(const PanelContext& ctx) {
  const RunningJob* const job = shown_job(ctx.state);
  if (job == nullptr) return 0;
  return ImGui::CalcTextSize((job->title + " 100 %").c_str()).x + ctx.px(kGap);
}

// Draws the last move and as many counts as fit beside it. Counts become shorter first; the move
// does so only where there is no room for any. Both make way for a notice or a running job.
void result_line(PanelContext& ctx) {
  const std::vector<LastMove> moves = last_move(ctx.state, shown_triangulation(ctx).get());
  const std::vector<std::vector<Item>> forms = counts(ctx.state.result->complex);
  const float room = ImGui::GetWindowWidth() - ctx.px(12) - ImGui::GetCursorPosX();
  const std::string notice = notice_text(ctx.state);
  const float right_room =
      std::max(ctx.px(kRightRoom) + room_of_job(ctx), room_of_notice(ctx, notice));
  const auto fits = [&](const LastMove& move, const std::vector<Item>& items, float right) {
    // The time has room for four digits, so that nothing jumps while alpha moves.
    const float most = ImGui::CalcTextSize("8888 ms").x;
    const float time = ImGui::CalcTextSize(move.time.substr(0, move.time.find(" to ")).c_str()).x;
    return ImGui::CalcTextSize(move.line().c_str()).x + std::max(0.0f, most - time) + ctx.px(kGap) +
               width_of(ctx, items) + right <=
           room;
  };
  const LastMove* move = &moves.back();
  const std::vector<Item>* items = &forms.back();
  const auto choose = [&] {
    for (const LastMove& m : moves) {
      for (const std::vector<Item>& form : forms) {
        // The middle form is for windows where the long one fits with no count at all.
        const bool no_count = form.empty() && &m != &moves.back();
        if (no_count || !fits(m, form, right_room)) continue;
        move = &m;
        items = &form;
        return;
      }
    }
    if (!notice.empty()) return;
    for (const LastMove& m : moves) {
      if (!fits(m, {}, 0)) continue;
      move = &m;
      return;
    }
  };
  choose();
  move_button(ctx, *move);
  for (const Item& item : *items) {
    draw_item(ctx, item);
    if (item.mono && ImGui::IsItemClicked()) {
      ImGui::SetClipboardText(hash_text(ctx.state.result->complex.hash).c_str());
    }
  }
}

// Whether the notice is so new that the thing under the mouse must not hide it.
bool is_new(ShownNotice& shown, const std::string& notice, std::size_t times) {
  constexpr double kNew = 6;  // seconds
  const double now = ImGui::GetTime();
  if (shown.text != notice || shown.times != times) shown = {notice, times, now};
  return !notice.empty() && now - shown.since_seconds < kNew;
}

// Names the thing under the mouse, in the place of the memory.
void under_mouse(PanelContext& ctx) {
  constexpr float kLeast = 60;  // pixels at scale 1
  const float end = ImGui::GetWindowWidth() - ctx.px(12), start = ImGui::GetCursorPosX();
  if (end - start < ctx.px(kLeast)) return;
  const std::string text = fitted_text(ctx.state.viewport.under_mouse_line, end - start);
  ImGui::SetCursorPosX(std::max(start, end - ImGui::CalcTextSize(text.c_str()).x));
  ImGui::TextUnformatted(text.c_str());
  record(ctx, "status.under_mouse");
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

// What runs in the background, a result a line, and what a click does.
void work_tooltip(PanelContext& ctx) {
  const std::string& detail = ctx.state.background.detail;
  tooltip(ctx, (detail + (detail.empty() ? "" : "\n") + "Click: tasks and messages.").c_str());
}

// What runs stays in sight while the mouse names something, if there is room for both.
void work_beside_name(PanelContext& ctx, const std::string& work) {
  constexpr float kLeastName = 160;  // pixels at scale 1
  if (work.empty()) return;
  const float room = ImGui::GetWindowWidth() - ctx.px(12) - ImGui::GetCursorPosX();
  if (room < ImGui::CalcTextSize(work.c_str()).x + ctx.px(kGap + kLeastName)) return;
  muted_text(ctx, work);
  tasks_button(ctx, "status.job");
  work_tooltip(ctx);
  ImGui::SameLine(0, ctx.px(kGap));
}

}  // namespace

void draw_status_bar(PanelContext& ctx) {
  const ViewState& s = ctx.state;
  ImGui::PushFont(ctx.fonts.small);
  if (s.result) {
    result_line(ctx);
  } else {
    muted_text(ctx, s.has_molecule() ? "No complex yet" : "No molecule");
    ImGui::SameLine(0, ctx.px(16));
  }
  if (!s.selected_count_text.empty()) {
    draw_item(ctx, {"status.selected", "selected", s.selected_count_text,
                    "Atoms and simplices that are selected in the picture. Those that the present "
                    "complex lacks stay selected and reappear with it."});
  }
  const std::string notice = notice_text(s);
  const bool fresh = is_new(ctx.state.tasks.shown_notice, notice, s.notice.times());
  const bool named = !s.viewport.under_mouse_line.empty();
  const std::string running = job_text(s);
  const std::string& work = running.empty() ? s.background.text : running;
  if (named && !fresh) {
    work_beside_name(ctx, work);
    under_mouse(ctx);
    ImGui::PopFont();
    return;
  }
  const std::string memory = bytes_text(s.memory_bytes) + " memory";
  std::string right = memory;
  if (!work.empty()) right = work + "  ·  " + right;
  const float end = ImGui::GetWindowWidth() - ctx.px(12);
  const float room = end - ImGui::GetCursorPosX();
  const float wanted =
      notice.empty() ? 0 : ImGui::CalcTextSize(notice.c_str()).x + ctx.px(kBeforeMemory);
  for (const std::string& shorter : {memory, bytes_text(s.memory_bytes)}) {
    if (wanted + ImGui::CalcTextSize(right.c_str()).x > room) right = shorter;
  }
  const float width = ImGui::CalcTextSize(right.c_str()).x;
  if (!notice.empty() && room > width + ctx.px(80)) {
    ImGui::TextUnformatted(fitted_text(notice, room - width - ctx.px(kBeforeMemory)).c_str());
    tasks_button(ctx, "status.notice");
    tooltip(ctx, (notice + "\nClick: tasks and messages.").c_str());
    ImGui::SameLine(0, ctx.px(kGap));
  }
  if (named) {
    under_mouse(ctx);
  } else if (width <= room) {
    ImGui::SetCursorPosX(end - width);
    muted_text(ctx, right);
    tasks_button(ctx, "status.memory");
    work_tooltip(ctx);
  }
  ImGui::PopFont();
}

}  // namespace alphascope
