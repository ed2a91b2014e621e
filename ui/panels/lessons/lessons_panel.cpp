// SPDX-License-Identifier: GPL-3.0-or-later
// The column at the right: the list of lessons, or the open one with its step, its question and its
// buttons. The program carries out the commands of a step.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/document/commands/commands.hpp"
#include "core/document/lessons/lesson_facts.hpp"
#include "ui/calls.hpp"
#include "ui/panels/lessons/lesson_state.hpp"
#include "ui/panels/lessons/lesson_text.hpp"
#include "ui/panels/lessons/shown_facts.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/window_settings.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// --- the list

void lesson_row(PanelContext& ctx, const ListedLesson& shelved, bool open) {
  const std::string name = "lessons." + shelved.name;
  if (!shelved.lesson) {
    ImGui::TextColored(to_imgui(ctx.palette.error), "%s", shelved.name.c_str());
    record(ctx, name.c_str());
    return muted_wrapped(ctx, shelved.problem);
  }
  ImGui::PushFont(ctx.fonts.strong);
  ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {0, 0.5f});
  const float width = ImGui::GetContentRegionAvail().x;
  const std::string title = fitted_text(shelved.lesson->title, width - ctx.px(20));
  if (button(ctx, name.c_str(), title.c_str(), {width, 0},
             open ? ButtonKind::primary : ButtonKind::normal)) {
    ctx.calls.lessons.open(shelved.lesson->file.string());
  }
  ImGui::PopStyleVar();
  ImGui::PopFont();
  ImGui::Indent(ctx.px(8));
  muted_wrapped(ctx, shelved.lesson->summary);
  ImGui::Unindent(ctx.px(8));
  ImGui::Dummy({0, ctx.px(3)});
}

void draw_list(PanelContext& ctx) {
  const LessonState& m = ctx.state.lessons;
  ImGui::BeginChild("list", {0, 0}, false);
  if (!m.shelf) {
    muted_text(ctx, "Reading the lessons…");
  } else if (m.shelf->empty()) {
    muted_wrapped(ctx,
                  "The lessons of the program were not found. Open one by its file: Ctrl+P, "
                  "Lessons, then its path.");
  } else {
    for (const ListedLesson& shelved : *m.shelf) {
      const bool open = m.open && shelved.lesson && shelved.lesson->file == m.open->file;
      lesson_row(ctx, shelved, open);
    }
  }
  ImGui::EndChild();
}

// --- the open lesson

// The paragraphs of a step on show.
struct StepText {
  std::vector<LessonParagraph> text, answer;
};

float answer_gap(const PanelContext& ctx) {
  return ctx.px(4) + 3 * ImGui::GetStyle().ItemSpacing.y;
}

// Chooses the largest letters in which the whole text fits, but none too small to read.
void choose_letters(PanelContext& ctx, const LessonStep& step, const StepText& all, float height) {
  LessonState& m = ctx.state.lessons;
  const float width = ImGui::GetContentRegionAvail().x;
  const float button = step.asks() && !m.revealed ? ImGui::GetFrameHeightWithSpacing() : 0;
  const auto needed = [&](float size) {
    const float answer = m.revealed && step.asks()
                             ? answer_gap(ctx) + lesson_text_height(ctx, all.answer, size, width)
                             : 0;
    return lesson_text_height(ctx, all.text, size, width) + answer + button;
  };
  constexpr float kLeast = 0.86f, kFiner = 0.02f;
  while (m.letters > kLeast && needed(m.letters) > height) m.letters -= kFiner;
}

void warning(PanelContext& ctx, const char* name, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.warning));
  wrapped_text(text);
  ImGui::PopStyleColor();
  record(ctx, name);
}

void draw_answer(PanelContext& ctx, const LessonStep& step, const StepText& all) {
  if (!step.asks()) return;
  if (!ctx.state.lessons.revealed) {
    if (button(ctx, "lesson.reveal", "Reveal the answer", {0, 0}, ButtonKind::primary)) {
      ctx.calls.lessons.reveal();
    }
    return;
  }
  ImGui::Separator();
  ImGui::Dummy({0, ctx.px(4)});
  draw_lesson_text(ctx, all.answer, ctx.state.lessons.letters);
  record(ctx, "lesson.answer");
}

// Draws a button in the last line, which scrolls on if the text goes on below.
void more_below(PanelContext& ctx, float page) {
  LessonState& m = ctx.state.lessons;
  ImGui::BeginDisabled(!m.more_below);
  const bool scrolls = button(ctx, "lesson.more", m.more_below ? "More below ↓" : "End of the step",
                              {ImGui::GetContentRegionAvail().x, 0}, ButtonKind::quiet);
  ImGui::EndDisabled();
  if (!scrolls) return;
  ImGui::BeginChild("step");
  ImGui::SetScrollY(ImGui::GetScrollY() + page);
  ImGui::EndChild();
}

