// SPDX-License-Identifier: GPL-3.0-or-later
// Bonds of known residues, of their hydrogens, and between neighbours in a chain.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/bonds/covalent_radii.hpp"
#include "core/bonds/residue_structures.hpp"
#include "core/bonds/unit_bonds.hpp"
#include "core/molecule/molecule.hpp"

namespace alphascope {
namespace {

// Å. Bonds of a chain are 1.3 to 1.7 Å long; nothing else comes nearer than 2 Å.
constexpr double kShortestLink = 0.8, kLongestLink = 2.0;
// Å beyond the sum of the covalent radii.
constexpr double kHydrogenTolerance = 0.45;
// Residues of more atoms are searched with the grid.
constexpr std::size_t kMostAtoms = 512;
constexpr std::uint32_t kAtomsBetweenChecks = 65536;

enum Role : std::uint8_t { kN, kC, kP, kO3, kRoles };

// True for hydrogens that are named after their heavy atom: HB2 and CB, H5'' and C5', HO2' and O2'.
bool named_after(std::string_view hydrogen, std::string_view heavy) {
  while (!hydrogen.empty() && hydrogen.front() >= '0' && hydrogen.front() <= '9') {
    hydrogen.remove_prefix(1);  // 1HB
  }
  if (hydrogen.empty() || heavy.empty()) return false;
  hydrogen.remove_prefix(1);
  if (hydrogen == heavy) return true;
  heavy.remove_prefix(1);
  // The first N of a chain has H1, HT1 or HN1.
  if (heavy.empty() && (hydrogen.starts_with('T') || hydrogen.starts_with('N'))) {
    hydrogen.remove_prefix(1);
  }
  return hydrogen.starts_with(heavy) && hydrogen.size() <= heavy.size() + 1;
}

class ResidueBonds {
 public:
  ResidueBonds(UnitBonds& state, const RunContext& context)
      : state_(state),
        context_(context),
        structures_(state.molecule.names),
        seen_in_(state.molecule.names.size(), UnitBonds::kNoResidue),
        seen_letters_(state.molecule.names.size(), 0) {
    const NameTable& names = state.molecule.names;
    roles_.assign(names.size(), kRoles);
    const std::string_view kNames[] = {"N", "C", "P", "O3'", "O3*"};
    const Role kOfName[] = {kN, kC, kP, kO3, kO3};
    for (std::size_t k = 0; k < std::size(kNames); ++k) {
      const NameId id = names.find(kNames[k]);
      if (id != 0) roles_[id] = kOfName[k];
    }
    sulphur_ = names.find("SG");
  }

  void add() {
    const auto count = static_cast<std::uint32_t>(state_.atoms.size());
    state_.residue.assign(count, UnitBonds::kNoResidue);
    state_.openness.assign(count, Openness::open);
    std::uint32_t begin = 0, next_check = kAtomsBetweenChecks;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (i > begin && !continues(i)) {
        take_residue(begin, i);
        begin = i;
        ++number_;
      }
      note_seen(i);
      if (i < next_check) continue;
      next_check += kAtomsBetweenChecks;
      context_.cancel.throw_if_cancelled();
      context_.report("finding bonds", 0.5 * i / count);
    }
    if (count > 0) take_residue(begin, count);
    linked_.clear();
    open_last_ends();
  }

 private:
  static bool named(const Atom& atom) { return atom.residue_name != 0 || atom.residue_number != 0; }
  static std::uint64_t letter_bit(const Atom& atom) {
    return std::uint64_t{1} << (static_cast<unsigned char>(atom.altloc) & 63u);
  }

  // Microheterogeneity is one residue, so names of residues may differ. A repeated atom begins
  // another one.
  bool continues(std::uint32_t i) const {
    const Atom &atom = state_.atom(i), &before = state_.atom(i - 1);
    if (!named(atom) && !named(before)) return true;
    if (!same_residue_number(atom, before)) return false;
    if (atom.residue_name != before.residue_name && atom.altloc == before.altloc) return false;
    const bool again = atom.name != 0 && seen_in_[atom.name] == number_ &&
                       (seen_letters_[atom.name] & letter_bit(atom)) != 0;
    return !again;
  }

