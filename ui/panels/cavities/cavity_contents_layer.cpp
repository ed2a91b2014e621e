// SPDX-License-Identifier: GPL-3.0-or-later
// The layer of the view that shows the contents of the chosen cavities: ligands, ions and waters.
#include <memory>
#include <utility>

#include "core/document/cavities/cavity_results.hpp"
#include "core/document/cavities/selected_cavities.hpp"
#include "core/document/reference/reference.hpp"
#include "core/molecule/atom_colours.hpp"
#include "core/molecule/molecule.hpp"
#include "ui/layer.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/rgb8.hpp"

namespace alphascope {
namespace {

// Returns the radius in which held atoms are drawn, Å.
double held_radius(DropReason kind) {
  return kind == DropReason::ion ? 0.7 : 0.45;
}

}  // namespace

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
