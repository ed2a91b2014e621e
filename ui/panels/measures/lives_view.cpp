// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the lives of cavities as bars, and takes clicks and drags on them.
#include "ui/panels/measures/lives_view.hpp"
#include "ui/panels/measures/curve_state.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/cavity/cavity_ground.hpp"
#include "core/chart/svg.hpp"
#include "core/document/cavities/cavity_curve_results.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/store/finished_text.hpp"
#include "core/document/store/store.hpp"
#include "ui/calls.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/dialogs/save_parts.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/plot.hpp"
#include "core/document/settings/request.hpp"
#include "core/cavity/cavity_lives.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/dialogs/table_to_save.hpp"
#include "core/cavity/cavity_table.hpp"
#include "ui/panels/view_state.hpp"
#include "core/document/reference/reference.hpp"
#include "ui/widgets/style.hpp"
#include "ui/panels/playback.hpp"
#include "ui/panels/cavities/cavity_state.hpp"

namespace alphascope {
namespace {


constexpr double kStep = 0.01;  // Å², as the slider's step
constexpr std::size_t kMostBars = 100;
constexpr float kLeastRow = 5, kMostRow = 14;  // pixels at scale 1, height of a bar

// The results behind the bars, and whether they belong to the picture.
struct Known {
  CavityPage* page = nullptr;
  std::shared_ptr<const CavityGround> ground;
  bool current = false;
};

// --- bars and rows

// Finds the row of each bar in the table on screen.
void find_rows(ShownLives& memory, const CavityPage& page) {
  if (memory.lines == page.rows.lines) return;
  memory.lines = page.rows.lines;
  memory.rows.assign(memory.bars.longest.size(), ShownLives::kNoRow);
  std::map<std::uint32_t, std::size_t> bar_of;
  for (std::size_t k = 0; k < memory.bars.longest.size(); ++k) {
    bar_of[memory.bars.longest[k].sink] = k;
  }
  for (std::size_t row = 0; row < page.rows.size(); ++row) {
    const auto at = bar_of.find(page.rows.table().cavity(row).deepest_sink);
    if (at != bar_of.end()) memory.rows[at->second] = row;
  }
}

// Makes the bars anew if their results changed. Returns whether there are any results yet.
bool follow(PanelContext& ctx, ShownLives& memory, Known& known, const Derived<CavityLives>& lives) {
  const Derived<CavityGround> ground = ctx.store.want(cavity_ground(), ctx.inputs);
  known.ground = ground.value;
  known.current = lives.ready() && ground.ready() && ctx.inputs.atoms;
  if (!known.current) return memory.of != nullptr;
  const double from = std::min(kCurveAlphaLeastAngstrom2, ctx.inputs.alpha_angstrom2.nearest());
  if (memory.of != lives.value || memory.from_angstrom2 != from) {
    memory.bars = longest_bars(*lives.value, ground.value->balls->lattice, from, kMostBars);
    memory.of = lives.value;
    memory.from_angstrom2 = from;
    memory.lines.reset();
  }
  const bool same_balls =
      known.page->rows.lines && known.page->rows.table().ground->balls == ctx.inputs.balls;
  if (same_balls) find_rows(memory, *known.page);
  return true;
}

// Returns the row of a bar; kNoRow if the table on screen is of other balls than the bars.
std::size_t row_of(const ShownLives& memory, const CavityPage& page, std::size_t bar) {
  const bool same = memory.lines && memory.lines == page.rows.lines;
  return same ? memory.rows.at(bar) : ShownLives::kNoRow;
}

// --- the line above the bars

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

// --- the bars

// Lays out as many bars as fit; the y axis counts them from the top. None: there is no room.
struct BarsPlot {
  Plot plot = {};
  PlotArea area = {};
  std::size_t drawn = 0;

