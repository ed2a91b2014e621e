// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and computes measurements.
#include "core/document/reference/atom_measurements.hpp"

#include <stdexcept>

#include "core/document/reference/reference.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/measure/angles.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/selection/atom_address.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kFewest = 2, kMost = 4;  // atoms
constexpr const char* kHowMany =
    "Two atoms have a distance, three an angle, and four a dihedral angle.";

std::size_t one_named(const Molecule& molecule, const std::string& address) {
  const auto is_named = atoms_named(molecule, address);
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < molecule.atoms.size(); ++i) {
    if (!is_named(i)) continue;
    if (found) {
      throw std::invalid_argument("\"" + address + "\" names several atoms, such as " +
                                  atom_address(molecule, *found) + " and " +
                                  atom_address(molecule, i) + ". Name one.");
    }
    found = i;
  }
  if (!found) throw std::invalid_argument("The molecule has no atom \"" + address + "\".");
  return *found;
}

std::optional<double> value_of(const Molecule& molecule, const std::vector<std::size_t>& atoms) {
  const auto at = [&](std::size_t n) -> const LatticePoint& {
    return molecule.atoms[atoms[n]].position;
  };
  if (atoms.size() == 2) return molecule.lattice.angstrom(distance_on_lattice(at(0), at(1)));
  if (atoms.size() == 3) return angle_degrees(at(0), at(1), at(2));
  return dihedral_degrees(at(0), at(1), at(2), at(3));
}

}  // namespace

const char* measurement_name(const Measurement& m) {
  return m.atoms.size() == 2 ? "distance" : m.atoms.size() == 3 ? "angle" : "dihedral angle";
}

const char* measurement_unit(const Measurement& m) {
  return m.atoms.size() == 2 ? "Å" : "°";
}

std::optional<Measured> measured(const Molecule& molecule, const Measurement& m) {
  Measured of;
  for (const AtomRef& ref : m.atoms) {
    const auto atom = find_atom(molecule, {ref.atom, ref.copy});
    if (!atom) return std::nullopt;
    of.atoms.push_back(*atom);
  }
  of.value = value_of(molecule, of.atoms);
  return of;
}

Measurement read_measurement(const BallReferences& atoms, std::string_view text) {
  Measurement m;
  for (bool more = true; more;) {
    const std::size_t end = text.find(';');
    more = end != std::string_view::npos;
    const std::string address(trimmed(text.substr(0, end)));
    text.remove_prefix(more ? end + 1 : text.size());
    if (address.empty() && !more && m.atoms.size() >= kFewest)
      break;  // allows a semicolon at the
              // end
    if (m.atoms.size() == kMost) throw std::invalid_argument(kHowMany);
    m.atoms.push_back(atoms.atom_of_molecule(one_named(atoms.molecule(), address)));
  }
  if (m.atoms.size() < kFewest) throw std::invalid_argument(kHowMany);
  return m;
}

SelectedMeasurement selected_measurement(const Selection& selection) {
  const std::vector<Ref>& items = selection.items.items();
  const SimplexRef* const simplex =
      items.size() == 1 ? std::get_if<SimplexRef>(&items.front()) : nullptr;
  if (simplex && simplex->size() == 2) return {Measurement{*simplex}, {}};
  const std::vector<AtomRef> atoms = selection.atoms_in_order();
  if (atoms.size() != items.size()) {
    return {{}, "Select atoms, or one edge; no triangle or tetrahedron has a distance."};
  }
  if (atoms.size() < kFewest || atoms.size() > kMost) {
    return {{},
            std::string("Select two to four atoms, one after the other (Ctrl+click). ") + kHowMany};
  }
  return {Measurement{atoms}, {}};
}

}  // namespace alphascope
