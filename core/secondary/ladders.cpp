// SPDX-License-Identifier: GPL-3.0-or-later
// Tests pairs of residues for the two patterns of bridges in parallel and antiparallel sheets.
#include "core/secondary/ladders.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

namespace alphascope {
namespace {

// The smallest distance in sequence of the two residues of a bridge.
constexpr int kNearestPair = 3;

class LadderFinder {
 public:
  LadderFinder(const std::vector<HydrogenBonds>& bonds, const std::vector<int>& chain_of)
      : bonds_(bonds), chain_of_(chain_of), size_(static_cast<int>(bonds.size())) {}

  std::vector<Ladder> find() {
    for (const auto& [i, j] : candidates()) {
      if (const std::optional<bool> parallel = bridge(i, j)) add(i, j, *parallel);
    }
    std::stable_sort(ladders_.begin(), ladders_.end(),
                     [](const Ladder& a, const Ladder& b) { return a.i_first < b.i_first; });
    join_over_bulges();
    return std::move(ladders_);
  }

 private:
  bool in_one_chain(int first, int last) const {
    return first >= 0 && last < size_ &&
           chain_of_[static_cast<std::size_t>(first)] == chain_of_[static_cast<std::size_t>(last)];
  }
  // From the N-H of one residue to the C=O of the other.
  bool bonded(int donor, int acceptor) const {
    return bonds_[static_cast<std::size_t>(donor)].accepts(static_cast<std::uint32_t>(acceptor));
  }

  // Pairs with a bond between their neighbours or themselves, in lexicographic order.
  std::vector<std::pair<int, int>> candidates() const {
    std::vector<std::pair<int, int>> pairs;
    for (int donor = 0; donor < size_; ++donor) {
      for (const std::uint32_t acceptor : bonds_[static_cast<std::size_t>(donor)].acceptor) {
        if (acceptor == HydrogenBonds::kNone) continue;
        const int other = static_cast<int>(acceptor);
        for (int i = donor - 1; i <= donor + 1; ++i) {
          for (int j = other - 1; j <= other + 1; ++j) {
            const std::pair<int, int> pair = std::minmax(i, j);
            if (pair.second - pair.first >= kNearestPair) pairs.push_back(pair);
          }
        }
      }
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  // True: parallel; false: antiparallel; empty: none.
  std::optional<bool> bridge(int i, int j) const {
    if (!in_one_chain(i - 1, i + 1) || !in_one_chain(j - 1, j + 1)) return std::nullopt;
    if ((bonded(i + 1, j) && bonded(j, i - 1)) || (bonded(j + 1, i) && bonded(i, j - 1))) {
      return true;
    }
    if ((bonded(i + 1, j - 1) && bonded(j + 1, i - 1)) || (bonded(j, i) && bonded(i, j))) {
      return false;
    }
    return std::nullopt;
  }

  // Pairs come with ascending i, so only ladders that reach i - 1 can grow.
  void add(int i, int j, bool parallel) {
    if (i != row_) {
      growing_ = i == row_ + 1 ? std::move(grown_) : std::vector<std::size_t>();
      grown_.clear();
      row_ = i;
    }
    for (const std::size_t k : growing_) {
      Ladder& ladder = ladders_[k];
      if (ladder.parallel != parallel || ladder.i_last != i - 1) continue;
      if (parallel ? ladder.j_last + 1 != j : ladder.j_first - 1 != j) continue;
      ladder.i_last = i;
      (parallel ? ladder.j_last : ladder.j_first) = j;
      ++ladder.bridges;
      grown_.push_back(k);
      return;
    }
    grown_.push_back(ladders_.size());
    ladders_.push_back({parallel, i, i, j, j, 1});
  }

  // Two ladders of one kind are one with a bulge, if at most one residue lies between their
  // stretches on one side and at most four on the other.
  void join_over_bulges() {
    constexpr int kLong = 6, kShort = 3;  // differences of indices are below these
    std::vector<bool> joined(ladders_.size(), false);
    for (std::size_t k = 0; k < ladders_.size(); ++k) {
      if (joined[k]) continue;
      for (std::size_t m = k + 1; m < ladders_.size(); ++m) {
        Ladder& a = ladders_[k];
        const Ladder& b = ladders_[m];
        const int i_gap = b.i_first - a.i_last;
        if (i_gap >= kLong) break;  // ladders are sorted by i_first
        if (joined[m] || a.parallel != b.parallel || i_gap <= 0) continue;
        const int j_gap = a.parallel ? b.j_first - a.j_last : a.j_first - b.j_last;
        if (j_gap < 0 || !in_one_chain(a.i_first, b.i_last) ||
            !in_one_chain(std::min(a.j_first, b.j_first), std::max(a.j_last, b.j_last))) {
          continue;
        }
        if (!((j_gap < kLong && i_gap < kShort) || j_gap < kShort)) continue;
        a.i_last = b.i_last;
        (a.parallel ? a.j_last : a.j_first) = a.parallel ? b.j_last : b.j_first;
        a.bridges += b.bridges;
        joined[m] = true;
      }
    }
    std::size_t kept = 0;
    for (std::size_t k = 0; k < ladders_.size(); ++k) {
      if (!joined[k]) ladders_[kept++] = ladders_[k];
    }
    ladders_.resize(kept);
  }

  const std::vector<HydrogenBonds>& bonds_;
  const std::vector<int>& chain_of_;
  const int size_;
  std::vector<Ladder> ladders_;
  int row_ = -2;                              // i of the pairs that are being added
  std::vector<std::size_t> growing_, grown_;  // ladders that reach row_ - 1, and row_
};

}  // namespace

std::vector<Ladder> find_ladders(const std::vector<HydrogenBonds>& bonds,
                                 const std::vector<int>& chain_of) {
  return LadderFinder(bonds, chain_of).find();
}

}  // namespace alphascope
