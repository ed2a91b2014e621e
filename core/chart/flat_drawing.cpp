// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the shapes of a flat drawing: circles, power cells and simplices.
#include "core/chart/flat_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/complex/own_dimension.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"

namespace alphascope {
namespace {

FlatPoint centre_of(const BallSet& balls, BallIndex i) {
  const LatticePoint& p = balls.centres[i];
  return {balls.lattice.angstrom(p.x), balls.lattice.angstrom(p.y)};
}

double radius_of(const BallSet& balls, BallIndex i) {
  return balls.lattice.angstrom(balls.radii[i]);
}

double weight_of(const BallSet& balls, BallIndex i) {
  const double r = radius_of(balls, i);
  return r * r;
}

// The points x with normal · x <= offset are kept.
struct HalfPlane {
  FlatPoint normal{};
  double offset = 0;
  double beyond(const FlatPoint& x) const { return normal[0] * x[0] + normal[1] * x[1] - offset; }
};

std::vector<FlatPoint> cut(const std::vector<FlatPoint>& polygon, const HalfPlane& kept) {
  std::vector<FlatPoint> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const FlatPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at_a = kept.beyond(a), at_b = kept.beyond(b);
    if (at_a <= 0) result.push_back(a);
    if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0)) {
      const double t = at_a / (at_a - at_b);
      result.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
    }
  }
  return result;
}

std::vector<FlatPoint> corners(const FlatBox& box) {
  return {box.low, {box.high[0], box.low[1]}, box.high, {box.low[0], box.high[1]}};
}

FlatKind edge_kind(SimplexClass in_the_plane) {
  return in_the_plane == SimplexClass::singular  ? FlatKind::edge_alone
         : in_the_plane == SimplexClass::regular ? FlatKind::edge_boundary
                                                 : FlatKind::edge_inside;
}

class Drawing {
 public:
  Drawing(const BallSet& balls, const AlphaComplex& complex) : balls_(balls), complex_(complex) {}

  std::vector<FlatShape> shapes(const FlatBox& box, const FlatContent& content) {
    if (content.discs) add_discs();
    if (content.cells) add_cells(box);
    if (content.complex) add_complex();
    add_balls();
    add_centres();
    add_orthocircle(content.chosen);
    return std::move(shapes_);
  }

 private:
  std::vector<FlatPoint> centres(std::vector<BallIndex> of) const {
    std::vector<FlatPoint> points;
    for (const BallIndex ball : of) points.push_back(centre_of(balls_, ball));
    return points;
  }
  void add_circle(FlatKind kind, BallIndex ball, double radius) {
    shapes_.push_back({kind, centres({ball}), radius, {ball}});
  }
  double grown_squared(BallIndex ball) const {
    return weight_of(balls_, ball) + complex_.alpha_angstrom2();
  }
  void add_discs() {
    for (BallIndex i = 0; i < balls_.size(); ++i) {
      const double squared = grown_squared(i);
      if (squared > 0) add_circle(FlatKind::grown_disc, i, std::sqrt(squared));
    }
  }
  void add_cells(const FlatBox& box) {
    for (BallIndex i = 0; i < balls_.size(); ++i) {
      auto polygon = power_cell(balls_, i, box);
      if (polygon.size() > 2) shapes_.push_back({FlatKind::cell, std::move(polygon), 0, {i}});
    }
  }
  void add_complex() {
    for (const auto& t : complex_.triangles.simplices) {
      const std::vector<BallIndex> of(t.begin(), t.end());
      shapes_.push_back({FlatKind::triangle, centres(of), 0, of});
    }
    AlphaComplex in_the_plane = complex_;  // classes of a plane, even if the balls are on a line
    set_classes_in(2, in_the_plane);
    const SimplexList<2>& edges = in_the_plane.edges;
    for (std::size_t n = 0; n < edges.size(); ++n) {
      const std::vector<BallIndex> of(edges.simplices[n].begin(), edges.simplices[n].end());
      shapes_.push_back({edge_kind(edges.classes[n]), centres(of), 0, of});
    }
  }
  void add_balls() {
    for (BallIndex i = 0; i < balls_.size(); ++i) {
      add_circle(grown_squared(i) < 0 ? FlatKind::empty_ball : FlatKind::ball, i,
                 radius_of(balls_, i));
    }
  }
  void add_centres() {
    std::vector<bool> there(balls_.size(), false);
    for (const auto& v : complex_.vertices.simplices) there[v[0]] = true;
    for (BallIndex i = 0; i < balls_.size(); ++i) {
      add_circle(there[i] ? FlatKind::vertex : FlatKind::no_vertex, i, 0);
    }
  }
  void add_orthocircle(const std::vector<BallIndex>& chosen) {
    const Orthocircle circle = orthocircle(balls_, chosen);
    if (!circle.any) return;
    shapes_.push_back({FlatKind::orthocentre, {circle.centre}, 0, chosen});
    if (circle.squared_radius <= 0) return;
    shapes_.push_back(
        {FlatKind::orthocircle, {circle.centre}, std::sqrt(circle.squared_radius), chosen});
  }

