// Draws the lives of cavities as bars, and takes clicks and drags on them.
#include "ui/panels/measures/lives_view.hpp"
#include "ui/panels/measures/curve_memory.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "core/document/cavities/cavity_curve_results.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/store/finished_text.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/dialogs/save_parts.hpp"
#include "ui/widgets/controls.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/plot_axis.hpp"

namespace alphascope {
namespace {

using Lives = CurveMemory::Lives;

constexpr double kStep = 0.01;  // Å², as the slider's step
constexpr std::size_t kMostBars = 100;
constexpr float kLeastRow = 5, kMostRow = 14;  // pixels at scale 1, height of a bar
constexpr float kDrag = 4;                     // pixels at scale 1; a shorter move is a click

// The results behind the bars, and whether they belong to the picture.
struct Known {
  CavityPage* page = nullptr;
  std::shared_ptr<const CavityGround> ground;
  bool current = false;
};

// --- bars and rows

// Finds the row of each bar in the table on screen.
void find_rows(Lives& memory, const CavityPage& page) {
  if (memory.lines == page.rows.lines) return;
  memory.lines = page.rows.lines;
  memory.rows.assign(memory.bars.longest.size(), Lives::kNoRow);
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
bool follow(PanelContext& ctx, Lives& memory, Known& known, const Derived<CavityLives>& lives) {
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

// Returns the row of a bar. The table on screen may be of other balls than the bars; then kNoRow.
std::size_t row_of(const Lives& memory, const CavityPage& page, std::size_t bar) {
  const bool same = memory.lines && memory.lines == page.rows.lines;
  return same ? memory.rows.at(bar) : Lives::kNoRow;
}

// --- the line above the bars

void table_buttons(PanelContext& ctx, const Lives& memory, const Known& known) {
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
  tooltip(ctx,
          "Copies the alphas between which each of these cavities is there, the longest first.");
  ImGui::SameLine(0, ctx.px(4));
  if (button(ctx, "curves.save", "Save…")) {
    ask_to_save(
        ctx,
        {"Lives of cavities", file_name_for(ctx, "lives"), finished_text(csv()), {}, {}, false});
  }
  tooltip(ctx, "The same as a CSV file.");
  ImGui::EndDisabled();
}

void legend(PanelContext& ctx, const Lives& memory, std::size_t drawn) {
  const auto number = [](std::size_t n) { return with_separators(static_cast<long long>(n)); };
  std::string text = "thin: pocket · thick: void · grey: not there at this alpha";
  if (drawn < memory.bars.all) {
    text = "the " + number(drawn) + " longest of " + number(memory.bars.all) + " · " + text;
  }
  ImGui::SameLine(0, ctx.px(14));
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, fitted_text(text, ImGui::GetContentRegionAvail().x));
  record(ctx, "curves.legend");
}

// --- the bars

struct Plot {
  ImVec2 from, to;  // pixels: the top left and bottom right corner
  PlotRange alpha;  // Å²
  float row = 0;    // pixels
  std::size_t drawn = 0;

  float x_of(double value) const {
    const double share = std::clamp(alpha.share(value), 0.0, 1.0);
    return from.x + static_cast<float>(share) * (to.x - from.x);
  }
  double at(float pixel) const {
    return alpha.low +
           (alpha.high - alpha.low) * static_cast<double>((pixel - from.x) / (to.x - from.x));
  }
  float middle_of(std::size_t bar) const { return from.y + (static_cast<float>(bar) + 0.5f) * row; }
  // Returns the bar under the mouse.
  std::optional<std::size_t> bar_at(const std::vector<CavityBar>& bars, ImVec2 mouse) const {
    const auto n = static_cast<std::ptrdiff_t>(std::floor((mouse.y - from.y) / row));
    if (n < 0 || n >= static_cast<std::ptrdiff_t>(drawn)) return {};
    const auto bar = static_cast<std::size_t>(n);
    const float slack = row / 2;  // makes short bars easier to hit
    const bool hit = mouse.x >= x_of(bars[bar].born_angstrom2) - slack &&
                     mouse.x <= x_of(bars[bar].gone_angstrom2) + slack;
    return hit ? std::optional(bar) : std::nullopt;
  }
};

// Lays out as many bars as fit. `drawn` is 0 if none does.
Plot place(const PanelContext& ctx, const Lives& memory, double shown) {
  const ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  Plot plot;
  plot.from = {corner.x + ctx.px(16), corner.y + ctx.px(2)};
  plot.to = {corner.x + room.x - ctx.px(16),
             corner.y + room.y - 2 * ImGui::GetTextLineHeight() - ctx.px(6)};
  const float height = plot.to.y - plot.from.y;
  if (height < ctx.px(30) || plot.to.x - plot.from.x < ctx.px(120)) return plot;
  const auto fit = static_cast<std::size_t>(height / ctx.px(kLeastRow));
  plot.drawn = std::min(fit, memory.bars.longest.size());
  plot.row =
      std::min(height / static_cast<float>(std::max<std::size_t>(plot.drawn, 1)), ctx.px(kMostRow));
  plot.alpha = {memory.from_angstrom2, shown};
  for (std::size_t k = 0; k < plot.drawn; ++k) {
    plot.alpha.take(memory.bars.longest[k].gone_angstrom2);
  }
  plot.alpha.high += 0.04 * (plot.alpha.high - plot.alpha.low);
  return plot;
}

void frame(PanelContext& ctx, const Plot& plot) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImU32 muted = to_u32(ctx.palette.text_muted);
  const int most = static_cast<int>((plot.to.x - plot.from.x) / ctx.px(70));
  for_ticks(plot.alpha, tick_step(plot.alpha, most), [&](double value) {
    const float x = plot.x_of(value);
    const std::string text = short_number_text(value, 2);
    draw->AddLine({x, plot.from.y}, {x, plot.to.y}, to_u32(ctx.palette.border, 0.6f));
    draw->AddText({x - ImGui::CalcTextSize(text.c_str()).x / 2, plot.to.y + ctx.px(3)}, muted,
                  text.c_str());
  });
  draw->AddRect(plot.from, plot.to, to_u32(ctx.palette.border));
  const std::string label = axis_label(CurveAxis::alpha);
  const float width = ImGui::CalcTextSize(label.c_str()).x;
  draw->AddText(
      {(plot.from.x + plot.to.x - width) / 2, plot.to.y + ctx.px(3) + ImGui::GetTextLineHeight()},
      muted, label.c_str());
}

void bars(PanelContext& ctx, const Plot& plot, const Lives& memory, const CavityPage& page) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float alpha = ImGui::GetStyle().Alpha, least = ctx.px(1);
  for (std::size_t k = 0; k < plot.drawn; ++k) {
    const CavityBar& bar = memory.bars.longest[k];
    const std::size_t row = row_of(memory, page, k);
    const bool there = row != Lives::kNoRow;
    const ImU32 ink = there ? to_u32(cavity_colour(page, row), alpha)
                            : to_u32(ctx.palette.text_muted, 0.45f * alpha);
    const float y = plot.middle_of(k);
    const auto part = [&](double from, double to, float share) {
      const float x = plot.x_of(from), half = std::max(share * plot.row / 2, least / 2);
      draw->AddRectFilled({x, y - half}, {std::max(plot.x_of(to), x + least), y + half}, ink);
    };
    const double closed = std::clamp(bar.closed_angstrom2, bar.born_angstrom2, bar.gone_angstrom2);
    if (bar.born_angstrom2 < closed) part(bar.born_angstrom2, closed, 0.3f);
    if (bar.is_ever_void()) part(closed, bar.gone_angstrom2, 0.8f);
    ctx.rects["curves.life." + std::to_string(k + 1)] = {
        plot.x_of(bar.born_angstrom2), y - plot.row / 2, plot.x_of(bar.gone_angstrom2),
        y + plot.row / 2};
    const auto& chosen = page.chosen_rows;
    if (!there || !std::binary_search(chosen.begin(), chosen.end(), row)) continue;
    draw->AddRect({plot.x_of(bar.born_angstrom2) - ctx.px(2), y - plot.row / 2},
                  {plot.x_of(bar.gone_angstrom2) + ctx.px(2), y + plot.row / 2},
                  to_u32(ctx.palette.text, alpha), 0, 0, ctx.px(1.2f));
  }
}

std::string hover_text(const PanelContext& ctx, const Lives& memory, const Known& known,
                       std::size_t bar) {
  const std::size_t row = row_of(memory, *known.page, bar);
  const bool there = row != Lives::kNoRow;
  const auto& sink = known.ground->triangulation->tetrahedra[memory.bars.longest[bar].sink];
  return (there ? "Cavity " + std::to_string(row + 1) : std::string("Not there at this alpha")) +
         "\n" + bar_text(memory.bars.longest[bar]) + "\nDeepest point between " +
         sink_name(*ctx.inputs.atoms, sink) +
         (there ? "\nClick to choose it."
                : "\nClick to go to an alpha at which it is there, and choose it.");
}

void set_alpha_to(PanelContext& ctx, double wanted) {
  set_alpha(ctx.state.settings.request, wanted);
  ctx.state.playback.alpha = false;
}

// Chooses the cavity of a bar. One that is not in the table is chosen by its sink; the table finds
// it after alpha has changed.
void choose(PanelContext& ctx, const Lives& memory, const Known& known, std::size_t bar) {
  const std::size_t row = row_of(memory, *known.page, bar);
  if (row != Lives::kNoRow) return choose_cavity(ctx, *known.page, row, HowChosen::alone);
  const auto& sink = known.ground->triangulation->tetrahedra[memory.bars.longest[bar].sink];
  ctx.state.settings.selection.cavities =
      RefSet(std::vector<Ref>{ctx.inputs.atoms->reference(sink)});
  ctx.state.settings.selection.items = {};
  set_alpha_to(ctx, alpha_within(memory.bars.longest[bar], memory.from_angstrom2));
}

void take_mouse(PanelContext& ctx, const Plot& plot, const Lives& memory, const Known& known) {
  ImGui::SetCursorScreenPos(plot.from);
  ImGui::InvisibleButton("##lives", {plot.to.x - plot.from.x, plot.to.y - plot.from.y});
  record(ctx, "curves.lives");
  if (!known.current) return;
  const ImGuiIO& io = ImGui::GetIO();
  const bool dragged = io.MouseDragMaxDistanceSqr[0] > ctx.px(kDrag) * ctx.px(kDrag);
  const double at =
      std::round(std::clamp(plot.at(io.MousePos.x), plot.alpha.low, plot.alpha.high) / kStep) *
      kStep;
  if (ImGui::IsItemActive()) {
    if (dragged) set_alpha_to(ctx, at);
    return;
  }
  const auto bar = plot.bar_at(memory.bars.longest, io.MousePos);
  if (ImGui::IsItemDeactivated() && !dragged && ImGui::IsItemHovered()) {
    if (bar) {
      choose(ctx, memory, known, *bar);
    } else {
      set_alpha_to(ctx, at);
    }
  } else if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip(
        "%s", bar ? hover_text(ctx, memory, known, *bar).c_str() : "Click or drag to set alpha.");
  }
}

