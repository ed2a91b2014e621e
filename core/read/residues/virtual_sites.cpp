// SPDX-License-Identifier: GPL-3.0-or-later
// Finds virtual sites by their names, their elements and their distance to an atom.
#include "core/read/residues/virtual_sites.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/selection/atom_groups.hpp"
#include "core/text/grouped_number.hpp"
#include "core/text/letter_case.hpp"

namespace alphascope {
namespace {

constexpr std::string_view kUnknownAtoms[] = {"UNX", "UNL", "UNK"};
// Atoms are never so near to each other. A Drude particle stays within 0.25 Å of its atom.
constexpr double kOnItsAtom = 0.5;  // Å
constexpr std::size_t kNamesListed = 6;

bool all_digits(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// True for the word, perhaps with a number: "MW", "MW1".
bool is_word(std::string_view name, std::string_view word) {
  return name.starts_with(word) && all_digits(name.substr(word.size()));
}

bool in_water(std::string_view name) {
  if (name.empty()) return false;
  // Other names are hydrogens, deuterium and the oxygen. OM is a site of SWM4; "DO" and "DOH2" are
  // Drude particles.
  constexpr std::string_view kOfSites = "MLEV";
  return kOfSites.find(name[0]) != kOfSites.npos || name == "OM" || name.starts_with("DO");
}

bool of_unknown_residue(const AtomNaming& naming) {
  return std::find(std::begin(kUnknownAtoms), std::end(kUnknownAtoms), naming.residue) !=
         std::end(kUnknownAtoms);
}

bool has_name_of_site(const AtomNaming& naming, std::string_view name) {
  if (naming.residue == "STP" && (name == "POL" || name == "APOL")) return true;
  if (is_word(name, "EP") || name == "EPW" || is_word(name, "VS") || is_word(name, "MW")) {
    return true;
  }
  if (name.starts_with("LP") && name.size() <= 5) return true;
  if (naming.family == ResidueFamily::water) return in_water(name);
  // Names of GROMACS' dummy masses (MCH3, MNH1, MTRP2) and of pseudo-atoms in NMR (QB, MG1).
  if (naming.family == ResidueFamily::biopolymer && !of_unknown_residue(naming)) {
    return name[0] == 'M' || name[0] == 'Q';
  }
  return is_word(name, "DU") || name == "DUM";
}

}  // namespace

bool is_virtual_site(const AtomNaming& naming, ElementStatement stated) {
  constexpr std::size_t kLongestName = 8;
  if (stated == ElementStatement::element) return false;
  if (stated == ElementStatement::virtual_site) return true;
  const std::string name =
      naming.atom.size() <= kLongestName ? upper_case(naming.atom) : std::string();
  if (!name.empty() && has_name_of_site(naming, name)) return true;
  if (stated != ElementStatement::placeholder) return false;
  return naming.family == ResidueFamily::unknown && !of_unknown_residue(naming);
}

namespace {

double squared_distance(const LatticePoint& a, const LatticePoint& b) {
  const double x = double(a.x) - b.x, y = double(a.y) - b.y, z = double(a.z) - b.z;
  return x * x + y * y + z * z;
}

// The atoms of one residue by name, location and grid cell. A search then looks only at atoms
// around a point.
class AtomsByPlace {
 public:
  // The atoms [begin, end) of the molecule; `near` in lattice units.
  AtomsByPlace(const Molecule& molecule, std::size_t begin, std::size_t end, double near)
      : molecule_(molecule), near_(near), side_(std::max(1.0, near)) {
    places_.reserve(end - begin);
    for (std::size_t i = begin; i < end; ++i) {
      const Atom& atom = molecule.atoms[i];
      const auto [x, y, z] = cell(atom.position);
      places_.emplace_back(Key{atom.name, atom.altloc, x, y, z}, i);
    }
    std::sort(places_.begin(), places_.end());
  }

