// SPDX-License-Identifier: GPL-3.0-or-later
// The page of curves: cavities against alpha, solvent radius or model. It plots the chosen
// cavities, or the totals of voids and pockets.
#include <algorithm>
#include <cmath>

#include "core/chart/chart.hpp"
#include "core/chart/colour_map.hpp"
#include "core/chart/svg.hpp"
#include "core/document/cavities/cavity_chart.hpp"
#include "core/document/cavities/cavity_curve_results.hpp"
#include "core/document/store/finished_text.hpp"
#include "core/document/store/store.hpp"
#include "ui/calls.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/dialogs/save_parts.hpp"
#include "ui/panels/measures/curve_state.hpp"
#include "ui/panels/measures/curves_plot.hpp"
#include "ui/panels/measures/lives_view.hpp"
#include "ui/panels/molecule/reset_for_molecule.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/plot.hpp"
#include "core/document/settings/request.hpp"
#include "core/cavity/cavities.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "core/cavity_identity/cavity_numbers.hpp"
#include "ui/panels/cavities/cavity_state.hpp"
#include "core/document/store/inputs.hpp"
#include "ui/panels/playback.hpp"
#include "ui/panels/view_info.hpp"
#include "core/document/settings/open_options.hpp"
#include "ui/panels/dialogs/table_to_save.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

constexpr double kAlphaStep = 0.01;   // Å², as the slider's step
constexpr double kSolventStep = 0.1;  // Å, as the samples' step
constexpr std::size_t kMostLines = kCavityColours;
constexpr double kMostSecondsUnasked = 60;  // on one thread, for one curve

using Curves = Derived<CavityCurves>;

CurveAxis axis_of(const CurveState& memory) {
  return static_cast<CurveAxis>(memory.axis);
}

CurveQuantity quantity_of(const CurveState& memory) {
  return static_cast<CurveQuantity>(memory.quantity);
}

const Definition<CavityCurves>& definition_of(const CurveState& memory) {
  const CurveNumbers numbers = numbers_for(quantity_of(memory));
  const CurveAxis axis = axis_of(memory);
  return axis == CurveAxis::alpha     ? curves_over_alpha(numbers)
         : axis == CurveAxis::solvent ? curves_over_solvent(numbers)
                                      : curves_over_models(numbers);
}

// --- the chart

// Makes the chart. `lines` is null for the totals.
void make_chart(CurveState& memory, const CavityCurves& curves, const CurveLinks* links,
                const CavityLines* lines, const std::vector<std::size_t>& rows) {
  memory.chart_axis = curves.axis;
  memory.colours.clear();
  if (!lines) {
    memory.chart = chart_of_totals(curves, quantity_of(memory));
    memory.colours = {chart_colour(0), chart_colour(1)};
    return;
  }
  const CavityTable& table = *lines->table;
  std::vector<ChartedCavity> chosen;
  for (const std::size_t row : rows) {
    const Cavity& cavity = table.cavity(row);
    const char* kind = cavity.is_void() ? "void " : cavity.is_part() ? "part " : "pocket ";
    chosen.push_back({table.order[row], kind + std::to_string(row + 1)});
    // The colour is the same as in the view.
    memory.colours.push_back(cavity_colour(lines->numbers->of[table.order[row]]));
  }
  memory.chart = chart_of_cavities(curves, quantity_of(memory), *links, chosen);
}

