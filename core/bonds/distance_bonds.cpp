// SPDX-License-Identifier: GPL-3.0-or-later
// Bonds that distances and covalent radii suggest.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/bonds/covalent_radii.hpp"
#include "core/bonds/unit_bonds.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/element.hpp"
#include "core/neighbours/uniform_grid.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

// Å beyond the sum of the covalent radii, for atoms of one residue and of two.
constexpr double kWithin = 0.45, kBetween = 0.25;
constexpr double kNearest = 0.4;  // Å
// An atom is crowded if more atoms are in the cells around it, or more in bonding distance. With
// hydrogens and two locations there are some 500 in the cells, and 20 in bonding distance.
constexpr std::uint32_t kMostInCells = 8192, kMostInReach = 256;
constexpr std::size_t kMostKept = 48;  // nearest candidates of an atom
constexpr int kMostOfMetal = 12;
constexpr std::size_t kBlock = 4096;  // atoms that one task searches around

constexpr Element kCarbon = 6, kNitrogen = 7, kOxygen = 8, kPhosphorus = 15, kSulphur = 16,
                  kSelenium = 34;

bool binds_metals(Element element) {
  return element == kNitrogen || element == kOxygen || element == kSulphur ||
         element == kSelenium || is_halogen(element);
}

struct Candidate {
  double square = 0;  // of the distance, in square lattice units
  std::uint32_t atom = 0;
  friend bool operator<(const Candidate& a, const Candidate& b) {
    return a.square != b.square ? a.square < b.square : a.atom < b.atom;
  }
};

// The nearest candidates, at most kMostKept.
class NearestList {
 public:
  void add(const Candidate& candidate) {
    if (size_ == kMostKept && !(candidate < list_[size_ - 1])) return;
    if (size_ < kMostKept) ++size_;
    std::size_t at = size_ - 1;
    while (at > 0 && candidate < list_[at - 1]) {
      list_[at] = list_[at - 1];
      --at;
    }
    list_[at] = candidate;
  }
  const Candidate* begin() const { return list_.data(); }
  const Candidate* end() const { return list_.data() + size_; }

 private:
  std::array<Candidate, kMostKept> list_{};
  std::size_t size_ = 0;
};

// Counts the partners of an atom by their alternative location. Those without a letter count with
// each of the others.
class PartnerCounts {
 public:
  // Returns whether there is room for one more partner, and then counts it.
  bool add(char letter, int most) {
    const int with_letter =
        letter == ' ' ? *std::max_element(letters_.begin(), letters_.end()) : count(letter);
    if (without_letter_ + with_letter >= most) return false;
    ++(letter == ' ' ? without_letter_ : count(letter));
    return true;
  }

 private:
  int& count(char letter) { return letters_[static_cast<unsigned char>(letter) % letters_.size()]; }
  int without_letter_ = 0;
  std::array<int, 64> letters_{};
};

class DistanceBonds {
 public:
  DistanceBonds(UnitBonds& state, const RunContext& context)
      : state_(state), context_(context), unit_(state.molecule.lattice.units_per_angstrom()) {}

  void add() {
    for (std::uint32_t i = 0; i < state_.atoms.size(); ++i) {
      if (is_open(i)) searching_.push_back(i);
    }
    if (searching_.empty()) return;
    make_grid();
    search();
    keep_mutual();
  }

 private:
  bool is_open(std::uint32_t i) const {
    const Openness openness = state_.openness[i];
    return openness == Openness::open || openness == Openness::hydrogen ||
           openness == Openness::chain_end || openness == Openness::cysteine;
  }
  Element element(std::uint32_t i) const { return state_.atom(i).element; }
  bool metal(std::uint32_t i) const { return is_metal(element(i)); }

  // Two balls meet if a bond may join their atoms.
  void make_grid() {
    BallSet balls;
    balls.lattice = state_.molecule.lattice;
    const std::size_t count = state_.atoms.size();
    balls.centres.reserve(count);
    balls.radii.reserve(count);
    std::vector<bool> hidden(count, false);
    for (std::uint32_t i = 0; i < count; ++i) {
      balls.centres.push_back(state_.atom(i).position);
      const double radius = covalent_radius_angstrom(element(i)) + kWithin / 2;
      balls.radii.push_back(static_cast<std::int32_t>(std::ceil(radius * unit_)) + 1);
      hidden[i] = state_.openness[i] == Openness::none;
    }
    grid_ = make_uniform_grid(balls, LatticeAlpha(0), hidden);
  }

  // Whether a distance can make a bond between two atoms, and up to which length in Å.
  std::optional<double> longest(std::uint32_t a, std::uint32_t b) const {
    const Openness first = state_.openness[a], second = state_.openness[b];
    if (second == Openness::none || !may_meet(state_.atom(a), state_.atom(b))) return std::nullopt;
    const double sum = covalent_radius_angstrom(element(a)) + covalent_radius_angstrom(element(b));
    const bool same = state_.residue[a] == state_.residue[b];
    if (metal(a) || metal(b)) {
      const bool pair = binds_metals(element(metal(a) ? b : a));
      return pair ? std::optional(sum + kWithin) : std::nullopt;
    }
    if (first == Openness::only_metal || second == Openness::only_metal) return std::nullopt;
    if (first == Openness::hydrogen || second == Openness::hydrogen) {
      const bool both = first == second;
      return same && !both ? std::optional(sum + kWithin) : std::nullopt;
    }
    // A file that states bonds of a residue's atoms states all of them.
    if (same && state_.stated[a] && state_.stated[b]) return std::nullopt;
    if (first == Openness::open || second == Openness::open) {
      return sum + (same ? kWithin : kBetween);
    }
    if (same) return std::nullopt;
    if (first == Openness::cysteine && second == Openness::cysteine) return sum + kWithin;
    if (first == Openness::chain_end && second == Openness::chain_end && ends_fit(a, b)) {
      return sum + kBetween;
    }
    return std::nullopt;
  }

