// SPDX-License-Identifier: GPL-3.0-or-later
// Collects the bonds of each unit by their evidence, and gives them to all copies.
#include "core/bonds/bonds.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "core/bonds/covalent_radii.hpp"
#include "core/bonds/unit_bonds.hpp"
#include "core/geometry/real_point.hpp"
#include "core/molecule/copy_units.hpp"
#include "core/text/grouped_number.hpp"

namespace alphascope {
namespace {

// A known bond is left out if it is longer than this many times the sum of the covalent radii.
constexpr double kLongestKnown = 2;
constexpr double kUnknownRadius = 1.5;  // Å, of elements without a covalent radius

class BondFinder {
 public:
  BondFinder(const Molecule& molecule, const ModelRange& model, const RunContext& context)
      : molecule_(molecule), context_(context), units_(copy_units(molecule, model)) {}

  BondList find() {
    stated_.resize(units_.size());
    sort_stated_into_units();
    for (std::size_t u = 0; u < units_.size(); ++u) {
      UnitBonds state{molecule_, units_[u]};
      for (const UnitPart& part : units_[u].parts) {
        for (std::size_t i = part.begin; i < part.end; ++i) {
          state.atoms.push_back(static_cast<std::uint32_t>(i));
        }
      }
      add_stated(state, stated_[u]);
      add_residue_bonds(state, context_);
      add_distance_bonds(state, context_);
      list_.too_long += state.too_long * units_[u].copies;
      list_.crowded += state.crowded * units_[u].copies;
      std::vector<Bond> bonds = each_once(std::move(state.bonds), state.atoms.size());
      for (Bond& bond : bonds) {
        bond.a = state.atoms[bond.a];
        bond.b = state.atoms[bond.b];
      }
      copy(bonds, units_[u]);
    }
    list_.unresolved = molecule_.unresolved_bonds;
    return std::move(list_);
  }

 private:
  void sort_stated_into_units() {
    for (Bond bond : molecule_.stated_bonds) {
      bool any_a = false, any_b = false, both = false;
      for (std::size_t u = 0; u < units_.size(); ++u) {
        const std::uint32_t a = units_[u].atom_of(bond.a), b = units_[u].atom_of(bond.b);
        any_a = any_a || a != CopyUnit::kNone;
        any_b = any_b || b != CopyUnit::kNone;
        if (a == CopyUnit::kNone || b == CopyUnit::kNone) continue;
        both = true;
        Bond in_unit = bond;
        in_unit.a = std::min(a, b);
        in_unit.b = std::max(a, b);
        stated_[u].push_back(in_unit);
      }
      if (any_a && any_b && !both) ++list_.other_copies;
    }
  }

  static void add_stated(UnitBonds& state, const std::vector<Bond>& stated) {
    const auto number = [&](std::uint32_t atom) {
      return static_cast<std::uint32_t>(
          std::lower_bound(state.atoms.begin(), state.atoms.end(), atom) - state.atoms.begin());
    };
    state.stated.assign(state.atoms.size(), false);
    for (const Bond& bond : stated) {
      const std::uint32_t a = number(bond.a), b = number(bond.b);
      state.add_known(a, b, bond.order, BondReason::file);
      if (bond.kind == BondKind::covalent) state.stated[a] = state.stated[b] = true;
    }
  }

  // Sorts the bonds by their atoms, in linear time, and keeps the best evidence of each. A known
  // order counts, whatever its evidence.
  static std::vector<Bond> each_once(std::vector<Bond> bonds, std::size_t atoms) {
    std::vector<std::size_t> start(atoms + 1, 0);
    for (const Bond& bond : bonds) ++start[bond.a + 1];
    for (std::size_t i = 0; i < atoms; ++i) start[i + 1] += start[i];
    std::vector<Bond> sorted(bonds.size());
    std::vector<std::size_t> next(start.begin(), start.end() - 1);
    for (const Bond& bond : bonds) sorted[next[bond.a]++] = bond;
    bonds.clear();
    for (std::size_t i = 0; i < atoms; ++i) {
      const auto first = sorted.begin() + static_cast<std::ptrdiff_t>(start[i]),
                 last = sorted.begin() + static_cast<std::ptrdiff_t>(start[i + 1]);
      std::sort(first, last, [](const Bond& a, const Bond& b) {
        return std::tuple(a.b, a.why, b.order) < std::tuple(b.b, b.why, a.order);
      });
      for (auto bond = first; bond != last; ++bond) {
        if (bond == first || bond->b != bonds.back().b) {
          bonds.push_back(*bond);
        } else if (bonds.back().order == BondOrder::unknown) {
          bonds.back().order = bond->order;
        }
      }
    }
    return bonds;
  }