// Replaces the chart as soon as results for a newer one are there. Returns whether the chart
// belongs to the picture.
bool follow(PanelContext& ctx, CurveState& memory, const Curves& curves) {
  std::shared_ptr<const CurveLinks> links;
  std::shared_ptr<const CavityLines> lines;
  std::vector<std::size_t> rows;
  if (!ctx.state.settings.selection.cavities.empty()) {
    // Cavities are followed even without curves. If a step of a slider were missed, their numbers
    // would be lost.
    const bool current = follow_cavities(ctx).current;
    CavityPage& page = *ctx.state.cavities.page;
    if (page.rows.lines) draw_layers_of_cavities(ctx, page, current);
    if (!current || !curves.ready()) return false;
    const auto linked = ctx.store.want(curve_links(curves.value, curves.have), ctx.inputs);
    if (!linked.ready()) return false;
    links = linked.value;
    lines = page.rows.lines;
    rows = page.selected_rows;
    if (rows.size() > kMostLines) rows.resize(kMostLines);
  }
  if (!curves.ready()) return false;
  const bool same = memory.curves == curves.value && memory.links == links && memory.rows == rows &&
                    memory.lines == lines && memory.chart_quantity == memory.quantity;
  if (same) return true;
  // The curve of a cavity that has left the table stays, since it shows where the cavity exists.
  const bool gone = lines && rows.empty() && !memory.rows.empty();
  if (gone && memory.curves == curves.value && memory.chart_quantity == memory.quantity)
    return true;
  make_chart(memory, *curves.value, links.get(), lines.get(), rows);
  memory.curves = curves.value;
  memory.links = links;
  memory.lines = lines;
  memory.rows = rows;
  memory.chart_quantity = memory.quantity;
  return true;
}

// --- the line above the plot

std::string csv_of(const PanelContext& ctx, const CurveState& memory) {
  std::vector<std::string> comments = comments_on_screen(ctx);
  if (memory.chart_axis != CurveAxis::solvent) {
    comments.push_back("solvent radius: " +
                       axis_text(CurveAxis::solvent, ctx.inputs.solvent_radius_angstrom) + " Å");
  }
  if (memory.chart_axis != CurveAxis::alpha) {
    comments.push_back("alpha: " + axis_text(CurveAxis::alpha, ctx.inputs.alpha_angstrom2) + " Å²");
  }
  comments.push_back("values: " + memory.chart.chart.value_label);
  return chart_csv(memory.chart.chart, comments);
}

void legend(PanelContext& ctx, const CurveState& memory) {
  const std::vector<ChartSeries>& series = memory.chart.chart.series;
  for (std::size_t s = 0; s < series.size(); ++s) {
    legend_entry(ctx, memory.colours[s], series[s].name);
  }
  if (!memory.chart.marks.empty()) {
    ImGui::SameLine(0, ctx.px(14));
    ImGui::AlignTextToFramePadding();
    muted_text(ctx, "ring: splits or joins");
  }
  record(ctx, "curves.legend");
}

void choices(PanelContext& ctx, CurveState& memory) {
  // Pixels at scale 1, of all choices; the names of the pages stand before them.
  constexpr float kWidth = 570;
  if (ImGui::GetContentRegionAvail().x < ctx.px(kWidth)) ImGui::NewLine();
  choice(ctx, "curves.quantity", {"Volume", "Area", "Exact", "Lives"}, memory.quantity,
         ctx.px(250));
  tooltip(ctx,
          "SA volume and SA area: CASTp's sums for the region of probe centres. Exact: the "
          "volume of the cavity's tetrahedra outside all grown balls, about twenty times "
          "slower. Lives: the range of alpha in which each cavity exists.");
  ImGui::SameLine(0, ctx.px(10));
  ImGui::AlignTextToFramePadding();
  if (memory.quantity == CurveState::kLives) {
    muted_text(ctx, "against alpha");
    return;
  }
  muted_text(ctx, "against");
  ImGui::SameLine(0, ctx.px(8));
  choice(ctx, "curves.axis", {"Alpha", "Solvent", "Model"}, memory.axis, ctx.px(240));
}

// --- the plot

void take_click(PanelContext& ctx, CurveAxis axis, double at) {
  ViewState& s = ctx.state;
  if (axis == CurveAxis::alpha) {
    set_alpha(s.settings.request, std::round(at / kAlphaStep) * kAlphaStep);
    s.playback.alpha = false;
  } else if (axis == CurveAxis::solvent) {
    const double steps = std::round(std::clamp(at, 0.0, kCurveSolventMostAngstrom) / kSolventStep);
    s.settings.request.solvent_radius_angstrom = steps / std::round(1 / kSolventStep);
  } else {
    const auto last = static_cast<double>(s.molecule.models.size()) - 1;
    s.settings.open.balls.model = static_cast<int>(std::lround(std::clamp(at, 0.0, last)));
    s.playback.models = false;
  }
}

