// SPDX-License-Identifier: GPL-3.0-or-later
// Sets, counts and places labels of atoms.
#include "core/document/reference/atom_labels.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <variant>

#include "core/document/reference/reference.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/element.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/radii/radii_set.hpp"
#include "core/selection/atom_address.hpp"
#include "core/selection/prepare_balls.hpp"

namespace alphascope {
namespace {

using Visit = std::function<bool(std::size_t atom)>;  // returns false to stop

// End of the atoms of the file, without copies of an assembly.
std::size_t end_of_atoms(const Molecule& molecule) {
  if (molecule.copied.empty()) return molecule.atoms.size();
  std::size_t end = 0;
  for (const CopiedAtoms& part : molecule.copied) {
    if (!part.source.empty()) end = std::max(end, part.source.back() + 1);
  }
  return end;
}

// Visits the atoms of the set that this molecule contains; another assembly may lack some.
void visit_atoms(const Molecule& molecule, const AtomSet& atoms, const Visit& visit) {
  const std::size_t end = end_of_atoms(molecule);
  for (const AtomSet::Run& run : atoms.runs()) {
    for (std::size_t atom = run.first; atom < end && atom <= run.last; ++atom) {
      const auto index = find_atom(molecule, {atom, run.copy});
      if (index && !visit(*index)) return;
    }
  }
}

bool of_one_label(const Atom& a, const Atom& b) {
  return same_residue_number(a, b) && a.residue_name == b.residue_name;
}

std::string number(double value, int decimals, const char* unit) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f %s", decimals, std::fabs(value), unit);
  return (value < 0 ? "−" : "") + std::string(text);
}

std::string label_text(const BallReferences& atoms, std::size_t atom, LabelText text) {
  const Molecule& molecule = atoms.molecule();
  const Atom& a = molecule.atoms[atom];
  switch (text) {
    case LabelText::name: {
      const std::string name(molecule.text(a.name));
      return name.empty() ? atom_address(molecule, atom) : name;
    }
    case LabelText::residue:
      return residue_within_chain(molecule, atom);
    case LabelText::element:
      return std::string(element_symbol(a.element));
    case LabelText::radius: {
      const auto ball = atoms.ball(atoms.atom_of_molecule(atom));
      if (!ball) return "";
      const BallSet& balls = *atoms.prepared().balls;
      return number(balls.lattice.angstrom(balls.radii[*ball]), 2, "Å");
    }
    case LabelText::b_factor:
      if (!a.has_b_factor) return "";
      return number(a.b_factor, 1, molecule.has_confidences ? "pLDDT" : "Å²");
    case LabelText::address:
      break;
  }
  return atom_address(molecule, atom);
}

// Finds beginnings of residues; atoms of one residue are consecutive in a file.
class Residues {
 public:
  explicit Residues(const Molecule& molecule) : molecule_(molecule) {}

  // Whether the atom belongs to another residue than the atom before.
  bool begins(std::size_t atom) {
    const bool other = last_ == kNone || atom < last_ ||
                       !of_one_label(molecule_.atoms[last_], molecule_.atoms[atom]);
    last_ = atom;
    return other;
  }

 private:
  static constexpr std::size_t kNone = ~std::size_t{0};
  const Molecule& molecule_;
  std::size_t last_ = kNone;
};

}  // namespace

const std::vector<std::pair<LabelText, std::string_view>>& label_text_ids() {
  static const std::vector<std::pair<LabelText, std::string_view>> ids{
      {LabelText::name, "name"},       {LabelText::residue, "residue"},
      {LabelText::address, "address"}, {LabelText::element, "element"},
      {LabelText::radius, "radius"},   {LabelText::b_factor, "b_factor"}};
  return ids;
}

std::string label_text(const BallReferences& atoms, const Ref& of, LabelText text) {
  std::vector<AtomRef> refs;
  if (const auto* const simplex = std::get_if<SimplexRef>(&of)) {
    refs = *simplex;
  } else {
    refs.push_back(std::get<AtomRef>(of));
  }
  std::vector<std::string> all;
  for (const AtomRef& ref : refs) {
    const auto atom = find_atom(atoms.molecule(), {ref.atom, ref.copy});
    std::string one = atom ? label_text(atoms, *atom, text) : "";
    const bool known = std::find(all.begin(), all.end(), one) != all.end();
    if (!one.empty() && !known) all.push_back(std::move(one));
  }
  std::string joined;
  for (const std::string& one : all) joined += (joined.empty() ? "" : ", ") + one;
  return joined;
}

void set_labels(LabelGroups& labels, const AtomSet& atoms, std::optional<LabelText> text) {
  set_value_of_atoms(labels, &AtomLabels::text, atoms, text);
}

std::size_t label_count(const Molecule& molecule, const LabelGroups& labels, std::size_t most) {
  std::size_t count = 0;
  for (const AtomLabels& group : labels) {
    Residues residues(molecule);
    visit_atoms(molecule, group.atoms, [&](std::size_t atom) {
      if (group.text != LabelText::residue || residues.begins(atom)) ++count;
      return count <= most;
    });
    if (count > most) break;
  }
  return count;
}

std::vector<PlacedText> placed_labels(const BallReferences& atoms, const LabelGroups& labels,
                                      const std::function<bool(std::size_t)>& is_drawn) {
  const Molecule& molecule = atoms.molecule();
  std::vector<PlacedText> placed;
  for (const AtomLabels& group : labels) {
    Residues residues(molecule);
    const bool joins = group.text == LabelText::residue;
    double joined = 0;  // number of atoms in the last text
    visit_atoms(molecule, group.atoms, [&](std::size_t atom) {
      if (!is_drawn(atom)) return true;
      const RealPoint at =
          molecule.lattice.unit_angstrom() * real_point(molecule.atoms[atom].position);
      if (joins && !residues.begins(atom)) {
        PlacedText& last = placed.back();
        last.at_angstrom = last.at_angstrom + (1 / ++joined) * (at - last.at_angstrom);
        return true;
      }
      if (placed.size() == kMostLabels) return false;
      joined = 1;
      placed.push_back({at, label_text(atoms, atom, group.text)});
      return true;
    });
  }
  std::erase_if(placed, [](const PlacedText& label) { return label.text.empty(); });
  return placed;
}

}  // namespace alphascope
