// SPDX-License-Identifier: GPL-3.0-or-later
// The benchmark page: measures the open molecule, and shows the thesis' table and figures of it. It
// is modal, so that no other work takes the cores meanwhile.
#include <imgui.h>

#include <algorithm>

#include "core/chart/layout.hpp"
#include "core/document/commands/commands.hpp"
#include "core/document/export/program_name.hpp"
#include "core/engine/engine_choice.hpp"
#include "core/engine/gpu_device.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "ui/calls.hpp"
#include "ui/panels/dialogs/benchmark_info.hpp"
#include "ui/panels/dialogs/dialog_stack.hpp"
#include "ui/panels/dialogs/dialog_state.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/running_job.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/number_field.hpp"
#include "ui/widgets/plot.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

void draw_chart(PanelContext& ctx, const Chart& chart) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const ChartDrawing d =
      lay_out(chart, ImGui::GetContentRegionAvail().x - ctx.px(8), chart_type(ctx));
  const std::string tip = draw_drawing(ctx, d, origin);
  ImGui::Dummy({d.width, d.height + ctx.px(16)});
  if (!tip.empty()) ImGui::SetTooltip("%s", tip.c_str());
}

void engine_box(PanelContext& ctx, EngineChoice choice) {
  const bool usable = !needs_gpu(choice) || has_gpu(ctx.state);
  std::set<EngineChoice>& wanted = ctx.state.benchmark_settings.engines;
  const std::string id(engine_id(choice));
  ImGui::BeginDisabled(!usable);
  bool shown = wanted.contains(choice) && usable;
  if (checkbox(ctx, ("benchmark." + id).c_str(), engine_title(choice).data(), shown)) {
    if (shown) {
      wanted.insert(choice);
    } else {
      wanted.erase(choice);
    }
  }
  ImGui::EndDisabled();
  const std::string help = usable          ? "“" + id + "” in table, figures and files."
                           : ctx.state.gpu ? ctx.state.gpu->why_not
                                           : "";
  tooltip(ctx, help.c_str());
}

void labelled_number(PanelContext& ctx, const char* name, const char* label, int& value,
                     const NumberRule& rule) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label);
  ImGui::SameLine(0, ctx.px(6));
  ImGui::SetNextItemWidth(ctx.px(56));
  number_field(ctx, name, value, rule);
  ImGui::SameLine(0, ctx.px(16));
}

// Returns whether Enter was pressed in a field for text.
bool controls(PanelContext& ctx) {
  BenchmarkSettings& c = ctx.state.benchmark_settings;
  ImGui::BeginDisabled(ctx.state.benchmark.running);
  row_label(ctx, "Alphas (Å²)");
  ImGui::SetNextItemWidth(ctx.px(190));
  const bool entered = text_field(ctx, "benchmark.alphas", c.alphas);
  ImGui::SameLine(0, ctx.px(16));
  labelled_number(ctx, "benchmark.runs", "runs", c.runs, kRunsRule);
  labelled_number(ctx, "benchmark.seconds", "seconds per row, at most", c.seconds_per_row,
                  kRowSecondsRule);
  tooltip(ctx, "A row that cannot finish one run in this time is left out; nothing is estimated.");
  ImGui::NewLine();
  row_label(ctx, "Engines");
  for (const EngineChoice choice : suite_engines()) {
    engine_box(ctx, choice);
    ImGui::SameLine(0, ctx.px(16));
  }
  ImGui::NewLine();
  row_label(ctx, "Optimisations");
  checkbox(ctx, "benchmark.ablation", "each optimisation off in turn", c.ablation);
  tooltip(ctx,
          "Measures the tuple engines again at the smallest alpha, with one optimisation off at a "
          "time.");
  ImGui::EndDisabled();
  return entered;
}

