// SPDX-License-Identifier: GPL-3.0-or-later
// A smooth tube through spheres: the surface swept by a ball of changing radius. Pure C++; no VTK.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ui/layer.hpp"
#include "ui/scene/mesh/ball_geometry.hpp"

namespace alphascope {

// Triangles with shared corners. Light is computed from the corners' normals, so that the surface
// looks round.
struct SmoothMesh {
  std::vector<float> xyz;      // Å, relative to BallGeometry::origin
  std::vector<float> normals;  // outwards, of length 1; three numbers a point
  std::vector<std::uint8_t> rgb;
  std::vector<std::int32_t> corners;  // indices of points, three a triangle
  std::size_t points() const { return xyz.size() / 3; }
  void add_point(const RealPoint& at, const RealPoint& normal, const Rgb8& colour);
};

// Upper bound for the number of points that a tube through this many spheres adds.
std::size_t tube_points(std::size_t spheres);

// Adds a tube; a single sphere makes a ball. `origin` is BallGeometry::origin. Spheres without a
// colour get `colour`. A sphere is skipped if its radius is not positive, or if it has the centre
// of the sphere before.
void add_tube(const std::vector<LayerSphere>& spheres, const std::array<double, 3>& origin,
              const Rgb8& colour, SmoothMesh& mesh);

// Adds a cylinder with open ends, to be covered by balls. Positions are in Å, relative to
// BallGeometry::origin.
void add_stick(const RealPoint& from, const RealPoint& to, double radius, const Rgb8& colour,
               SmoothMesh& mesh);

}  // namespace alphascope
