// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the layer of an explanation from wire spheres and tubes, cut off at a distance.
#include "ui/panels/explain/why_layer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/explain/explanation.hpp"
#include "core/geometry/ball_set.hpp"

namespace alphascope {
namespace {

constexpr Colour kOrthosphere{1, 0.75f, 0.2f, 1}, kNearest{0.95f, 0.3f, 0.45f, 1};
constexpr double kWire = 0.025;      // Å
constexpr double kFarthest = 40;     // Å; nothing farther from the simplex is drawn
constexpr double kLargestWire = 60;  // Å; a larger sphere would look like planes

using Tube = std::vector<LayerSphere>;

Tube circle(const RealPoint& centre, const RealPoint& a, const RealPoint& b, const Colour& colour,
            double wire) {
  constexpr int kPoints = 64;
  Tube tube;
  for (int n = 0; n <= kPoints; ++n) {
    const double turn = 2 * std::numbers::pi * n / kPoints;
    tube.push_back({centre + std::cos(turn) * a + std::sin(turn) * b, wire, colour});
  }
  return tube;
}

// Draws a ball as meridians and parallels of wire.
void add_wire_ball(Layer& layer, const RealPoint& centre, double radius, const Colour& colour) {
  const double wire = std::max(kWire, radius * 0.006);
  const RealPoint up{0, 0, radius};
  for (int n = 0; n < 4; ++n) {
    const double turn = std::numbers::pi * n / 4;
    layer.tubes.push_back(
        circle(centre, radius * RealPoint{std::cos(turn), std::sin(turn), 0}, up, colour, wire));
  }
  for (int n = -1; n <= 1; ++n) {
    const double height = std::sin(n * std::numbers::pi / 4),
                 wide = radius * std::sqrt(1 - height * height);
    layer.tubes.push_back(
        circle(centre + height * up, RealPoint{wide, 0, 0}, RealPoint{0, wide, 0}, colour, wire));
  }
}

// Cuts a segment to the part within kFarthest of a point. Returns false if there is none.
bool cut_to_sight(std::array<RealPoint, 2>& segment, const RealPoint& middle) {
  const RealPoint along = segment[1] - segment[0], from = segment[0] - middle;
  const double a = dot(along, along), b = dot(along, from),
               c = dot(from, from) - kFarthest * kFarthest;
  if (a == 0) return c <= 0;
  const double square = b * b - a * c;
  if (!(square >= 0)) return false;
  const double low = std::max(0.0, (-b - std::sqrt(square)) / a),
               high = std::min(1.0, (-b + std::sqrt(square)) / a);
  if (low >= high) return false;
  segment = {segment[0] + low * along, segment[0] + high * along};
  return true;
}

}  // namespace

std::shared_ptr<const Layer> make_why_layer(const Explanation& e,
                                            const std::shared_ptr<const BallSet>& balls,
                                            std::uint64_t key) {
  auto layer = std::make_shared<Layer>();
  layer->id = "why";
  layer->key = key;
  layer->balls = balls;
  layer->colour = kOrthosphere;
  layer->body = true;
  const auto centre_of = [&](BallIndex ball) {
    return balls->lattice.unit_angstrom() * real_point(balls->centres[ball]);
  };
  for (std::size_t i = 0; i < e.simplex.size(); ++i) {
    layer->vertices.push_back({e.simplex[i]});
    for (std::size_t k = i + 1; k < e.simplex.size(); ++k) {
      layer->edges.push_back({e.simplex[i], e.simplex[k]});
    }
  }
  const RealPoint first = centre_of(e.simplex[0]);
  const auto add_line = [&](std::array<RealPoint, 2> ends, const Colour& colour) {
    if (!cut_to_sight(ends, first)) return;
    layer->tubes.push_back({{ends[0], 2 * kWire, colour}, {ends[1], 2 * kWire, colour}});
  };
  for (const auto& edge : e.dual_edges_angstrom) add_line(edge, kDualColour);
  if (!e.orthosphere) return layer;
  const RealPoint centre = e.orthosphere->centre_angstrom;
  if (!(length(centre - first) < kFarthest)) return layer;
  layer->spheres.push_back({centre, 0.12, kOrthosphere});
  const double radius = std::sqrt(std::max(0.0, e.orthosphere->rho_angstrom2));
  if (e.orthosphere->rho_sign > 0 && radius < kLargestWire) {
    add_wire_ball(*layer, centre, radius, kOrthosphere);
  }
  if (e.nearest.empty()) return layer;
  const BallIndex near = e.nearest.front().ball;
  add_wire_ball(*layer, centre_of(near), balls->lattice.angstrom(balls->radii[near]), kNearest);
  add_line({centre, centre_of(near)}, kNearest);
  return layer;
}

}  // namespace alphascope
