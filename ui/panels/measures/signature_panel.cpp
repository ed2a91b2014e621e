// The page of the signature: counts of simplices and the Euler characteristic against alpha. A
// cursor sets alpha, and marks in the view show which simplices appear there.
#include <cmath>
#include <string>

#include "core/chart/chart.hpp"
#include "core/document/alpha/signature.hpp"
#include "core/document/store/derived.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/controls.hpp"
#include "ui/widgets/format.hpp"

namespace alphascope {
namespace {

constexpr double kMarkedWithin = 0.02;  // Å², on either side of alpha
constexpr double kLeastHigh = 10;       // Å², the right end of the axis, unless alpha is larger
constexpr double kStep = 0.01;          // Å², as the slider's step
constexpr std::size_t kMostMarked = 20000;  // for each dimension; more would be a blur
constexpr const char* kNames[] = {"vertices", "edges", "triangles", "tetrahedra"};

// --- simplices that appear at the cursor

template <class List, class Simplices>
void collect(const List& list, float low, float high, Simplices& to) {
  for (std::size_t i = 0; i < list.size() && to.size() < kMostMarked; ++i) {
    const float value = list.alpha_values[i];
    if (value >= low && value <= high) to.push_back(list.simplices[i]);
  }
}

std::shared_ptr<const Layer> make_appearing(const Inputs& in, const RunContext& context) {
  const AlphaComplex& all = in.of(whole_filtration()).top();
  auto layer = std::make_shared<Layer>();
  layer->id = "signature.appearing";
  layer->key = key_of_balls_and_alpha(in).number();
  layer->balls = in.balls;
  const auto bound = [&](double alpha) {
    return all.lattice.alpha_on_lattice(alpha).nearest_float();
  };
  const float low = bound(in.alpha_angstrom2 - kMarkedWithin),
              high = bound(in.alpha_angstrom2 + kMarkedWithin);
  collect(all.tetrahedra, low, high, layer->tetrahedra);
  context.cancel.throw_if_cancelled();
  collect(all.triangles, low, high, layer->triangles);
  context.cancel.throw_if_cancelled();
  collect(all.edges, low, high, layer->edges);
  collect(all.vertices, low, high, layer->vertices);
  layer->colour = {1, 0.35f, 0.75f, 1};
  return layer;
}

const Definition<Layer>& appearing() {
  static const Definition<Layer> definition{{.id = "signature.appearing",
                                             .title = "What appears at this alpha",
                                             .made_of = {&whole_filtration()},
                                             .key = key_of_balls_and_alpha,
                                             .memory =
                                                 [](const Inputs&) {
                                                   constexpr std::uint64_t kMost =
                                                       kMostMarked * 10 * sizeof(BallIndex);
                                                   return MemoryNeed{kMost, kMost};
                                                 },
                                             .lane = Lane::interactive},
                                            make_appearing};
  return definition;
}

struct SignatureMemory {
  bool mark = false;  // the view marks the simplices that appear at alpha
};

void mark_what_appears(PanelContext& ctx, bool& on) {
  checkbox(ctx, "signature.mark", "Mark what appears", on);
  tooltip(ctx,
          "Marks in the view the simplices whose alpha value is within 0.02 Å² of the present "
          "alpha, at most 20,000 of each dimension.");
  if (!on) return;
  // The layer never belongs to another alpha than the picture.
  const Derived<Layer> layer = ctx.store.want(appearing(), ctx.inputs);
  if (layer.ready()) ctx.state.layers.push_back(layer.value);
}

// --- the curves

struct Plot {
  ImVec2 from, to;             // pixels: the top left and bottom right corner
  double low, high;            // ends of the x axis, Å²
  double bottom = 0, top = 1;  // ends of the y axis

  float x(double alpha) const {
    return from.x + static_cast<float>((alpha - low) / (high - low)) * (to.x - from.x);
  }
  float y(double value) const {
    return to.y - static_cast<float>((value - bottom) / (top - bottom)) * (to.y - from.y);
  }
  double alpha_at(float pixel) const {
    return low + (high - low) * static_cast<double>((pixel - from.x) / (to.x - from.x));
  }
  // Returns the number of points of a curve: one every two pixels.
  int points() const { return to.x < from.x ? 0 : 1 + static_cast<int>((to.x - from.x) / 2); }
  float x_of_point(int n) const { return from.x + 2 * static_cast<float>(n); }
};

ImU32 series_colour(std::size_t n) {
  const ChartColour c = chart_colour(n);
  return IM_COL32(c.r, c.g, c.b, 255);
}

template <class Value>
void curve(const Plot& plot, ImU32 colour, float width, const Value& value) {
  std::vector<ImVec2> points;
  for (int n = 0; n < plot.points(); ++n) {
    const float x = plot.x_of_point(n);
    points.push_back({x, plot.y(static_cast<double>(value(plot.alpha_at(x))))});
  }
  ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0,
                                          width);
}

void frame(PanelContext& ctx, const Plot& plot, const char* what) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImU32 muted = to_u32(ctx.palette.text_muted), line = to_u32(ctx.palette.border);
  draw->AddRect(plot.from, plot.to, line);
  const float name = plot.to.x - ImGui::CalcTextSize(what).x - ctx.px(6);
  draw->AddText({name, plot.from.y + ctx.px(2)}, muted, what);
  const auto number = [](double value) { return with_separators(std::llround(value)); };
  const float right = plot.from.x - ctx.px(6);
  const auto label = [&](double value, float y) {
    const std::string text = number(value);
    draw->AddText({right - ImGui::CalcTextSize(text.c_str()).x, y}, muted, text.c_str());
  };
  label(plot.top, plot.from.y);
  label(plot.bottom, plot.to.y - ImGui::GetTextLineHeight());
}

