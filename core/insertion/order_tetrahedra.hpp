// SPDX-License-Identifier: GPL-3.0-or-later
// Puts tetrahedra, given in any order, into the one order of a Triangulation.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include "core/complex/triangulation.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/cancel_token.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {

// A ball of a tetrahedron, with the slot of the tetrahedron across the face opposite to it. A slot
// without a tetrahedron, or kOutside, is outside.
class TetrahedronCorner {
 public:
  static constexpr std::uint32_t kOutside = ~std::uint32_t{0};

  TetrahedronCorner() = default;  // not initialised
  TetrahedronCorner(BallIndex ball, std::uint32_t across)
      : both_(static_cast<std::uint64_t>(ball) << 32 | across) {}
  BallIndex ball() const { return static_cast<BallIndex>(both_ >> 32); }
  std::uint32_t across() const { return static_cast<std::uint32_t>(both_); }

  // By ball.
  friend TetrahedronCorner lower(TetrahedronCorner a, TetrahedronCorner b) {
    a.both_ = std::min(a.both_, b.both_);
    return a;
  }
  friend TetrahedronCorner higher(TetrahedronCorner a, TetrahedronCorner b) {
    a.both_ = std::max(a.both_, b.both_);
    return a;
  }

 private:
  std::uint64_t both_;  // one number, which is compared without a branch
};
using TetrahedronCorners = std::array<TetrahedronCorner, 4>;

inline TetrahedronCorners sorted(const TetrahedronCorners& c) {
  const TetrahedronCorner a = lower(c[0], c[1]), b = higher(c[0], c[1]), d = lower(c[2], c[3]),
                          e = higher(c[2], c[3]);
  const TetrahedronCorner low = higher(a, d), high = lower(b, e);
  return {lower(a, d), lower(low, high), higher(low, high), higher(b, e)};
}

// Tetrahedra in any order, each in a slot of its own.
struct UnorderedTetrahedra {
  std::vector<TetrahedronCorners> tetrahedra;

  std::size_t slots() const { return tetrahedra.size(); }
  bool has(std::size_t) const { return true; }
  const TetrahedronCorners& corners(std::size_t slot) const { return tetrahedra[slot]; }
  std::array<BallIndex, 4> balls(std::size_t slot) const {
    const TetrahedronCorners& c = tetrahedra[slot];
    return {c[0].ball(), c[1].ball(), c[2].ball(), c[3].ball()};
  }
};

// A face without a neighbour, opposite a corner of a tetrahedron.
struct OutsideFace {
  std::uint32_t tetrahedron;
  int corner;
  std::array<BallIndex, 4> balls;  // of the tetrahedron
};

// Makes the facets of the hull, in their order, into which it puts `outside`, too. The tetrahedra
// are in order.
std::vector<HullFacet> hull_facets(const BallSet& balls, std::vector<OutsideFace>& outside);

// Sets those facets as the neighbours that are still missing.
void set_hull(std::vector<HullFacet> facets, const std::vector<OutsideFace>& outside,
              Triangulation& result);

// Sets vertices and hidden balls from the tetrahedra. Throws Cancelled.
void set_vertices(std::size_t balls, const CancelToken& cancel, Triangulation& result);

// The order of tetrahedra while it is made.
class TetrahedronOrder {
 public:
  TetrahedronOrder(std::size_t balls, std::size_t slots) : first_(balls + 1, 0), after_(slots) {}

  // First each tetrahedron is counted by its lowest ball, then each is placed; both on any threads.
  void count(BallIndex lowest) { raise(first_[lowest + 1]); }
  void leave_out(std::size_t slot) { after_[slot] = TetrahedronCorner::kOutside; }
  void begin_placing();
  void place(const TetrahedronCorners& c, std::uint32_t slot) {
    records_[raise(next_[c[0].ball()])] = {
        {c[0].ball(), c[1].ball(), c[2].ball(), c[3].ball()},
        {c[0].across(), c[1].across(), c[2].across(), c[3].across()},
        slot};
  }
  // Sorts what was placed, and fills the tetrahedra.
  void sort(const CancelToken& cancel, Simplices<4>& tetrahedra);

  std::size_t size() const { return first_.back(); }
  // The one across the face opposite a corner, or kOutside.
  std::uint32_t across(std::size_t tetrahedron, std::size_t corner) const {
    const std::uint32_t slot = records_[tetrahedron].across[corner];
    return slot == TetrahedronCorner::kOutside ? slot : after_[slot];
  }

 private:
  struct Record {
    std::array<BallIndex, 4> balls;
    std::array<std::uint32_t, 4> across;
    std::uint32_t slot;
    bool operator<(const Record& other) const { return balls < other.balls; }
  };
  // Returns the number before.
  static std::uint32_t raise(std::uint32_t& number) {
    return std::atomic_ref(number).fetch_add(1, std::memory_order_relaxed);
  }

  std::vector<std::uint32_t> first_, next_;  // by ball, which has some seven records
  ResultArray<Record> records_;
  ResultArray<std::uint32_t> after_;  // by slot
};

// Calls body(first, end) for ranges that divide [0, count). Throws Cancelled.
template <class Body>
void for_ranges(std::size_t count, const CancelToken& cancel, const Body& body) {
  constexpr std::size_t kGrain = 1 << 13;
  parallel_ranges(0, count, kGrain, [&](std::size_t first, std::size_t end) {
    if (!cancel.cancelled()) body(first, end);
  });
  cancel.throw_if_cancelled();
}

// Fills tetrahedra, neighbours and hull of `result`. A source has numbered slots, not all of them
// with a tetrahedron; UnorderedTetrahedra is one. Works in the caller's task arena. Throws
// Cancelled, and std::length_error for more tetrahedra than a Neighbour can name.
template <class Source>
void set_tetrahedra(const BallSet& balls, const Source& source, const CancelToken& cancel,
                    Triangulation& result) {
  TetrahedronOrder order(balls.size(), source.slots());
  for_ranges(source.slots(), cancel, [&](std::size_t first, std::size_t end) {
    for (std::size_t slot = first; slot != end; ++slot) {
      if (source.has(slot)) {
        const std::array<BallIndex, 4> balls_of = source.balls(slot);
        order.count(*std::min_element(balls_of.begin(), balls_of.end()));
      } else {
        order.leave_out(slot);
      }
    }
  });
  order.begin_placing();
  for_ranges(source.slots(), cancel, [&](std::size_t first, std::size_t end) {
    for (std::size_t slot = first; slot != end; ++slot) {
      if (source.has(slot))
        order.place(sorted(source.corners(slot)), static_cast<std::uint32_t>(slot));
    }
  });
  order.sort(cancel, result.tetrahedra);

  result.neighbours.resize(order.size());
  std::vector<OutsideFace> outside;
  std::mutex outside_mutex;
  for_ranges(order.size(), cancel, [&](std::size_t first, std::size_t end) {
    std::vector<OutsideFace> found;
    for (std::size_t t = first; t != end; ++t) {
      for (std::size_t k = 0; k < 4; ++k) {
        const std::uint32_t next = order.across(t, k);
        if (next == TetrahedronCorner::kOutside) {
          found.push_back(
              {static_cast<std::uint32_t>(t), static_cast<int>(k), result.tetrahedra[t]});
        } else {
          result.neighbours[t][k] = Neighbour::tetrahedron(next);
        }
      }
    }
    const std::lock_guard lock(outside_mutex);
    outside.insert(outside.end(), found.begin(), found.end());
  });
  set_hull(hull_facets(balls, outside), outside, result);
}

}  // namespace alphascope