  bool has(NameId name, char altloc, const LatticePoint& point) const {
    const auto [x, y, z] = cell(point);
    for (std::int32_t nx = x - 1; nx <= x + 1; ++nx) {
      for (std::int32_t ny = y - 1; ny <= y + 1; ++ny) {
        const Key last{name, altloc, nx, ny, z + 1};
        auto at = std::lower_bound(places_.begin(), places_.end(),
                                   Place{{name, altloc, nx, ny, z - 1}, 0});
        for (; at != places_.end() && at->first <= last; ++at) {
          const LatticePoint& other = molecule_.atoms[at->second].position;
          if (squared_distance(other, point) <= near_ * near_) return true;
        }
      }
    }
    return false;
  }

 private:
  using Key = std::tuple<NameId, char, std::int32_t, std::int32_t, std::int32_t>;
  using Place = std::pair<Key, std::size_t>;

  std::array<std::int32_t, 3> cell(const LatticePoint& p) const {
    const auto of = [&](std::int32_t c) {
      return static_cast<std::int32_t>(std::floor(double(c) / side_));
    };
    return {of(p.x), of(p.y), of(p.z)};
  }

  const Molecule& molecule_;
  double near_, side_;
  std::vector<Place> places_;
};

std::string_view parent_name(std::string_view name) {
  if (name == "OM") return "OH2";
  return name.size() > 1 && name[0] == 'D' ? name.substr(1) : std::string_view();
}

// The atoms [begin, end) belong to one residue.
void mark_on_their_atoms(Molecule& molecule, std::size_t begin, std::size_t end) {
  const double near = kOnItsAtom * molecule.lattice.units_per_angstrom();
  const AtomsByPlace atoms(molecule, begin, end, near);
  for (std::size_t i = begin; i < end; ++i) {
    Atom& atom = molecule.atoms[i];
    const std::string_view parent = parent_name(molecule.text(atom.name));
    if (parent.empty() || atom.kind == ResidueKind::dummy) continue;
    const NameId name = molecule.names.find(parent);
    if (name == 0 || !atoms.has(name, atom.altloc, atom.position)) continue;
    atom.kind = ResidueKind::dummy;
    atom.element = kUnknownElement;
    atom.element_guessed = false;
  }
}

void mark_on_their_atoms(Molecule& molecule) {
  for (const ModelRange& model : molecule.models) {
    for (std::size_t begin = model.begin, end; begin < model.end; begin = end) {
      end = begin + 1;
      bool candidate = false;
      for (; end < model.end; ++end) {
        if (!same_residue(molecule.atoms[begin], molecule.atoms[end])) break;
      }
      for (std::size_t i = begin; i < end && !candidate; ++i) {
        candidate = !parent_name(molecule.text(molecule.atoms[i].name)).empty();
      }
      if (candidate) mark_on_their_atoms(molecule, begin, end);
    }
  }
}

}  // namespace

void mark_sites_at_atoms(Molecule& molecule) {
  mark_on_their_atoms(molecule);
}

void finish_virtual_sites(Molecule& molecule) {
  std::size_t dummies = 0;
  std::map<std::string_view, std::size_t> names;
  bool planes = false;  // membrane planes of OPM, in residues named DUM
  for (const Atom& atom : molecule.atoms) {
    if (atom.kind != ResidueKind::dummy) continue;
    ++dummies;
    planes = planes || molecule.text(atom.residue_name) == "DUM";
    if (names.size() <= kNamesListed) ++names[molecule.text(atom.name)];
  }
  if (dummies == 0) return;
  const std::string total = grouped(molecule.atoms.size());
  if (dummies == molecule.atoms.size() && !planes) {
    // A file with nothing but such points: they are kept as atoms.
    for (Atom& atom : molecule.atoms) {
      atom.kind = atom.hetero ? ResidueKind::ligand : ResidueKind::polymer;
      atom.why = atom.hetero ? ResidueReason::hetatm : ResidueReason::no_name;
    }
    molecule.notes.push_back("All " + total +
                             " atoms look like virtual sites or dummies; they are kept as atoms of "
                             "unknown element");
    return;
  }
  std::string list;
  std::size_t listed = 0;
  for (const auto& [name, count] : names) {
    if (listed++ == kNamesListed) break;
    list += (list.empty() ? "" : ", ") + std::string(name);
  }
  if (names.size() > kNamesListed) list += " …";
  molecule.notes.push_back("Virtual sites and dummies, which are no atoms and get no ball: " +
                           grouped(dummies) + " of " + total + " (" + list + ")");
}

}  // namespace alphascope
