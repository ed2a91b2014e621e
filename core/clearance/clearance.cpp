// SPDX-License-Identifier: GPL-3.0-or-later
// Clearance of points by a tree of boxes.
#include "core/clearance/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace alphascope {
namespace {

constexpr std::uint32_t kLeafSize = 8;
// A path has fewer nodes than this, since halves of 2^32 balls are leaves after 30 steps.
constexpr std::size_t kMostDepth = 40;

// Among balls with equal centres only the largest with the lowest index. A million of them would
// share one leaf.
std::vector<BallIndex> outermost_by_centre(const BallSet& balls) {
  std::vector<BallIndex> order(balls.size());
  std::iota(order.begin(), order.end(), BallIndex{0});
  std::sort(order.begin(), order.end(), [&](BallIndex a, BallIndex b) {
    if (balls.centres[a] != balls.centres[b]) return balls.centres[a] < balls.centres[b];
    return balls.radii[a] != balls.radii[b] ? balls.radii[a] > balls.radii[b] : a < b;
  });
  order.erase(
      std::unique(order.begin(), order.end(),
                  [&](BallIndex a, BallIndex b) { return balls.centres[a] == balls.centres[b]; }),
      order.end());
  return order;
}

// The distance from x to a surface. Lattice units.
inline double surface_distance(const RealPoint& x, const LatticePoint& centre,
                               std::int32_t radius) {
  const double dx = x.x - centre.x, dy = x.y - centre.y, dz = x.z - centre.z;
  return std::sqrt(dx * dx + dy * dy + dz * dz) - radius;
}

}  // namespace

Clearance::Clearance(const BallSet& balls) : unit_(balls.lattice.unit_angstrom()) {
  for (const BallIndex i : outermost_by_centre(balls)) {
    slots_.push_back({balls.centres[i], balls.radii[i], i});
  }
  if (!slots_.empty()) build(0, static_cast<std::uint32_t>(slots_.size()));
}

// Halves the slots along the longest side of their box.
void Clearance::build(std::uint32_t first, std::uint32_t end) {
  const std::size_t own = nodes_.size();
  Node node{slots_[first].centre, slots_[first].centre, 0, first, end, 0};
  for (std::uint32_t s = first; s < end; ++s) {
    const LatticePoint& p = slots_[s].centre;
    node.low = {std::min(node.low.x, p.x), std::min(node.low.y, p.y), std::min(node.low.z, p.z)};
    node.high = {std::max(node.high.x, p.x), std::max(node.high.y, p.y),
                 std::max(node.high.z, p.z)};
    node.most_radius = std::max(node.most_radius, slots_[s].radius);
  }
  nodes_.push_back(node);
  if (end - first <= kLeafSize) return;
  const RealPoint size = real_point(node.high) - real_point(node.low);
  const auto split = [&](std::int32_t LatticePoint::*along) {
    const std::uint32_t middle = first + (end - first) / 2;
    std::nth_element(slots_.begin() + first, slots_.begin() + middle, slots_.begin() + end,
                     [&](const Slot& a, const Slot& b) {
                       return a.centre.*along != b.centre.*along ? a.centre.*along < b.centre.*along
                                                                 : a.ball < b.ball;
                     });
    build(first, middle);
    nodes_[own].second = static_cast<std::uint32_t>(nodes_.size());
    build(middle, end);
  };
  if (size.x >= size.y && size.x >= size.z) {
    split(&LatticePoint::x);
  } else {
    split(size.y >= size.z ? &LatticePoint::y : &LatticePoint::z);
  }
}

// The square of the distance from x to the box of a node.
inline double Clearance::square_distance(const RealPoint& x, const Node& node) {
  const auto beyond = [](double at, std::int32_t low, std::int32_t high) {
    return std::max(std::max(low - at, at - high), 0.0);
  };
  const double dx = beyond(x.x, node.low.x, node.high.x), dy = beyond(x.y, node.low.y, node.high.y),
               dz = beyond(x.z, node.low.z, node.high.z);
  return dx * dx + dy * dy + dz * dz;
}

template <class Visit>
void Clearance::visit_leaves(const RealPoint& x, const double& most, const Visit& visit) const {
  if (nodes_.empty()) return;
  // The slack is above the rounding errors of distances: nothing is skipped because of them.
  constexpr double kSlack = 1e-14;
  struct Open {
    double square;
    std::uint32_t node;
  };
  std::array<Open, kMostDepth> open;
  std::size_t count = 0;
  Open next{square_distance(x, nodes_[0]), 0};
  while (true) {
    const Node& node = nodes_[next.node];
    const double radius = node.most_radius;
    const double reach = (most + radius) + kSlack * (std::fabs(most) + radius);
    const bool is_in_reach = reach >= 0 && next.square <= (1 + kSlack) * (reach * reach);
    if (is_in_reach && node.second != 0) {
      Open near{square_distance(x, nodes_[next.node + 1]), next.node + 1};
      Open far{square_distance(x, nodes_[node.second]), node.second};
      if (far.square < near.square) std::swap(near, far);
      open[count++] = far;
      next = near;
      continue;
    }
    if (is_in_reach) visit(node);
    if (count == 0) return;
    next = open[--count];
  }
}

