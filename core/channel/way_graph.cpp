// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the graph of empty tetrahedra and finds crossings and routes in it.
#include "core/channel/way_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "core/clearance/equal_clearance.hpp"
#include "core/predicates/exact_alpha.hpp"

namespace alphascope {
namespace {

constexpr std::uint32_t kNothing = ~std::uint32_t{0};

// A place outside all balls, far enough away to change nothing near them.
LatticePoint beside(const BallSet& balls) {
  LatticePoint low = balls.centres.front();
  for (const LatticePoint& p : balls.centres) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  }
  const std::int32_t largest = *std::max_element(balls.radii.begin(), balls.radii.end());
  const auto away = static_cast<std::int32_t>(2 * largest + balls.lattice.nearest_units(1));
  return {low.x - away, low.y - away, low.z - away};
}

}  // namespace

WayAxis::WayAxis(const BallSet& balls, const std::vector<BallIndex>& part, const RealPoint& axis)
    : axis_(axis),
      low_(std::numeric_limits<double>::infinity()),
      high_(-std::numeric_limits<double>::infinity()) {
  const double unit = balls.lattice.unit_angstrom();
  for (const BallIndex ball : part) {
    const RealPoint p = unit * real_point(balls.centres[ball]);
    middle_ = middle_ + p;
    low_ = std::min(low_, along(p));
    high_ = std::max(high_, along(p));
  }
  middle_ = (1 / static_cast<double>(part.size())) * middle_;
  // Each slab is averaged with two neighbours on both sides. A single slab has too few atoms to
  // locate the part.
  constexpr std::size_t kBeside = 2;
  near_.assign(static_cast<std::size_t>((high_ - low_) / kSlab) + 1, 0);
  std::vector<double> count(near_.size(), 0);
  for (const BallIndex ball : part) {
    const RealPoint p = unit * real_point(balls.centres[ball]);
    const double away = from_axis(p);
    const std::size_t slab = slab_of(along(p));
    const std::size_t last = std::min(slab + kBeside, near_.size() - 1);
    for (std::size_t n = slab > kBeside ? slab - kBeside : 0; n <= last; ++n) {
      near_[n] += away * away;
      ++count[n];
    }
  }
  for (std::size_t n = 0; n < near_.size(); ++n) {
    near_[n] = count[n] > 0 ? std::sqrt(near_[n] / count[n]) / 2 : 0;
  }
}

std::size_t WayAxis::slab_of(double along) const {
  return std::min(static_cast<std::size_t>(std::max(0.0, along - low_) / kSlab), near_.size() - 1);
}

double WayAxis::from_axis(const RealPoint& x) const {
  const RealPoint away = x - middle_;
  return length(away - dot(axis_, away) * axis_);
}

int WayAxis::zone(const RealPoint& x) const {
  const double third = (high_ - low_) / 3, at = along(x);
  return at < low_ + third ? -1 : at > high_ - third ? 1 : 0;
}

bool WayAxis::is_near(const RealPoint& x) const {
  return from_axis(x) <= near_[slab_of(along(x))];
}

bool WayAxis::stays_near_axis(const RealPoint& from, const RealPoint& to) const {
  const double third = (high_ - low_) / 3, low = low_ + third, high = high_ - third;
  const double begin = along(from), end = along(to);
  if (std::max(begin, end) < low || std::min(begin, end) > high) return true;
  if (begin == end) return is_near(from) && is_near(to);
  const auto place = [&](double height) {
    return from + ((std::clamp(height, low, high) - begin) / (end - begin)) * (to - from);
  };
  return is_near(place(begin)) && is_near(place(end));
}

WayGraph::WayGraph(const BallSet& balls, const Envelope& envelope, const RunContext& context)
    : balls_(balls) {
  const PassageEnds ends{beside(balls), {}, {}};
  scene_ = GrownTriangulations(balls, ends).at(0, context);
  space_.emplace(scene_->balls, scene_->triangulation);
  const std::size_t count = scene_->triangulation.tetrahedra.size();
  kind_.assign(count, Kind::full);
  corner_.resize(count);
  const double unit = balls.lattice.unit_angstrom();
  for (std::uint32_t t = 0; t < count; ++t) {
    if (t % 4096 == 0) context.cancel.throw_if_cancelled();
    if (!space_->is_empty(t)) continue;
    corner_[t] = unit * space_->corner(t);
    kind_[t] = envelope.holds(corner_[t]) ? Kind::inside : Kind::outside;
  }
  set_widths(context.cancel);
}

