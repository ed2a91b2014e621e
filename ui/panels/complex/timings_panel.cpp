// SPDX-License-Identifier: GPL-3.0-or-later
// The page of timings: our engine's times beside CGAL's, and whether both complexes are equal.
#include <optional>

#include "core/document/store/answer.hpp"
#include "core/engine/cold_and_warm.hpp"
#include "ui/calls.hpp"
#include "ui/panels/complex/timings_state.hpp"
#include "ui/panels/complex/timings_text.hpp"
#include "ui/panels/molecule/reset_for_molecule.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/work_info.hpp"
#include "ui/running_job.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// Shorter comparisons end before a user could press Cancel.
constexpr double kCancelAfterSeconds = 1;

struct BadgeLook {
  Colour text, fill;
};

BadgeLook look(const Palette& p, BadgeInfo::State state) {
  switch (state) {
    case BadgeInfo::State::identical:
      return {p.success, p.success_fill};
    case BadgeInfo::State::different:
      return {p.error, p.error_fill};
    case BadgeInfo::State::failed:
      return {p.warning, p.warning_fill};
    case BadgeInfo::State::comparing:
    case BadgeInfo::State::not_compared:
      break;
  }
  return {p.text_muted, p.field};
}

void pill(PanelContext& ctx, const std::string& text, const Colour& colour, const Colour& fill) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight(), width = size.x + ctx.px(20);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(corner, {corner.x + width, corner.y + height}, to_u32(fill), height / 2);
  draw->AddText({corner.x + ctx.px(10), corner.y + (height - size.y) / 2}, to_u32(colour),
                text.c_str());
  ImGui::Dummy({width, height});
}

std::string badge_help(const ViewState& s) {
  const bool identical = s.badge.state == BadgeInfo::State::identical;
  const bool different = s.badge.state == BadgeInfo::State::different;
  if (!identical && !different) return {};
  std::string text =
      s.result && s.result->complex.tetrahedra_only
          ? "\n\nThe tetrahedra of both were compared one by one."
          : "\n\nVertices, edges, triangles and tetrahedra of both were compared one "
            "by one, with their alpha values and classes.";
  if (different) {
    text +=
        " In the picture, simplices that only CGAL has are magenta; those that only this engine "
        "has are yellow.";
  }
  return text;
}

// Shortens "✓ identical to CGAL: 16,445 of …" to "✓ identical to CGAL" or "✓ identical". The
// tooltip has the numbers.
std::string badge_text(const std::string& full, float room) {
  const auto fits = [room](const std::string& text) {
    return ImGui::CalcTextSize(text.c_str()).x <= room;
  };
  if (fits(full)) return full;
  const std::string what = full.substr(0, full.find_first_of(":,"));
  if (fits(what)) return what;
  return what.substr(0, what.find(' ', what.find(' ') + 1));
}

void badge(PanelContext& ctx) {
  const BadgeInfo& b = ctx.state.badge;
  const BadgeLook l = look(ctx.palette, b.state);
  const std::string full = badge_mark(b.state) + b.text;
  const bool compared = b.state == BadgeInfo::State::identical;
  const float room = ImGui::GetContentRegionAvail().x - ctx.px(compared ? 220 : 290);
  pill(ctx, compared ? badge_text(full, room) : fitted_text(full, room), l.text, l.fill);
  record(ctx, "timings.badge");
  tooltip(ctx, (full + badge_help(ctx.state)).c_str());
}

// Shows how many times faster than CGAL the run on show is.
void speed(PanelContext& ctx, bool cold) {
  const ViewState& s = ctx.state;
  const std::optional<double> found = speed_up(s, cold);
  if (!found) return;
  const double ratio = *found;
  ImGui::SameLine();
  // In a warm run CGAL reuses its triangulation and only filters it.
  const std::string whom = cold ? "CGAL" : "CGAL's filter";
  const bool even = ratio > 0.95 && ratio < 1.05;
  const std::string text = even         ? "as fast as " + whom
                           : ratio >= 1 ? ratio_text(ratio) + " faster than " + whom
                                        : ratio_text(1 / ratio) + " slower than " + whom;
  const bool slower = ratio < 1 && !even;
  pill(ctx, text, slower ? ctx.palette.warning : ctx.palette.accent,
       slower ? ctx.palette.warning_fill : ctx.palette.field);
  record(ctx, "timings.speed");
  tooltip(ctx, cold ? "The whole first computation, including set-up, compared with CGAL's "
                      "triangulation and filter (one thread)."
                    : "A later alpha of the same molecule, compared with CGAL's filter on its "
                      "triangulation.");
}

