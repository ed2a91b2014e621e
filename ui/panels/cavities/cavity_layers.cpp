// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of the view that show a cavity or the contents of the chosen ones.
#include <memory>
#include <string>
#include <utility>

#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/cavity_numbers.hpp"
#include "core/cavity_shape/filling_spheres.hpp"
#include "core/chart/colour_map.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/cavities/selected_cavities.hpp"
#include "core/document/reference/reference.hpp"
#include "core/molecule/atom_colours.hpp"
#include "core/molecule/molecule.hpp"
#include "ui/layer.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/rgb8.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// Returns the radius in which held atoms are drawn, Å.
double held_radius(DropReason kind) {
  return kind == DropReason::ion ? 0.7 : 0.45;
}

}  // namespace

Colour cavity_colour(const CavityPage& page, std::size_t row) {
  const CavityNumbers& numbers = *page.rows.lines->numbers;
  return to_colour(cavity_colour(numbers.of[page.rows.table().order[row]]));
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

void add_layer_of_contents(CavityPage& page) {
  if (!page.fades_rest) return;
  const BallReferences& references = *page.rows.lines->atoms;
  const Molecule& molecule = references.molecule();
  auto layer = std::make_shared<Layer>();
  layer->id = "cavities.held";
  layer->balls = page.layers_of;
  layer->key = page.layers_key;
  for (const ContainedAtom& held : page.drawn->held) {
    const Atom& atom = molecule.atoms[held.atom];
    const bool shown = held.in_body || shows(page.beside, held.kind, atom.element);
    if (!shown || page.hidden.contains(references.atom_of_molecule(held.atom))) continue;
    const auto angstrom = [&](std::int64_t units) { return molecule.lattice.angstrom(units); };
    layer->atoms.push_back(
        {{angstrom(atom.position.x), angstrom(atom.position.y), angstrom(atom.position.z)},
         held_radius(held.kind),
         to_colour(element_colour(atom.element)),
         held.atom});
  }
  if (!layer->atoms.empty()) page.layers.push_back(std::move(layer));
}

}  // namespace alphascope