  bool ends_fit(std::uint32_t a, std::uint32_t b) const {
    const auto is = [&](Element first, Element second) {
      return (element(a) == first && element(b) == second) ||
             (element(a) == second && element(b) == first);
    };
    return is(kCarbon, kNitrogen) || is(kOxygen, kPhosphorus);
  }

  int most(std::uint32_t i) const { return metal(i) ? kMostOfMetal : most_bonds(element(i)); }

  // Returns false if the atom is crowded.
  bool find_near(std::uint32_t i, NearestList& near) const {
    const LatticePoint& p = state_.atom(i).position;
    const UniformGrid::Cell cell = grid_.cell_at(p);
    std::uint32_t in_cells = 0, in_reach = 0;
    grid_.for_rows_around(cell,
                          [&](std::uint32_t begin, std::uint32_t end) { in_cells += end - begin; });
    if (in_cells > kMostInCells) return false;
    const double nearest = kNearest * unit_, farthest = kFarthest * unit_;
    grid_.for_rows_around(cell, [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t slot = begin; slot < end && in_reach <= kMostInReach; ++slot) {
        const std::uint32_t other = grid_.ball[slot];
        const double x = double(grid_.x[slot]) - p.x, y = double(grid_.y[slot]) - p.y,
                     z = double(grid_.z[slot]) - p.z;
        const double square = x * x + y * y + z * z;
        if (square > farthest * farthest || square < nearest * nearest || other == i) continue;
        const std::optional<double> reach = longest(i, other);
        if (!reach || square > *reach * *reach * unit_ * unit_) continue;
        ++in_reach;
        near.add({square, other});
      }
    });
    return in_reach <= kMostInReach;
  }

  void search() {
    const std::size_t blocks = (searching_.size() + kBlock - 1) / kBlock;
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> found(blocks);
    std::vector<std::size_t> crowded(blocks, 0);
    parallel_ranges(0, blocks, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t block = first; block < last; ++block) {
        const std::size_t end = std::min(searching_.size(), (block + 1) * kBlock);
        for (std::size_t k = block * kBlock; k < end; ++k) {
          if (k % 256 == 0 && context_.cancel.cancelled()) return;
          const std::uint32_t i = searching_[k];
          NearestList near;
          if (!find_near(i, near)) {
            ++crowded[block];
            continue;
          }
          PartnerCounts covalent, ligands;
          for (const Candidate& candidate : near) {
            // Bonds to metals do not take the place of others.
            const bool to_metal = metal(i) || metal(candidate.atom);
            PartnerCounts& counts = to_metal ? ligands : covalent;
            const int limit = to_metal && !metal(i) ? kMostOfMetal : most(i);
            if (counts.add(state_.atom(candidate.atom).altloc, limit)) {
              found[block].emplace_back(i, candidate.atom);
            }
          }
        }
      }
    });
    context_.cancel.throw_if_cancelled();
    start_.assign(state_.atoms.size() + 1, 0);
    for (const auto& block : found) {
      for (const auto& pair : block) {
        ++start_[pair.first + 1];
        partners_.push_back(pair.second);  // blocks ascend, as the atoms in them do
      }
    }
    for (std::size_t i = 0; i + 1 < start_.size(); ++i) start_[i + 1] += start_[i];
    for (const std::size_t count : crowded) state_.crowded += count;
  }

  bool has_partner(std::uint32_t i, std::uint32_t partner) const {
    return std::find(partners_.begin() + start_[i], partners_.begin() + start_[i + 1], partner) !=
           partners_.begin() + start_[i + 1];
  }

  // Where both atoms are searched, each must be among the nearest of the other.
  void keep_mutual() {
    for (const std::uint32_t i : searching_) {
      for (std::uint32_t k = start_[i]; k < start_[i + 1]; ++k) {
        const std::uint32_t other = partners_[k];
        if (is_open(other) && (i > other || !has_partner(other, i))) continue;
        state_.bonds.push_back(
            {std::min(i, other), std::max(i, other), BondOrder::unknown,
             metal(i) || metal(other) ? BondKind::coordination : BondKind::covalent,
             BondReason::distance});
      }
    }
  }

  static constexpr double kFarthest = 6;  // Å, beyond the largest sum of radii

  UnitBonds& state_;
  const RunContext& context_;
  const double unit_;  // lattice units per Å
  UniformGrid grid_;
  std::vector<std::uint32_t> searching_;  // atoms around which is searched, ascending
  std::vector<std::uint32_t> start_;      // where the partners of each atom begin
  std::vector<std::uint32_t> partners_;
};

}  // namespace

void add_distance_bonds(UnitBonds& state, const RunContext& context) {
  DistanceBonds(state, context).add();
}

}  // namespace alphascope
