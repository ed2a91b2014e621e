// SPDX-License-Identifier: GPL-3.0-or-later
// A tube is made of rings of points around the line through the centres. Each ring's frame is the
// previous one with the least possible rotation, by double reflection: W. Wang, B. Jüttler, D.
// Zheng, Y. Liu, "Computation of rotation minimizing frames" (ACM Transactions on Graphics 27,
// 2008). If the radius grows by g for each Å, a ball touches the envelope in a circle. That circle
// lies g radii behind the centre, and there the ring is.
#include "ui/scene/mesh/tube_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/alpha.hpp"
#include "core/molecule/rgb8.hpp"
#include "ui/rgb8.hpp"

namespace alphascope {
namespace {

constexpr int kAround = 48;          // points of a ring
constexpr int kEndRings = 16;        // from the rim of a round end to its tip
constexpr double kMostSlope = 0.95;  // limit on the growth of the radius; at 1 the next ball would
                                     // contain this one

struct Knot {
  RealPoint centre;
  double radius = 0;
  Rgb8 colour;
};

class TubeBuilder {
 public:
  TubeBuilder(std::vector<Knot> knots, SmoothMesh& mesh)
      : knots_(std::move(knots)), mesh_(mesh), first_corner_(mesh.corners.size()) {}

  void build() {
    find_tangents();
    normals_of(tangents_.front(), across_, up_);
    add_end(0, -1);
    for (std::size_t i = 0; i < knots_.size(); ++i) {
      if (i > 0) turn_frame(i);
      add_ring(i, slope(i));
    }
    add_end(knots_.size() - 1, 1);
    turn_outwards();
  }

 private:
  void find_tangents() {
    const std::size_t n = knots_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const RealPoint ahead = knots_[std::min(i + 1, n - 1)].centre - knots_[i].centre;
      const RealPoint behind = knots_[i].centre - knots_[i > 0 ? i - 1 : 0].centre;
      RealPoint tangent = unit_vector(unit_vector(ahead) + unit_vector(behind));
      if (length(tangent) == 0) tangent = unit_vector(length(ahead) > 0 ? ahead : behind);
      if (length(tangent) == 0) tangent = {0, 0, 1};
      tangents_.push_back(tangent);
    }
  }

  static RealPoint reflected(const RealPoint& v, const RealPoint& mirror) {
    const double square = dot(mirror, mirror);
    return square > 0 ? v - (2 * dot(mirror, v) / square) * mirror : v;
  }

  void turn_frame(std::size_t i) {
    const RealPoint step = knots_[i].centre - knots_[i - 1].centre;
    const RealPoint across = reflected(across_, step), along = reflected(tangents_[i - 1], step);
    across_ = unit_vector(reflected(across, tangents_[i] - along));
    up_ = cross(tangents_[i], across_);
  }

  // Growth of the radius, Å for each Å of the line.
  double slope(std::size_t i) const {
    const std::size_t a = i > 0 ? i - 1 : i, b = std::min(i + 1, knots_.size() - 1);
    double way = 0;
    for (std::size_t k = a; k < b; ++k) way += length(knots_[k + 1].centre - knots_[k].centre);
    if (way == 0) return 0;
    return std::clamp((knots_[b].radius - knots_[a].radius) / way, -kMostSlope, kMostSlope);
  }

  RealPoint vector(const std::vector<float>& values, std::int32_t point) const {
    const float* v = &values[3 * static_cast<std::size_t>(point)];
    return {v[0], v[1], v[2]};
  }

  // Turns triangles that face inwards, as some do on the inner side of a bend. Their light would
  // come from within.
  void turn_outwards() {
    for (std::size_t t = first_corner_; t < mesh_.corners.size(); t += 3) {
      std::int32_t* c = &mesh_.corners[t];
      const RealPoint at = vector(mesh_.xyz, c[0]);
      const RealPoint face = cross(vector(mesh_.xyz, c[1]) - at, vector(mesh_.xyz, c[2]) - at);
      RealPoint normal;
      for (int k = 0; k < 3; ++k) normal = normal + vector(mesh_.normals, c[k]);
      if (dot(face, normal) < 0) std::swap(c[1], c[2]);
    }
  }