Surface Clearance::nearest(const RealPoint& x_angstrom) const {
  const RealPoint x = (1 / unit_) * x_angstrom;
  double best = std::numeric_limits<double>::infinity();
  Slot nearest{};
  visit_leaves(x, best, [&](const Node& leaf) {
    for (std::uint32_t s = leaf.first; s < leaf.end; ++s) {
      const Slot& slot = slots_[s];
      const double distance = surface_distance(x, slot.centre, slot.radius);
      if (distance > best || (distance == best && slot.ball > nearest.ball)) continue;
      best = distance;
      nearest = slot;
    }
  });
  return {best * unit_, nearest.ball, unit_vector(x - real_point(nearest.centre))};
}

void Clearance::collect(const RealPoint& x_angstrom, double most_angstrom,
                        std::vector<Surface>& out) const {
  out.clear();
  const RealPoint x = (1 / unit_) * x_angstrom;
  const double most = most_angstrom / unit_;
  visit_leaves(x, most, [&](const Node& leaf) {
    for (std::uint32_t s = leaf.first; s < leaf.end; ++s) {
      const Slot& slot = slots_[s];
      const double distance = surface_distance(x, slot.centre, slot.radius);
      if (distance > most) continue;
      out.push_back({distance * unit_, slot.ball, unit_vector(x - real_point(slot.centre))});
    }
  });
  std::sort(out.begin(), out.end(), [](const Surface& a, const Surface& b) {
    return a.distance_angstrom != b.distance_angstrom ? a.distance_angstrom < b.distance_angstrom
                                                      : a.ball < b.ball;
  });
}

// Clearance and the distance of each surface change by no more than the distance between two
// points. So a surface at most value(x) + around from x is at most value(middle) + 2 |x - middle| +
// around from the middle.
double ClearanceNearby::look_around(const RealPoint& x_angstrom, double around_angstrom) {
  constexpr double kRounding = 1e-9, kKeptFor = 0.45, kBeside = 1;  // Å
  const double moved = slots_.empty() ? 0 : length(x_angstrom - middle_);
  const double around = around_angstrom + kRounding;
  if (!slots_.empty() && value_ + 2 * moved + around <= most_) return at(x_angstrom);
  // Of balls from a place beside it, the nearest is not much farther away than the nearest of all.
  const bool is_beside = !slots_.empty() && moved <= kBeside;
  const double upper = is_beside ? at(x_angstrom) : clearance_.at(x_angstrom);
  middle_ = x_angstrom;
  most_ = upper + around + 2 * kKeptFor;
  slots_.clear();
  const RealPoint x = (1 / clearance_.unit_) * x_angstrom;
  const double most = most_ / clearance_.unit_;
  clearance_.visit_leaves(x, most, [&](const Clearance::Node& leaf) {
    for (std::uint32_t s = leaf.first; s < leaf.end; ++s) {
      const Clearance::Slot& slot = clearance_.slots_[s];
      if (surface_distance(x, slot.centre, slot.radius) <= most) slots_.push_back(slot);
    }
  });
  value_ = at(x_angstrom);
  return value_;
}

double ClearanceNearby::at(const RealPoint& x_angstrom) const {
  const RealPoint x = (1 / clearance_.unit_) * x_angstrom;
  double best = std::numeric_limits<double>::infinity();
  for (const Clearance::Slot& slot : slots_) {
    best = std::min(best, surface_distance(x, slot.centre, slot.radius));
  }
  return best * clearance_.unit_;
}

void ClearanceNearby::collect(const RealPoint& x_angstrom, double most_angstrom, std::size_t count,
                              std::vector<Surface>& out) {
  out.clear();
  near_.clear();
  const RealPoint x = (1 / clearance_.unit_) * x_angstrom;
  const double most = most_angstrom / clearance_.unit_;
  for (std::uint32_t s = 0; s < slots_.size(); ++s) {
    const double distance = surface_distance(x, slots_[s].centre, slots_[s].radius);
    if (distance <= most) near_.push_back({distance * clearance_.unit_, s});
  }
  const auto end = near_.begin() + static_cast<std::ptrdiff_t>(std::min(count, near_.size()));
  std::partial_sort(near_.begin(), end, near_.end(), [&](const Near& a, const Near& b) {
    return a.distance_angstrom != b.distance_angstrom ? a.distance_angstrom < b.distance_angstrom
                                                      : slots_[a.slot].ball < slots_[b.slot].ball;
  });
  near_.erase(end, near_.end());
  for (const Near& near : near_) {
    const Clearance::Slot& slot = slots_[near.slot];
    out.push_back({near.distance_angstrom, slot.ball, unit_vector(x - real_point(slot.centre))});
  }
}

}  // namespace alphascope
