// A smooth tube through spheres: the surface that a ball of changing radius sweeps. Pure C++; no
// VTK.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ui/layer.hpp"
#include "ui/scene/mesh/ball_geometry.hpp"

namespace alphascope {

// Triangles that share their corners and are lit by the corners' normals, so that they look round.
struct SmoothMesh {
  std::vector<float> xyz;      // Å, relative to BallGeometry::origin
  std::vector<float> normals;  // outwards, of length 1; three a point
  std::vector<std::uint8_t> rgb;
  std::vector<std::int32_t> corners;  // three points a triangle
  std::size_t points() const { return xyz.size() / 3; }
};

// Points that a tube through so many spheres adds, at most.
std::size_t tube_points(std::size_t spheres);

// Of one sphere: a ball. `colour`: of spheres that have none of their own. Spheres at the same
// place as the one before, and those without size, are left out.
void add_tube(const std::vector<LayerSphere>& spheres, const std::array<double, 3>& origin,
              const Rgb8& colour, SmoothMesh& mesh);

// Open at its ends, which other things cover; places in Å, relative to BallGeometry::origin.
void add_stick(const RealPoint& from, const RealPoint& to, double radius, const Rgb8& colour,
               SmoothMesh& mesh);

}  // namespace alphascope
