// SPDX-License-Identifier: GPL-3.0-or-later
// The waterfall of the timings. Each stage is one line and starts where the previous one ended. Our
// engine is above CGAL, on one time axis.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "core/complex/engine_info.hpp"
#include "core/complex/face_class.hpp"
#include "core/document/commands/commands.hpp"
#include "core/engine/cold_and_warm.hpp"
#include "core/engine/known_results.hpp"
#include "core/run/stage_timer.hpp"
#include "core/triangulation/triangulation_report.hpp"
#include "ui/calls.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/complex/shown_triangulation.hpp"
#include "ui/panels/complex/timings_text.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/running_job.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/plot.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

// Width of the names in pixels at scale 1. The wide one is for headings that end in "tetrahedra
// only". A width that followed the text would make the chart jump while alpha moves.
constexpr float kGutter = 250, kWideGutter = 350;

struct Line {
  std::string label;
  double start = 0, length = 0;  // milliseconds
  Colour colour;
  bool heading = false;
};

const MeasuredRun* shown_run(const ColdAndWarm& timings, bool cold) {
  const auto& run = cold ? timings.cold : timings.warm;
  return run ? &*run : nullptr;
}

void add_lines(std::vector<Line>& lines, const EngineInfo& engine, const MeasuredRun& run,
               const Colour& bar, const Colour& setup_bar) {
  const std::string task = "  α " + short_number_text(run.alpha_angstrom2, 3) +
                           (run.tetrahedra_only ? ", tetrahedra only" : "");
  lines.push_back(
      {engine.name + ", " + engine.device + task, 0, run.times.wall_milliseconds, bar, true});
  double start = 0;
  for (const StageTime& stage : run.times.stages) {
    lines.push_back({stage.label, start, stage.milliseconds, stage.setup ? setup_bar : bar, false});
    start += stage.milliseconds;
  }
}

void add_lines(std::vector<Line>& lines, const TriangulationReport& report, const Colour& bar) {
  lines.push_back({"triangulation of all balls, " + report.maker, 0,
                   report.timings.wall_milliseconds, bar, true});
  double start = 0;
  for (const StageTime& stage : report.timings.stages) {
    lines.push_back({stage.label, start, stage.milliseconds, bar, false});
    start += stage.milliseconds;
  }
}

class Waterfall {
 public:
  Waterfall(PanelContext& ctx, double range, std::size_t lines, float gutter)
      : ctx_(ctx), draw_(ImGui::GetWindowDrawList()) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    left_ = corner.x;
    row_ = ctx.px(15.5f);
    plot_.numbers_above = true;
    plot_.x = {.range = {0, std::max(range, 1e-6)}, .unit = "ms"};
    plot_.y = {.range = {static_cast<double>(lines), 0}, .numbered = false};
    area_.left = corner.x + std::min(ctx.px(gutter), 0.36f * width);
    area_.right = corner.x + width - ctx.px(86);  // room for the last duration
    area_.top = corner.y + row_;
    area_.bottom = area_.top + row_ * static_cast<float>(lines);
    area_.x = plot_.x.range;
    area_.y = plot_.y.range;
  }

  void add(const Line& line, std::size_t index) {
    // The whole run is a thin rail, and its stages hang below it.
    const double middle = static_cast<double>(index) + 0.5;
    const double half = line.heading ? 2 / 15.5 : 0.5 - 3 / 15.5;
    const double least = area_.x_at(area_.left + 2) - area_.x.low;  // two pixels
    plot_.boxes.push_back({line.start, line.start + std::max(line.length, least), middle - half,
                           middle + half, plot_colour(line.colour, line.heading ? 0.45f : 1), true,
                           2});
  }

  void draw() { draw_plot(ctx_, plot_, area_); }

  // Draws the name and the duration, beside the bar.
  void name(const Line& line, int index) {
    const float y = area_.top + row_ * static_cast<float>(index);
    ImGui::SetCursorScreenPos({left_, y});
    ImGui::PushID(index);
    ImGui::InvisibleButton("##line", {area_.right - left_ + ctx_.px(80), row_});
    ImGui::PopID();
    tooltip(ctx_, (line.label + ": " + milliseconds_text(line.length)).c_str());
    if (line.heading) ImGui::PushFont(ctx_.fonts.strong);
    const float indent = line.heading ? 0 : ctx_.px(12);
    const std::string label = fitted_text(line.label, area_.left - left_ - indent - ctx_.px(10));
    const float text = y + (row_ - ImGui::GetFontSize()) / 2;
    draw_->AddText({left_ + indent, text},
                   to_u32(line.heading ? ctx_.palette.text : ctx_.palette.text_muted),
                   label.c_str());
    const float end =
        std::max(area_.x_of(line.start + line.length), area_.x_of(line.start) + 2) + ctx_.px(6);
    draw_->AddText({end, text}, to_u32(ctx_.palette.text), milliseconds_text(line.length).c_str());
    if (line.heading) ImGui::PopFont();
  }

 private:
  PanelContext& ctx_;
  ImDrawList* draw_;
  Plot plot_;
  PlotArea area_;
  float left_, row_;
};

