// SPDX-License-Identifier: GPL-3.0-or-later
// Counters and lists that steps fill while an engine's code runs. Inner header of core/explain.
#pragma once

#include <algorithm>
#include <array>
#include <unordered_map>

#include "core/explain/ball_steps.hpp"

namespace alphascope {

struct Tally {
  std::uint64_t all = 0, here = 0;
  void add(bool is_here, std::uint64_t count = 1) {
    all += count;
    here += is_here ? count : 0;
  }
  Tally& operator+=(const Tally& other) {
    all += other.all;
    here += other.here;
    return *this;
  }
};

inline StepCount counted(std::string_view id, const Tally& tally) {
  return {id, tally.all, tally.here};
}
inline StepCount counted(std::string_view id, std::uint64_t number) {
  return {id, number, number};
}

template <int N>
Simplices<N>& list_of(MarkedSimplices& marked) {
  if constexpr (N == 1) return marked.vertices;
  if constexpr (N == 2) return marked.edges;
  if constexpr (N == 3) return marked.triangles;
  if constexpr (N == 4) return marked.tetrahedra;
}

template <int N>
void add(MarkedSimplices& marked, const std::array<BallIndex, N>& simplex) {
  if (list_of<N>(marked).size() < MarkedSimplices::kMostMarked) {
    list_of<N>(marked).push_back(simplex);
  } else {
    ++marked.left_out;
  }
}

// The results of a kernel's tests: numbers and lists of simplices.
struct TestTallies {
  Tally tested, conflict, above_alpha, flat, valid, band;
  MarkedSimplices gone{.mark = StepMark::dropped}, kept{.mark = StepMark::kept},
      open{.mark = StepMark::undecided};
  std::unordered_map<BallIndex, StepConflict> removers;

  template <int N>
  void remove(BallIndex by, const std::array<BallIndex, N>& simplex) {
    StepConflict& remover = removers[by];
    remover.ball = by;
    if (remover.simplices++ == 0) remover.first.assign(simplex.begin(), simplex.end());
  }
  void give_to(Step& step) {
    for (auto& [ball, remover] : removers) step.removers.push_back(std::move(remover));
    std::sort(step.removers.begin(), step.removers.end(),
              [](const StepConflict& a, const StepConflict& b) {
                return a.simplices != b.simplices ? a.simplices > b.simplices : a.ball < b.ball;
              });
    step.marks.push_back(std::move(gone));
    step.marks.push_back(std::move(open));
    step.marks.push_back(std::move(kept));
  }
};

// The simplices that an optimisation kept and dropped.
struct OptimisationTallies {
  Tally kept, dropped;
  MarkedSimplices gone{.mark = StepMark::dropped}, left{.mark = StepMark::kept};
};

template <int N>
void keep_simplices_with(BallIndex ball, SimplexList<N>& list) {
  SimplexList<N> kept;
  for (std::size_t n = 0; n < list.size(); ++n) {
    const auto& s = list.simplices[n];
    if (std::find(s.begin(), s.end(), ball) == s.end()) continue;
    kept.simplices.push_back(s);
    kept.alpha_values.push_back(list.alpha_values[n]);
    kept.classes.push_back(list.classes[n]);
  }
  list = std::move(kept);
}

}  // namespace alphascope