void alpha_axis(PanelContext& ctx, const Plot& plot) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const double step = plot.high - plot.low > 40
                          ? std::pow(10, std::floor(std::log10(plot.high - plot.low))) / 2
                          : 2;
  const long first = std::lround(std::ceil(plot.low / step));
  const long last = std::lround(std::floor(plot.high / step));
  for (long n = first; n <= last; ++n) {
    const double a = static_cast<double>(n) * step;
    const std::string text = short_number_text(a, 2) + (n == last ? " Å²" : "");
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    draw->AddLine({plot.x(a), plot.to.y}, {plot.x(a), plot.to.y + ctx.px(3)},
                  to_u32(ctx.palette.text_muted));
    draw->AddText({std::min(plot.x(a) - width / 2, plot.to.x - width), plot.to.y + ctx.px(4)},
                  to_u32(ctx.palette.text_muted), text.c_str());
  }
}

void legend_line(PanelContext& ctx, const Signature& signature, double alpha) {
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, "α " + short_number_text(alpha, 2) + " Å²");
  for (int d = 0; d < 4; ++d) {
    ImGui::SameLine(0, ctx.px(14));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float side = ctx.px(9), middle = corner.y + ImGui::GetFrameHeight() / 2;
    ImGui::GetWindowDrawList()->AddRectFilled({corner.x, middle - side / 2},
                                              {corner.x + side, middle + side / 2},
                                              series_colour(static_cast<std::size_t>(d)));
    ImGui::SetCursorScreenPos({corner.x + side + ctx.px(5), corner.y});
    ImGui::AlignTextToFramePadding();
    ImGui::Text("%s %s", kNames[d],
                with_separators(static_cast<long long>(signature.count(d, alpha))).c_str());
  }
  ImGui::SameLine(0, ctx.px(14));
  strong_text(ctx, "Euler χ " + with_separators(signature.euler(alpha)));
  record(ctx, "signature.values");
}

void set_ranges(const Signature& signature, Plot& counts, Plot& euler) {
  counts.top = 1;
  for (int d = 0; d < 4; ++d) {
    counts.top = std::max(counts.top, static_cast<double>(signature.count(d, counts.high)));
  }
  euler.bottom = 0;
  euler.top = 1;
  for (int n = 0; n < euler.points(); ++n) {
    const double alpha = euler.alpha_at(euler.x_of_point(n));
    const auto value = static_cast<double>(signature.euler(alpha));
    euler.bottom = std::min(euler.bottom, value);
    euler.top = std::max(euler.top, value);
  }
}

void plots(PanelContext& ctx, const Signature& signature) {
  Request& request = ctx.state.settings.request;
  const double shown = ctx.inputs.alpha_angstrom2;
  const ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const float left = corner.x + ctx.px(64), right = corner.x + room.x - ctx.px(16);
  const float bottom = corner.y + room.y - ctx.px(22);
  const float middle = corner.y + (bottom - corner.y) * 0.62f;
  if (bottom - corner.y < ctx.px(60) || right - left < ctx.px(120)) return;
  const double high = std::max(kLeastHigh, shown),
               low = std::min({signature.least_alpha(), shown, high - 1});
  Plot counts{{left, corner.y}, {right, middle - ctx.px(6)}, low, high};
  Plot euler{{left, middle}, {right, bottom}, low, high};
  set_ranges(signature, counts, euler);
  frame(ctx, counts, "simplices");
  frame(ctx, euler, "Euler χ");
  for (int d = 0; d < 4; ++d) {
    curve(counts, series_colour(static_cast<std::size_t>(d)), ctx.px(1.5f),
          [&](double a) { return signature.count(d, a); });
  }
  curve(euler, to_u32(ctx.palette.text), ctx.px(1.5f),
        [&](double a) { return signature.euler(a); });
  alpha_axis(ctx, euler);
  ImGui::GetWindowDrawList()->AddLine({counts.x(shown), counts.from.y}, {counts.x(shown), bottom},
                                      to_u32(ctx.palette.accent), ctx.px(1.5f));
  ImGui::SetCursorScreenPos(counts.from);
  ImGui::InvisibleButton("##signature", {right - left, bottom - corner.y});
  record(ctx, "signature.plot");
  tooltip(ctx, "Click or drag to set alpha.");
  if (!ImGui::IsItemActive()) return;
  const double wanted = std::clamp(counts.alpha_at(ImGui::GetIO().MousePos.x), low, high);
  set_alpha(request, std::round(wanted / kStep) * kStep);
  ctx.state.playback.alpha = false;
}

// Says why there are no curves yet.
std::string waiting_text(const PanelContext& ctx, const Derived<Signature>& signature) {
  if (!ctx.state.molecule.loaded) return "Open a molecule: its signature appears here.";
  if (signature.state != DerivedState::waiting && !signature.why.empty()) {
    return "There is no signature. " + signature.why;
  }
  if (!ctx.state.background.detail.empty()) return ctx.state.background.detail;
  return "The signature appears here when all simplices are known.";
}

void draw_signature(PanelContext& ctx, SignatureMemory& memory) {
  const Derived<Signature> signature = ctx.store.want(whole_signature(), ctx.inputs);
  mark_what_appears(ctx, memory.mark);
  if (!signature.ready()) {
    muted_wrapped(ctx, waiting_text(ctx, signature));
    record(ctx, "signature.waiting");
    return;
  }
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
