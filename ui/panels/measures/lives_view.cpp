// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the lives of cavities as bars, and takes clicks and drags on them.
#include "ui/panels/measures/lives_view.hpp"
#include "ui/panels/measures/lives_state.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/cavity/cavity_lives.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/cavities/cavity_state.hpp"
#include "ui/panels/measures/lives_parts.hpp"
#include "ui/panels/measures/lives_plot.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/plot.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

constexpr double kStep = 0.01;  // Å², as the slider's step

void legend(PanelContext& ctx, const ShownLives& memory, std::size_t drawn) {
  const auto number = [](std::size_t n) { return with_separators(static_cast<long long>(n)); };
  std::string text = "thin: pocket · thick: void · grey: does not exist at this alpha";
  if (drawn < memory.bars.all) {
    text = "the " + number(drawn) + " longest of " + number(memory.bars.all) + " · " + text;
  }
  ImGui::SameLine(0, ctx.px(14));
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, fitted_text(text, ImGui::GetContentRegionAvail().x));
  record(ctx, "curves.legend");
}

void take_mouse(PanelContext& ctx, const BarsPlot& bars, const ShownLives& memory,
                const KnownLives& known) {
  const PlotMouse mouse = plot_mouse(ctx, bars.area, "curves.lives");
  if (!known.current) return;
  const double at = std::round(mouse.x / kStep) * kStep;
  if (mouse.held) {
    if (mouse.dragged) ctx.state.go_to_alpha(at);
    return;
  }
  const auto bar = bars.bar_at(memory.bars.longest, mouse);
  if (mouse.clicked) {
    if (bar) {
      choose_life(ctx, memory, known, *bar);
    } else {
      ctx.state.go_to_alpha(at);
    }
  } else if (mouse.hovered) {
    ImGui::SetTooltip(
        "%s", bar ? life_text(ctx, memory, known, *bar).c_str() : "Click or drag to set alpha.");
  }
}

std::string waiting_text(const PanelContext& ctx, const Derived<CavityLives>& lives) {
  if (!ctx.state.has_molecule()) return "Open a molecule: the lives of its cavities appear here.";
  if (lives.state == DerivedState::no_room || lives.state == DerivedState::failed) {
    return "There are no lives of cavities. " + lives.why;
  }
  return "The triangulation is still being computed. Lives of cavities appear here afterwards.";
}

}  // namespace

void draw_cavity_lives(PanelContext& ctx, ShownLives& memory) {
  const FollowedCavities followed = follow_cavities(ctx);
  KnownLives known;
  known.page = ctx.state.cavities.page.get();
  if (known.page->rows.lines) draw_layers_of_cavities(ctx, *known.page, followed.current);
  const Derived<CavityLives> lives = ctx.store.want(whole_cavity_lives(), ctx.inputs);
  if (!follow_lives(ctx, memory, known, lives)) {
    muted_wrapped(ctx, waiting_text(ctx, lives));
    record(ctx, "curves.waiting");
    return;
  }
  if (memory.bars.longest.empty()) {
    muted_wrapped(ctx, "There is no cavity at any alpha from " +
                           short_number_text(memory.from_angstrom2, 2) + " Å² on.");
    record(ctx, "curves.nothing");
    return;
  }
  lives_save_buttons(ctx, memory, known);
  // Bars that do not belong to the picture are grey.
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, known.current ? 1.0f : 0.55f);
  ImGui::PushFont(ctx.fonts.small);
  const double shown = ctx.state.alpha_angstrom2();
  auto bars = place_bars(ctx, memory, shown);
  ImGui::PopFont();
  if (bars) {
    legend(ctx, memory, bars->drawn);
    ImGui::PushFont(ctx.fonts.small);
    add_bars(ctx, *bars, memory, *known.page);
    bars->plot.lines.push_back({shown, plot_ink(ChartColourRole::accent), 1.5f});
    draw_plot(ctx, bars->plot, bars->area);
    take_mouse(ctx, *bars, memory, known);
    ImGui::PopFont();
  } else {
    muted_wrapped(ctx, "There is no room for bars here: drag the upper edge of this page up.");
  }
  ImGui::PopStyleVar();
}

}  // namespace alphascope