void missing(PanelContext& ctx, bool cold) {
  ViewState& s = ctx.state;
  const std::vector<std::string> sentences = missing_times(s, cold);
  if (sentences.empty()) return;
  ImGui::Dummy({0, ctx.px(3)});
  for (const std::string& sentence : sentences) muted_wrapped(ctx, sentence);
  record(ctx, "timings.missing");
  if (!cold || !lacks_cold_time(s)) return;
  ImGui::BeginDisabled(awaited_job(s.jobs) != nullptr);
  if (button(ctx, "timings.compute_anew", "Measure cold times")) ctx.calls.jobs.compute_anew();
  ImGui::EndDisabled();
  tooltip(ctx,
          "Computes the same complex again as if the molecule had just been opened, including "
          "set-up. CGAL triangulates again at the next comparison.");
}

}  // namespace

void draw_waterfall(PanelContext& ctx, bool cold, float height) {
  const ViewState& s = ctx.state;
  const Palette& p = ctx.palette;
  ImGui::BeginChild("waterfall", {0, height});
  ImGui::PushFont(ctx.fonts.small);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  std::vector<Line> lines;
  double range = 0;
  bool only_tetrahedra = false;
  if (const MeasuredRun* run = shown_run(s.ours, cold)) {
    add_lines(lines, s.ours.engine, *run, p.bar_ours, p.bar_ours_setup);
    // Stages of the picture end after the wall time.
    range = std::max(range, lines.back().start + lines.back().length);
    range = std::max(range, run->times.wall_milliseconds);
    only_tetrahedra |= run->tetrahedra_only;
  }
  if (const MeasuredRun* run = shown_run(s.cgal, cold)) {
    add_lines(lines, s.cgal.engine, *run, p.bar_cgal, p.bar_cgal_setup);
    range = std::max(range, run->times.wall_milliseconds);
    only_tetrahedra |= run->tetrahedra_only;
  }
  if (const MeasuredRun* run = shown_run(s.cgal_parallel, cold)) {
    add_lines(lines, s.cgal_parallel.engine, *run, p.bar_cgal, p.bar_cgal_setup);
    range = std::max(range, run->times.wall_milliseconds);
    only_tetrahedra |= run->tetrahedra_only;
  }
  const auto triangulation = cold ? shown_triangulation(ctx) : nullptr;
  if (triangulation) {
    add_lines(lines, *triangulation,
              triangulation->by == TriangulationReport::By::cgal ? p.bar_cgal : p.bar_ours);
    range = std::max(range, triangulation->timings.wall_milliseconds);
  }
  if (!lines.empty()) {
    Waterfall chart(ctx, range, lines.size(), only_tetrahedra ? kWideGutter : kGutter);
    for (std::size_t i = 0; i < lines.size(); ++i) chart.add(lines[i], i);
    chart.draw();
    for (std::size_t i = 0; i < lines.size(); ++i) chart.name(lines[i], static_cast<int>(i));
  }
  ImGui::PopStyleVar();
  if (triangulation) {
    for (const std::string& sentence : triangulation_sentences(*triangulation))
      muted_wrapped(ctx, sentence);
  }
  missing(ctx, cold);
  ImGui::PopFont();
  ImGui::EndChild();
  record(ctx, "timings.waterfall");
}

}  // namespace alphascope
