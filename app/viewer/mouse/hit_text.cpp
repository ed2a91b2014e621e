// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and tooltips for balls, left-out atoms and simplices.
#include "app/viewer/mouse/hit_text.hpp"

#include "core/document/explain/explanation_text.hpp"
#include "core/selection/atom_address.hpp"
#include "core/selection/ball_options.hpp"
#include "core/selection/prepare_balls.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/explain/ball_text.hpp"
#include "ui/widgets/format.hpp"

namespace alphascope {
namespace {

std::string count(std::size_t n) {
  return with_separators(static_cast<long long>(n));
}

// The assembly's copy that holds the atom; empty in a molecule as deposited.
std::string copy_text(const BallReferences& references, std::size_t atom) {
  if (references.molecule().copied.empty()) return "";
  return "copy " + count(references.atom_of_molecule(atom).copy + std::size_t{1}) +
         " in the assembly";
}

const char* kind_name(DropReason reason) {
  switch (reason) {
    case DropReason::water:
      return "water";
    case DropReason::ion:
      return "ion";
    case DropReason::ligand:
      return "ligand";
    default:
      return "hydrogen";
  }
}

}  // namespace

HitText describe_ball(const BallReferences& references, const Request* shown, BallIndex ball) {
  const Molecule& molecule = references.molecule();
  const BallSet& balls = *references.prepared().balls;
  const std::size_t atom = references.prepared().atom_of_ball.at(ball);
  const std::string position = place_text(balls.centres[ball], balls.lattice);
  const std::string copy = copy_text(references, atom);
  const std::string radius = radius_text(balls, shown, ball);
  HitText text;
  text.line = atom_address(molecule, atom) + (copy.empty() ? "" : "  ·  " + copy) + "  ·  (" +
              position + ") Å  ·  " + radius;
  text.tooltip = atom_label(molecule, atom) + (copy.empty() ? "" : "\n" + copy) + "\ncentre " +
                 position + " Å\n" + radius;
  return text;
}

HitText describe_atom_beside(const BallReferences& references, const LeftOutAtom& left_out) {
  const Molecule& molecule = references.molecule();
  const std::string position =
      place_text(molecule.atoms.at(left_out.atom).position, molecule.lattice);
  const std::string copy = copy_text(references, left_out.atom);
  const std::string why = kind_name(left_out.reason) + std::string(", not in the body");
  HitText text;
  text.line = atom_address(molecule, left_out.atom) + (copy.empty() ? "" : "  ·  " + copy) +
              "  ·  (" + position + ") Å  ·  " + why;
  text.tooltip = atom_label(molecule, left_out.atom) + (copy.empty() ? "" : "\n" + copy) +
                 "\ncentre " + position + " Å\n" + why;
  return text;
}

HitText describe_simplex(const BallReferences& references, const HitSimplex& simplex) {
  const Molecule& molecule = references.molecule();
  HitText text;
  text.line = name_of(molecule, references.reference(simplex.balls));
  text.tooltip = simplex_kind_name(simplex.balls.size());
  for (const BallIndex ball : simplex.balls) {
    text.tooltip += "\n" + atom_label(molecule, references.prepared().atom_of_ball.at(ball));
  }
  std::string facts = simplex.kind ? simplex_class_name(*simplex.kind) : "class not computed";
  if (simplex.angstrom2) {
    facts += "  ·  alpha value " + short_number_text(*simplex.angstrom2, 4) + " Å²";
  }
  text.line += "  ·  " + facts;
  text.tooltip += "\n" + facts;
  return text;
}

std::string selected_text(std::size_t selected, std::size_t not_in_the_picture) {
  if (selected == 0) return "";
  if (not_in_the_picture == 0) return count(selected);
  return count(selected) + ", " + count(not_in_the_picture) + " not in the picture";
}

}  // namespace alphascope