double WayGraph::clearance_at_gap(const std::array<BallIndex, 3>& triangle,
                                  RealPoint* place) const {
  if (triangle[2] >= scene_->original.size()) return -1;
  const EqualClearance gap =
      equal_clearance(balls_, {scene_->original[triangle[0]], scene_->original[triangle[1]],
                               scene_->original[triangle[2]]});
  if (!gap.found) return -1;
  if (place != nullptr) *place = gap.place_angstrom;
  return gap.clearance_angstrom;
}

// Visits each face once, from the tetrahedron of the lower index.
void WayGraph::set_widths(const CancelToken& cancel) {
  const auto& neighbours = scene_->triangulation.neighbours;
  const double unit = balls_.lattice.unit_angstrom();
  const WayWidth width{[&](const std::array<BallIndex, 3>& triangle) {
                         const double gap = clearance_at_gap(triangle, nullptr);
                         return gap < 0 ? std::nullopt : std::optional(gap / unit);
                       },
                       0, static_cast<BallIndex>(scene_->original.size())};
  const auto power_of = [&](std::uint32_t t) {
    return ortho_radius_rounded(scene_->balls, scene_->triangulation.tetrahedra[t]);
  };
  width_.assign(kind_.size(), {kShut, kShut, kShut, kShut});
  power_ = width_;
  is_gap_.assign(kind_.size(), {false, false, false, false});
  for (std::uint32_t t = 0; t < kind_.size(); ++t) {
    if (t % 4096 == 0) cancel.throw_if_cancelled();
    if (kind_[t] == Kind::full) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      const Neighbour across = neighbours[t][k];
      if (across.is_hull() || across.index() < t || kind_[across.index()] == Kind::full) continue;
      // Ways end at the first tetrahedron outside, so faces between two of them are not needed.
      if (kind_[t] == Kind::outside && kind_[across.index()] == Kind::outside) continue;
      if (!space_->is_open(t, k)) continue;
      const auto here = static_cast<float>(unit * space_->width_across(t, k, width));
      const bool gap = space_->is_ringed_gap(t, k);
      const float power = space_->is_gap(t, k)
                              ? ortho_radius_rounded(scene_->balls, space_->face(t, k))
                              : std::min(power_of(t), power_of(across.index()));
      std::size_t back = 0;
      while (neighbours[across.index()][back] != Neighbour::tetrahedron(t)) ++back;
      width_[t][k] = width_[across.index()][back] = std::max(here, 0.0F);
      power_[t][k] = power_[across.index()][back] = std::max(power, 0.0F);
      is_gap_[t][k] = is_gap_[across.index()][back] = gap;
    }
  }
}

// Tests the whole segment between both corners, because they can be far apart.
bool WayGraph::may_pass(std::uint32_t from, std::uint32_t to) const {
  return axis_->stays_near_axis(corner_[from], corner_[to]);
}