double shown_at(const PanelContext& ctx, CurveAxis axis) {
  const Request& request = ctx.state.settings.request;
  if (axis == CurveAxis::alpha) return request.alpha_angstrom2;
  if (axis == CurveAxis::solvent) return request.solvent_radius_angstrom;
  return ctx.state.settings.open.balls.model;
}

void table_buttons(PanelContext& ctx, const CurveState& memory, bool current) {
  ImGui::BeginDisabled(!current || !ctx.state.references);
  if (button(ctx, "curves.copy", "Copy CSV")) {
    ImGui::SetClipboardText(csv_of(ctx, memory).c_str());
    ctx.state.notice = "Curves copied as CSV.";
  }
  tooltip(ctx, "Copies the curves as CSV.");
  ImGui::SameLine(0, ctx.px(4));
  if (button(ctx, "curves.save", "Save…")) {
    open_save_dialog(
        ctx, {"Curves",
              file_name_for(ctx, "curves"),
              finished_text(csv_of(ctx, memory)),
              {},
              {},
              false,
              {figure_to_save(plot_svg(curves_plot(memory, shown_at(ctx, memory.chart_axis)),
                                       ctx.state.file_name()))}});
  }
  tooltip(ctx, "Saves the curves as a CSV file, or their plot as an SVG file.");
  ImGui::EndDisabled();
}

void draw_curves_plot(PanelContext& ctx, const CurveState& memory) {
  auto area = plot_area(ctx, {});
  if (!area) return;
  const Plot plot = curves_plot(memory, shown_at(ctx, memory.chart_axis));
  draw_plot(ctx, plot, *area);
  const PlotMouse mouse = plot_mouse(ctx, *area, "curves.plot");
  const auto sample = nearest_point(plot.curves.front(), mouse.x);
  if (mouse.hovered && sample) {
    const double at = plot.curves.front().points[*sample].x;
    if (at >= area->x.low && at <= area->x.high) {
      draw_cursor(ctx, plot, *area, at);
      ImGui::SetTooltip("%s", curves_text(memory, *sample).c_str());
    }
  }
  if (mouse.held) take_click(ctx, memory.chart_axis, mouse.x);
}

// --- when there is nothing to plot

std::string waiting_text(const PanelContext& ctx, const CurveState& memory, const Curves& curves) {
  if (!ctx.state.has_molecule()) return "Open a molecule: curves of its cavities appear here.";
  if (axis_of(memory) == CurveAxis::model) {
    const std::string why = why_no_model_curve(ctx.inputs);
    if (!why.empty()) return why;
  }
  const std::string title(definition_of(memory).title);
  if (curves.state == DerivedState::running) return title + ": " + percent_text(curves.share);
  if (curves.state == DerivedState::cancelled) return "Cancelled.";
  if (curves.state != DerivedState::waiting && !curves.why.empty()) {
    return "There are no curves. " + curves.why;
  }
  return "The triangulations are still being computed. Curves appear here afterwards.";
}

struct CurveWork {
  std::size_t balls = 0;  // in all samples together
  double seconds = 0;     // on one thread
};

CurveWork work_of(const PanelContext& ctx, const CurveState& memory) {
  constexpr double kSumsPerBall = 1e-5, kExactPerBall = 1.6e-4;  // seconds; measured with 4HHB
  const CurveAxis axis = axis_of(memory);
  const bool exact = numbers_for(quantity_of(memory)) == CurveNumbers::exact;
  if (!ctx.inputs.balls || (axis == CurveAxis::alpha && !exact)) return {};
  constexpr std::size_t kSamples = 51;  // approximate number of samples of alpha or solvent radius
  const std::size_t times = axis == CurveAxis::model ? ctx.state.molecule.models.size() : kSamples;
  const std::size_t balls = ctx.inputs.balls->size() * times;
  return {balls, static_cast<double>(balls) * (exact ? kExactPerBall : kSumsPerBall)};
}

