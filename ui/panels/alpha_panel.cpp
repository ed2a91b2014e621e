// Alpha and the solvent radius: two separate controls, each with its unit, and what they do to the
// radii.
#include <algorithm>
#include <cmath>

#include "ui/panels/format.hpp"
#include "ui/panels/number_field.hpp"
#include "ui/panels/panels.hpp"

namespace alphascope {
namespace {

constexpr double kSliderLow = -3, kSliderHigh = 10;  // Å²; typed values may lie outside
constexpr double kSliderStep = 0.01;
constexpr double kPresets[] = {0, 1.4, 3, 10};
constexpr double kWater = 1.4;  // Å, radius of a water molecule

void draw_ticks(PanelContext& ctx, double low, double high) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
  const float grab = ImGui::GetStyle().GrabMinSize / 2 + 2;
  for (const double preset : kPresets) {
    const float t = static_cast<float>((preset - low) / (high - low));
    const float x = a.x + grab + t * (b.x - a.x - 2 * grab);
    draw->AddLine({x, b.y - ctx.px(5)}, {x, b.y - ctx.px(1)}, to_u32(ctx.palette.text_muted),
                  ctx.px(1));
  }
}

void slider(PanelContext& ctx) {
  double& alpha = ctx.state.compute.alpha_angstrom2;
  const double low = std::min(kSliderLow, alpha), high = std::max(kSliderHigh, alpha);
  double value = alpha;
  bool& playing = ctx.state.memory.playing;
  ImGui::BeginDisabled(!ctx.state.result);
  if (button(ctx, "alpha.play", playing ? "Stop" : "Play", {ctx.px(44), 0})) {
    ctx.commands.run("alpha.play");
  }
  ImGui::EndDisabled();
  tooltip(ctx, playing ? "Stop here" : "Let alpha grow by itself, up to 10 Å²");
  ImGui::SameLine(0, ctx.px(6));
  ImGui::SetNextItemWidth(-1);
  const bool typing = ctx.state.memory.number.name == "alpha.slider";
  if (number_slider(ctx, "alpha.slider", value, low, high, kAlphaRule)) {
    alpha = typing ? value : std::round(value / kSliderStep) * kSliderStep;
    if (alpha == 0) alpha = 0;  // no minus zero in the text
    playing = false;
  }
  tooltip(ctx,
          "Alpha in Å². Every radius r becomes sqrt(r² + α).\nCtrl+click to type; arrow keys step "
          "by 0.1, with shift by 1.");
  draw_ticks(ctx, low, high);
}

void typed_and_presets(PanelContext& ctx) {
  double& alpha = ctx.state.compute.alpha_angstrom2;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("α");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(ctx.px(78));
  if (number_field(ctx, "alpha.typed", alpha, kAlphaRule)) ctx.state.memory.playing = false;
  ImGui::SameLine(0, ctx.px(4));
  ImGui::TextUnformatted("Å²");
  const float left = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + ctx.px(10);
  const float width = (ImGui::GetWindowContentRegionMax().x - left - ctx.px(12)) / 4;
  for (const double preset : kPresets) {
    ImGui::SameLine(0, preset == kPresets[0] ? ctx.px(10) : ctx.px(4));
    const std::string text = short_number_text(preset, 1);
    const std::string name = "alpha.preset." + text;
    if (button(ctx, name.c_str(), text.c_str(), {width, 0})) alpha = preset;
  }
}

void solvent(PanelContext& ctx) {
  double& radius = ctx.state.compute.solvent_radius_angstrom;
  row_label(ctx, "Solvent radius");
  double value = radius;
  const double high = std::max(5.0, radius);
  const bool typing = ctx.state.memory.number.name == "alpha.solvent";
  if (value_slider(ctx, "alpha.solvent", value, 0, high, kSolventRule,
                   short_number_text(radius, 3) + " Å", 56)) {
    radius = typing ? std::round(value * 1000) / 1000 : std::round(value * 100) / 100;
  }
  tooltip(
      ctx,
      "Solvent radius in Å: every radius grows by it before anything else.\nCtrl+click to type.");
  ImGui::SameLine(0, ctx.px(6));
  const bool water = radius == kWater;
  if (button(ctx, "alpha.water", water ? "none" : "water", {-1, 0})) {
    radius = water ? 0 : kWater;
  }
  tooltip(ctx, water ? "No solvent: 0 Å" : "Water: 1.4 Å");
}

std::string grown_text(const GrownRadius& r) {
  return number_text(r.radius, 2) + " → " + (r.grown > 0 ? number_text(r.grown, 2) : "empty");
}

// Which atoms: an element may have several radii.
std::string balls_text(const GrownRadius& r) {
  return with_separators(static_cast<long long>(r.balls)) + (r.balls == 1 ? " ball" : " balls") +
         (r.atoms.empty() ? "" : ": " + r.atoms);
}

// "C 1.70 → 2.07", two columns.
void grown_radii(PanelContext& ctx) {
  const auto& radii = ctx.state.molecule.radii;
  if (radii.empty()) return;
  muted_text(ctx, "Radii → grown by solvent and α (Å)");
  const float half = ImGui::GetContentRegionAvail().x / 2;
  const float start = ImGui::GetCursorPosX();
  constexpr std::size_t kShown = 6;
  for (std::size_t i = 0; i < std::min(radii.size(), kShown); ++i) {
    if (i % 2 == 1) ImGui::SameLine(start + half);
    const GrownRadius& r = radii[i];
    strong_text(ctx, r.element.empty() ? "r" : r.element);
    ImGui::SameLine(start + (i % 2 == 1 ? half : 0) + ctx.px(28));
    ImGui::TextUnformatted(grown_text(r).c_str());
    record(ctx, ("alpha.radius." + std::to_string(i)).c_str());
    tooltip(ctx, balls_text(r).c_str());
  }
  if (radii.size() <= kShown) return;
  muted_text(ctx, "and " + std::to_string(radii.size() - kShown) + " more");
  std::string rest;
  for (std::size_t i = kShown; i < radii.size(); ++i) {
    rest += (i == kShown ? "" : "\n") + radii[i].element + " " + grown_text(radii[i]) + "; " +
            balls_text(radii[i]);
  }
  tooltip(ctx, rest.c_str());
}

}  // namespace

void draw_alpha_panel(PanelContext& ctx) {
  if (!section(ctx, "alpha", "Alpha")) return;
  slider(ctx);
  typed_and_presets(ctx);
  solvent(ctx);
  grown_radii(ctx);
}

}  // namespace alphascope