  void note_seen(std::uint32_t i) {
    const Atom& atom = state_.atom(i);
    if (seen_in_[atom.name] != number_) seen_letters_[atom.name] = 0;
    seen_in_[atom.name] = number_;
    seen_letters_[atom.name] |= letter_bit(atom);
  }

  void take_residue(std::uint32_t begin, std::uint32_t end) {
    here_ = {};
    for (auto& list : places_) list.clear();
    const bool has_names = named(state_.atom(begin));
    for (std::uint32_t i = begin; i < end; ++i) {
      if (has_names) state_.residue[i] = number_;
      state_.openness[i] = openness(i, end - begin);
    }
    if (has_names) {
      bond_structure(begin, end);
      bond_hydrogens(begin, end);
    }
    link(begin);
    before_ = here_;
    before_first_ = begin;
  }

  // Fills places_ and here_ as well.
  Openness openness(std::uint32_t i, std::size_t size) {
    const Atom& atom = state_.atom(i);
    if (atom.kind == ResidueKind::dummy || covalent_radius_angstrom(atom.element) == 0) {
      return Openness::none;
    }
    if (atom.element == kHydrogen) return Openness::hydrogen;
    if (atom.kind == ResidueKind::water) return Openness::only_metal;
    if (is_metal(atom.element)) return Openness::open;
    if (atom.kind == ResidueKind::ion && size == 1) return Openness::only_metal;
    if (named(atom) && atom.kind == ResidueKind::polymer && roles_[atom.name] < kRoles) {
      const Role role = static_cast<Role>(roles_[atom.name]);
      if (here_.ends[role].size() < kMostEnds) here_.ends[role].push_back(i);
    }
    const std::uint8_t place = structures_.place(atom.residue_name, atom.name);
    if (place == ResidueStructures::kNoPlace) return Openness::open;
    if (places_.size() <= place) places_.resize(place + std::size_t{1});
    places_[place].push_back(i);
    return atom.name == sulphur_ ? Openness::cysteine : Openness::closed;
  }

  // With microheterogeneity the residue has several structures.
  void bond_structure(std::uint32_t begin, std::uint32_t end) {
    NameId last = 0;
    done_.clear();
    for (std::uint32_t i = begin; i < end; ++i) {
      const NameId name = state_.atom(i).residue_name;
      if (name == last || std::find(done_.begin(), done_.end(), name) != done_.end()) continue;
      last = name;
      if (done_.size() < kMostTypes) done_.push_back(name);
      const ResidueStructure* structure = structures_.structure(name);
      if (structure == nullptr) continue;
      for (const StructureBond& bond : structure->bonds) {
        if (std::max(bond.a, bond.b) < places_.size()) bond_places(bond, name);
      }
    }
  }

  void bond_places(const StructureBond& bond, NameId residue_name) {
    for (const std::uint32_t a : places_[bond.a]) {
      if (state_.atom(a).residue_name != residue_name) continue;
      for (const std::uint32_t b : places_[bond.b]) {
        const Atom& other = state_.atom(b);
        if (other.residue_name != residue_name || !may_meet(state_.atom(a), other)) continue;
        state_.add_known(a, b, bond.order, BondReason::residue);
      }
    }
  }

