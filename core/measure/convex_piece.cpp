// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts a convex polyhedron by planes, and integrates a ball around the origin over its faces.
#include "core/measure/convex_piece.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace alphascope {
namespace {

using Point = Vector3<double>;

Point minus(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

// The parts of a face inside and beyond a circle around the foot of the origin.
struct FaceShare {
  double area = 0;   // area inside the circle
  double angle = 0;  // solid angle at the origin of the part beyond, with the sign of the distance
};

// Adds the solid angle of the triangle of the foot and an edge of the face, which lies wholly
// beyond the circle. The edge is on a line at distance x from the foot, from a to b along that
// line; `ga` and `gb` are the distances of its ends from the origin. In polar coordinates around
// the foot, the solid angle is that of a cone minus one with the edge as base. The antiderivative
// of the latter is arctan(h s / x g).
struct Beyond {
  double h, x;
  double cosine;         // h / R, or the sign of h without a circle
  double square_circle;  // 0 without a circle

  void add(double a, double ga, double b, double gb, FaceShare& share) const {
    const double turn = std::atan2(x * (b - a), x * x + a * b);
    const double lost = std::atan2(h * x * (b * ga - a * gb), x * x * ga * gb + h * h * a * b);
    share.area += 0.5 * square_circle * turn;
    share.angle += cosine * turn - lost;
  }
};

class FaceIntegral {
 public:
  FaceIntegral(const PieceFace& face, double radius)
      : normal_(face.normal),
        h_(face.distance),
        radius_(radius),
        square_circle_(std::max(0.0, (radius - std::fabs(h_)) * (radius + std::fabs(h_)))),
        cosine_(std::fabs(h_) < radius ? h_ / radius : std::copysign(1.0, h_)) {}

  void add_edge(const Point& p, const Point& q) {
    const Point e = minus(q, p);
    const double length = std::sqrt(dot(e, e));
    if (length == 0) return;
    const Point along = {e.x / length, e.y / length, e.z / length};
    const double x = dot(p, cross(along, normal_));
    const double a = dot(p, along), b = dot(q, along);
    const double square_half = square_circle_ - x * x;
    const Beyond beyond = {h_, x, cosine_, square_circle_};
    const auto from_origin = [&](double s) { return std::sqrt(h_ * h_ + x * x + s * s); };
    if (square_half <= 0 || b <= -std::sqrt(square_half) || a >= std::sqrt(square_half)) {
      beyond.add(a, from_origin(a), b, from_origin(b), share_);
      return;
    }
    const double half = std::sqrt(square_half);
    if (a < -half) beyond.add(a, from_origin(a), -half, radius_, share_);
    share_.area += 0.5 * x * (std::min(b, half) - std::max(a, -half));
    if (b > half) beyond.add(half, radius_, b, from_origin(b), share_);
  }
  const FaceShare& share() const { return share_; }

 private:
  Point normal_;
  double h_, radius_, square_circle_, cosine_;
  FaceShare share_;
};

}  // namespace

void ConvexPiece::start(const Point (&corner)[4], const PieceFace (&face)[4], bool is_mirrored) {
  static constexpr std::uint32_t kLoop[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  corners_.assign(corner, corner + 4);
  loops_.clear();
  indices_.clear();
  for (std::uint32_t m = 0; m < 4; ++m) {
    loops_.push_back({face[m], 3 * m, 3});
    indices_.insert(indices_.end(), kLoop[m], kLoop[m] + 3);
    if (is_mirrored) std::swap(indices_[3 * m + 1], indices_[3 * m + 2]);
  }
  measure_reach();
}

std::uint32_t ConvexPiece::crossing(std::uint32_t in, std::uint32_t out) {
  for (std::uint32_t c = 0; c < crossings_.size(); ++c) {
    if (crossings_[c].in == in && crossings_[c].out == out) return c;
  }
  const double inside = std::max(0.0, side_[in]);
  const double at = inside / (inside - side_[out]);
  const Point p = corners_[in], e = minus(corners_[out], p);
  crossings_.push_back({in, out, static_cast<std::uint32_t>(corners_.size())});
  corners_.push_back({p.x + at * e.x, p.y + at * e.y, p.z + at * e.z});
  return static_cast<std::uint32_t>(crossings_.size() - 1);
}

// Drops corners that are cut off, so that later cuts do not process them.
void ConvexPiece::forget_corners() {
  constexpr std::uint32_t kUnused = 0xffffffff;
  place_.assign(corners_.size(), kUnused);
  std::uint32_t kept = 0;
  for (std::uint32_t& i : indices_) {
    if (place_[i] == kUnused) {
      place_[i] = kept++;
      kept_corners_.push_back(corners_[i]);
    }
    i = place_[i];
  }
  corners_.swap(kept_corners_);
  kept_corners_.clear();
  measure_reach();
}

void ConvexPiece::measure_reach() {
  double square = 0;
  for (const Point& p : corners_) square = std::max(square, dot(p, p));
  reach_ = std::sqrt(square);
}

bool ConvexPiece::cut(const Point& normal, double offset, double length, std::uint32_t made_by) {
  // Corners and sides are known only up to some roundings of this size, so a cut below it is
  // skipped. Otherwise, where many cells meet in a point, their planes would cut off slivers
  // without thickness.
  const double slack = kSlack * (std::fabs(offset) + length * reach_);
  side_.resize(corners_.size());
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const double side = offset - dot(normal, corners_[i]);
    side_[i] = side;
    least = std::min(least, side);
    most = std::max(most, side);
  }
  if (least >= -slack) return true;
  if (most <= slack) {
    loops_.clear();
    indices_.clear();
    corners_.clear();
    return false;
  }
  const auto is_in = [&](std::uint32_t i) { return side_[i] >= -slack; };
  crossings_.clear();
  kept_loops_.clear();
  kept_indices_.clear();
  for (const Loop& loop : loops_) {
    const auto first = static_cast<std::uint32_t>(kept_indices_.size());
    const auto corners = corners_of(loop);
    // The boundary of the face leaves and comes back. The new face has the opposite direction.
    std::uint32_t left = 0, back = 0;
    bool is_out = false, came_first = false;
    for (std::size_t n = 0; n < corners.size(); ++n) {
      const std::uint32_t u = corners[n], v = corners[n + 1 < corners.size() ? n + 1 : 0];
      const bool u_in = is_in(u), v_in = is_in(v);
      if (u_in) kept_indices_.push_back(u);
      if (u_in == v_in) continue;
      const std::uint32_t c = u_in ? crossing(u, v) : crossing(v, u);
      kept_indices_.push_back(crossings_[c].corner);
      if (u_in) {
        left = c;
        is_out = true;
      } else if (is_out) {
        crossings_[c].next = left;
        is_out = false;
      } else {
        back = c;
        came_first = true;
      }
    }
    if (came_first) crossings_[back].next = left;
    if (kept_indices_.size() == first) continue;
    kept_loops_.push_back(
        {loop.face, first, static_cast<std::uint32_t>(kept_indices_.size()) - first});
  }
  loops_.swap(kept_loops_);
  indices_.swap(kept_indices_);
  add_loops(normal, offset, length, made_by);
  forget_corners();
  return true;
}

void ConvexPiece::add_loops(const Point& normal, double offset, double length,
                            std::uint32_t made_by) {
  const PieceFace face = {
      {normal.x / length, normal.y / length, normal.z / length}, offset / length, made_by};
  constexpr std::uint32_t kTaken = 0xffffffff;
  for (std::uint32_t start = 0; start < crossings_.size(); ++start) {
    const auto first = static_cast<std::uint32_t>(indices_.size());
    for (std::uint32_t c = start; crossings_[c].next != kTaken;) {
      indices_.push_back(crossings_[c].corner);
      c = std::exchange(crossings_[c].next, kTaken);
    }
    const auto count = static_cast<std::uint32_t>(indices_.size()) - first;
    if (count > 0) loops_.push_back({face, first, count});
  }
}

double ConvexPiece::volume() const {
  double six = 0;
  for (const Loop& loop : loops_) {
    const auto at = corners_of(loop);
    for (std::size_t n = 2; n < at.size(); ++n) {
      six += dot(corners_[at[0]], cross(corners_[at[n - 1]], corners_[at[n]]));
    }
  }
  return six / 6;
}

SharedMeasures ConvexPiece::shared_with_ball(double radius) const {
  SharedMeasures shared;
  for (const Loop& loop : loops_) {
    const double h = loop.face.distance;
    if (h <= -radius) return {};
    if (h == 0) continue;
    FaceIntegral integral(loop.face, radius);
    const auto at = corners_of(loop);
    for (std::size_t n = 0; n < at.size(); ++n) {
      integral.add_edge(corners_[at[n]], corners_[at[n + 1 < at.size() ? n + 1 : 0]]);
    }
    shared.area += radius * radius * integral.share().angle;
    shared.volume += h * integral.share().area;
  }
  shared.volume = (shared.volume + radius * shared.area) / 3;
  return shared;
}

}  // namespace alphascope
