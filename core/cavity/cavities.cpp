// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the cavities of one K_alpha: joins empty tetrahedra across open triangles, then lists
// mouths, sinks and Betti numbers.
#include "core/cavity/cavities.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>
#include <vector>

#include "core/cavity/bodies.hpp"
#include "core/cavity/inside.hpp"
#include "core/cavity/mouths.hpp"
#include "core/run/internal_error.hpp"
#include "core/run/parallel.hpp"
#include "core/triangulation/grouped.hpp"
#include "core/triangulation/indices_where.hpp"
#include "core/triangulation/membership.hpp"
#include "core/triangulation/triangulation_maker.hpp"
#include "core/triangulation/union_find.hpp"

namespace alphascope {
namespace {

class CavityFinder {
 public:
  CavityFinder(const CavityGround& ground, const Membership& membership, OutsideRule rule,
               const CancelToken& cancel)
      : ground_(ground),
        in_(membership),
        incidence_(ground.incidence),
        rule_(rule),
        cancel_(cancel),
        tetrahedra_(ground.triangulation->tetrahedra.size()) {}

  Cavities find() {
    label_tetrahedra();
    list_tetrahedra();
    list_atoms();
    set_mouths(ground_, in_, openings(), result_.cavities);
    look_for_sinks();
    set_betti_numbers();
    return std::move(result_);
  }

 private:
  bool is_inside(std::size_t t) const {
    return !in_.tetrahedra[t] && is_inside_if_empty(ground_.flow, t, rule_);
  }

  // Joins tetrahedra of cavities across triangles not in K_alpha. Each tetrahedron gets the lowest
  // index of its set as its label; list_tetrahedra() replaces it by the number of the cavity.
  void label_tetrahedra() {
    UnionFind sets(tetrahedra_);
    parallel_many(incidence_.triangles.size(), cancel_, [&](std::size_t f) {
      const auto [a, b] = incidence_.tetrahedra_of_triangle[f];
      if (!in_.triangles[f] && b != Incidence::kOutside && is_inside(a) && is_inside(b)) {
        sets.unite(a, b);
      }
    });
    auto& labels = result_.cavity_of_tetrahedron;
    labels.resize(tetrahedra_);
    parallel_many(tetrahedra_, cancel_, [&](std::size_t t) {
      labels[t] = is_inside(t) ? sets.root(static_cast<std::uint32_t>(t)) : Cavities::kNone;
    });
  }

  std::uint32_t cavity_of(std::size_t t) const { return result_.cavity_of_tetrahedron[t]; }

  // Cavities are numbered by their lowest tetrahedra.
  void list_tetrahedra() {
    auto& labels = result_.cavity_of_tetrahedron;
    const ResultArray<std::uint32_t> lowest = indices_where(
        tetrahedra_, [&](std::size_t t) { return labels[t] == t; }, cancel_);
    const auto number_of = [&](std::uint32_t label) {
      return static_cast<std::uint32_t>(std::lower_bound(lowest.begin(), lowest.end(), label) -
                                        lowest.begin());
    };
    inside_ = indices_where(
        tetrahedra_, [&](std::size_t t) { return labels[t] != Cavities::kNone; }, cancel_);
    parallel_ranges(0, inside_.size(), kGrain, [&](std::size_t first, std::size_t end) {
      std::uint32_t label = Cavities::kNone, number = 0;  // often the same as before
      for (std::size_t n = first; n != end; ++n) {
        std::uint32_t& own = labels[inside_[n]];
        if (own != label) number = number_of(label = own);
        own = number;
      }
    });
    result_.cavities.resize(lowest.size());
    const Grouped lists = grouped(
        inside_, lowest.size(), [&](std::size_t n) { return labels[inside_[n]]; }, cancel_);
    parallel_each(0, lowest.size(), [&](std::size_t c) {
      const auto own = lists.of(c);
      result_.cavities[c].tetrahedra.assign(own.begin(), own.end());
    });
  }