  void bond_hydrogens(std::uint32_t begin, std::uint32_t end) {
    if (end - begin > kMostAtoms) return;
    for (std::uint32_t h = begin; h < end; ++h) {
      const Atom& atom = state_.atom(h);
      const bool known = structures_.structure(atom.residue_name) != nullptr;
      if (state_.openness[h] != Openness::hydrogen) continue;
      if (!known && atom.kind != ResidueKind::water) continue;
      std::uint32_t nearest = h;
      double least = std::numeric_limits<double>::infinity();
      for (std::uint32_t i = begin; i < end; ++i) {
        const Atom& heavy = state_.atom(i);
        if (heavy.element == kHydrogen || state_.openness[i] == Openness::none) continue;
        if (is_metal(heavy.element) || !may_meet(atom, heavy)) continue;
        const double distance = state_.distance_angstrom(h, i);
        if (distance >= least) continue;
        least = distance;
        nearest = i;
      }
      // The search by distance need not try it again.
      state_.openness[h] = Openness::none;
      if (nearest == h) continue;
      const Atom& heavy = state_.atom(nearest);
      const double longest = covalent_radius_angstrom(kHydrogen) +
                             covalent_radius_angstrom(heavy.element) + kHydrogenTolerance;
      if (least > longest) continue;
      const NameTable& names = state_.molecule.names;
      const bool sure = atom.kind == ResidueKind::water ||
                        named_after(names.text(atom.name), names.text(heavy.name));
      state_.bonds.push_back({std::min(h, nearest), std::max(h, nearest), BondOrder::one,
                              BondKind::covalent,
                              sure ? BondReason::residue : BondReason::distance});
    }
  }

  // Bonds the residue to the one before it. Ends without a neighbour are open to others.
  void link(std::uint32_t first) {
    linked_.clear();
    if (before_first_ != UnitBonds::kNoResidue) {
      const Atom &a = state_.atom(before_first_), &b = state_.atom(first);
      if (a.chain == b.chain && a.segment == b.segment) {
        link_ends(before_.ends[kC], here_.ends[kN]);
        link_ends(before_.ends[kO3], here_.ends[kP]);
      }
    }
    open_last_ends();
    open_ends(here_.ends[kN]);
    open_ends(here_.ends[kP]);
  }

  void open_last_ends() {
    open_ends(before_.ends[kC]);
    open_ends(before_.ends[kO3]);
  }

  void link_ends(const std::vector<std::uint32_t>& before,
                 const std::vector<std::uint32_t>& after) {
    for (const std::uint32_t a : before) {
      for (const std::uint32_t b : after) {
        if (!may_meet(state_.atom(a), state_.atom(b))) continue;
        const double distance = state_.distance_angstrom(a, b);
        if (distance < kShortestLink || distance > kLongestLink) continue;
        state_.bonds.push_back({a, b, BondOrder::one, BondKind::covalent, BondReason::chain_link});
        linked_.push_back(a);
        linked_.push_back(b);
      }
    }
  }

  void open_ends(const std::vector<std::uint32_t>& ends) {
    for (const std::uint32_t i : ends) {
      const bool is_linked = std::find(linked_.begin(), linked_.end(), i) != linked_.end();
      if (!is_linked && state_.openness[i] == Openness::closed) {
        state_.openness[i] = Openness::chain_end;
      }
    }
  }

  // Alternative locations of one end, and types of one residue, beyond these numbers are ignored.
  static constexpr std::size_t kMostEnds = 16, kMostTypes = 16;
  struct Ends {
    std::array<std::vector<std::uint32_t>, kRoles> ends;
  };

  UnitBonds& state_;
  const RunContext& context_;
  ResidueStructures structures_;
  std::vector<std::uint32_t> seen_in_;       // by NameId: the last residue with the name
  std::vector<std::uint64_t> seen_letters_;  // by NameId: its alternative locations there
  std::vector<std::uint8_t> roles_;          // by NameId
  NameId sulphur_ = 0;
  std::uint32_t number_ = 0;                        // of the residue
  std::vector<std::vector<std::uint32_t>> places_;  // atoms of the residue by place
  std::vector<NameId> done_;
  Ends here_, before_;
  std::uint32_t before_first_ = UnitBonds::kNoResidue;
  std::vector<std::uint32_t> linked_;  // ends of the last two residues
};

}  // namespace

void add_residue_bonds(UnitBonds& state, const RunContext& context) {
  ResidueBonds(state, context).add();
}

}  // namespace alphascope