// --- when there is nothing to draw

std::string waiting_text(const PanelContext& ctx, const Derived<CavityLives>& lives) {
  if (!ctx.state.molecule.loaded) return "Open a molecule: the lives of its cavities appear here.";
  if (lives.state == DerivedState::no_room || lives.state == DerivedState::failed) {
    return "There are no lives of cavities. " + lives.why;
  }
  return "Lives of cavities appear here when the triangulation of all balls is there.";
}

}  // namespace

void draw_cavity_lives(PanelContext& ctx, CurveMemory::Lives& memory) {
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
  const Plot plot = place(ctx, memory, shown);
  ImGui::PopFont();
  if (plot.drawn > 0) {
    legend(ctx, memory, plot.drawn);
    ImGui::PushFont(ctx.fonts.small);
    frame(ctx, plot);
    bars(ctx, plot, memory, *known.page);
    ImGui::GetWindowDrawList()->AddLine({plot.x_of(shown), plot.from.y},
                                        {plot.x_of(shown), plot.to.y}, to_u32(ctx.palette.accent),
                                        ctx.px(1.5f));
    take_mouse(ctx, plot, memory, known);
    ImGui::PopFont();
  } else {
    muted_wrapped(ctx, "There is no room for bars here: drag the upper edge of this page up.");
  }
  ImGui::PopStyleVar();
}

}  // namespace alphascope
