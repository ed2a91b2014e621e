// The benchmark page: measures the open molecule, and shows the thesis' table and figures of it. It
// is modal, so that no other work takes the cores meanwhile.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "core/chart/layout.hpp"
#include "ui/panels/dialogs/dialog_stack.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/number_field.hpp"

namespace alphascope {
namespace {

ImU32 ink(const Palette& p, ChartInk ink) {
  switch (ink) {
    case ChartInk::text:
      return to_u32(p.text);
    case ChartInk::grid:
      return to_u32(p.border);
    case ChartInk::muted:
    case ChartInk::axis:
      break;
  }
  return to_u32(p.text_muted);
}

ImU32 ink_of_series(std::size_t n) {
  const ChartColour c = chart_colour(n);
  return IM_COL32(c.r, c.g, c.b, 255);
}

void dashed(ImDrawList* draw, ImVec2 from, ImVec2 to, ImU32 colour, float dash) {
  const float dx = to.x - from.x, dy = to.y - from.y;
  const float length = std::max(1.0f, std::sqrt(dx * dx + dy * dy));
  const int dashes = static_cast<int>(std::ceil(length / (2 * dash)));
  for (int n = 0; n < dashes; ++n) {
    const float at = 2 * dash * static_cast<float>(n);
    const float end = std::min(at + dash, length);
    draw->AddLine({from.x + dx * at / length, from.y + dy * at / length},
                  {from.x + dx * end / length, from.y + dy * end / length}, colour, 1);
  }
}

void draw_chart(PanelContext& ctx, const Chart& chart) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const auto width_of = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
  const ChartDrawing d = lay_out(chart, ImGui::GetContentRegionAvail().x - ctx.px(8),
                                 {ImGui::GetFontSize(), width_of});
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const auto at = [&](float x, float y) { return ImVec2{origin.x + x, origin.y + y}; };
  for (const ChartLine& l : d.lines) {
    const ImU32 colour = l.series ? ink_of_series(*l.series) : ink(ctx.palette, l.ink);
    if (l.dashed) {
      dashed(draw, at(l.x0, l.y0), at(l.x1, l.y1), colour, ctx.px(4));
    } else {
      draw->AddLine(at(l.x0, l.y0), at(l.x1, l.y1), colour, l.series ? ctx.px(2) : 1);
    }
  }
  std::string tip;
  const auto over = [&](float x0, float y0, float x1, float y1, const std::string& what) {
    if (ImGui::IsMouseHoveringRect(at(x0, y0), at(x1, y1))) tip = what;
  };
  for (const ChartBox& b : d.boxes) {
    draw->AddRectFilled(at(b.x, b.y), at(b.x + b.width, b.y + b.height), ink_of_series(b.series));
    over(b.x, b.y, b.x + b.width, b.y + b.height, b.tip);
  }
  const float r = ctx.px(3.5f);
  for (const ChartDot& p : d.dots) {
    draw->AddCircleFilled(at(p.x, p.y), r, ink_of_series(p.series));
    over(p.x - r, p.y - r, p.x + r, p.y + r, p.tip);
  }
  for (const ChartText& t : d.texts) {
    const float width = width_of(t.text), middle = ImGui::GetFontSize() / 2;
    const float shift = t.anchor == ChartAnchor::start    ? 0
                        : t.anchor == ChartAnchor::middle ? width / 2
                                                          : width;
    if (t.title) ImGui::PushFont(ctx.fonts.strong);
    draw->AddText(at(t.x - shift, t.y - middle), ink(ctx.palette, t.ink), t.text.c_str());
    if (t.title) ImGui::PopFont();
  }
  ImGui::Dummy({d.width, d.height + ctx.px(16)});
  if (!tip.empty()) ImGui::SetTooltip("%s", tip.c_str());
}

void engine_box(PanelContext& ctx, EngineChoice choice) {
  const bool usable = !needs_gpu(choice) || has_gpu(ctx.state);
  std::set<EngineChoice>& wanted = ctx.state.benchmark_controls.engines;
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

void controls(PanelContext& ctx) {
  BenchmarkControls& c = ctx.state.benchmark_controls;
  ImGui::BeginDisabled(ctx.state.benchmark.running);
  row_label(ctx, "Alphas (Å²)");
  ImGui::SetNextItemWidth(ctx.px(190));
  text_field(ctx, "benchmark.alphas", c.alphas);
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
  checkbox(ctx, "benchmark.ablation", "each optimisation off in turn", c.ablation);
  tooltip(ctx,
          "Measures the tuple engines again at the smallest alpha, with one optimisation off at a "
          "time.");
  ImGui::EndDisabled();
}

void run_row(PanelContext& ctx) {
  ViewState& s = ctx.state;
  BenchmarkInfo& b = s.benchmark;
  row_label(ctx, "");
  // Cancel has a place of its own, so that a second click on Run does not cancel.
  ImGui::BeginDisabled(!b.running);
  if (button(ctx, "benchmark.cancel", "Cancel", {ctx.px(100), 0})) {
    ctx.calls.jobs.cancel(JobId::benchmark);
  }
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (b.running) {
    ImGui::ProgressBar(static_cast<float>(b.share), {ctx.px(160), 0});
    ImGui::SameLine(0, ctx.px(12));
    muted_text(ctx, b.progress);
    return;
  }
  ImGui::BeginDisabled(!s.molecule.loaded);
  const bool clicked = button(ctx, "benchmark.run", "Run", {ctx.px(100), 0}, ButtonKind::primary);
  if (clicked || (s.molecule.loaded && enter_pressed(ctx))) {
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

// Returns the width that other columns leave to the last one, pixels. It holds notes: sentences,
// which can be wrapped.
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
  int page = s.benchmark_controls.charts ? 1 : 0;
  choice(ctx, "benchmark.page", {"Table", "Charts"}, page, ctx.px(180));
  s.benchmark_controls.charts = page == 1;
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
  ImGui::BeginDisabled(!s.benchmark.can_export || s.benchmark_controls.folder.empty());
  if (button(ctx, "benchmark.export", "Export CSV and SVG", {ctx.px(170), 0})) {
    ctx.calls.jobs.export_benchmark();
  }
  ImGui::EndDisabled();
  ImGui::SameLine(0, ctx.px(8));
  ImGui::TextUnformatted("into the folder");
  ImGui::SameLine(0, ctx.px(8));
  ImGui::SetNextItemWidth(ctx.px(260));
  text_field(ctx, "benchmark.folder", s.benchmark_controls.folder);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ctx.px(100));
  ImGui::BeginDisabled(s.benchmark.running);
  const bool closed = button(ctx, "benchmark.close", "Close", {ctx.px(100), 0}) ||
                      (!s.benchmark.running && escape_pressed(ctx));
  ImGui::EndDisabled();
  if (closed) s.memory.show_benchmark = false;
}

void message(PanelContext& ctx) {
  const BenchmarkInfo& b = ctx.state.benchmark;
  const std::string& text = !b.error.empty()      ? b.error
                            : !b.exported.empty() ? b.exported
                                                  : b.cancelled;
  const Colour& colour = !b.error.empty()      ? ctx.palette.error
                         : !b.exported.empty() ? ctx.palette.success
                                               : ctx.palette.text_muted;
  ImGui::TextColored(to_imgui(colour), "%s", text.c_str());
  record(ctx, "benchmark.message");
}

}  // namespace

void draw_benchmark_page(PanelContext& ctx) {
  constexpr const char* kTitle = "Benchmark: the thesis' table and figures";
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  if (!begin_dialog(ctx, kTitle, {display.x * 0.92f, display.y * 0.9f})) return;
  controls(ctx);
  run_row(ctx);
  message(ctx);
  results(ctx, ImGui::GetContentRegionAvail().y - ImGui::GetFrameHeightWithSpacing() - ctx.px(6));
  export_row(ctx);
  end_dialog(ctx);
}

}  // namespace alphascope