  const BallSet& balls_;
  const AlphaComplex& complex_;
  std::vector<FlatShape> shapes_;
};

}  // namespace

bool is_flat(const BallSet& balls) {
  return std::all_of(balls.centres.begin(), balls.centres.end(),
                     [](const LatticePoint& p) { return p.z == 0; });
}

FlatBox box_of(const BallSet& balls, double alpha_angstrom2) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  FlatBox box{{kInfinite, kInfinite}, {-kInfinite, -kInfinite}};
  for (BallIndex i = 0; i < balls.size(); ++i) {
    const double radius = std::sqrt(weight_of(balls, i) + std::max(0.0, alpha_angstrom2));
    const FlatPoint centre = centre_of(balls, i);
    for (int d = 0; d < 2; ++d) {
      box.low[d] = std::min(box.low[d], centre[d] - radius);
      box.high[d] = std::max(box.high[d], centre[d] + radius);
    }
  }
  if (balls.size() == 0) box = {{-5, -5}, {5, 5}};
  constexpr double kMargin = 0.08;  // margin on each side, as a share of the longer side
  const double margin = kMargin * std::max(box.width(), box.height());
  for (int d = 0; d < 2; ++d) {
    box.low[d] -= margin;
    box.high[d] += margin;
  }
  return box;
}

std::vector<FlatShape> flat_shapes(const BallSet& balls, const AlphaComplex& complex,
                                   const FlatBox& box, const FlatContent& content) {
  if (!is_flat(balls)) {
    throw std::invalid_argument(
        "Only balls in the plane z = 0 can be drawn flat, and some of these are not in it.");
  }
  return Drawing(balls, complex).shapes(box, content);
}

std::vector<FlatPoint> power_cell(const BallSet& balls, BallIndex ball, const FlatBox& box) {
  std::vector<FlatPoint> cell = corners(box);
  const FlatPoint centre = centre_of(balls, ball);
  const double weight = weight_of(balls, ball);
  for (BallIndex other = 0; other < balls.size() && !cell.empty(); ++other) {
    if (other == ball) continue;
    const FlatPoint q = centre_of(balls, other);
    const double other_weight = weight_of(balls, other);
    const FlatPoint along{q[0] - centre[0], q[1] - centre[1]};
    if (along[0] == 0 && along[1] == 0) {
      const bool behind = other_weight > weight || (other_weight == weight && other < ball);
      if (behind) cell.clear();
      continue;
    }
    // Relative to the centre, so that no digits are lost far from the origin.
    const double squared = along[0] * along[0] + along[1] * along[1];
    const double offset = 0.5 * (squared + weight - other_weight);
    cell = cut(cell, {along, offset + along[0] * centre[0] + along[1] * centre[1]});
  }
  return cell;
}

// The centre c has equal power to all balls, and the least such power. So, with c in
// the span of the centres, each other ball q has
// (q - p) · (c - p) = (|q - p|² + w(p) - w(q)) / 2.
Orthocircle orthocircle(const BallSet& balls, const std::vector<BallIndex>& of) {
  if (of.empty() || of.size() > 3) return {};
  const FlatPoint p = centre_of(balls, of[0]);
  const double weight = weight_of(balls, of[0]);
  std::array<FlatPoint, 2> along{};
  std::array<double, 2> rest{};
  for (std::size_t k = 1; k < of.size(); ++k) {
    const FlatPoint q = centre_of(balls, of[k]);
    along[k - 1] = {q[0] - p[0], q[1] - p[1]};
    const auto& a = along[k - 1];
    rest[k - 1] = 0.5 * (a[0] * a[0] + a[1] * a[1] + weight - weight_of(balls, of[k]));
  }
  const auto& [a, b] = along;
  FlatPoint step{};
  if (of.size() == 2) {
    const double squared = a[0] * a[0] + a[1] * a[1];
    if (squared == 0) return {};
    step = {a[0] * rest[0] / squared, a[1] * rest[0] / squared};
  } else if (of.size() == 3) {
    const double area = a[0] * b[1] - a[1] * b[0];
    if (area == 0) return {};
    step = {(rest[0] * b[1] - rest[1] * a[1]) / area, (a[0] * rest[1] - b[0] * rest[0]) / area};
  }
  return {{p[0] + step[0], p[1] + step[1]}, step[0] * step[0] + step[1] * step[1] - weight, true};
}

}  // namespace alphascope
