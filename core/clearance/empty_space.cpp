// SPDX-License-Identifier: GPL-3.0-or-later
// Searches through the empty tetrahedra of a triangulation: widest and cheapest ways, and the gaps
// on them.
#include "core/clearance/empty_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "core/clearance/orthocentre.hpp"
#include "core/complex/face_groups.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/predicates/perturbation.hpp"

namespace alphascope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// ∫ dh / clearance² from `begin` to `end`, with end >= begin >= 0. On the line, power distance is
// `least` + h². Uses midpoints of steps that grow with the clearance. The result is mostly within a
// few per cent, and within a third where the way soon becomes narrow.
double integrated_narrowness(double begin, double end, double least, double radius,
                             const WayCost& cost) {
  const auto clearance = [&](double h) {
    const double outside = std::sqrt(std::max(0.0, least + h * h) + radius * radius) - radius;
    return std::min(outside + cost.grown, cost.enough);
  };
  double sum = 0;
  while (begin < end) {
    const double step = std::min(end - begin, std::max(0.5 * clearance(begin), 0.02 * end));
    const double middle = clearance(begin + step / 2);
    sum += step / (middle * middle);
    begin += step;
  }
  return sum;
}

}  // namespace

std::array<BallIndex, 3> EmptySpace::face(std::uint32_t tetrahedron, std::size_t k) const {
  const auto& t = triangulation_.tetrahedra[tetrahedron];
  return {t[k == 0 ? 1 : 0], t[k <= 1 ? 2 : 1], t[k <= 2 ? 3 : 2]};
}

bool EmptySpace::is_empty(std::uint32_t tetrahedron) const {
  return compare_ortho_radius(balls_, triangulation_.tetrahedra[tetrahedron], 0) > 0;
}

// Such a face between tetrahedra outside K is in K iff two things hold. Its ortho-radius is at most
// 0, and no ball conflicts with its smallest orthosphere. Only the apexes of its two tetrahedra can
// conflict.
bool EmptySpace::is_open(std::uint32_t tetrahedron, std::size_t k) const {
  return is_open_gap(face(tetrahedron, k)) || !is_gap(tetrahedron, k);
}

bool EmptySpace::is_open_gap(const std::array<BallIndex, 3>& gap) const {
  return compare_ortho_radius(balls_, gap, 0) > 0;
}

bool EmptySpace::leads_out(std::uint32_t tetrahedron) const {
  for (std::size_t k = 0; k < 4; ++k) {
    if (triangulation_.neighbours[tetrahedron][k].is_hull() && is_open(tetrahedron, k)) return true;
  }
  return false;
}

// The largest radius among balls of an index below `end`; 0 if there is none.
double EmptySpace::largest_radius(std::span<const BallIndex> balls, BallIndex end) const {
  std::int32_t largest = 0;
  for (const BallIndex i : balls) {
    if (i < end) largest = std::max(largest, balls_.radii[i]);
  }
  return largest;
}

double EmptySpace::power(std::uint32_t tetrahedron) const {
  return ortho_radius_rounded(balls_, triangulation_.tetrahedra[tetrahedron]);
}

bool EmptySpace::is_gap(std::uint32_t tetrahedron, std::size_t k) const {
  const auto f = face(tetrahedron, k);
  const auto attaches = [&](BallIndex apex) {
    return conflict_with_smallest_orthosphere(balls_, f, apex) < 0;
  };
  if (attaches(triangulation_.tetrahedra[tetrahedron][k])) return false;
  const Neighbour across = triangulation_.neighbours[tetrahedron][k];
  if (across.is_hull()) return true;
  return !attaches(apex<3>(triangulation_.tetrahedra[across.index()], f));
}

bool EmptySpace::is_ringed_gap(const std::array<BallIndex, 3>& gap) const {
  for (std::size_t n = 0; n < 3; ++n) {
    const std::array<BallIndex, 2> edge{gap[n == 0 ? 1 : 0], gap[n == 2 ? 1 : 2]};
    if (conflict_with_smallest_orthosphere(balls_, edge, gap[n]) < 0) return false;
  }
  return true;
}

// Dijkstra's search over tetrahedra. If the key of t is `key`, relax(key, t, k) is the key of the
// neighbour across open face k. It is never less than `key`. Equal keys go by index, so the way is
// unique.
template <class Relax>
std::optional<EmptySpace::Way> EmptySpace::least_way(BallIndex from, BallIndex to,
                                                     const CancelToken& cancel,
                                                     const Relax& relax) const {
  constexpr std::uint32_t kNothing = ~std::uint32_t{0};
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const Simplices<4>& tetrahedra = triangulation_.tetrahedra;
  std::vector<double> key(tetrahedra.size(), kInfinity);
  std::vector<std::uint32_t> before(key.size(), kNothing);
  const auto is_around = [&](std::uint32_t t, BallIndex ball) {
    return std::find(tetrahedra[t].begin(), tetrahedra[t].end(), ball) != tetrahedra[t].end();
  };
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t) {
    if (!is_around(t, from)) continue;
    key[t] = -kInfinity;
    open.push({-kInfinity, t});
  }
  for (std::size_t steps = 0; !open.empty(); ++steps) {
    if (steps % 4096 == 0) cancel.throw_if_cancelled();
    const auto [own, t] = open.top();
    open.pop();
    if (own > key[t]) continue;
    if (to == kOutside ? leads_out(t) : is_around(t, to)) {
      Way way{t};
      while (before[way.back()] != kNothing) way.push_back(before[way.back()]);
      std::reverse(way.begin(), way.end());
      return way;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const Neighbour across = triangulation_.neighbours[t][k];
      if (across.is_hull() || key[across.index()] <= own) continue;
      if (!is_empty(across.index()) || !is_open(t, k)) continue;
      const double next = relax(own, t, k);
      if (next >= key[across.index()]) continue;
      key[across.index()] = next;
      before[across.index()] = t;
      open.push({next, across.index()});
    }
  }
  return std::nullopt;
}

