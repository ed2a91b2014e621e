// Curves of cavities against alpha, solvent radius and model: of those that are chosen on the page
// of cavities, or of all voids and all pockets.
#include <algorithm>
#include <cmath>

#include "core/chart/readable_number.hpp"
#include "core/document/cavity_chart.hpp"
#include "core/document/cavity_curve_results.hpp"
#include "core/document/cavity_names.hpp"
#include "core/document/cavity_results.hpp"
#include "core/document/store.hpp"
#include "ui/panels/curve_plot.hpp"
#include "ui/panels/format.hpp"
#include "ui/panels/panels.hpp"

namespace alphascope {
namespace {

constexpr double kAlphaStep = 0.01;            // Å², as the slider's
constexpr double kSolventStep = 0.1;           // Å, as the samples'
constexpr std::size_t kMostLines = 8;          // as many colours as there are
constexpr std::size_t kMostUnasked = 6000000;  // balls, of all triangulations of one curve

using Curves = Derived<CavityCurves>;

CurveAxis axis_of(const CurveMemory& memory) {
  return static_cast<CurveAxis>(memory.axis);
}

CurveQuantity quantity_of(const CurveMemory& memory) {
  return static_cast<CurveQuantity>(memory.quantity);
}

const Definition<CavityCurves>& definition_of(CurveAxis axis) {
  return axis == CurveAxis::alpha     ? curves_over_alpha()
         : axis == CurveAxis::solvent ? curves_over_solvent()
                                      : curves_over_models();
}

// --- what is chosen

// The cavities of the table that were chosen, whichever it was chosen of: the one that the sink is
// in, wherever the triangulation has it.
std::vector<std::size_t> chosen_rows(const CavityTable& table, const BallReferences& atoms,
                                     const std::vector<SimplexRef>& chosen) {
  std::vector<std::size_t> row_of(table.size());
  for (std::size_t row = 0; row < table.size(); ++row) row_of[table.order[row]] = row;
  const Simplices<4>& all = table.ground->triangulation->tetrahedra;
  std::vector<std::size_t> rows;
  for (const SimplexRef& ref : chosen) {
    const auto balls = atoms.balls(ref);
    if (!balls || balls->size() != 4) continue;
    const std::array<BallIndex, 4> sink{(*balls)[0], (*balls)[1], (*balls)[2], (*balls)[3]};
    const auto at = std::lower_bound(all.begin(), all.end(), sink);
    if (at == all.end() || *at != sink) continue;
    const std::uint32_t cavity =
        table.found.cavity_of_tetrahedron[static_cast<std::size_t>(at - all.begin())];
    if (cavity == Cavities::kNone) continue;
    const std::size_t row = row_of[cavity];
    if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(row);
  }
  std::sort(rows.begin(), rows.end());
  if (rows.size() > kMostLines) rows.resize(kMostLines);
  return rows;
}

void make_chart(CurveMemory& memory, const CavityCurves& curves, const CurveLinks* links,
                const CavityTable* table, const std::vector<std::size_t>& rows) {
  memory.chart_axis = curves.axis;
  memory.colours.clear();
  if (rows.empty()) {
    memory.chart = chart_of_totals(curves, quantity_of(memory));
    memory.colours = {0, 1};
    return;
  }
  std::vector<ChartedCavity> chosen;
  for (const std::size_t row : rows) {
    const char* kind = table->cavity(row).is_void() ? "void " : "pocket ";
    chosen.push_back({table->order[row], kind + std::to_string(row + 1)});
    memory.colours.push_back(row);
  }
  memory.chart = chart_of_cavities(curves, quantity_of(memory), *links, chosen);
}

// Keeps the chart that there is until the next one can be made. True: it is of what is on screen.
bool follow(PanelContext& ctx, CurveMemory& memory, const Curves& curves) {
  if (!curves.ready()) return false;
  const std::vector<SimplexRef>& chosen = ctx.state.memory.cavities.chosen;
  const auto& atoms = ctx.inputs.atoms;
  std::shared_ptr<const CurveLinks> links;
  std::shared_ptr<const CavityTable> table;
  if (!chosen.empty() && atoms) {
    const Derived<CavityTable> tables = ctx.store.want(cavity_table(), ctx.inputs);
    const Derived<CurveLinks> linked =
        ctx.store.want(curve_links(curves.value, curves.have), ctx.inputs);
    if (!tables.ready() || !linked.ready()) return false;
    table = tables.value;
    links = linked.value;
  }
  const bool same = memory.curves == curves.value && memory.links == links &&
                    memory.chosen == chosen && memory.chart_quantity == memory.quantity;
  if (same) return true;
  std::vector<std::size_t> rows;
  if (table) rows = chosen_rows(*table, *atoms, chosen);
  make_chart(memory, *curves.value, links.get(), table.get(), rows);
  memory.curves = curves.value;
  memory.links = links;
  memory.chosen = chosen;
  memory.chart_quantity = memory.quantity;
  return true;
}

// --- the line above the plot

void copy_button(PanelContext& ctx, const CurveMemory& memory) {
  if (button(ctx, "curves.copy", "Copy CSV")) {
    std::vector<std::string> comments;
    for (const auto& [key, value] : ctx.state.molecule.provenance) {
      if (!value.empty()) comments.push_back(key + ": " + value);
    }
    if (memory.chart_axis != CurveAxis::solvent) {
      comments.push_back("solvent radius: " +
                         axis_text(CurveAxis::solvent, ctx.inputs.solvent_radius_angstrom) + " Å");
    }
    if (memory.chart_axis != CurveAxis::alpha) {
      comments.push_back("alpha: " + axis_text(CurveAxis::alpha, ctx.inputs.alpha_angstrom2) +
                         " Å²");
    }
    ImGui::SetClipboardText(chart_csv(memory.chart.chart, comments).c_str());
    ctx.state.notice = "Curves copied as CSV.";
  }
  tooltip(ctx, "Copies the curves as a table with commas between the numbers");
}

void legend(PanelContext& ctx, const CurveMemory& memory) {
  const std::vector<ChartSeries>& series = memory.chart.chart.series;
  for (std::size_t s = 0; s < series.size(); ++s) {
    ImGui::SameLine(0, ctx.px(14));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float side = ctx.px(9), middle = corner.y + ImGui::GetFrameHeight() / 2;
    const ChartColour c = chart_colour(memory.colours[s]);
    ImGui::GetWindowDrawList()->AddRectFilled({corner.x, middle - side / 2},
                                              {corner.x + side, middle + side / 2},
                                              IM_COL32(c.r, c.g, c.b, 255));
    ImGui::SetCursorScreenPos({corner.x + side + ctx.px(5), corner.y});
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(series[s].name.c_str());
  }
  if (!memory.chart.marks.empty()) {
    ImGui::SameLine(0, ctx.px(14));
    ImGui::AlignTextToFramePadding();
    muted_text(ctx, "ring: splits or joins");
  }
  record(ctx, "curves.legend");
}

void choices(PanelContext& ctx, CurveMemory& memory) {
  constexpr float kWidth = 430;  // pixels at scale 1, of all; the names of the pages stand before
  if (ImGui::GetContentRegionAvail().x < ctx.px(kWidth)) ImGui::NewLine();
  choice(ctx, "curves.quantity", {"Volume", "Area"}, memory.quantity, ctx.px(120));
  tooltip(ctx, "The region of probe centres, as CASTp sums it: SA volume or SA area");
  ImGui::SameLine(0, ctx.px(10));
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, "against");
  ImGui::SameLine(0, ctx.px(8));
  choice(ctx, "curves.axis", {"Alpha", "Solvent", "Model"}, memory.axis, ctx.px(240));
}

// --- the plot

void take_click(PanelContext& ctx, CurveAxis axis, double at) {
  ViewState& s = ctx.state;
  if (axis == CurveAxis::alpha) {
    set_alpha(s.compute, std::round(at / kAlphaStep) * kAlphaStep);
    s.memory.playing = false;
  } else if (axis == CurveAxis::solvent) {
    const double steps = std::round(std::clamp(at, 0.0, kCurveSolventMostAngstrom) / kSolventStep);
    s.compute.solvent_radius_angstrom = steps / std::round(1 / kSolventStep);
  } else {
    const auto last = static_cast<double>(s.molecule.models.size()) - 1;
    s.open.balls.model = static_cast<int>(std::lround(std::clamp(at, 0.0, last)));
    s.memory.playing_models = false;
  }
}

double shown_at(const PanelContext& ctx, CurveAxis axis) {
  const Request& request = ctx.state.compute;
  if (axis == CurveAxis::alpha) return request.alpha_angstrom2;
  if (axis == CurveAxis::solvent) return request.solvent_radius_angstrom;
  return ctx.state.open.balls.model;
}

void draw_plot(PanelContext& ctx, const CurveMemory& memory) {
  const CurveAxis axis = memory.chart_axis;
  CurvePlot plot{&memory.chart, &memory.colours, axis, shown_at(ctx, axis), "", "", ""};
  plot.unit = axis == CurveAxis::alpha ? "Å²" : axis == CurveAxis::solvent ? "Å" : "";
  plot.value_unit = memory.chart_quantity == 0 ? "Å³" : "Å²";
  plot.click = axis == CurveAxis::alpha     ? "Click or drag to set alpha."
               : axis == CurveAxis::solvent ? "Click or drag to set the solvent radius."
                                            : "Click to show this model.";
  const auto at = draw_curve_plot(ctx, plot);
  if (at) take_click(ctx, axis, *at);
}

// --- when there is nothing to plot

std::string percent(double share) {
  return std::to_string(static_cast<int>(share * 100)) + " %";
}

std::string waiting_text(const PanelContext& ctx, const Curves& curves, CurveAxis axis) {
  if (!ctx.state.molecule.loaded) return "Open a molecule: curves of its cavities appear here.";
  if (axis == CurveAxis::model) {
    const std::string why = why_no_model_curve(ctx.inputs);
    if (!why.empty()) return why;
  }
  const std::string title(definition_of(axis).title);
  if (curves.state == DerivedState::running) return title + ": " + percent(curves.share);
  if (curves.state != DerivedState::waiting && !curves.why.empty()) {
    return "There are no curves. " + curves.why;
  }
  return "Curves appear here when the triangulations that they need are there.";
}

// Balls to be triangulated for a curve.
std::size_t work_of(const PanelContext& ctx, CurveAxis axis) {
  if (!ctx.inputs.balls || axis == CurveAxis::alpha) return 0;
  const std::size_t times = axis == CurveAxis::solvent ? 51 : ctx.state.molecule.models.size();
  return ctx.inputs.balls->size() * times;
}

// Of what takes long, only upon request.
bool is_asked_for(PanelContext& ctx, CurveMemory& memory, CurveAxis axis) {
  const std::size_t work = work_of(ctx, axis);
  if (work <= kMostUnasked || memory.asked_for == memory.axis) return true;
  constexpr double kSecondsPerBall = 1e-5;  // one thread; 7 microseconds measured
  const long minutes = std::lround(std::ceil(static_cast<double>(work) * kSecondsPerBall / 60));
  muted_wrapped(ctx, "These curves need triangulations of " +
                         with_separators(static_cast<long long>(work)) + " balls: some " +
                         std::to_string(minutes) + " minutes in the background.");
  record(ctx, "curves.waiting");
  if (button(ctx, "curves.compute", "Compute")) memory.asked_for = memory.axis;
  return false;
}

std::string nothing_text(const PanelContext& ctx) {
  return ctx.state.memory.cavities.chosen.empty()
             ? "There are no cavities here to plot."
             : "The chosen cavities are on none of these samples. Choose others on the page "
               "Cavities.";
}

}  // namespace