  // The balls in K_alpha of each cavity's tetrahedra. A ball keeps one of its cavities, whichever
  // comes first; the others of a ball, which are few, go to a list.
  void list_atoms() {
    const Simplices<4>& tetrahedra = ground_.triangulation->tetrahedra;
    ResultArray<std::uint32_t> kept(ground_.balls->size());
    parallel_many(kept.size(), cancel_, [&](std::size_t v) { kept[v] = Cavities::kNone; });
    using CavityAndBall = std::pair<std::uint32_t, BallIndex>;
    std::vector<CavityAndBall> others;
    std::mutex mutex;
    parallel_ranges(0, inside_.size(), kGrain, [&](std::size_t first, std::size_t end) {
      std::vector<CavityAndBall> own;
      for (std::size_t n = first; n != end; ++n) {
        const std::uint32_t c = cavity_of(inside_[n]);
        for (const BallIndex v : tetrahedra[inside_[n]]) {
          if (in_.vertices[v] && !keep(c, kept[v])) own.push_back({c, v});
        }
      }
      const std::lock_guard lock(mutex);
      others.insert(others.end(), own.begin(), own.end());
    });
    tbb::parallel_sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    const ResultArray<std::uint32_t> balls = indices_where(
        kept.size(), [&](std::size_t v) { return kept[v] != Cavities::kNone; }, cancel_);
    const Grouped lists = grouped(
        balls, result_.cavities.size(), [&](std::size_t n) { return kept[balls[n]]; }, cancel_);
    parallel_each(0, result_.cavities.size(), [&](std::size_t c) {
      const auto number = static_cast<std::uint32_t>(c);
      std::vector<BallIndex>& atoms = result_.cavities[c].atoms;
      atoms.assign(lists.of(c).begin(), lists.of(c).end());
      const auto middle = static_cast<std::ptrdiff_t>(atoms.size());
      for (auto other = std::lower_bound(others.begin(), others.end(), CavityAndBall{number, 0});
           other != others.end() && other->first == number; ++other)
        atoms.push_back(other->second);
      std::inplace_merge(atoms.begin(), atoms.begin() + middle, atoms.end());
    });
  }
  // Returns whether a ball keeps this cavity.
  static bool keep(std::uint32_t cavity, std::uint32_t& kept) {
    std::atomic_ref<std::uint32_t> at(kept);
    std::uint32_t now = at.load(std::memory_order_relaxed);
    if (now == Cavities::kNone &&
        at.compare_exchange_strong(now, cavity, std::memory_order_relaxed))
      return true;
    return now == cavity;
  }

  // For each cavity the triangles not in K_alpha between it and tetrahedra of no cavity.
  Grouped openings() const {
    const auto& sides = incidence_.tetrahedra_of_triangle;
    const auto across = [&](std::size_t f) {
      return sides[f][1] == Incidence::kOutside ? Cavities::kNone : cavity_of(sides[f][1]);
    };
    const ResultArray<std::uint32_t> triangles = indices_where(
        incidence_.triangles.size(),
        [&](std::size_t f) { return !in_.triangles[f] && cavity_of(sides[f][0]) != across(f); },
        cancel_);
    parallel_many(triangles.size(), cancel_, [&](std::size_t n) {
      const std::uint32_t f = triangles[n];
      require_outside(sides[f][cavity_of(sides[f][0]) != Cavities::kNone ? 1 : 0]);
    });
    return grouped(
        triangles, result_.cavities.size(),
        [&](std::size_t n) {
          const std::uint32_t own = cavity_of(sides[triangles[n]][0]);
          return own != Cavities::kNone ? own : across(triangles[n]);
        },
        cancel_);
  }
  // Checks that the flow leads to infinity from the tetrahedron on the other side of a mouth.
  // Otherwise this tetrahedron would belong to the cavity.
  void require_outside(std::uint32_t t) const {
    if (t == Incidence::kOutside) return;
    if (!in_.tetrahedra[t] && (ground_.flow.marks[t] & Flow::kReachesInfinity)) return;
    throw InternalError("A mouth of a pocket does not lead to the outside.");
  }

