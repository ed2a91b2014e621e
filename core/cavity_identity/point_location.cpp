// SPDX-License-Identifier: GPL-3.0-or-later
// Locates points by walking through tetrahedra, with exact tests and a grid of starts.
#include "core/cavity_identity/point_location.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/geometry/alpha.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/predicates/lifted.hpp"
#include "core/predicates/wide_int.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

using Vector = Vector3<std::int64_t>;

Vector difference(const LatticePoint& a, const LatticePoint& b) {
  return {std::int64_t{a.x} - b.x, std::int64_t{a.y} - b.y, std::int64_t{a.z} - b.z};
}

// Returns on which side of the plane through `a` with this normal a place is: +1 where the normal
// points. Bits needed: 61 for coordinates of the normal, 30 for the difference, 2 for `times`.
int side_of_plane(const LatticePoint& a, const Vector& normal, const LatticePlace& place) {
  const Int128 along = static_cast<Int128>(normal.x) * (place.x - std::int64_t{place.times} * a.x) +
                       static_cast<Int128>(normal.y) * (place.y - std::int64_t{place.times} * a.y) +
                       static_cast<Int128>(normal.z) * (place.z - std::int64_t{place.times} * a.z);
  if (along != 0) return sign_of(along);
  const std::int64_t moved = normal.x != 0 ? normal.x : normal.y != 0 ? normal.y : normal.z;
  return moved > 0 ? 1 : -1;  // The normal is not 0, because no face is a line.
}

// Returns whether the place is beyond the face opposite ball number k of these four.
bool is_beyond(const LatticePlace& place, const std::vector<LatticePoint>& centres,
               const std::array<BallIndex, 4>& balls, std::size_t k) {
  const LatticePoint& a = centres[balls[k == 0 ? 1 : 0]];
  const LatticePoint& b = centres[balls[k <= 1 ? 2 : 1]];
  const LatticePoint& c = centres[balls[k <= 2 ? 3 : 2]];
  const LatticePoint& inner = centres[balls[k]];
  const Vector normal = cross(difference(b, a), difference(c, a));
  return side_of_plane(a, normal, place) != side_of_plane(a, normal, {inner.x, inner.y, inner.z});
}

// Other threads may raise the same number.
void raise_to(std::uint32_t& number, std::uint32_t least) {
  const std::atomic_ref<std::uint32_t> shared(number);
  std::uint32_t now = shared.load(std::memory_order_relaxed);
  while (now < least && !shared.compare_exchange_weak(now, least, std::memory_order_relaxed)) {
  }
}

}  // namespace

LatticePlace place_on(const Lattice& finer, const LatticePoint& point, const Lattice& lattice) {
  std::int64_t factor = 1;
  for (int digits = lattice.digits; digits < finer.digits; ++digits) factor *= 10;
  return {point.x * factor, point.y * factor, point.z * factor, 1};
}

PointLocator::PointLocator(const BallSet& balls, const Triangulation& triangulation)
    : balls_(balls), triangulation_(triangulation) {
  if (triangulation.tetrahedra.empty()) return;
  set_box();
  set_cells();
}

void PointLocator::set_box() {
  low_ = high_ = balls_.centres[triangulation_.vertices.front()];
  for (const BallIndex v : triangulation_.vertices) {
    const LatticePoint& p = balls_.centres[v];
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
  }
}

// Makes about one cell for every four vertices, if these fill the box.
void PointLocator::set_cells() {
  constexpr double kVertices = 4, kMostCells = 512;  // cells along one axis
  const Vector size = difference(high_, low_);
  const double x = static_cast<double>(size.x) + 1, y = static_cast<double>(size.y) + 1,
               z = static_cast<double>(size.z) + 1;
  const double cells = static_cast<double>(triangulation_.vertices.size()) / kVertices + 1;
  side_ = std::max({std::cbrt(x * y * z / cells), std::max({x, y, z}) / kMostCells, 1.0});
  const auto count = [&](double length) { return static_cast<std::size_t>(length / side_) + 1; };
  cells_x_ = count(x);
  cells_y_ = count(y);
  cells_z_ = count(z);
  near_.assign(cells_x_ * cells_y_ * cells_z_, 0);
  const Simplices<4>& tetrahedra = triangulation_.tetrahedra;
  constexpr std::size_t kGrain = 4096;
  // Of each cell the last tetrahedron whose first vertex is in it, plus 1. The first vertices are
  // in ascending order.
  parallel_ranges(0, tetrahedra.size(), kGrain, [&](std::size_t first, std::size_t end) {
    for (std::size_t t = first; t != end; ++t) {
      const BallIndex v = tetrahedra[t][0];
      if (t + 1 != end && tetrahedra[t + 1][0] == v) continue;
      const LatticePoint& p = balls_.centres[v];
      raise_to(near_[cell_of({p.x, p.y, p.z})], static_cast<std::uint32_t>(t + 1));
    }
  });
  std::uint32_t near = 0;  // an empty cell takes the start of the last cell that is not empty
  for (std::uint32_t& t : near_) near = t = t == 0 ? near : t - 1;
}

bool PointLocator::is_in_box(const LatticePlace& place) const {
  const std::int64_t n = place.times;
  return place.x >= n * low_.x && place.x <= n * high_.x && place.y >= n * low_.y &&
         place.y <= n * high_.y && place.z >= n * low_.z && place.z <= n * high_.z;
}

std::size_t PointLocator::cell_of(const LatticePlace& place) const {
  const auto index = [&](std::int64_t at, std::int32_t low, std::size_t count) {
    const double from_low = static_cast<double>(at) / place.times - low;
    return std::min(static_cast<std::size_t>(std::max(from_low, 0.0) / side_), count - 1);
  };
  return (index(place.z, low_.z, cells_z_) * cells_y_ + index(place.y, low_.y, cells_y_)) *
             cells_x_ +
         index(place.x, low_.x, cells_x_);
}

std::uint32_t PointLocator::find(const LatticePlace& place) const {
  if (near_.empty() || !is_in_box(place)) return kOutside;
  return find(place, near_[cell_of(place)]);
}

std::uint32_t PointLocator::find(const LatticePlace& place, std::uint32_t start) const {
  if (near_.empty() || !is_in_box(place)) return kOutside;
  return walk_to(place, balls_, triangulation_, start);
}

std::uint32_t walk_to(const LatticePlace& place, const BallSet& balls,
                      const Triangulation& triangulation, std::uint32_t start) {
  std::uint32_t t = start, from = kOutsideHull;
  for (;;) {
    std::size_t k = 0;
    const auto is_way_on = [&] {
      const Neighbour next = triangulation.neighbours[t][k];
      return (next.is_hull() || next.index() != from) &&
             is_beyond(place, balls.centres, triangulation.tetrahedra[t], k);
    };
    while (k < 4 && !is_way_on()) ++k;
    if (k == 4) return t;
    const Neighbour next = triangulation.neighbours[t][k];
    if (next.is_hull()) return kOutsideHull;
    from = t;
    t = next.index();
  }
}

}  // namespace alphascope
