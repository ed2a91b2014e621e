// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the chosen cavities in the view: asks for their shapes, and makes their layers anew
// whenever something that they depend on has changed.
#include <memory>
#include <utility>

#include "core/document/cavities/selected_cavities.hpp"
#include "core/document/reference/appearance.hpp"
#include "core/document/settings/display.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

void make_layers(PanelContext& ctx, CavityPage& page) {
  bool old = std::exchange(page.layers_are_old, false);
  old |= std::exchange(page.beside, ctx.state.settings.display.beside) !=
         ctx.state.settings.display.beside;
  old |= !(std::exchange(page.hidden, ctx.state.settings.appearance.hidden) ==
           ctx.state.settings.appearance.hidden);
  const DisplaySettings& d = ctx.state.settings.display;
  const bool body = d.balls || d.tetrahedra || d.boundary || d.triangles || d.edges;
  const CavityPage::Sticks sticks{d.lining_sticks, page.fades_rest || !body, d.lining_opacity,
                                  d.content_opacity};
  old |= !(std::exchange(page.sticks, sticks) == sticks);
  old |= std::exchange(page.theme, ctx.state.theme()) != ctx.state.theme();
  const auto balls = page.drawn ? balls_of_layers(ctx, page) : nullptr;
  old |= std::exchange(page.layers_of, balls) != balls;
  if (!old) return;
  ++page.layers_key;
  page.layers.clear();
  if (!page.drawn) return;
  for (const SelectedCavity& cavity : page.drawn->of) {
    // While a newer table waits for its shapes, it may have fewer rows.
    if (cavity.row < page.rows.size()) add_layers_of_cavity(ctx, page, cavity);
  }
  add_layer_of_lining(page);
  add_layer_of_contents(page);
}

}  // namespace

void draw_layers_of_cavities(PanelContext& ctx, CavityPage& page, bool current) {
  if (page.selected_rows.empty()) {
    page.layers_are_old |= page.drawn != nullptr;
    page.drawn = nullptr;
  } else if (current) {
    const auto drawn = ctx.store.want(
        selected_cavities(page.choice.sinks, page.choice.parts, page.choice.key), ctx.inputs);
    if (drawn.ready() && drawn.value != page.drawn) {
      page.drawn = drawn.value;
      page.layers_are_old = true;
    }
  }
  make_layers(ctx, page);
  for (const auto& layer : page.layers) ctx.state.layers.push_back(layer);
  follow_hover_mark(ctx, page);
  if (page.hover_mark) ctx.state.layers.push_back(page.hover_mark);
}

}  // namespace alphascope
