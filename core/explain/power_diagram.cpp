// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts the faces of a power diagram as polygons out of planes.
#include "core/explain/power_diagram.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace alphascope {
namespace {

using Polygon = std::vector<RealPoint>;

// The box' extra margin on each side, as a share of the diagonal of all balls
constexpr double kBeyond = 0.1;

// The points x with normal · x <= offset are kept.
struct HalfSpace {
  RealPoint normal;
  double offset = 0;
  double beyond(const RealPoint& x) const { return dot(normal, x) - offset; }
};

Polygon cut(const Polygon& polygon, const HalfSpace& kept) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RealPoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double at_p = kept.beyond(p), at_q = kept.beyond(q);
    if (at_p <= 0) result.push_back(p);
    if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) {
      result.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
  }
  return result;
}

class Diagram {
 public:
  explicit Diagram(const BallSet& balls) {
    const double unit = balls.lattice.unit_angstrom();
    RealPoint low, high;
    for (BallIndex i = 0; i < balls.size(); ++i) {
      const RealPoint centre = unit * real_point(balls.centres[i]);
      const double radius = balls.lattice.angstrom(balls.radii[i]);
      centres_.push_back(centre);
      squares_.push_back(radius * radius);
      const RealPoint reach{radius, radius, radius};
      const RealPoint from = centre - reach, to = centre + reach;
      low = i == 0 ? from
                   : RealPoint{std::min(low.x, from.x), std::min(low.y, from.y),
                               std::min(low.z, from.z)};
      high = i == 0 ? to
                    : RealPoint{std::max(high.x, to.x), std::max(high.y, to.y),
                                std::max(high.z, to.z)};
    }
    reach_ = length(high - low);
    const double more = kBeyond * reach_;
    sides_ = {{{1, 0, 0}, high.x + more}, {{0, 1, 0}, high.y + more}, {{0, 0, 1}, high.z + more},
              {{-1, 0, 0}, more - low.x}, {{0, -1, 0}, more - low.y}, {{0, 0, -1}, more - low.z}};
  }

  // The border between the cells of a and b. Fewer than three corners: there is none.
  Polygon face(std::size_t a, std::size_t b) const {
    const auto of_a = least_beside(a, b);
    if (!of_a) return {};
    Polygon polygon = plane_of(*of_a, centres_[a]);
    for (const HalfSpace& side : sides_) polygon = cut(polygon, side);
    for (std::size_t k = 0; k < centres_.size() && polygon.size() > 2; ++k) {
      if (k == a || k == b) continue;
      if (const auto kept = least_beside(a, k)) {
        polygon = cut(polygon, *kept);
      } else if (squares_[k] > squares_[a] || (squares_[k] == squares_[a] && k < a)) {
        return {};  // ball a has no cell
      }
    }
    return polygon;
  }

 private:
  // The half-space where the power to a is at most that to b; empty if both have one centre.
  std::optional<HalfSpace> least_beside(std::size_t a, std::size_t b) const {
    const RealPoint along = centres_[b] - centres_[a];
    const double distance = length(along);
    if (distance == 0) return std::nullopt;
    const double from_a = (distance * distance + squares_[a] - squares_[b]) / (2 * distance);
    const RealPoint normal = (1 / distance) * along;
    return HalfSpace{normal, dot(normal, centres_[a]) + from_a};
  }

  // A square in the half-space's border plane that reaches beyond the box.
  Polygon plane_of(const HalfSpace& half, const RealPoint& near) const {
    const RealPoint middle = near - half.beyond(near) * half.normal;
    RealPoint u, v;
    normals_of(half.normal, u, v);
    const double far = 4 * reach_ + length(middle - near);
    return {middle - far * u - far * v, middle + far * u - far * v, middle + far * u + far * v,
            middle - far * u + far * v};
  }

  std::vector<RealPoint> centres_;  // Å
  std::vector<double> squares_;     // squared radii, Å²
  std::vector<HalfSpace> sides_;    // of the box
  double reach_ = 0;                // diagonal of the box around all balls, Å
};

}  // namespace

std::vector<PowerFace> power_diagram(const BallSet& balls) {
  std::vector<PowerFace> faces;
  if (balls.size() > kMostBallsOfDiagram) return faces;
  const Diagram diagram(balls);
  for (BallIndex a = 0; a < balls.size(); ++a) {
    for (BallIndex b = a + 1; b < balls.size(); ++b) {
      std::vector<RealPoint> corners = diagram.face(a, b);
      if (corners.size() > 2) faces.push_back({a, b, std::move(corners)});
    }
  }
  return faces;
}

}  // namespace alphascope
