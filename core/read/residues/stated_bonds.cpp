// SPDX-License-Identifier: GPL-3.0-or-later
// Looks up the atoms of recorded bonds by their names and serial numbers.
#include "core/read/residues/stated_bonds.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

#include "core/bonds/residue_structures.hpp"
#include "core/molecule/element.hpp"
#include "core/read/residues/recorded_atoms.hpp"

namespace alphascope {
namespace {

// Alternative locations of one atom beyond this number are not bonded by name.
constexpr std::size_t kMostLocations = 16;

using Atoms = std::vector<std::uint32_t>;

class Statement {
 public:
  Statement(Molecule& molecule, const RecordedBonds& bonds) : molecule_(molecule), bonds_(bonds) {}

  void make() {
    for (const ModelRange& model : molecule_.models) {
      if (!bonds_.named().empty()) add_named(model);
      if (!bonds_.numbered().empty()) add_numbered(model);
    }
    add_those_of_components();
    std::vector<Bond>& list = molecule_.stated_bonds;
    // Of equal pairs the one with the known order comes first.
    std::sort(list.begin(), list.end(), [](const Bond& a, const Bond& b) {
      return std::tuple(a.a, a.b, b.order) < std::tuple(b.a, b.b, a.order);
    });
    const auto same = [](const Bond& a, const Bond& b) { return a.a == b.a && a.b == b.b; };
    list.erase(std::unique(list.begin(), list.end(), same), list.end());
    list.shrink_to_fit();
  }

 private:
  void add(std::uint32_t a, std::uint32_t b, BondOrder order) {
    if (a == b) {
      ++molecule_.unresolved_bonds;
      return;
    }
    const bool metal = is_metal(molecule_.atoms[a].element) || is_metal(molecule_.atoms[b].element);
    molecule_.stated_bonds.push_back({std::min(a, b), std::max(a, b), order,
                                      metal ? BondKind::coordination : BondKind::covalent,
                                      BondReason::file});
  }

  void add_named(const ModelRange& model) {
    std::map<AtomKey, Atoms> wanted;
    for (const NamedBond& bond : bonds_.named()) {
      for (const BondedAtom* atom : {&bond.a, &bond.b}) {
        if (const auto key = atom_key(molecule_.names, *atom)) wanted[*key];
      }
    }
    for (std::size_t i = model.begin; i < model.end; ++i) {
      const auto found = wanted.find(atom_key(molecule_.atoms[i]));
      if (found != wanted.end() && found->second.size() < kMostLocations) {
        found->second.push_back(static_cast<std::uint32_t>(i));
      }
    }
    for (const NamedBond& bond : bonds_.named()) {
      const auto a = atom_key(molecule_.names, bond.a), b = atom_key(molecule_.names, bond.b);
      if (!a || !b || !join(wanted[*a], wanted[*b], bond.order)) ++molecule_.unresolved_bonds;
    }
  }

  // Returns false if no pair of locations fits.
  bool join(const Atoms& a, const Atoms& b, BondOrder order) {
    bool any = false;
    for (const std::uint32_t i : a) {
      for (const std::uint32_t k : b) {
        if (i == k || !may_meet(molecule_.atoms[i], molecule_.atoms[k])) continue;
        add(i, k, order);
        any = true;
      }
    }
    return any;
  }

  void add_numbered(const ModelRange& model) {
    const AtomsBySerial atoms(molecule_, model);
    // In MOL2 and with several models each bond belongs to some models only, so an atom that is
    // missing in one of them is no fault.
    const bool one_model = molecule_.models.size() == 1;
    for (const NumberedBond& bond : bonds_.numbered()) {
      const std::uint32_t a = atoms.atom(bond.a), b = atoms.atom(bond.b);
      if (a != kNoIndex && b != kNoIndex) {
        add(a, b, bond.order);
      } else {
        molecule_.unresolved_bonds += one_model;
      }
    }
  }

  struct WithinResidue {
    NameId a = 0, b = 0;
    BondOrder order = BondOrder::unknown;
  };

  // Residues whose structure the program knows need none. Atoms that are not in the file, such as
  // hydrogens, are no fault.
  void add_those_of_components() {
    std::map<NameId, std::vector<WithinResidue>> of_name;
    const NameTable& names = molecule_.names;
    for (const ComponentBond& bond : bonds_.of_components()) {
      const NameId residue = names.find(bond.residue);
      const WithinResidue within{names.find(bond.a), names.find(bond.b), bond.order};
      const bool known = residue == 0 || residue_structure(bond.residue) != nullptr;
      if (!known && within.a != 0 && within.b != 0) of_name[residue].push_back(within);
    }
    if (of_name.empty()) return;
    for (const ModelRange& model : molecule_.models) {
      for (std::size_t i = model.begin; i < model.end;) {
        const auto found = of_name.find(molecule_.atoms[i].residue_name);
        i = found == of_name.end() ? i + 1 : bond_residue(i, model.end, found->second);
      }
    }
  }

  // Returns the end of the residue that begins at `begin`. A repeated atom begins another residue.
  std::size_t bond_residue(std::size_t begin, std::size_t end,
                           const std::vector<WithinResidue>& bonds) {
    const auto& atoms = molecule_.atoms;
    std::map<NameId, Atoms> of_name;
    std::size_t i = begin;
    for (; i < end && same_residue_number(atoms[i], atoms[begin]) &&
           atoms[i].residue_name == atoms[begin].residue_name;
         ++i) {
      Atoms& locations = of_name[atoms[i].name];
      const bool again = std::any_of(locations.begin(), locations.end(), [&](std::uint32_t other) {
        return atoms[other].altloc == atoms[i].altloc;
      });
      if (again) break;
      if (locations.size() < kMostLocations) locations.push_back(static_cast<std::uint32_t>(i));
    }
    for (const WithinResidue& bond : bonds) {
      const auto a = of_name.find(bond.a), b = of_name.find(bond.b);
      if (a != of_name.end() && b != of_name.end()) join(a->second, b->second, bond.order);
    }
    return i;
  }

  Molecule& molecule_;
  const RecordedBonds& bonds_;
};

}  // namespace

void state_bonds(Molecule& molecule, const RecordedBonds& bonds) {
  const bool any =
      !bonds.named().empty() || !bonds.numbered().empty() || !bonds.of_components().empty();
  if (any) Statement(molecule, bonds).make();
}

}  // namespace alphascope