// Returns whether the curves may be computed. Curves that take long wait until the user starts
// them.
bool is_asked_for(PanelContext& ctx, CurveState& memory) {
  const CurveWork work = work_of(ctx, memory);
  const std::pair<int, int> question{memory.axis, memory.quantity};
  if (work.seconds <= kMostSecondsUnasked || memory.asked_for == question) return true;
  const long minutes = std::lround(std::ceil(work.seconds / 60));
  muted_wrapped(ctx, "These curves are of " + with_separators(static_cast<long long>(work.balls)) +
                         " balls in all samples together. They take about " +
                         std::to_string(minutes) + (minutes == 1 ? " minute" : " minutes") +
                         " in the background.");
  record(ctx, "curves.waiting");
  if (button(ctx, "curves.compute", "Compute")) memory.asked_for = question;
  return false;
}

// Draws a button that cancels the computation, or starts it again.
void cancel_button(PanelContext& ctx, const CurveState& memory, const Curves& curves) {
  const std::string_view id = definition_of(memory).id;
  if (curves.state == DerivedState::running || curves.state == DerivedState::waiting) {
    if (button(ctx, "curves.cancel", "Cancel")) ctx.store.cancel(id);
  } else if (curves.state == DerivedState::cancelled) {
    if (button(ctx, "curves.again", "Compute")) ctx.store.retry(id);
  }
}

std::string nothing_text(const PanelContext& ctx) {
  return ctx.state.settings.selection.cavities.empty()
             ? "There are no cavities here to plot."
             : "The selected cavities do not exist at this alpha and solvent radius. Select "
               "others on the page Cavities.";
}

void draw_curves(PanelContext& ctx, CurveState& memory) {
  choices(ctx, memory);
  reset_for_molecule(memory, ctx.state.file_hash(), [](const CurveState& old) {
    CurveState fresh;
    fresh.axis = old.axis;
    fresh.quantity = old.quantity;
    return fresh;
  });
  if (memory.quantity == CurveState::kLives) return draw_cavity_lives(ctx, memory.lives);
  const CurveAxis axis = axis_of(memory);
  // Between two pictures the atoms of the balls are unknown.
  const bool unknown = !ctx.inputs.atoms;
  const bool none = !unknown && axis == CurveAxis::model && !why_no_model_curve(ctx.inputs).empty();
  if (!unknown && !none && !is_asked_for(ctx, memory)) return;
  const Curves curves =
      unknown || none ? Curves{} : ctx.store.want(definition_of(memory), ctx.inputs);
  const bool current = follow(ctx, memory, curves);
  const bool old = memory.curves && memory.chart_axis == axis && !none;
  if (!current && !old) {
    muted_wrapped(ctx, waiting_text(ctx, memory, curves));
    record(ctx, "curves.waiting");
    cancel_button(ctx, memory, curves);
    return;
  }
  if (memory.chart.chart.empty()) {
    muted_wrapped(ctx, nothing_text(ctx));
    record(ctx, "curves.nothing");
    return;
  }
  table_buttons(ctx, memory, current);
  // Curves that do not belong to the picture are grey.
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, current ? 1.0f : 0.55f);
  legend(ctx, memory);
  ImGui::PopStyleVar();
  if (!current && !curves.ready()) {
    ImGui::SameLine(0, ctx.px(14));
    ImGui::AlignTextToFramePadding();
    muted_text(ctx, waiting_text(ctx, memory, curves));
    ImGui::SameLine(0, ctx.px(8));
    cancel_button(ctx, memory, curves);
  }
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, current ? 1.0f : 0.55f);
  ImGui::PushFont(ctx.fonts.small);
  draw_curves_plot(ctx, memory);
  ImGui::PopFont();
  ImGui::PopStyleVar();
}

}  // namespace

std::unique_ptr<Panel> curves_panel() {
  return panel_of(draw_curves);
}

}  // namespace alphascope
