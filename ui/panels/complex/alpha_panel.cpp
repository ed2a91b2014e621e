// SPDX-License-Identifier: GPL-3.0-or-later
// The section on alpha: controls for alpha and the solvent radius, each with its unit, and the
// grown radii.
#include <algorithm>
#include <cmath>

#include "core/document/alpha/alpha_slider.hpp"
#include "core/document/alpha/signature.hpp"
#include "core/document/commands/commands.hpp"
#include "core/document/settings/request.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "core/geometry/ball_set.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/complex/alpha_state.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/playback.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/window_settings.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/key_focus.hpp"
#include "ui/widgets/number_field.hpp"
#include "ui/widgets/number_typing.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

constexpr double kPresets[] = {0, 1.4, 3, 10};
constexpr double kWater = 1.4;  // Å, radius of a water molecule

// The track on which the middle of the slider's grab moves.
struct Track {
  float from, to, top, bottom;  // pixels
  float x(double place) const { return from + static_cast<float>(place) * (to - from); }
};

Track track_of_last_item() {
  const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
  const float grab = ImGui::GetStyle().GrabMinSize / 2 + 2;
  return {a.x + grab, b.x - grab, a.y, b.y};
}

void draw_preset_ticks(PanelContext& ctx, const AlphaSlider& s, const Track& track) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  for (const double preset : kPresets) {
    if (preset < s.low || preset > s.high) continue;
    const float x = track.x(slider_position_of_alpha(s, preset));
    draw->AddLine({x, track.bottom - ctx.px(5)}, {x, track.bottom - ctx.px(1)},
                  to_u32(ctx.palette.text_muted), ctx.px(1));
  }
}

// Marks the critical values, at which simplices appear, along the slider. Each column of pixels has
// a bar, which is higher for more simplices.
void draw_critical_values(PanelContext& ctx, const AlphaSlider& s, const Track& track) {
  // Larger molecules have critical values at every pixel, and sorting them takes memory.
  constexpr std::size_t kMostBalls = 50000;
  const float height = ctx.px(6);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::Dummy({ImGui::GetContentRegionAvail().x, height});
  record(ctx, "alpha.critical");
  if (!ctx.inputs.balls || ctx.inputs.balls->size() > kMostBalls) return;
  const Derived<Signature> signature = ctx.store.want(whole_signature(), ctx.inputs);
  if (!signature.ready() || track.to <= track.from) return;
  tooltip(
      ctx,
      "Critical values: alphas at which simplices appear. Higher marks stand for more simplices.");
  const auto columns = static_cast<std::size_t>(track.to - track.from);
  const std::vector<std::uint32_t> counts = critical_values(s, *signature.value, columns);
  const std::uint32_t most = std::max(1u, *std::max_element(counts.begin(), counts.end()));
  const float full = std::log1p(static_cast<float>(most));
  ImDrawList* draw = ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    const float share = 0.3f + 0.7f * std::log1p(static_cast<float>(counts[i])) / full;
    const float x = track.from + static_cast<float>(i);
    draw->AddRectFilled({x, corner.y + height * (1 - share)}, {x + 1, corner.y + height},
                        to_u32(ctx.palette.text_muted));
  }
}

// While Shift is down, the grab moves a tenth as far as the mouse. When Shift is released, the drag
// goes on from where the grab is.
void drag_finely(AlphaState& m, const AlphaSlider& s, double alpha, const Track& track,
                 double& place, bool& fine) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsItemActive()) m.relative = m.fine = false;
  fine = ImGui::IsItemActive() && io.KeyShift;
  if (!ImGui::IsItemActive() || (!m.relative && !io.KeyShift)) return;
  if (!m.relative || m.fine != io.KeyShift) {
    m.from_place = slider_position_of_alpha(s, alpha);
    m.from_x = io.MousePos.x;
  }
  m.relative = true;
  m.fine = io.KeyShift;
  const double moved = (io.MousePos.x - m.from_x) / std::max(1.0f, track.to - track.from);
  place = std::clamp(m.from_place + moved * (m.fine ? 0.1 : 1), 0.0, 1.0);
}

void alpha_slider(PanelContext& ctx, AlphaState& memory) {
  const AlphaSlider& scale = ctx.state.window.alpha_slider;
  Alpha& alpha = ctx.state.settings.request.alpha_angstrom2;
  bool changed = false;
  if (draw_typed_number(ctx, "alpha.slider", alpha, changed)) {
    if (changed) ctx.state.playback.alpha = false;
    return;
  }
  const double before = slider_position_of_alpha(scale, alpha), low = 0, high = 1;
  double place = before;
  ImGui::PushID("alpha.slider");
  changed = ImGui::SliderScalar("##slider", ImGuiDataType_Double, &place, &low, &high, "",
                                ImGuiSliderFlags_NoInput);
  ImGui::PopID();
  record(ctx, "alpha.slider");
  // KeyStop::slide is not needed, since the arrow keys change alpha wherever the focus is.
  key_stop(ctx, "alpha.slider", KeyStop::number);
  const Track track = track_of_last_item();
  bool fine = false;
  drag_finely(memory, scale, alpha, track, place, fine);
  if ((changed || memory.relative) && place != before) {
    const double pixel = 1 / std::max(1.0f, track.to - track.from);
    alpha = alpha_at_slider_position(scale, place, fine ? pixel / 10 : pixel);
    ctx.state.playback.alpha = false;
  }
}

