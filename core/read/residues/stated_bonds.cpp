// SPDX-License-Identifier: GPL-3.0-or-later
// Looks up the atoms of recorded bonds by their names and serial numbers.
#include "core/read/residues/stated_bonds.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/molecule/element.hpp"

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
    using Key = std::tuple<NameId, std::int32_t, char, NameId>;
    // Names that no atom has must not count as the empty name.
    const auto is_there = [&](const std::string& name) {
      return name.empty() || molecule_.names.find(name) != 0;
    };
    const auto key = [&](const BondedAtom& atom) {
      return Key{molecule_.names.find(atom.chain), atom.residue_number, atom.insertion_code,
                 molecule_.names.find(atom.name)};
    };
    std::map<Key, Atoms> wanted;
    for (const NamedBond& bond : bonds_.named()) {
      wanted[key(bond.a)];
      wanted[key(bond.b)];
    }
    for (std::size_t i = model.begin; i < model.end; ++i) {
      const Atom& atom = molecule_.atoms[i];
      const auto found =
          wanted.find({atom.chain, atom.residue_number, atom.insertion_code, atom.name});
      if (found != wanted.end() && found->second.size() < kMostLocations) {
        found->second.push_back(static_cast<std::uint32_t>(i));
      }
    }
    for (const NamedBond& bond : bonds_.named()) {
      const bool there = is_there(bond.a.chain) && is_there(bond.a.name) &&
                         is_there(bond.b.chain) && is_there(bond.b.name);
      if (!there || !join(wanted[key(bond.a)], wanted[key(bond.b)], bond.order))
        ++molecule_.unresolved_bonds;
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
    std::vector<std::pair<std::int32_t, std::uint32_t>> atoms;
    atoms.reserve(model.size());
    for (std::size_t i = model.begin; i < model.end; ++i) {
      atoms.emplace_back(molecule_.atoms[i].serial, static_cast<std::uint32_t>(i));
    }
    std::sort(atoms.begin(), atoms.end());
    constexpr std::uint32_t kNone = 0xffffffff;
    // A serial number of several atoms identifies none of them.
    const auto atom_of = [&](std::int32_t serial) {
      const auto at = std::lower_bound(atoms.begin(), atoms.end(), std::pair(serial, 0u));
      const bool one = at != atoms.end() && at->first == serial &&
                       (at + 1 == atoms.end() || (at + 1)->first != serial);
      return one ? at->second : kNone;
    };
    // In MOL2 and with several models each bond belongs to some models only, so an atom that is
    // missing in one of them is no fault.
    const bool one_model = molecule_.models.size() == 1;
    for (const NumberedBond& bond : bonds_.numbered()) {
      const std::uint32_t a = atom_of(bond.a), b = atom_of(bond.b);
      if (a != kNone && b != kNone) {
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