  float row() const { return area.y_of(1) - area.y_of(0); }  // pixels
  // Returns the bar under the mouse.
  std::optional<std::size_t> bar_at(const std::vector<CavityBar>& bars, const PlotMouse& at) const {
    const double n = std::floor(at.y);
    if (n < 0 || n >= static_cast<double>(drawn)) return {};
    const auto bar = static_cast<std::size_t>(n);
    // Half a row of slack makes short bars easier to hit.
    const double slack = area.x_at(area.left + row() / 2) - area.x.low;
    const bool hit =
        at.x >= bars[bar].born_angstrom2 - slack && at.x <= bars[bar].gone_angstrom2 + slack;
    return hit ? std::optional(bar) : std::nullopt;
  }
};

std::optional<BarsPlot> place(const PanelContext& ctx, const ShownLives& memory, double shown) {
  const auto area = plot_area(ctx, {.left = 16, .least_height = 30});
  if (!area) return {};
  BarsPlot bars{.area = *area};
  const auto fit = static_cast<std::size_t>(area->height() / ctx.px(kLeastRow));
  bars.drawn = std::min(fit, memory.bars.longest.size());
  if (bars.drawn == 0) return {};
  const float row = std::min(area->height() / static_cast<float>(bars.drawn), ctx.px(kMostRow));
  bars.plot.x = {.range = {memory.from_angstrom2, shown}, .label = axis_label(CurveAxis::alpha)};
  for (std::size_t k = 0; k < bars.drawn; ++k) {
    bars.plot.x.range.take(memory.bars.longest[k].gone_angstrom2);
  }
  PlotRange& alpha = bars.plot.x.range;
  alpha.high += 0.04 * (alpha.high - alpha.low);
  bars.plot.y = {.range = {static_cast<double>(area->height() / row), 0}, .numbered = false};
  bars.area.x = alpha;
  bars.area.y = bars.plot.y.range;
  return bars;
}

void add_bar(BarsPlot& bars, const CavityBar& bar, std::size_t k, const ChartPaint& paint) {
  const double middle = static_cast<double>(k) + 0.5;
  const double least = 0.5 / static_cast<double>(bars.row());  // half a pixel
  const PlotRange& alpha = bars.plot.x.range;
  const auto part = [&](double from, double to, double share) {
    const double half = std::max(share / 2, least);
    bars.plot.boxes.push_back(
        {std::max(from, alpha.low), std::min(to, alpha.high), middle - half, middle + half, paint});
  };
  const double closed = std::clamp(bar.closed_angstrom2, bar.born_angstrom2, bar.gone_angstrom2);
  if (bar.born_angstrom2 < closed) part(bar.born_angstrom2, closed, 0.3);
  if (bar.is_ever_void()) part(closed, bar.gone_angstrom2, 0.8);
}

void add_bars(PanelContext& ctx, BarsPlot& bars, const ShownLives& memory, const CavityPage& page) {
  const PlotArea& area = bars.area;
  const double edge = area.x_at(area.left + ctx.px(2)) - area.x.low;
  for (std::size_t k = 0; k < bars.drawn; ++k) {
    const CavityBar& bar = memory.bars.longest[k];
    const std::size_t row = row_of(memory, page, k);
    const bool there = row != ShownLives::kNoRow;
    add_bar(
        bars, bar, k,
        there ? plot_colour(cavity_colour(page, row)) : plot_ink(ChartColourRole::muted, 0.45f));
    const auto top = static_cast<double>(k);
    ctx.rects["curves.life." + std::to_string(k + 1)] = {
        area.x_of(std::max(bar.born_angstrom2, area.x.low)), area.y_of(top),
        area.x_of(bar.gone_angstrom2), area.y_of(top + 1)};
    const auto& chosen = page.selected_rows;
    if (!there || !std::binary_search(chosen.begin(), chosen.end(), row)) continue;
    bars.plot.boxes.push_back({std::max(bar.born_angstrom2, area.x.low) - edge,
                               bar.gone_angstrom2 + edge, top, top + 1,
                               plot_ink(ChartColourRole::text), false});
  }
}

void table_buttons(PanelContext& ctx, const ShownLives& memory, const Known& known) {
  const auto csv = [&] {
    std::vector<std::string> comments = comments_on_screen(ctx);
    comments.push_back(
        "solvent radius: " + short_number_text(ctx.inputs.solvent_radius_angstrom, 2) + " Å");
    return bars_csv(memory.bars.longest, *known.ground->triangulation, *ctx.inputs.atoms, comments);
  };
  ImGui::BeginDisabled(!known.current || !ctx.state.references);
  if (button(ctx, "curves.copy", "Copy CSV")) {
    ImGui::SetClipboardText(csv().c_str());
    ctx.state.notice = "Lives of cavities copied as CSV.";
  }
  tooltip(ctx, "Copies the range of alpha of each of these cavities, the longest first.");
  ImGui::SameLine(0, ctx.px(4));
  if (button(ctx, "curves.save", "Save…")) {
    std::vector<FormatToSave> figure;
    if (auto bars = place(ctx, memory, ctx.state.settings.request.alpha_angstrom2)) {
      add_bars(ctx, *bars, memory, *known.page);
      figure.push_back(figure_to_save(plot_svg(bars->plot, ctx.state.file_name())));
    }
    open_save_dialog(ctx, {"Lives of cavities",
                           file_name_for(ctx, "lives"),
                           finished_text(csv()),
                           {},
                           {},
                           false,
                           std::move(figure)});
  }
  tooltip(ctx, "The same as a CSV file, or the drawn bars as an SVG file.");
  ImGui::EndDisabled();
}

std::string hover_text(const PanelContext& ctx, const ShownLives& memory, const Known& known,
                       std::size_t bar) {
  const std::size_t row = row_of(memory, *known.page, bar);
  const bool there = row != ShownLives::kNoRow;
  const auto& sink = known.ground->triangulation->tetrahedra[memory.bars.longest[bar].sink];
  return (there ? "Cavity " + std::to_string(row + 1)
                : std::string("Does not exist at this alpha")) +
         "\n" + bar_text(memory.bars.longest[bar]) + "\nDeepest point between " +
         sink_name(*ctx.inputs.atoms, sink) +
         (there ? "\nClick to select it."
                : "\nClick to select it and go to an alpha at which it exists.");
}

void set_alpha_to(PanelContext& ctx, double wanted) {
  set_alpha(ctx.state.settings.request, wanted);
  ctx.state.playback.alpha = false;
}

// Chooses the cavity of a bar. One that is not in the table is chosen by its sink; the table finds
// it after alpha has changed.
void choose(PanelContext& ctx, const ShownLives& memory, const Known& known, std::size_t bar) {
  const std::size_t row = row_of(memory, *known.page, bar);
  if (row != ShownLives::kNoRow) return select_cavity(ctx, *known.page, row, HowSelected::alone);
  const auto& sink = known.ground->triangulation->tetrahedra[memory.bars.longest[bar].sink];
  ctx.state.settings.selection.cavities =
      RefSet(std::vector<Ref>{ctx.inputs.atoms->reference(sink)});
  ctx.state.settings.selection.items = {};
  set_alpha_to(ctx, alpha_within(memory.bars.longest[bar], memory.from_angstrom2));
}

void take_mouse(PanelContext& ctx, const BarsPlot& bars, const ShownLives& memory, const Known& known) {
  const PlotMouse mouse = plot_mouse(ctx, bars.area, "curves.lives");
  if (!known.current) return;
  const double at = std::round(mouse.x / kStep) * kStep;
  if (mouse.held) {
    if (mouse.dragged) set_alpha_to(ctx, at);
    return;
  }
  const auto bar = bars.bar_at(memory.bars.longest, mouse);
  if (mouse.clicked) {
    if (bar) {
      choose(ctx, memory, known, *bar);
    } else {
      set_alpha_to(ctx, at);
    }
  } else if (mouse.hovered) {
    ImGui::SetTooltip(
        "%s", bar ? hover_text(ctx, memory, known, *bar).c_str() : "Click or drag to set alpha.");
  }
}

// --- when there is nothing to draw

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
  Known known;
  known.page = ctx.state.cavities.page.get();
  if (known.page->rows.lines) draw_layers_of_cavities(ctx, *known.page, followed.current);
  const Derived<CavityLives> lives = ctx.store.want(whole_cavity_lives(), ctx.inputs);
  if (!follow(ctx, memory, known, lives)) {
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
  table_buttons(ctx, memory, known);
  // Bars that do not belong to the picture are grey.
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, known.current ? 1.0f : 0.55f);
  ImGui::PushFont(ctx.fonts.small);
  const double shown = ctx.state.settings.request.alpha_angstrom2;
  auto bars = place(ctx, memory, shown);
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
