// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of the view that show the contents of the chosen cavities (ligands, ions and waters)
// and the residues that line them.
#include <memory>
#include <utility>
#include <vector>

#include "core/document/cavities/cavity_results.hpp"
#include "core/document/cavities/selected_cavities.hpp"
#include "core/document/reference/reference.hpp"
#include "core/molecule/atom_colours.hpp"
#include "core/molecule/molecule.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/selection/selection_masks.hpp"
#include "ui/layer.hpp"
#include "ui/layer_objects.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/rgb8.hpp"

namespace alphascope {
namespace {

// Returns the radius in which held atoms are drawn, Å.
double held_radius(DropReason kind) {
  return kind == DropReason::ion ? 0.7 : 0.45;
}

std::shared_ptr<const LayerObjects> objects_of(LayerObject object) {
  LayerObjects objects;
  objects.of.push_back(std::move(object));
  return std::make_shared<const LayerObjects>(std::move(objects));
}

}  // namespace

void add_layer_of_contents(CavityPage& page) {
  if (!page.sticks.in_front) return;
  const BallReferences& references = *page.rows.lines->atoms;
  const Molecule& molecule = references.molecule();
  auto layer = std::make_shared<Layer>();
  layer->id = "cavities.held";
  layer->balls = page.layers_of;
  layer->key = page.layers_key;
  LayerObject ligands{{.kind = ObjectKind::sticks,
                       .colour = ObjectColour::element,
                       .opacity = page.sticks.content_opacity},
                      {},
                      true};
  for (const ContainedAtom& held : page.drawn->held) {
    const Atom& atom = molecule.atoms[held.atom];
    const bool shown = held.in_body || shows(page.beside, held.kind, atom.element);
    if (!shown || page.hidden.contains(references.atom_of_molecule(held.atom))) continue;
    if (held.kind == DropReason::ligand) ligands.atoms.push_back(held.atom);
    const auto angstrom = [&](std::int64_t units) { return molecule.lattice.angstrom(units); };
    layer->atoms.push_back(
        {{angstrom(atom.position.x), angstrom(atom.position.y), angstrom(atom.position.z)},
         held_radius(held.kind),
         to_colour(element_colour(atom.element)),
         held.atom});
  }
  if (!ligands.atoms.empty()) layer->objects = objects_of(std::move(ligands));
  if (!layer->atoms.empty() || layer->objects) page.layers.push_back(std::move(layer));
}

void add_layer_of_lining(CavityPage& page) {
  if (!page.sticks.lining) return;
  const BallReferences& references = *page.rows.lines->atoms;
  const Molecule& molecule = references.molecule();
  std::vector<bool> atoms(molecule.atoms.size(), false);
  for (const Ref& lining : page.drawn->atoms) {
    const auto balls = references.balls(lining);
    if (!balls) continue;
    for (const BallIndex ball : *balls) {
      const std::uint32_t atom = references.prepared().atom_of_ball[ball];
      if (molecule.atoms[atom].kind == ResidueKind::polymer) atoms[atom] = true;
    }
  }
  atoms = whole_residues(molecule, std::move(atoms));
  LayerObject sticks{{.kind = ObjectKind::sticks,
                      .colour = ObjectColour::element,
                      .opacity = page.sticks.lining_opacity},
                     {},
                     false};
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    if (atoms[i] && !page.hidden.contains(references.atom_of_molecule(i))) {
      sticks.atoms.push_back(static_cast<std::uint32_t>(i));
    }
  }
  if (sticks.atoms.empty()) return;
  auto layer = std::make_shared<Layer>();
  layer->id = "cavities.lining";
  layer->balls = page.layers_of;
  layer->key = page.layers_key;
  layer->objects = objects_of(std::move(sticks));
  page.layers.push_back(std::move(layer));
}

}  // namespace alphascope