void slider(PanelContext& ctx, AlphaState& memory) {
  const AlphaSlider& scale = ctx.state.window.alpha_slider;
  const bool playing = ctx.state.playback.alpha;
  ImGui::BeginDisabled(!ctx.state.result);
  if (button(ctx, "alpha.play", playing ? "Stop" : "Play", {ctx.px(44), 0})) {
    ctx.commands.run(playing && ctx.state.playback.backwards ? "alpha.play_back" : "alpha.play");
  }
  ImGui::EndDisabled();
  tooltip(ctx, playing ? "Stop here" : "Let alpha grow by itself, to the slider's high end");
  ImGui::SameLine(0, ctx.px(6));
  ImGui::SetNextItemWidth(-1);
  const float left = ImGui::GetCursorPosX();
  alpha_slider(ctx, memory);
  tooltip(ctx,
          "Alpha in Å². Every radius r becomes sqrt(r² + α).\nCtrl+click to type; Shift while "
          "dragging for fine steps; arrow keys step by 0.1, with shift by 1.");
  const Track track = track_of_last_item();
  draw_preset_ticks(ctx, scale, track);
  ImGui::SetCursorPosX(left);
  draw_critical_values(ctx, scale, track);
}

// --- settings of slider and playback, which few users change often

void scale_row(PanelContext& ctx, AlphaSlider& s) {
  row_label(ctx, "Scale");
  int chosen = static_cast<int>(s.scaling);
  choice(ctx, "alpha.scale", {"linear", "±√", "log"}, chosen, ImGui::GetContentRegionAvail().x);
  s.scaling = static_cast<AlphaScaling>(chosen);
}

void range_row(PanelContext& ctx, AlphaSlider& s) {
  constexpr double kApart = 0.001;  // Å², least distance of the ends
  row_label(ctx, "From, to (Å²)");
  const float fit = ctx.px(34), gap = ctx.px(4);
  const float each = (ImGui::GetContentRegionAvail().x - fit - 2 * gap) / 2;
  ImGui::SetNextItemWidth(each);
  number_field(ctx, "alpha.low", s.low, {"The low end", kAlphaRule.least, s.high - kApart, "Å²"});
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(each);
  number_field(ctx, "alpha.high", s.high, {"The high end", s.low + kApart, kAlphaRule.most, "Å²"});
  ImGui::SameLine(0, gap);
  const Derived<Signature> signature = ctx.store.want(whole_signature(), ctx.inputs);
  ImGui::BeginDisabled(!signature.ready());
  if (button(ctx, "alpha.fit", "fit", {fit, 0})) fit_range(s, *signature.value);
  ImGui::EndDisabled();
  tooltip(ctx, signature.ready()
                   ? "Fit the slider: from the first critical value to 98 % of the tetrahedra"
                   : "The critical values are still being computed.");
}

void playing_row(PanelContext& ctx, AlphaSlider& s) {
  const bool back = ctx.state.playback.alpha && ctx.state.playback.backwards;
  row_label(ctx, "Playing");
  ImGui::BeginDisabled(!ctx.state.result);
  if (button(ctx, "alpha.play_back", back ? "stop" : "back", {ctx.px(44), 0})) {
    ctx.commands.run("alpha.play_back");
  }
  ImGui::EndDisabled();
  tooltip(ctx, "Let alpha shrink by itself, to the slider's low end");
  ImGui::SameLine(0, ctx.px(6));
  checkbox(ctx, "alpha.loop", "loop", s.loop);
  ImGui::SameLine(0, ctx.px(10));
  ImGui::SetNextItemWidth(-1);
  number_field(ctx, "alpha.speed", s.speed, kPlaySpeedRule);
  tooltip(ctx, "Speed: 1 crosses the slider in 260 pictures; 0.1 to 20");
}

void slider_options(PanelContext& ctx) {
  AlphaSlider& s = ctx.state.window.alpha_slider;
  const AlphaSlider usual;
  const std::string changed = s == usual ? "" : ", changed";
  ImGui::PushFont(ctx.fonts.small);
  const bool open =
      disclosure(ctx, "alpha.options", "Slider and playing" + changed, ctx.palette.text_muted);
  ImGui::PopFont();
  if (!open) return;
  ImGui::TreePop();
  scale_row(ctx, s);
  range_row(ctx, s);
  playing_row(ctx, s);
}

void typed_and_presets(PanelContext& ctx) {
  Alpha& alpha = ctx.state.settings.request.alpha_angstrom2;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("α");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(ctx.px(78));
  if (number_field(ctx, "alpha.typed", alpha)) ctx.state.playback.alpha = false;
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
  double& radius = ctx.state.settings.request.solvent_radius_angstrom;
  row_label(ctx, "Solvent radius");
  double value = radius;
  const double high = std::max(5.0, radius);
  const bool typing = ctx.state.number.name == "alpha.solvent";
  if (value_slider(ctx, "alpha.solvent", value, 0, high, kSolventRule,
                   short_number_text(radius, 3) + " Å", 56)) {
    radius = typing ? std::round(value * 1000) / 1000 : std::round(value * 100) / 100;
  }
  tooltip(ctx,
          "Solvent radius in Å. It is added to every radius before alpha is applied.\nCtrl+click "
          "to type.");
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

// Names some atoms too, since an element may have several radii.
std::string balls_text(const GrownRadius& r) {
  return with_separators(static_cast<long long>(r.balls)) + (r.balls == 1 ? " ball" : " balls") +
         (r.atoms.empty() ? "" : ": " + r.atoms);
}

// Draws lines such as "C 1.70 → 2.07", in two columns.
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

void draw_alpha(PanelContext& ctx, AlphaState& memory) {
  if (!section(ctx, "alpha", "Alpha")) return;
  slider(ctx, memory);
  typed_and_presets(ctx);
  slider_options(ctx);
  solvent(ctx);
  grown_radii(ctx);
}

}  // namespace

std::unique_ptr<Panel> alpha_panel() {
  return panel_of(draw_alpha);
}

}  // namespace alphascope