void draw_curves_panel(PanelContext& ctx) {
  CurveMemory& memory = ctx.state.memory.curves;
  choices(ctx, memory);
  const CurveAxis axis = axis_of(memory);
  if (std::exchange(memory.molecule, ctx.state.molecule.sha256) != ctx.state.molecule.sha256) {
    memory.curves = nullptr;
    memory.asked_for = -1;
  }
  // Between two pictures it is not known of which atoms the balls are.
  const bool unknown = !ctx.inputs.atoms;
  const bool none = !unknown && axis == CurveAxis::model && !why_no_model_curve(ctx.inputs).empty();
  if (!unknown && !none && !is_asked_for(ctx, memory, axis)) return;
  const Curves curves =
      unknown || none ? Curves{} : ctx.store.want(definition_of(axis), ctx.inputs);
  const bool current = follow(ctx, memory, curves);
  const bool old = memory.curves && memory.chart_axis == axis && !none;
  if (!current && !old) {
    muted_wrapped(ctx, waiting_text(ctx, curves, axis));
    record(ctx, "curves.waiting");
    return;
  }
  if (memory.chart.chart.empty()) {
    muted_wrapped(ctx, nothing_text(ctx));
    record(ctx, "curves.nothing");
    return;
  }
  copy_button(ctx, memory);
  // What is no longer, or not yet, of the picture is grey.
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, current ? 1.0f : 0.55f);
  legend(ctx, memory);
  if (!current && curves.state == DerivedState::running) {
    ImGui::SameLine(0, ctx.px(14));
    muted_text(ctx, percent(curves.share));
  }
  ImGui::PushFont(ctx.fonts.small);
  draw_plot(ctx, memory);
  ImGui::PopFont();
  ImGui::PopStyleVar();
}

}  // namespace alphascope
