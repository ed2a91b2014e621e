// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the cavities of one K_alpha: joins empty tetrahedra across open triangles, then lists
// mouths, sinks and Betti numbers.
#include "core/cavity/cavities.hpp"

#include <algorithm>
#include <utility>

#include "core/cavity/bodies.hpp"
#include "core/cavity/inside.hpp"
#include "core/cavity/mouths.hpp"
#include "core/run/internal_error.hpp"
#include "core/run/parallel.hpp"
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
    const std::vector<std::vector<std::uint32_t>> opening = openings();
    set_mouths(ground_, in_, opening, result_.cavities);
    for (Cavity& cavity : result_.cavities) look_for_sinks(cavity);
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

  void list_tetrahedra() {
    auto& labels = result_.cavity_of_tetrahedron;
    for (std::uint32_t t = 0; t < tetrahedra_; ++t) {
      if (labels[t] == Cavities::kNone) continue;
      if (labels[t] == t) {
        labels[t] = static_cast<std::uint32_t>(result_.cavities.size());
        result_.cavities.emplace_back();
      } else {
        labels[t] = labels[labels[t]];
      }
      result_.cavities[labels[t]].tetrahedra.push_back(t);
    }
  }

  void list_atoms() {
    std::vector<std::uint32_t> last_cavity(ground_.balls->size(), Cavities::kNone);
    for (std::uint32_t c = 0; c < result_.cavities.size(); ++c) {
      Cavity& cavity = result_.cavities[c];
      for (const std::uint32_t t : cavity.tetrahedra) {
        for (const BallIndex v : ground_.triangulation->tetrahedra[t]) {
          if (std::exchange(last_cavity[v], c) != c && in_.vertices[v]) cavity.atoms.push_back(v);
        }
      }
      std::sort(cavity.atoms.begin(), cavity.atoms.end());
    }
  }

  // For each cavity the triangles not in K_alpha between it and tetrahedra of no cavity.
  std::vector<std::vector<std::uint32_t>> openings() const {
    std::vector<std::vector<std::uint32_t>> opening(result_.cavities.size());
    for (std::uint32_t f = 0; f < incidence_.triangles.size(); ++f) {
      if (in_.triangles[f]) continue;
      const auto [a, b] = incidence_.tetrahedra_of_triangle[f];
      const std::uint32_t of_a = result_.cavity_of_tetrahedron[a],
                          of_b = b == Incidence::kOutside ? Cavities::kNone
                                                          : result_.cavity_of_tetrahedron[b];
      if (of_a == of_b) continue;
      opening[of_a != Cavities::kNone ? of_a : of_b].push_back(f);
      require_outside(of_a != Cavities::kNone ? b : a);
    }
    return opening;
  }
  // Checks that the flow leads to infinity from the tetrahedron on the other side of a mouth.
  // Otherwise this tetrahedron would belong to the cavity.
  void require_outside(std::uint32_t t) const {
    if (t == Incidence::kOutside) return;
    if (!in_.tetrahedra[t] && (ground_.flow.marks[t] & Flow::kReachesInfinity)) return;
    throw InternalError("A mouth of a pocket does not lead to the outside.");
  }

  void look_for_sinks(Cavity& cavity) const {
    for (const std::uint32_t t : cavity.tetrahedra) {
      // A flow that reaches infinity leaves the cavity by a mouth. So no tetrahedron of a void has
      // such a flow.
      if (cavity.is_void() && (ground_.flow.marks[t] & Flow::kReachesInfinity)) {
        throw InternalError("A cavity without mouths has a way out.");
      }
      if (!ground_.flow.is_sink(t)) continue;
      if (cavity.sinks++ == 0 || is_deeper_sink(ground_, t, cavity.deepest_sink))
        cavity.deepest_sink = t;
    }
    if (cavity.sinks == 0) throw InternalError("A cavity has no sink.");
  }

  void set_betti_numbers() {
    result_.simplices = in_.counts();
    UnionFind sets = joined_balls(ground_, in_, cancel_);
    for (std::uint32_t v = 0; v < in_.vertices.size(); ++v) {
      result_.components += in_.vertices[v] && sets.root(v) == v;
    }
    for (Cavity& cavity : result_.cavities) {
      result_.voids += cavity.is_void();
      cavity.bodies = count_bodies(cavity, sets);
    }
    const auto& n = result_.simplices;
    const auto euler = static_cast<long long>(n[0] + n[2]) - static_cast<long long>(n[1] + n[3]);
    result_.tunnels = result_.components + result_.voids - euler;
    if (result_.tunnels < 0)
      throw InternalError("The number of voids contradicts the Euler characteristic.");
  }

  const CavityGround& ground_;
  const Membership& in_;
  const Incidence& incidence_;
  const OutsideRule rule_;
  const CancelToken& cancel_;
  const std::size_t tetrahedra_;
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
