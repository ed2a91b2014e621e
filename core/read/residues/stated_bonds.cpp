// SPDX-License-Identifier: GPL-3.0-or-later
// Looks up the atoms of recorded bonds by their names and serial numbers.
#include "core/read/residues/stated_bonds.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

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

  Molecule& molecule_;
  const RecordedBonds& bonds_;
};

}  // namespace

void state_bonds(Molecule& molecule, const RecordedBonds& bonds) {
  if (!bonds.named().empty() || !bonds.numbered().empty()) Statement(molecule, bonds).make();
}

}  // namespace alphascope