// Dijkstra's search inwards from both sides at once. Each tetrahedron gets the label of the side
// from which the larger sphere reaches it. A crossing is a face where both labels meet.
std::vector<WayCrossing> WayGraph::crossings(const WayAxis& axis, const CancelToken& cancel) {
  using Entry = std::pair<float, std::uint32_t>;
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr std::int8_t kNowhere = 2;  // no step may lead into this zone
  const auto& neighbours = scene_->triangulation.neighbours;
  std::priority_queue<Entry> open;
  std::vector<float> widest(kind_.size(), kShut);
  axis_ = axis;
  zone_.assign(kind_.size(), kNowhere);
  label_.assign(kind_.size(), 0);
  for (std::uint32_t t = 0; t < kind_.size(); ++t) {
    if (kind_[t] == Kind::outside) {
      zone_[t] = label_[t] = static_cast<std::int8_t>(axis.side(corner_[t]));
      widest[t] = kInfinity;
      open.push({kInfinity, t});
    } else if (kind_[t] == Kind::inside) {
      const int zone = axis.zone(corner_[t]);
      if (zone != 0 || axis.is_near(corner_[t])) zone_[t] = static_cast<std::int8_t>(zone);
    }
  }
  const auto leads = [&](std::uint32_t t, std::size_t k) {
    if (width_[t][k] < 0) return false;
    const std::uint32_t to = neighbours[t][k].index();
    return zone_[to] != kNowhere && may_pass(t, to);
  };
  for (std::size_t steps = 0; !open.empty(); ++steps) {
    if (steps % 4096 == 0) cancel.throw_if_cancelled();
    const auto [own, t] = open.top();
    open.pop();
    if (own < widest[t]) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      if (!leads(t, k)) continue;
      const std::uint32_t to = neighbours[t][k].index();
      const float next = std::min(own, power_[t][k]);
      if (next <= widest[to]) continue;
      widest[to] = next;
      label_[to] = label_[t];
      open.push({next, to});
    }
  }
  std::vector<WayCrossing> found;
  for (std::uint32_t t = 0; t < kind_.size(); ++t) {
    if (label_[t] != -1) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      if (!is_gap_[t][k] || !leads(t, k)) continue;
      WayCrossing crossing;
      crossing.below = t;
      crossing.power = power_[t][k];
      crossing.above = neighbours[t][k].index();
      if (label_[crossing.above] != 1) continue;
      crossing.width_angstrom = clearance_at_gap(space_->face(t, k), &crossing.place_angstrom);
      if (crossing.width_angstrom >= 0) found.push_back(crossing);
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const WayCrossing& a, const WayCrossing& b) {
    return a.width_angstrom > b.width_angstrom;
  });
  return found;
}

std::vector<std::uint32_t> WayGraph::way_out(std::uint32_t from, float power,
                                             const CancelToken& cancel) const {
  using Entry = std::pair<double, std::uint32_t>;
  constexpr double kLeast = 0.1, kEnough = 10;  // Å, as for a channel's curve
  const Lattice& lattice = balls_.lattice;
  const WayCost cost{static_cast<double>(lattice.nearest_units(kLeast)),
                     static_cast<double>(lattice.nearest_units(kEnough)),
                     static_cast<BallIndex>(scene_->original.size())};
  const auto& neighbours = scene_->triangulation.neighbours;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<double> least(kind_.size(), std::numeric_limits<double>::infinity());
  std::vector<std::uint32_t> before(kind_.size(), kNothing);
  least[from] = 0;
  open.push({0, from});
  for (std::size_t steps = 0; !open.empty(); ++steps) {
    if (steps % 1024 == 0) cancel.throw_if_cancelled();
    const auto [own, t] = open.top();
    open.pop();
    if (own > least[t]) continue;
    if (kind_[t] == Kind::outside) {
      std::vector<std::uint32_t> way{t};
      while (before[way.back()] != kNothing) way.push_back(before[way.back()]);
      std::reverse(way.begin(), way.end());
      return way;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      if (width_[t][k] < 0) continue;
      const std::uint32_t to = neighbours[t][k].index();
      if (label_[to] != label_[from] || !may_pass(t, to)) continue;
      if (power_[t][k] < power) continue;
      const double next = own + space_->cost_across(t, k, cost);
      if (next >= least[to]) continue;
      least[to] = next;
      before[to] = t;
      open.push({next, to});
    }
  }
  return {};
}

WayGraph::Route WayGraph::route(const WayCrossing& crossing, const CancelToken& cancel) const {
  Route route{way_out(crossing.below, crossing.power, cancel),
              way_out(crossing.above, crossing.power, cancel), crossing.width_angstrom};
  for (const auto* way : {&route.below, &route.above}) {
    for (std::size_t n = 1; n < way->size(); ++n) {
      const auto& neighbours = scene_->triangulation.neighbours[(*way)[n - 1]];
      std::size_t k = 0;
      while (neighbours[k] != Neighbour::tetrahedron((*way)[n])) ++k;
      if (!space_->is_gap((*way)[n - 1], k)) continue;
      route.width_angstrom =
          std::min(route.width_angstrom, static_cast<double>(width_[(*way)[n - 1]][k]));
    }
  }
  return route;
}

}  // namespace alphascope