  void look_for_sinks() {
    // A flow that reaches infinity leaves the cavity by a mouth. So no tetrahedron of a void has
    // such a flow.
    parallel_many(inside_.size(), cancel_, [&](std::size_t n) {
      const std::uint32_t t = inside_[n];
      if (result_.cavities[cavity_of(t)].is_void() &&
          (ground_.flow.marks[t] & Flow::kReachesInfinity))
        throw InternalError("A cavity without mouths has a way out.");
    });
    const ResultArray<std::uint32_t> sinks = indices_where(
        inside_.size(), [&](std::size_t n) { return ground_.flow.is_sink(inside_[n]); }, cancel_);
    for (const std::uint32_t n : sinks) {
      const std::uint32_t t = inside_[n];
      Cavity& cavity = result_.cavities[cavity_of(t)];
      if (cavity.sinks++ == 0 || is_deeper_sink(ground_, t, cavity.deepest_sink))
        cavity.deepest_sink = t;
    }
    for (const Cavity& cavity : result_.cavities) {
      if (cavity.sinks == 0) throw InternalError("A cavity has no sink.");
    }
  }

  void set_betti_numbers() {
    result_.simplices = in_.counts();
    UnionFind sets = joined_balls(ground_, in_, cancel_);
    result_.components = static_cast<long long>(
        parallel_sum(0, in_.vertices.size(), kGrain, [&](std::size_t first, std::size_t end) {
          std::uint64_t roots = 0;
          for (std::size_t v = first; v != end; ++v)
            roots += in_.vertices[v] && sets.root(static_cast<std::uint32_t>(v)) == v;
          return roots;
        }));
    parallel_each(0, result_.cavities.size(), [&](std::size_t c) {
      Cavity& cavity = result_.cavities[c];
      cavity.bodies =
          result_.components == 1 ? (cavity.atoms.empty() ? 0 : 1) : count_bodies(cavity, sets);
    });
    result_.voids = std::count_if(result_.cavities.begin(), result_.cavities.end(),
                                  [](const Cavity& cavity) { return cavity.is_void(); });
    const auto& n = result_.simplices;
    const auto euler = static_cast<long long>(n[0] + n[2]) - static_cast<long long>(n[1] + n[3]);
    result_.tunnels = result_.components + result_.voids - euler;
    if (result_.tunnels < 0)
      throw InternalError("The number of voids contradicts the Euler characteristic.");
  }

  static constexpr std::size_t kGrain = 4096;

  const CavityGround& ground_;
  const Membership& in_;
  const Incidence& incidence_;
  const OutsideRule rule_;
  const CancelToken& cancel_;
  const std::size_t tetrahedra_;
  ResultArray<std::uint32_t> inside_;  // tetrahedra of cavities, ascending
  Cavities result_;
};

}  // namespace

std::size_t Cavity::mouth_triangles() const {
  std::size_t count = 0;
  for (const Mouth& mouth : mouths) count += mouth.triangles.size();
  return count;
}

CavityGround make_cavity_ground(std::shared_ptr<const BallSet> balls,
                                std::shared_ptr<const Triangulation> triangulation, FlowTies ties,
                                const RunContext& context, TriangulationMaker* maker) {
  if (maker != nullptr) {
    if (auto made = maker->ground(*balls, *triangulation, ties, context)) {
      return {std::move(balls), std::move(triangulation), std::move(made->incidence),
              std::move(made->flow)};
    }
  }
  Incidence incidence = make_incidence(*triangulation, context.cancel);
  Flow flow = make_flow(*balls, *triangulation, ties, context.cancel);
  return {std::move(balls), std::move(triangulation), std::move(incidence), std::move(flow)};
}

Cavities find_cavities(const CavityGround& ground, const Membership& membership, OutsideRule rule,
                       const CancelToken& cancel) {
  if (ground.triangulation->dimension < 3) return {};
  return CavityFinder(ground, membership, rule, cancel).find();
}

}  // namespace alphascope