  // On the inner side of a bend a ring may reach into balls of its neighbours. Such a point is
  // moved out to the surface of the ball that contains it deepest. Otherwise folds would show as
  // specks.
  void add_outer_point(RealPoint at, RealPoint normal, std::size_t i) {
    constexpr std::size_t kNeighbours = 12;  // to either side
    constexpr double kRounding = 1e-6;       // Å
    double deepest = kRounding;
    const std::size_t end = std::min(knots_.size(), i + kNeighbours + 1);
    const Knot* outer = nullptr;
    for (std::size_t k = i > kNeighbours ? i - kNeighbours : 0; k < end; ++k) {
      const double depth = knots_[k].radius - length(at - knots_[k].centre);
      if (depth <= deepest) continue;
      deepest = depth;
      outer = &knots_[k];
    }
    const RealPoint outwards = outer ? unit_vector(at - outer->centre) : RealPoint{};
    if (length(outwards) > 0) {
      normal = outwards;
      at = outer->centre + outer->radius * outwards;
    }
    mesh_.add_point(at, normal, knots_[i].colour);
  }

  // Adds a ring on the sphere, `back` radii behind its centre, and joins it to the previous ring.
  void add_ring(std::size_t i, double back) {
    const Knot& knot = knots_[i];
    const double out = std::sqrt(1 - back * back);
    const auto first = static_cast<std::int32_t>(mesh_.points());
    for (int k = 0; k < kAround; ++k) {
      const double angle = 2 * M_PI * k / kAround;
      const RealPoint radial = std::cos(angle) * across_ + std::sin(angle) * up_;
      const RealPoint normal = out * radial - back * tangents_[i];
      add_outer_point(knot.centre + knot.radius * normal, normal, i);
    }
    if (rings_++ == 0) return;
    for (int k = 0; k < kAround; ++k) {
      const std::int32_t a = first + k, b = first + (k + 1) % kAround;
      mesh_.corners.insert(mesh_.corners.end(), {a - kAround, b - kAround, b, a - kAround, b, a});
    }
  }

  // Adds the part of the first or last sphere beyond its ring. `side`: -1 at the start of the tube,
  // 1 at its end.
  void add_end(std::size_t knot, int side) {
    const double rim = std::asin(slope(knot));  // angle by which the ring lies behind the centre
    const double tip = side < 0 ? M_PI / 2 : -M_PI / 2;
    for (int k = 0; k < kEndRings; ++k) {
      const double share = side < 0 ? k / double(kEndRings) : (k + 1) / double(kEndRings);
      const double angle = side < 0 ? tip + share * (rim - tip) : rim + share * (tip - rim);
      add_ring(knot, std::sin(angle));
    }
  }

  const std::vector<Knot> knots_;
  SmoothMesh& mesh_;
  const std::size_t first_corner_;  // of this tube
  std::vector<RealPoint> tangents_;
  RealPoint across_, up_;  // the frame, with the tangent
  int rings_ = 0;
};

}  // namespace

void SmoothMesh::add_point(const RealPoint& at, const RealPoint& normal, const Rgb8& colour) {
  for (const double x : {at.x, at.y, at.z}) xyz.push_back(static_cast<float>(x));
  for (const double x : {normal.x, normal.y, normal.z}) normals.push_back(static_cast<float>(x));
  rgb.insert(rgb.end(), {colour.r, colour.g, colour.b});
}

std::size_t tube_points(std::size_t spheres) {
  return spheres == 0 ? 0 : kAround * (spheres + 2 * kEndRings);
}

void add_tube(const std::vector<LayerSphere>& spheres, const std::array<double, 3>& origin,
              const Rgb8& colour, SmoothMesh& mesh) {
  std::vector<Knot> knots;
  const RealPoint from{origin[0], origin[1], origin[2]};
  for (const LayerSphere& sphere : spheres) {
    if (!(sphere.radius_angstrom > 0)) continue;
    const RealPoint centre = sphere.centre_angstrom - from;
    if (!knots.empty() && knots.back().centre == centre) continue;
    knots.push_back(
        {centre, sphere.radius_angstrom, sphere.colour ? to_rgb8(*sphere.colour) : colour});
  }
  if (!knots.empty()) TubeBuilder(std::move(knots), mesh).build();
}

void add_stick(const RealPoint& from, const RealPoint& to, double radius, const Rgb8& colour,
               SmoothMesh& mesh) {
  constexpr int kSides = 8;
  const auto first = static_cast<std::int32_t>(mesh.points());
  RealPoint across, up;
  normals_of(unit_vector(to - from), across, up);
  for (const RealPoint& end : {from, to}) {
    for (int k = 0; k < kSides; ++k) {
      const double angle = 2 * M_PI * k / kSides;
      const RealPoint normal = std::cos(angle) * across + std::sin(angle) * up;
      mesh.add_point(end + radius * normal, normal, colour);
    }
  }
  for (int k = 0; k < kSides; ++k) {
    const std::int32_t a = first + k, b = first + (k + 1) % kSides;
    mesh.corners.insert(mesh.corners.end(), {a, b, b + kSides, a, b + kSides, a + kSides});
  }
}

}  // namespace alphascope