  void copy(const std::vector<Bond>& bonds, const CopyUnit& unit) {
    for (const Bond& bond : bonds) {
      list_.reasons[static_cast<std::size_t>(bond.why)] += unit.copies;
      if (bond.kind == BondKind::coordination) list_.coordinations += unit.copies;
    }
    list_.bonds.reserve(list_.bonds.size() + bonds.size() * unit.copies);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> steps;  // from a copy to the next
    steps.reserve(bonds.size());
    for (const Bond& bond : bonds) {
      steps.emplace_back(unit.part_of(bond.a).size(), unit.part_of(bond.b).size());
    }
    for (std::uint32_t k = 0; k < unit.copies; ++k) {
      context_.cancel.throw_if_cancelled();
      for (std::size_t i = 0; i < bonds.size(); ++i) {
        Bond bond = bonds[i];
        bond.a += k * steps[i].first;
        bond.b += k * steps[i].second;
        if (bond.a > bond.b) std::swap(bond.a, bond.b);
        list_.bonds.push_back(bond);
      }
    }
  }

  const Molecule& molecule_;
  const RunContext& context_;
  std::vector<CopyUnit> units_;
  std::vector<std::vector<Bond>> stated_;  // of each unit, between atoms of its first copy
  BondList list_;
};

std::string count_text(std::size_t count, const char* text) {
  return grouped(count) + ' ' + text;
}

}  // namespace

double UnitBonds::distance_angstrom(std::uint32_t a, std::uint32_t b) const {
  return molecule.lattice.angstrom(
      length(real_point(atom(a).position) - real_point(atom(b).position)));
}

void UnitBonds::add_known(std::uint32_t a, std::uint32_t b, BondOrder order, BondReason why) {
  const auto radius = [&](std::uint32_t i) {
    const double known = covalent_radius_angstrom(atom(i).element);
    return known > 0 ? known : kUnknownRadius;
  };
  if (distance_angstrom(a, b) > kLongestKnown * (radius(a) + radius(b))) {
    ++too_long;
    return;
  }
  const bool metal = is_metal(atom(a).element) || is_metal(atom(b).element);
  bonds.push_back({std::min(a, b), std::max(a, b), order,
                   metal ? BondKind::coordination : BondKind::covalent, why});
}

BondList find_bonds(const Molecule& molecule, const ModelRange& model, const RunContext& context) {
  return BondFinder(molecule, model, context).find();
}

std::vector<Bond> bonds_of_balls(std::span<const Bond> bonds,
                                 std::span<const std::uint32_t> atom_of_ball) {
  if (atom_of_ball.empty()) return {};
  constexpr std::uint32_t kNone = 0xffffffff;
  std::vector<std::uint32_t> ball_of(std::size_t{atom_of_ball.back()} + 1, kNone);
  for (std::uint32_t ball = 0; ball < atom_of_ball.size(); ++ball) {
    ball_of[atom_of_ball[ball]] = ball;
  }
  std::vector<Bond> result;
  for (Bond bond : bonds) {
    if (std::max(bond.a, bond.b) >= ball_of.size()) continue;
    bond.a = ball_of[bond.a];
    bond.b = ball_of[bond.b];
    if (bond.a != kNone && bond.b != kNone) result.push_back(bond);
  }
  return result;
}

std::string summary(const BondList& list) {
  const auto reason = [&](BondReason why) { return list.reasons[static_cast<std::size_t>(why)]; };
  std::string text = grouped(list.bonds.size()) + (list.bonds.size() == 1 ? " bond" : " bonds");
  text += ": " + count_text(reason(BondReason::file), "from the file, ");
  text += count_text(reason(BondReason::residue), "of known residues, ");
  text += count_text(reason(BondReason::chain_link), "between neighbours in a chain; ");
  text += count_text(list.guessed(), "guessed by distance");
  if (list.coordinations > 0) text += "; " + count_text(list.coordinations, "of them to metals");
  const std::pair<std::size_t, const char*> left_out[] = {
      {list.too_long, "left out because the atoms are too far apart"},
      {list.other_copies, "left out because the chains are not copied together"},
      {list.unresolved, "left out because an atom is not in the file or shares its number"},
      {list.crowded, "atoms without guessed bonds, because too many atoms are at one place"}};
  for (const auto& [count, what] : left_out) {
    if (count > 0) text += "; " + count_text(count, what);
  }
  return text;
}

}  // namespace alphascope
