// SPDX-License-Identifier: GPL-3.0-or-later
// The page of the signature: counts of simplices and the Euler characteristic against alpha. A
// cursor sets alpha, and marks in the view show which simplices appear there.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/document/alpha/signature.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "core/molecule/rgb8.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/measures/signature_parts.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/work_info.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/plot.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

constexpr double kStep = 0.01;  // Å², as the slider's step

struct SignatureMemory {
  bool mark = false;  // the view marks the simplices that appear at alpha
};

void legend_line(PanelContext& ctx, const Signature& signature, double alpha) {
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, "α " + short_number_text(alpha, 2) + " Å²");
  for (int d = 0; d < 4; ++d) {
    legend_entry(ctx, signature_colour(d),
                 std::string(kSimplexNames[d]) + " " +
                     with_separators(static_cast<long long>(signature.count(d, alpha))));
  }
  ImGui::SameLine(0, ctx.px(14));
  strong_text(ctx, "Euler χ " + with_separators(signature.euler(alpha)));
  record(ctx, "signature.values");
}

// Returns evenly spaced values of alpha, one for every two pixels.
std::vector<double> alphas_of(const PlotRange& range, float width) {
  std::vector<double> alphas;
  const int points = 1 + static_cast<int>(width / 2);
  for (int n = 0; n < points; ++n) {
    alphas.push_back(range.at(static_cast<double>(2 * static_cast<float>(n) / width)));
  }
  return alphas;
}

void plots(PanelContext& ctx, const Signature& signature) {
  const double shown = ctx.inputs.alpha_angstrom2;
  const auto area =
      plot_area(ctx, {.left = 64, .top = 0, .bottom = 22, .lines_below = 0, .least_height = 60});
  if (!area) return;
  const PlotRange alpha = signature_range(ctx, signature);
  const float middle = area->top + area->height() * 0.62f;
  PlotArea above = *area, below = *area;
  above.bottom = middle - ctx.px(6);
  below.top = middle;
  const std::vector<double> alphas = alphas_of(alpha, area->width());
  Plot counts = plot_of_counts(signature, alpha, alphas);
  Plot euler = plot_of_euler(signature, alpha, alphas);
  for (Plot* plot : {&counts, &euler}) {
    plot->lines.push_back({shown, plot_ink(ChartColourRole::accent), 1.5f});
  }
  draw_plot(ctx, counts, above);
  draw_plot(ctx, euler, below);
  above.bottom = below.bottom;  // the mouse is over both
  const PlotMouse mouse = plot_mouse(ctx, above, "signature.plot");
  tooltip(ctx, "Click or drag to set alpha.");
  if (!mouse.held) return;
  ctx.state.go_to_alpha(std::round(mouse.x / kStep) * kStep);
}

// Says why there are no curves yet.
std::string waiting_text(const PanelContext& ctx, const Derived<Signature>& signature) {
  if (!ctx.state.has_molecule()) return "Open a molecule: its signature appears here.";
  if (signature.state != DerivedState::waiting && !signature.why.empty()) {
    return "There is no signature. " + signature.why;
  }
  if (!ctx.state.background.detail.empty()) return ctx.state.background.detail;
  return "The signature appears here when all simplices are known.";
}

void draw_signature(PanelContext& ctx, SignatureMemory& memory) {
  const Derived<Signature> signature = ctx.store.want(whole_signature(), ctx.inputs);
  mark_appearing(ctx, memory.mark);
  if (!signature.ready()) {
    muted_wrapped(ctx, waiting_text(ctx, signature));
    record(ctx, "signature.waiting");
    return;
  }
  signature_save_button(ctx, *signature.value);
  ImGui::SameLine(0, ctx.px(14));
  legend_line(ctx, *signature.value, ctx.inputs.alpha_angstrom2);
  ImGui::PushFont(ctx.fonts.small);
  plots(ctx, *signature.value);
  ImGui::PopFont();
}

}  // namespace

std::unique_ptr<Panel> signature_panel() {
  return panel_of(draw_signature);
}

}  // namespace alphascope
