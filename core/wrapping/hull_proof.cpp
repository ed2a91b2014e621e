// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a hull edge by edge and along one ray.
#include "core/wrapping/hull_proof.hpp"

#include <algorithm>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/int128.hpp"
#include "core/predicates/wide_int.hpp"

namespace alphascope {
namespace {

using Vector = std::array<std::int64_t, 3>;

Vector difference(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector sum(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

// The sign of det(a, b, c), for coordinates below 2^34.
int side(const Vector& a, const Vector& b, const Vector& c) {
  const auto term = [&](int x, int y, int z) {
    return (Int128{a[y]} * b[z] - Int128{a[z]} * b[y]) * c[x];
  };
  return sign_of(term(0, 1, 2) + term(1, 2, 0) + term(2, 0, 1));
}

// An edge of a facet, from `low` to `high` or the other way.
struct FacetEdge {
  BallIndex low, high;
  bool forward;
  std::uint32_t facet;
  BallIndex apex;
};

class Surface {
 public:
  // Coordinates are multiplied by 12, so that the middles of a facet and of a tetrahedron are whole
  // numbers. They are below 2^33 then.
  Surface(const BallSet& balls, const std::vector<HullFacet>& hull,
          const std::array<BallIndex, 4>& inside)
      : balls_(balls), hull_(hull) {
    for (const BallIndex i : inside) {
      const Vector p = position(i);
      inside_ = sum(inside_, {p[0] / 4, p[1] / 4, p[2] / 4});
    }
  }

  // Is each edge of two facets that are oriented alike and convex?
  bool closed_and_convex() const {
    std::vector<FacetEdge> edges;
    edges.reserve(3 * hull_.size());
    for (std::uint32_t f = 0; f < hull_.size(); ++f) {
      const auto& b = hull_[f].balls;
      for (int n = 0; n < 3; ++n) {
        const BallIndex from = b[n], to = b[(n + 1) % 3];
        edges.push_back({std::min(from, to), std::max(from, to), from < to, f, b[(n + 2) % 3]});
      }
    }
    std::sort(edges.begin(), edges.end(), [](const FacetEdge& a, const FacetEdge& b) {
      return std::pair(a.low, a.high) < std::pair(b.low, b.high);
    });
    const auto same = [&](std::size_t a, std::size_t b) {
      return edges[a].low == edges[b].low && edges[a].high == edges[b].high;
    };
    for (std::size_t e = 0; e < edges.size(); e += 2) {
      if (e + 1 >= edges.size() || !same(e, e + 1) || (e + 2 < edges.size() && same(e, e + 2)))
        return false;
      if (edges[e].forward == edges[e + 1].forward) return false;
      if (side_of_facet(hull_[edges[e].facet], position(edges[e + 1].apex)) > 0) return false;
    }
    return true;
  }

  // Is a point of the first tetrahedron behind all facets, and does one ray meet only one?
  bool met_once() const {
    Vector ray{};
    for (const BallIndex i : hull_[0].balls) {
      const Vector p = position(i);
      ray = sum(ray, {p[0] / 3, p[1] / 3, p[2] / 3});
    }
    ray = difference(ray, inside_);
    std::size_t met = 0;
    for (const HullFacet& facet : hull_) {
      const Vector a = from_inside(facet.balls[0]), b = from_inside(facet.balls[1]),
                   c = from_inside(facet.balls[2]);
      if (side(a, b, c) <= 0) return false;
      met += side(ray, b, c) >= 0 && side(a, ray, c) >= 0 && side(a, b, ray) >= 0;
    }
    return met == 1;
  }

 private:
  Vector position(BallIndex i) const {
    const LatticePoint& p = balls_.centres[i];
    return {std::int64_t{12} * p.x, std::int64_t{12} * p.y, std::int64_t{12} * p.z};
  }
  Vector from_inside(BallIndex i) const { return difference(position(i), inside_); }
  // +1 outside.
  int side_of_facet(const HullFacet& facet, const Vector& point) const {
    const Vector from = position(facet.balls[0]);
    return side(difference(position(facet.balls[1]), from),
                difference(position(facet.balls[2]), from), difference(point, from));
  }

  const BallSet& balls_;
  const std::vector<HullFacet>& hull_;
  Vector inside_{};  // the middle of the first tetrahedron
};

}  // namespace

bool encloses_once(const BallSet& balls, const std::vector<HullFacet>& hull,
                   const std::array<BallIndex, 4>& inside) {
  if (hull.empty()) return false;
  const Surface surface(balls, hull, inside);
  return surface.closed_and_convex() && surface.met_once();
}

}  // namespace alphascope