void draw_text(PanelContext& ctx, float height) {
  LessonState& m = ctx.state.lessons;
  const LessonStep& step = m.open->steps[m.step];
  const LessonFacts facts = facts_on_screen(ctx);
  m.said.clear();
  m.paragraphs.clear();
  m.whole = m.ready;
  StepText all;
  all.text = with_facts_in(ctx, step.shown, facts);
  if (step.asks() && m.revealed) all.answer = with_facts_in(ctx, step.answer, facts);
  if (m.scroll_to_top) m.letters = 1;
  choose_letters(ctx, step, all, height);
  const float line = m.overflows ? ImGui::GetFrameHeightWithSpacing() : 0;
  ImGui::BeginChild("step", {0, height - line}, false);
  if (std::exchange(m.scroll_to_top, false)) ImGui::SetScrollY(0);
  if (!m.refused.empty()) warning(ctx, "lesson.refused", m.refused);
  if (m.left) {
    warning(ctx, "lesson.left",
            "Another molecule was opened. It stays open when you close the lesson.");
    if (button(ctx, "lesson.again_left", "Back to the lesson's molecule")) {
      ctx.calls.lessons.restart_step();
    }
    ImGui::Dummy({0, ctx.px(4)});
  }
  draw_lesson_text(ctx, all.text, m.letters);
  record(ctx, "lesson.text");
  draw_answer(ctx, step, all);
  m.overflows = ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y > height + 1;
  m.more_below = ImGui::GetScrollY() < ImGui::GetScrollMaxY() - 1;
  ImGui::EndChild();
  if (line > 0) more_below(ctx, (height - line) * 0.8f);
}

void draw_buttons(PanelContext& ctx) {
  const LessonState& m = ctx.state.lessons;
  LessonCalls& calls = ctx.calls.lessons;
  const LessonStep& step = m.open->steps[m.step];
  const bool last = m.step + 1 == m.open->steps.size() && (!step.asks() || m.revealed);
  const float gap = ctx.px(6), width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  ImGui::BeginDisabled(m.step == 0);
  if (button(ctx, "lesson.back", "Back", {width, 0})) calls.back();
  ImGui::EndDisabled();
  tooltip(ctx, "Page Up");
  ImGui::SameLine(0, gap);
  if (button(ctx, "lesson.again", "Again", {width, 0})) calls.restart_step();
  tooltip(ctx, "Restores the beginning of this step and discards your changes.");
  ImGui::SameLine(0, gap);
  const float right = ImGui::GetContentRegionAvail().x;
  if (last) {
    if (button(ctx, "lesson.list", "All lessons", {right, 0}, ButtonKind::primary)) {
      ctx.state.lessons.list = true;
    }
  } else if (button(ctx, "lesson.next", "Next", {right, 0}, ButtonKind::primary)) {
    calls.next();
  }
  if (!last) tooltip(ctx, "Page Down");
}

void draw_open(PanelContext& ctx) {
  const LessonState& m = ctx.state.lessons;
  const LessonStep& step = m.open->steps[m.step];
  const std::string place =
      "step " + std::to_string(m.step + 1) + " of " + std::to_string(m.open->steps.size());
  muted_text(ctx, fitted_text(m.open->title, ImGui::GetContentRegionAvail().x - ctx.px(90)));
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(place.c_str()).x);
  muted_text(ctx, place);
  record(ctx, "lesson.place");
  ImGui::PushFont(ctx.fonts.strong);
  wrapped_text(step.title);
  ImGui::PopFont();
  record(ctx, "lesson.title");
  ImGui::Dummy({0, ctx.px(2)});
  const float buttons = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.y;
  draw_text(ctx, ImGui::GetContentRegionAvail().y - buttons);
  draw_buttons(ctx);
}

// --- the line on top

void draw_head(PanelContext& ctx) {
  LessonState& m = ctx.state.lessons;
  const bool list = !m.open || m.list;
  const char* close = m.open ? "Close the lesson" : "Close";
  const char* other = list ? "Back to the lesson" : "All";
  const char* size = ctx.state.window.presenter_size ? "Smaller" : "Larger";
  const float gap = ctx.px(4), right = ImGui::GetWindowContentRegionMax().x;
  const float buttons =
      button_width(close) + gap + (m.open ? button_width(other) + gap : 0) + button_width(size);
  ImGui::AlignTextToFramePadding();
  if (ImGui::CalcTextSize("Lessons").x + ctx.px(12) + buttons <= right) {
    strong_text(ctx, "Lessons");
  } else {
    ImGui::NewLine();  // the buttons show the same
  }
  ImGui::SameLine(right - buttons);
  if (button(ctx, "lesson.presenter", size, {0, 0}, ButtonKind::quiet)) {
    ctx.commands.run("view.presenter_size");
  }
  tooltip(ctx, ctx.state.window.presenter_size
                   ? "Switches presenter size off."
                   : "Presenter size: text, controls and lines larger, for a "
                     "projector. Also in the View menu.");
  if (m.open) {
    ImGui::SameLine(right - button_width(close) - gap - button_width(other));
    if (button(ctx, "lesson.other", other, {0, 0}, ButtonKind::quiet)) m.list = !m.list;
  }
  ImGui::SameLine(right - button_width(close));
  if (button(ctx, "lesson.close", close, {0, 0}, ButtonKind::quiet)) {
    if (m.open) {
      ctx.calls.lessons.close();
    } else {
      m.shown = false;
    }
  }
  if (m.open) tooltip(ctx, "Closes the lesson and restores the previous molecule.");
}

void draw_lessons(PanelContext& ctx) {
  const LessonState& m = ctx.state.lessons;
  draw_head(ctx);
  if (m.open && !m.list) {
    draw_open(ctx);
  } else {
    draw_list(ctx);
  }
}

}  // namespace

std::unique_ptr<Panel> lessons_panel() {
  return panel_of(draw_lessons);
}

}  // namespace alphascope
