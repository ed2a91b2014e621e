// The waterfall of the timings. Each stage is one line and starts where the previous one ended. Our
// engine is above CGAL, on one time axis.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/chart/readable_number.hpp"
#include "ui/panels/complex/timings_text.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/format.hpp"

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

// Returns 1, 2 or 5 times a power of ten, so that at most `most` ticks cover `range`.
double tick_step(double range, int most) {
  double step = std::pow(10.0, std::floor(std::log10(std::max(range, 1e-9))) - 1);
  for (const double factor : {2.0, 2.5, 2.0, 2.0, 2.5, 2.0, 2.0}) {
    if (range / step <= most) break;
    step *= factor;
  }
  return step;
}

class Waterfall {
 public:
  Waterfall(PanelContext& ctx, double range, std::size_t lines, float gutter)
      : ctx_(ctx), draw_(ImGui::GetWindowDrawList()), range_(std::max(range, 1e-6)) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    gutter_ = corner.x + std::min(ctx.px(gutter), 0.36f * width);
    left_ = corner.x;
    right_ = corner.x + width - ctx.px(86);  // room for the last duration
    top_ = corner.y;
    row_ = ctx.px(15.5f);
    bottom_ = top_ + row_ * static_cast<float>(lines + 1);
  }

  float x(double ms) const {
    return gutter_ + static_cast<float>(ms / range_) * (right_ - gutter_);
  }

  void axis() {
    const int most = std::max(2, static_cast<int>((right_ - gutter_) / ctx_.px(90)));
    const double step = tick_step(range_, most);
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
    for (int i = 0; i * step <= range_ * (1 + 1e-9); ++i) {
      const float tick = std::round(x(i * step));
      draw_->AddLine({tick, top_ + row_}, {tick, bottom_}, to_u32(ctx_.palette.border), 1);
      char printed[32];
      std::snprintf(printed, sizeof printed, "%.*f", decimals, i * step);
      const std::string text = separated_number(printed) + (i == 0 ? " ms" : "");
      draw_->AddText({tick, top_}, to_u32(ctx_.palette.text_muted), text.c_str());
    }
  }

  void line(const Line& line, int index) {
    const float y = top_ + row_ * static_cast<float>(index + 1);
    const float pad = ctx_.px(3);
    const float start = x(line.start), end = std::max(x(line.start + line.length), start + 2);
    ImGui::SetCursorScreenPos({left_, y});
    ImGui::PushID(index);
    ImGui::InvisibleButton("##line", {right_ - left_ + ctx_.px(80), row_});
    ImGui::PopID();
    tooltip(ctx_, (line.label + ": " + milliseconds_text(line.length)).c_str());
    if (line.heading) ImGui::PushFont(ctx_.fonts.strong);
    const float indent = line.heading ? 0 : ctx_.px(12);
    const std::string label = fitted_text(line.label, gutter_ - left_ - indent - ctx_.px(10));
    draw_->AddText({left_ + indent, y + (row_ - ImGui::GetFontSize()) / 2},
                   to_u32(line.heading ? ctx_.palette.text : ctx_.palette.text_muted),
                   label.c_str());
    if (line.heading) {
      // The whole run is a thin rail, and its stages hang below it.
      const float middle = std::round(y + row_ / 2);
      draw_->AddRectFilled({start, middle - ctx_.px(2)}, {end, middle + ctx_.px(2)},
                           to_u32(line.colour, 0.45f), ctx_.px(2));
    } else {
      draw_->AddRectFilled({start, y + pad}, {end, y + row_ - pad}, to_u32(line.colour),
                           ctx_.px(2));
    }
    draw_->AddText({end + ctx_.px(6), y + (row_ - ImGui::GetFontSize()) / 2},
                   to_u32(ctx_.palette.text), milliseconds_text(line.length).c_str());
    if (line.heading) ImGui::PopFont();
  }

 private:
  PanelContext& ctx_;
  ImDrawList* draw_;
  double range_;
  float left_, gutter_, right_, top_, bottom_, row_;
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
  if (!lines.empty()) {
    Waterfall chart(ctx, range, lines.size(), only_tetrahedra ? kWideGutter : kGutter);
    chart.axis();
    for (std::size_t i = 0; i < lines.size(); ++i) chart.line(lines[i], static_cast<int>(i));
  }
  ImGui::PopStyleVar();
  missing(ctx, cold);
  ImGui::PopFont();
  ImGui::EndChild();
  record(ctx, "timings.waterfall");
}

}  // namespace alphascope
