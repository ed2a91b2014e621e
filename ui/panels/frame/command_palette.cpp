// SPDX-License-Identifier: GPL-3.0-or-later
// The command palette (Ctrl+P): finds a command by a few letters of its name, and runs it with
// arguments. It asks for missing arguments one after the other, in the same field.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "core/chart/flat_drawing.hpp"
#include "core/document/commands/command_search.hpp"
#include "core/document/commands/commands.hpp"
#include "core/document/reference/atom_set.hpp"
#include "core/document/reference/ref_set.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/text/letter_case.hpp"
#include "ui/panels/dialogs/dialog_stack.hpp"
#include "ui/panels/frame/palette_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/keys.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

constexpr float kWidth = 660, kHelpAt = 210, kGap = 14;  // pixels at scale 1
constexpr std::size_t kMostRows = 10;

struct Row {
  std::string name;              // name of the widget
  std::string title, arguments;  // arguments as typed; for a switch its present state
  std::string help, keys;
  bool enabled = true;
};

float width(const PanelContext& ctx) {
  return std::min(ctx.px(kWidth), ImGui::GetIO().DisplaySize.x - ctx.px(60));
}

PaletteState& memory(PanelContext& ctx) {
  return ctx.state.palette;
}

// Draws the field. Returns whether Enter was pressed in it.
bool field(PanelContext& ctx, const std::string& hint) {
  PaletteState& p = memory(ctx);
  const std::string before = p.typed;
  // The field gets the focus back after Enter, and after a click on a row that did not run.
  if (on_top(ctx) && !ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(width(ctx));
  // ImGui keeps a field's text, so each question has a field of its own.
  ImGui::PushID(static_cast<int>(p.words.size()));
  ImGui::PushID(p.asking.c_str());
  const bool entered = ImGui::InputTextWithHint("##field", hint.c_str(), &p.typed,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::PopID();
  ImGui::PopID();
  record(ctx, "palette.field");
  if (p.typed != before) {
    p.chosen = 0;
    p.error.clear();
  }
  return entered;
}

// Moves the choice by Up and Down. Returns whether it moved.
bool choose_by_keys(PanelContext& ctx, std::size_t count) {
  PaletteState& p = memory(ctx);
  p.chosen = count == 0 ? 0 : std::min(p.chosen, count - 1);
  if (count == 0 || !on_top(ctx)) return false;
  const bool down = ImGui::IsKeyPressed(key::kDown), up = ImGui::IsKeyPressed(key::kUp);
  if (down) p.chosen = (p.chosen + 1) % count;
  if (up) p.chosen = (p.chosen + count - 1) % count;
  if (down || up) p.error.clear();
  return down || up;
}

// Draws the text, and moves `at` behind it.
void put(ImVec2& at, ImU32 colour, const std::string& text) {
  ImGui::GetWindowDrawList()->AddText(at, colour, text.c_str());
  at.x += ImGui::CalcTextSize(text.c_str()).x;
}

void row_texts(PanelContext& ctx, const Row& row, ImVec2 low, ImVec2 high) {
  const ImU32 muted = to_u32(ctx.palette.text_muted);
  const float middle = (low.y + high.y - ImGui::GetTextLineHeight()) / 2;
  ImVec2 at{low.x + ctx.px(6), middle};
  put(at, row.enabled ? to_u32(ctx.palette.text) : muted, row.title);
  if (!row.arguments.empty()) put(at, to_u32(ctx.palette.accent), "  " + row.arguments);
  const float keys_width = row.keys.empty() ? 0 : ImGui::CalcTextSize(row.keys.c_str()).x;
  const float right = high.x - ctx.px(6) - keys_width;
  ImVec2 keys_at{right, middle};
  put(keys_at, muted, row.keys);
  ImGui::PushFont(ctx.fonts.small);
  ImVec2 help_at{std::max(low.x + ctx.px(kHelpAt), at.x + ctx.px(kGap)),
                 (low.y + high.y - ImGui::GetTextLineHeight()) / 2};
  const float room = right - ctx.px(kGap) - help_at.x;
  const ImU32 colour = row.enabled ? muted : to_u32(ctx.palette.warning);
  if (room > ctx.px(40)) put(help_at, colour, fitted_text(row.help, room));
  ImGui::PopFont();
}

// Draws the rows, or the text `none` if there are none. Returns the clicked row, else rows.size().
std::size_t list(PanelContext& ctx, const std::vector<Row>& rows, const char* none) {
  const bool moved = choose_by_keys(ctx, rows.size());
  // Without rows there is no child. One without a height would take the window's, which would then
  // grow.
  if (rows.empty()) {
    muted_text(ctx, none);
    record(ctx, "palette.none");
    return 0;
  }
  const float height = ImGui::GetFrameHeight(), gap = ImGui::GetStyle().ItemSpacing.y;
  const auto shown = static_cast<float>(std::min(rows.size(), kMostRows));
  std::size_t clicked = rows.size();
  ImGui::BeginChild("rows", {width(ctx), shown * (height + gap)}, false);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool chosen = i == memory(ctx).chosen;
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::Selectable("##row", chosen, ImGuiSelectableFlags_DontClosePopups, {0, height})) {
      clicked = i;
    }
    ImGui::PopID();
    record(ctx, rows[i].name.c_str());
    if (chosen && moved) ImGui::SetScrollHereY();
    row_texts(ctx, rows[i], ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  }
  ImGui::EndChild();
  return clicked;
}

void ask_for_arguments(PaletteState& p, const CommandSpec& spec, std::vector<std::string> words) {
  p = {.show = true, .asking = spec.id, .words = std::move(words)};
}

// Runs the command, asks for the next missing argument, or notes an error.
void submit(PanelContext& ctx, const CommandSpec& spec, const CommandLine& line) {
  PaletteState& p = memory(ctx);
  p.error = line.error.empty() ? spec.reason_against() : line.error;
  if (!p.error.empty()) return;
  const Commands::Reading reading = Commands::read(spec, line.words);
  if (reading.missing != nullptr && line.words.size() >= p.words.size()) {
    ask_for_arguments(p, spec, line.words);
    return;
  }
  const Outcome outcome = ctx.commands.run(spec.id, line.words);
  if (outcome.state == Outcome::State::refused || outcome.state == Outcome::State::failed) {
    p.error = outcome.why;
  } else {
    p = {};
  }
}

std::string shown_arguments(const CommandMatch& m) {
  if (!m.arguments.empty() || !m.command->is_switch()) return m.arguments;
  return m.command->checked() ? "is on" : "is off";
}

void search(PanelContext& ctx) {
  const bool entered = field(ctx, "Name of a command, such as reset, or alpha 3.2");
  const std::vector<CommandMatch> matches = search_commands(ctx.commands, memory(ctx).typed);
  std::vector<Row> rows;
  for (const CommandMatch& m : matches) {
    const std::string reason = m.command->reason_against();
    rows.push_back({"palette." + m.command->id, m.command->title, shown_arguments(m),
                    reason.empty() ? m.command->help : reason, m.command->shortcuts_text(),
                    reason.empty()});
  }
  std::size_t taken = list(ctx, rows, "No command has these words in its name or help.");
  if (entered && !rows.empty()) taken = memory(ctx).chosen;
  if (taken >= matches.size()) return;
  const CommandMatch& m = matches[taken];
  submit(ctx, *m.command, Commands::parse_words(*m.command, m.arguments));
}

bool contains(const std::string& text, const std::string& part) {
  return lower_case(text).find(lower_case(part)) != std::string::npos;
}

std::vector<Row> choice_rows(const Parameter& parameter, const std::string& typed) {
  std::vector<Row> rows;
  for (const Choice& choice : parameter.choices()) {
    if (!contains(choice.id + " " + choice.title, typed)) continue;
    rows.push_back({"palette.choice." + choice.id, choice.title, {}, choice.detail, choice.id});
  }
  return rows;
}

void ask(PanelContext& ctx, const CommandSpec& spec, const Parameter& parameter) {
  PaletteState& p = memory(ctx);
  std::string title = spec.title;
  for (const std::string& word : p.words) title += "  " + word;
  strong_text(ctx, title);
  bool entered = field(ctx, parameter.name);
  muted_text(ctx, parameter.what_to_type());
  record(ctx, "palette.asks");
  CommandLine line{spec.id, p.words, {}};
  if (parameter.kind == Parameter::Kind::choice) {
    const std::vector<Row> rows = choice_rows(parameter, p.typed);
    std::size_t taken = list(ctx, rows, "There is no such choice.");
    if (entered && !rows.empty()) taken = p.chosen;
    if (taken < rows.size()) entered = true;
    line.words.push_back(taken < rows.size() ? rows[taken].keys : p.typed);
  } else {
    line.words.push_back(p.typed);
  }
  if (entered) submit(ctx, spec, line);
}

void footer(PanelContext& ctx) {
  const PaletteState& p = memory(ctx);
  ImGui::PushFont(ctx.fonts.small);
  if (p.error.empty()) {
    muted_text(ctx, p.asking.empty() ? "Up, Down: choose     Enter: run     Esc: close"
                                     : "Enter: run     Esc: back to the commands");
  } else {
    ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.error));
    ImGui::TextUnformatted(broken_lines(p.error, width(ctx)).c_str());
    ImGui::PopStyleColor();
    record(ctx, "palette.error");
  }
  ImGui::PopFont();
}

void close_or_go_back(PanelContext& ctx) {
  PaletteState& p = memory(ctx);
  if (!on_top(ctx)) return;
  const bool outside =
      ImGui::IsMouseClicked(0) && !ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows);
  // escape_pressed() fails here, because the field always takes text.
  const bool escape = ImGui::IsKeyPressed(key::kEscape, false);
  if (outside || (escape && p.asking.empty())) {
    p = {};
  } else if (escape) {
    p = {.show = true};
  }
}

}  // namespace

void draw_command_palette(PanelContext& ctx) {
  if (!begin_dialog(ctx, "Commands###palette", {0, 0}, DialogPlace::top)) return;
  const CommandSpec* const spec = ctx.commands.find(memory(ctx).asking);
  const Parameter* const missing =
      spec ? Commands::read(*spec, memory(ctx).words).missing : nullptr;
  close_or_go_back(ctx);
  if (memory(ctx).show && missing) {
    ask(ctx, *spec, *missing);
  } else if (memory(ctx).show) {
    search(ctx);
  }
  footer(ctx);
  end_dialog(ctx);
}

}  // namespace alphascope