void compare_button(PanelContext& ctx) {
  const ViewState& s = ctx.state;
  if (!s.result) return;
  if (s.badge.state == BadgeInfo::State::comparing) {
    if (s.badge.seconds < kCancelAfterSeconds) return;
    ImGui::SameLine();
    if (button(ctx, "timings.cancel", "Cancel")) ctx.calls.jobs.cancel(JobId::comparing);
    return;
  }
  if (s.badge.state == BadgeInfo::State::identical) return;
  ImGui::SameLine();
  const bool first = s.badge.state == BadgeInfo::State::not_compared;
  if (button(ctx, "timings.compare", first ? "Compare" : "Compare again", {0, 0},
             ButtonKind::primary)) {
    ctx.calls.jobs.compare();
  }
  tooltip(ctx, "Computes the same complex with CGAL and compares simplex by simplex (C).");
}

void title(PanelContext& ctx, TimingsState& m) {
  reset_for_molecule(m, ctx.state.file_hash());
  // Until the user chooses, the page shows warm runs as soon as there are any, and the first run
  // before that. So it is never empty. If the user chooses a run without times, missing_times()
  // explains why.
  const bool warm = ctx.state.ours.warm.has_value();
  if (!m.pinned) m.cold = !warm;
  int run = m.cold ? 0 : 1;
  if (choice(ctx, "timings.run", {"Cold", "Warm"}, run, ctx.px(124))) {
    m.pinned = true;
    m.cold = run == 0;
  }
  tooltip(ctx,
          "Cold: the first alpha of a molecule, including set-up.\nWarm: a later alpha of the same "
          "molecule, as the slider asks for.");
  ImGui::SameLine(0, ctx.px(14));
}

std::string speed_part(const ViewState& state, bool cold) {
  const std::optional<double> ratio = speed_up(state, cold);
  return ratio ? (cold ? "cold " : "warm ") + ratio_text(*ratio) : std::string();
}

void summary_line(PanelContext& ctx) {
  const ViewState& s = ctx.state;
  if (!s.ours.any()) return;
  std::string text =
      s.ours.engine.name + ": cold " + wall_text(s.ours.cold) + ", warm " + wall_text(s.ours.warm);
  if (s.cgal.any()) {
    text += "   ·   CGAL: cold " + wall_text(s.cgal.cold) + ", warm " + wall_text(s.cgal.warm);
    if (s.cgal_parallel.any()) {
      text += "   ·   CGAL on " + s.cgal_parallel.engine.device + ": cold " +
              wall_text(s.cgal_parallel.cold) + ", warm " + wall_text(s.cgal_parallel.warm);
    }
    const std::string cold = speed_part(s, true);
    const std::string warm = speed_part(s, false);
    if (!cold.empty() || !warm.empty()) {
      text += "   ·   speed-up " + cold + (cold.empty() || warm.empty() ? "" : ", ") + warm;
    }
  }
  ImGui::PushFont(ctx.fonts.small);
  muted_text(ctx, fitted_text(text, ImGui::GetContentRegionAvail().x));
  ImGui::PopFont();
  record(ctx, "timings.summary");
  tooltip(ctx, text.c_str());
}

void draw_timings(PanelContext& ctx, TimingsState& memory) {
  title(ctx, memory);
  if (ctx.state.result) {
    badge(ctx);
    speed(ctx, memory.cold);
    compare_button(ctx);
  } else {
    ImGui::NewLine();
  }
  summary_line(ctx);
  draw_waterfall(ctx, memory.cold, ImGui::GetContentRegionAvail().y);
}

}  // namespace

std::unique_ptr<Panel> timings_panel() {
  return panel_of(draw_timings);
}

}  // namespace alphascope