void run_row(PanelContext& ctx, bool entered) {
  ViewState& s = ctx.state;
  BenchmarkInfo& b = s.benchmark;
  row_label(ctx, "");
  // Cancel has a place of its own, so that a second click on Run does not cancel.
  ImGui::BeginDisabled(!b.running && !b.exporting);
  if (button(ctx, "benchmark.cancel", "Cancel", {ctx.px(100), 0})) {
    ctx.calls.jobs.cancel(b.running ? JobId::benchmark : JobId::benchmark_files);
  }
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (b.running) {
    ImGui::ProgressBar(static_cast<float>(b.share), {ctx.px(160), 0});
    ImGui::SameLine(0, ctx.px(12));
    muted_text(ctx, b.progress);
    return;
  }
  const bool can_run = s.molecule.loaded && !b.exporting && !has_refused_number(ctx, "benchmark");
  entered |= entered_field(ctx) || enter_pressed(ctx);
  ImGui::BeginDisabled(!can_run);
  const bool clicked = button(ctx, "benchmark.run", "Run", {ctx.px(100), 0}, ButtonKind::primary);
  if (clicked || (can_run && entered)) {
    ctx.calls.jobs.run_benchmark();
  }
  ImGui::EndDisabled();
  ImGui::SameLine(0, ctx.px(12));
  muted_text(ctx, s.molecule.loaded ? s.molecule.name + ", tetrahedra only, beside CGAL"
                                    : "Open a molecule first.");
}

// Puts the last word of a name, most often a unit, below the others. Numbers need less width.
std::string header_text(std::string name) {
  const std::size_t blank = name.rfind(' ');
  if (blank != std::string::npos) name[blank] = '\n';
  return name;
}

// Returns the width that the other columns leave for the last one, pixels. The last column has
// notes, whose sentences are wrapped.
float note_width(PanelContext& ctx, float table_width) {
  const BenchmarkInfo& b = ctx.state.benchmark;
  const ImGuiStyle& style = ImGui::GetStyle();
  constexpr float kBorder = 1;
  float left = table_width - style.ScrollbarSize;
  for (std::size_t c = 0; c < b.columns.size(); ++c) {
    left -= 2 * style.CellPadding.x + kBorder;
    if (c + 1 == b.columns.size()) break;
    float widest = ImGui::CalcTextSize(header_text(b.columns[c]).c_str()).x;
    for (const auto& row : b.rows) {
      widest = std::max(widest, ImGui::CalcTextSize(row[c].c_str()).x);
    }
    left -= widest;
  }
  return std::max(left, ctx.px(90));
}

void table_row(PanelContext& ctx, std::size_t r, float notes) {
  const BenchmarkInfo& b = ctx.state.benchmark;
  ImGui::TableNextRow();
  if (b.differs[r]) ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.error));
  for (const std::string& text : b.rows[r]) {
    ImGui::TableNextColumn();
    const bool note = &text == &b.rows[r].back();
    ImGui::TextUnformatted((note ? broken_lines(text, notes) : text).c_str());
    if (note) record(ctx, ("benchmark.note." + std::to_string(r)).c_str());
  }
  if (b.differs[r]) ImGui::PopStyleColor();
}

void table_rows(PanelContext& ctx, float notes) {
  const BenchmarkInfo& b = ctx.state.benchmark;
  ImGui::TableSetupScrollFreeze(1, 1);
  for (const std::string& name : b.columns) ImGui::TableSetupColumn(header_text(name).c_str());
  ImGui::TableHeadersRow();
  for (std::size_t r = 0; r < b.rows.size(); ++r) table_row(ctx, r, notes);
  ImGui::EndTable();
}

void table(PanelContext& ctx, float height) {
  const BenchmarkInfo& b = ctx.state.benchmark;
  const int columns = static_cast<int>(b.columns.size());
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY |
                                     ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV |
                                     ImGuiTableFlags_SizingFixedFit;
  if (columns == 0) {
    muted_wrapped(
        ctx,
        "Run measures each engine at each alpha, beside CGAL. Rows appear here as they are "
        "finished; Cancel keeps them.");
    record(ctx, "benchmark.empty");
    return;
  }
  ImGui::PushStyleColor(ImGuiCol_TableRowBgAlt, to_imgui(ctx.palette.field, 0.45f));
  const float notes = note_width(ctx, ImGui::GetContentRegionAvail().x);
  const bool open = ImGui::BeginTable("rows", columns, kFlags, {0, height});
  if (open) table_rows(ctx, notes);
  ImGui::PopStyleColor();
  record(ctx, "benchmark.table");
}

