// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of the view that show a cavity, and the balls to which they belong.
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/cavity_shape/cavity_shape.hpp"
#include "core/cavity_shape/filling_spheres.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/cavities/selected_cavities.hpp"
#include "core/document/reference/reference.hpp"
#include "ui/layer.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

std::shared_ptr<const BallSet> balls_of_layers(const PanelContext& ctx, const CavityPage& page) {
  const bool same_atoms = ctx.state.shown_selection() == &page.rows.lines->atoms->prepared();
  return same_atoms ? ctx.state.shown_balls() : page.drawn->table->ground->balls;
}

void add_layers_of_cavity(PanelContext& ctx, CavityPage& page, const SelectedCavity& cavity) {
  const auto add = [&](const char* kind, const Colour& colour) -> Layer& {
    auto layer = std::make_shared<Layer>();
    layer->id = std::string("cavities.") + kind + "." + std::to_string(cavity.row);
    layer->balls = page.layers_of;
    layer->key = page.layers_key;
    layer->colour = colour;
    page.layers.push_back(layer);
    return *layer;
  };
  const Colour colour = cavity_colour(page, cavity.row);
  if (!cavity.surface.empty() || !cavity.tetrahedra.empty() || !cavity.spheres.empty()) {
    Layer& body = add("body", colour);
    body.body = body.translucent = true;
    if (page.drawn->table == page.rows.all) {  // else the row may be another cavity by now
      body.name = cavity_title(page, cavity.row);
      body.page = "cavities";
      body.cavity = cavity.row;
    }
    body.fades_rest = page.fades_rest;
    body.triangles = cavity.surface;
    body.tetrahedra = cavity.tetrahedra;
    for (const FillingSphere& sphere : cavity.spheres) {
      body.spheres.push_back({sphere.centre_angstrom, sphere.radius_angstrom});
    }
  }
  if (!cavity.rims.empty()) {
    Layer& rims = add("mouths", ctx.palette.text);
    rims.edges = cavity.rims;
    rims.body = true;  // else rims of the far side would show through
    rims.fades_rest = page.fades_rest;
  }
  if (page.choice.parts.numbers) {
    add("number", ctx.palette.text)
        .labels.push_back({cavity.place_angstrom, std::to_string(cavity.row + 1)});
  }
}

void follow_hover_mark(PanelContext& ctx, CavityPage& page) {
  const auto row = std::exchange(page.hovered, std::nullopt);
  const auto& lines = page.rows.lines;
  const auto& balls = ctx.state.shown_balls();
  const auto& chosen = page.selected_rows;  // they are drawn whole
  if (!row || !lines || !balls || *row >= lines->of.size() ||
      ctx.state.shown_selection() != &lines->atoms->prepared() ||
      std::binary_search(chosen.begin(), chosen.end(), *row)) {
    page.hover_mark = nullptr;
    return;
  }
  const bool same = page.hover_mark && page.marked_row == row && page.hover_mark->balls == balls &&
                    page.marked_in == lines;
  if (same) return;
  page.marked_row = row;
  page.marked_in = lines;
  const CavityTable& table = page.rows.table();
  auto mark = std::make_shared<Layer>();
  mark->id = "cavities.hovered";
  mark->key = ++page.layers_key;
  mark->balls = balls;
  mark->colour = cavity_colour(page, *row);
  const auto& sink = table.sink(*row);
  for (std::size_t i = 0; i < sink.size(); ++i) {
    for (std::size_t j = i + 1; j < sink.size(); ++j) mark->edges.push_back({sink[i], sink[j]});
  }
  mark->labels.push_back(
      {deepest_place_angstrom(*table.ground, table.cavity(*row)), std::to_string(*row + 1)});
  mark->in_pictures = false;
  page.hover_mark = std::move(mark);
}

}  // namespace alphascope
