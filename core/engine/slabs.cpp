// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts the balls into slabs with halos, computes each, and joins the results. A halo that is one
// neighbourhood wide suffices. Let v be an own ball of a slab. Only balls that meet v when grown
// decide which simplices contain v, whichever vertex of a simplex is the lowest
// (docs/algorithm.md). All these balls are in the part of that slab. So are all edges of v, which
// decide the alpha value and class of v.
#include "core/engine/slabs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {
namespace {

std::int32_t coordinate(const LatticePoint& p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

int longest_axis(const BallSet& balls) {
  int longest = 0;
  std::int64_t extent = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const auto less = [axis](const LatticePoint& a, const LatticePoint& b) {
      return coordinate(a, axis) < coordinate(b, axis);
    };
    const auto [low, high] = std::minmax_element(balls.centres.begin(), balls.centres.end(), less);
    const std::int64_t length = std::int64_t{coordinate(*high, axis)} - coordinate(*low, axis);
    if (length > extent) {
      extent = length;
      longest = axis;
    }
  }
  return longest;
}

// The lowest coordinate of each slab but the first. They are quantiles, so the slabs have about as
// many balls each.
std::vector<std::int32_t> slab_bounds(const BallSet& balls, int axis, std::size_t slabs) {
  std::vector<std::int32_t> all(balls.size());
  for (std::size_t i = 0; i < balls.size(); ++i) all[i] = coordinate(balls.centres[i], axis);
  std::sort(all.begin(), all.end());
  std::vector<std::int32_t> bounds;
  for (std::size_t s = 1; s < slabs; ++s) {
    const std::int32_t bound = all[all.size() * s / slabs];
    if (bounds.empty() || bound > bounds.back()) bounds.push_back(bound);
  }
  return bounds;
}

// No two grown balls meet whose centres are farther apart than this. Lattice units; infinite for
// infinite alpha.
double meeting_distance(const BallSet& balls, const LatticeAlpha& alpha) {
  std::int32_t largest = 0;
  for (const std::int32_t r : balls.radii) largest = std::max(largest, r);
  const double square = alpha.plus(std::int64_t{largest} * largest);
  return square < 0 ? 0 : 2 * std::sqrt(square) * (1 + 1e-9) + 2;
}

struct Part {
  std::shared_ptr<BallSet> balls = std::make_shared<BallSet>();
  std::vector<BallIndex> original;
  std::vector<bool> own;
};

// Simplices of one dimension from all parts, in the order of the parts.
template <int N>
struct Gathered {
  SimplexList<N> list;

  void append(const SimplexList<N>& from, const Part& part) {
    for (std::size_t s = 0; s < from.size(); ++s) {
      if (!part.own[from.simplices[s][0]]) continue;
      std::array<BallIndex, N> simplex = from.simplices[s];
      for (BallIndex& v : simplex) v = part.original[v];
      list.simplices.push_back(simplex);
      if (!from.alpha_values.empty()) list.alpha_values.push_back(from.alpha_values[s]);
      if (!from.classes.empty()) list.classes.push_back(from.classes[s]);
    }
  }

  // In lexicographic order. All simplices with one lowest vertex come from one part, where they are
  // in order already.
  SimplexList<N> ordered(std::size_t balls) const {
    std::vector<std::size_t> place(balls + 1, 0);
    for (const auto& simplex : list.simplices) ++place[simplex[0] + 1];
    for (std::size_t i = 0; i < balls; ++i) place[i + 1] += place[i];
    SimplexList<N> result;
    result.simplices.resize(list.simplices.size());
    result.alpha_values.resize(list.alpha_values.size());
    result.classes.resize(list.classes.size());
    for (std::size_t s = 0; s < list.size(); ++s) {
      const std::size_t to = place[list.simplices[s][0]]++;
      result.simplices[to] = list.simplices[s];
      if (!list.alpha_values.empty()) result.alpha_values[to] = list.alpha_values[s];
      if (!list.classes.empty()) result.classes[to] = list.classes[s];
    }
    return result;
  }
};

void add_times(StageTimes& sum, const StageTimes& times) {
  for (const StageTime& stage : times.stages) {
    const auto same = std::find_if(sum.stages.begin(), sum.stages.end(), [&](const StageTime& s) {
      return s.label == stage.label && s.setup == stage.setup;
    });
    if (same == sum.stages.end()) {
      sum.stages.push_back(stage);
    } else {
      same->milliseconds += stage.milliseconds;
    }
  }
}

}  // namespace

AlphaComplex compute_in_slabs(const BallSet& balls, const AlphaRequest& request, std::size_t slabs,
                              const RunContext& context, const ComputePart& compute) {
  AlphaComplex result;
  result.lattice = balls.lattice;
  result.alpha_on_lattice = balls.lattice.alpha_on_lattice(request.alpha_angstrom2);
  result.tetrahedra_only = request.tetrahedra_only;
  StageTimer wall(result.timings);
  const int axis = balls.size() == 0 ? 0 : longest_axis(balls);
  const std::vector<std::int32_t> bounds =
      balls.size() == 0 ? std::vector<std::int32_t>{} : slab_bounds(balls, axis, slabs);
  const double halo = meeting_distance(balls, result.alpha_on_lattice);
  Gathered<1> vertices;
  Gathered<2> edges;
  Gathered<3> triangles;
  Gathered<4> tetrahedra;
  StageTimes parts;
  for (std::size_t s = 0; s <= bounds.size(); ++s) {
    context.cancel.throw_if_cancelled();
    context.report("slabs", static_cast<double>(s) / static_cast<double>(bounds.size() + 1));
    Part part;
    part.balls->lattice = balls.lattice;
    for (BallIndex i = 0; i < balls.size(); ++i) {
      const std::int32_t at = coordinate(balls.centres[i], axis);
      const bool after = s == 0 || at >= bounds[s - 1],
                 before = s == bounds.size() || at < bounds[s];
      if (!after && static_cast<double>(bounds[s - 1]) - at > halo) continue;
      if (!before && static_cast<double>(at) - bounds[s] > halo) continue;
      part.balls->centres.push_back(balls.centres[i]);
      part.balls->radii.push_back(balls.radii[i]);
      part.original.push_back(i);
      part.own.push_back(after && before);
    }
    const AlphaComplex complex = compute(part.balls);
    vertices.append(complex.vertices, part);
    edges.append(complex.edges, part);
    triangles.append(complex.triangles, part);
    tetrahedra.append(complex.tetrahedra, part);
    add_times(parts, complex.timings);
    const EngineInfo before = std::exchange(result.engine, complex.engine);
    result.engine.of_whole |= before.of_whole;
    result.engine.rests_on_cgal |= before.rests_on_cgal;
  }
  result.vertices = vertices.ordered(balls.size());
  result.edges = edges.ordered(balls.size());
  result.triangles = triangles.ordered(balls.size());
  result.tetrahedra = tetrahedra.ordered(balls.size());
  wall.finish();
  add_times(result.timings, parts);
  result.hash = complex_hash(result);
  return result;
}

}  // namespace alphascope