double EmptySpace::width_of(double power, std::span<const BallIndex> balls, double grown,
                            BallIndex ball_end) const {
  const double radius = largest_radius(balls, ball_end);
  return std::sqrt(std::max(0.0, power) + radius * radius) - radius + grown;
}

double EmptySpace::width_by_power(const std::array<BallIndex, 3>& gap, double grown,
                                  BallIndex ball_end) const {
  return width_of(ortho_radius_rounded(balls_, gap), gap, grown, ball_end);
}

double EmptySpace::width_across(std::uint32_t tetrahedron, std::size_t k,
                                const WayWidth& width) const {
  if (is_gap(tetrahedron, k)) {
    const auto f = face(tetrahedron, k);
    const std::optional<double> known = width.at_gap(f);
    return known ? *known : width_by_power(f, width.grown, width.ball_end);
  }
  const auto within = [&](std::uint32_t t) {
    return width_of(power(t), triangulation_.tetrahedra[t], width.grown, width.ball_end);
  };
  return std::min(within(tetrahedron), within(triangulation_.neighbours[tetrahedron][k].index()));
}

std::optional<EmptySpace::Way> EmptySpace::widest_way(BallIndex from, BallIndex to,
                                                      const WayWidth& width,
                                                      const CancelToken& cancel) const {
  return least_way(from, to, cancel, [&](double key, std::uint32_t t, std::size_t k) {
    return std::max(key, -width_across(t, k, width));
  });
}

// Dijkstra's search inwards from all faces of the hull. The width across a face is the same from
// both sides.
std::vector<EmptySpace::WayOut> EmptySpace::widest_ways_out(const WayWidth& width,
                                                            const CancelToken& cancel) const {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry> open;
  std::vector<WayOut> ways(triangulation_.tetrahedra.size(), {-kInfinity, WayOut::kNoFace, 0});
  for (const HullFacet& facet : triangulation_.hull) {
    const std::uint32_t t = facet.tetrahedron;
    if (ways[t].width == kInfinity || !is_empty(t) || !leads_out(t)) continue;
    ways[t].width = kInfinity;
    open.push({kInfinity, t});
  }
  for (std::size_t steps = 0; !open.empty(); ++steps) {
    if (steps % 4096 == 0) cancel.throw_if_cancelled();
    const auto [own, t] = open.top();
    open.pop();
    if (own < ways[t].width) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      const Neighbour across = triangulation_.neighbours[t][k];
      if (across.is_hull() || ways[across.index()].width >= own) continue;
      if (!is_empty(across.index()) || !is_open(t, k)) continue;
      const double here = width_across(t, k, width);
      WayOut& next = ways[across.index()];
      if (std::min(own, here) <= next.width) continue;
      next = here < own ? WayOut{here, t, static_cast<std::uint32_t>(k)} : ways[t];
      open.push({next.width, across.index()});
    }
  }
  return ways;
}

std::vector<std::array<BallIndex, 3>> EmptySpace::gaps(const Way& way) const {
  std::vector<std::array<BallIndex, 3>> result;
  for (std::size_t n = 0; n + 1 < way.size(); ++n) {
    std::size_t k = 0;
    while (triangulation_.neighbours[way[n]][k] != Neighbour::tetrahedron(way[n + 1])) ++k;
    if (is_gap(way[n], k)) result.push_back(face(way[n], k));
  }
  return result;
}

double EmptySpace::cost_across(std::uint32_t tetrahedron, std::size_t k,
                               const WayCost& cost) const {
  const auto f = face(tetrahedron, k);
  const Neighbour across = triangulation_.neighbours[tetrahedron][k];
  const double radius = largest_radius(f, cost.ball_end);
  const double least = ortho_radius_rounded(balls_, f);
  const auto height = [&](std::uint32_t t) { return std::sqrt(std::max(0.0, power(t) - least)); };
  const double own = height(tetrahedron), other = height(across.index());
  const auto integral = [&](double begin, double end) {
    return integrated_narrowness(begin, end, least, radius, cost);
  };
  return is_gap(tetrahedron, k) ? integral(0, own) + integral(0, other)
                                : integral(std::min(own, other), std::max(own, other));
}

std::optional<EmptySpace::Way> EmptySpace::cheapest_way(BallIndex from, BallIndex to,
                                                        const WayCost& cost,
                                                        const CancelToken& cancel) const {
  return least_way(from, to, cancel, [&](double key, std::uint32_t t, std::size_t k) {
    return std::max(key, 0.0) + cost_across(t, k, cost);
  });
}

RealPoint EmptySpace::corner(std::uint32_t tetrahedron) const {
  return orthocentre(balls_, triangulation_.tetrahedra[tetrahedron]);
}

}  // namespace alphascope