void table_page(PanelContext& ctx) {
  const std::vector<std::string>& lines = ctx.state.benchmark.lines;
  const float below = ImGui::GetTextLineHeightWithSpacing() * static_cast<float>(lines.size());
  table(ctx, std::max(ctx.px(80), ImGui::GetContentRegionAvail().y - below - ctx.px(4)));
  for (const std::string& text : lines) muted_text(ctx, text);
}

void chart_page(PanelContext& ctx) {
  const BenchmarkInfo& b = ctx.state.benchmark;
  if (b.charts.empty()) muted_text(ctx, "Charts appear at the end of a run.");
  for (const Chart& chart : b.charts) draw_chart(ctx, chart);
}

void results(PanelContext& ctx, float height) {
  ViewState& s = ctx.state;
  int page = s.benchmark_settings.charts ? 1 : 0;
  choice(ctx, "benchmark.page", {"Table", "Charts"}, page, ctx.px(180));
  s.benchmark_settings.charts = page == 1;
  height -= ImGui::GetFrameHeightWithSpacing();
  ImGui::PushFont(ctx.fonts.small);
  ImGui::BeginChild("results", {0, height});
  page == 0 ? table_page(ctx) : chart_page(ctx);
  ImGui::EndChild();
  record(ctx, "benchmark.results");
  ImGui::PopFont();
}

void export_row(PanelContext& ctx) {
  ViewState& s = ctx.state;
  const BenchmarkInfo& b = s.benchmark;
  ImGui::BeginDisabled(!b.can_export || b.exporting || s.benchmark_settings.folder.empty());
  if (button(ctx, "benchmark.export", "Export CSV and SVG", {ctx.px(170), 0})) {
    ctx.calls.jobs.export_benchmark();
  }
  ImGui::EndDisabled();
  ImGui::SameLine(0, ctx.px(8));
  ImGui::TextUnformatted("into the folder");
  ImGui::SameLine(0, ctx.px(8));
  ImGui::SetNextItemWidth(ctx.px(260));
  text_field(ctx, "benchmark.folder", s.benchmark_settings.folder);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ctx.px(100));
  ImGui::BeginDisabled(s.benchmark.running);
  const bool closed = button(ctx, "benchmark.close", "Close", {ctx.px(100), 0}) ||
                      (!s.benchmark.running && escape_pressed(ctx));
  ImGui::EndDisabled();
  if (closed) s.dialogs.show_benchmark = false;
}

void message(PanelContext& ctx) {
  const BenchmarkInfo& b = ctx.state.benchmark;
  const std::string text = b.exporting           ? "Writing the table and the figures…"
                           : !b.error.empty()    ? b.error
                           : !b.exported.empty() ? b.exported
                                                 : b.cancelled;
  const Colour& colour = !b.error.empty()      ? ctx.palette.error
                         : !b.exported.empty() ? ctx.palette.success
                                               : ctx.palette.text_muted;
  ImGui::TextColored(to_imgui(colour), "%s", text.c_str());
  record(ctx, "benchmark.message");
}

}  // namespace

void draw_benchmark_dialog(PanelContext& ctx) {
  constexpr const char* kTitle = "Benchmark: the thesis' table and figures";
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  if (!begin_dialog(ctx, kTitle, {display.x * 0.92f, display.y * 0.9f})) return;
  const bool entered = controls(ctx);
  run_row(ctx, entered);
  message(ctx);
  results(ctx, ImGui::GetContentRegionAvail().y - ImGui::GetFrameHeightWithSpacing() - ctx.px(6));
  export_row(ctx);
  end_dialog(ctx);
}

}  // namespace alphascope
