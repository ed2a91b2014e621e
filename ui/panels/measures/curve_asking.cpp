// SPDX-License-Identifier: GPL-3.0-or-later
// Whether curves may be computed: the work that they take, and the buttons that start and cancel
// it.
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "core/document/cavities/cavity_chart.hpp"
#include "core/document/cavities/cavity_curve_results.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "core/geometry/ball_set.hpp"
#include "ui/panels/measures/curve_parts.hpp"
#include "ui/panels/measures/curve_state.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

constexpr double kMostSecondsUnasked = 60;  // on one thread, for one curve

struct CurveWork {
  std::size_t balls = 0;  // in all samples together
  double seconds = 0;     // on one thread
};

CurveWork work_of(const PanelContext& ctx, const CurveState& memory) {
  constexpr double kSumsPerBall = 1e-5, kExactPerBall = 1.6e-4;  // seconds; measured with 4HHB
  const CurveAxis axis = curve_axis(memory);
  const bool exact = numbers_for(curve_quantity(memory)) == CurveNumbers::exact;
  if (!ctx.inputs.balls || (axis == CurveAxis::alpha && !exact)) return {};
  constexpr std::size_t kSamples = 51;  // approximate number of samples of alpha or solvent radius
  const std::size_t times = axis == CurveAxis::model ? ctx.state.molecule.models.size() : kSamples;
  const std::size_t balls = ctx.inputs.balls->size() * times;
  return {balls, static_cast<double>(balls) * (exact ? kExactPerBall : kSumsPerBall)};
}

}  // namespace

bool curves_are_asked_for(PanelContext& ctx, CurveState& memory) {
  const CurveWork work = work_of(ctx, memory);
  const std::pair<int, int> question{memory.axis, memory.quantity};
  if (work.seconds <= kMostSecondsUnasked || memory.asked_for == question) return true;
  const long minutes = std::lround(std::ceil(work.seconds / 60));
  if (button(ctx, "curves.compute", "Compute")) memory.asked_for = question;
  ImGui::SameLine(0, ctx.px(8));
  ImGui::AlignTextToFramePadding();
  muted_wrapped(ctx, "These curves are of " + with_separators(static_cast<long long>(work.balls)) +
                         " balls in all samples together. They take about " +
                         std::to_string(minutes) + (minutes == 1 ? " minute" : " minutes") +
                         " in the background.");
  record(ctx, "curves.waiting");
  return false;
}

bool is_on_its_way(DerivedState state) {
  return state == DerivedState::running || state == DerivedState::waiting;
}

void curves_cancel_button(PanelContext& ctx, const CurveState& memory,
                          const Derived<CavityCurves>& curves) {
  const std::string_view id = curves_wanted(memory).id;
  if (is_on_its_way(curves.state)) {
    if (button(ctx, "curves.cancel", "Cancel")) ctx.store.cancel(id);
  } else if (curves.state == DerivedState::cancelled) {
    if (button(ctx, "curves.again", "Compute")) ctx.store.retry(id);
  }
}

std::string curves_waiting_text(const PanelContext& ctx, const CurveState& memory,
                                const Derived<CavityCurves>& curves) {
  if (!ctx.state.has_molecule()) return "Open a molecule: curves of its cavities appear here.";
  if (curve_axis(memory) == CurveAxis::model) {
    const std::string why = why_no_model_curve(ctx.inputs);
    if (!why.empty()) return why;
  }
  const std::string title(curves_wanted(memory).title);
  if (curves.state == DerivedState::running) return title + ": " + percent_text(curves.share);
  if (curves.state == DerivedState::cancelled) return "Cancelled.";
  if (curves.state != DerivedState::waiting && !curves.why.empty()) {
    return "There are no curves. " + curves.why;
  }
  if (memory.trace) return "The other radii follow when the slider rests.";
  return "The triangulations are still being computed. Curves appear here afterwards.";
}

}  // namespace alphascope
