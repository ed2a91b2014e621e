// SPDX-License-Identifier: GPL-3.0-or-later
// Simplices of any dimension as triangles and lines for drawing, each in a given colour. For
// sources of the scene only.
#pragma once

#include <array>
#include <stdexcept>

#include "ui/scene/mesh/ball_geometry.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"

namespace alphascope {

// Throws std::invalid_argument when a simplex has a vertex beyond the balls.
class SimplexSoup {
 public:
  explicit SimplexSoup(const BallGeometry& balls) : balls_(balls) {}

  template <class Simplices>
  void add(const Simplices& simplices, const Rgb8& colour) {
    for (const auto& simplex : simplices) add_simplex(simplex, colour);
  }

  // Adds an end of a line: Å, relative to BallGeometry::origin. Two ends in succession make a line.
  void add_line_end(const std::array<float, 3>& point, const Rgb8& colour) {
    add_point(edges, point, colour);
  }

  CellSoup faces;  // of triangles and tetrahedra; vertices as small octahedra
  CellSoup edges;  // lines

 private:
  using Point = std::array<float, 3>;
  static constexpr float kVertexSize = 0.5f;  // Å, from the centre of an octahedron to its corners

  const Point& centre(BallIndex v) const {
    if (v >= balls_.centres.size()) {
      throw std::invalid_argument("a simplex that is to be marked has no ball of this molecule");
    }
    return balls_.centres[v];
  }

  static void add_point(CellSoup& soup, const Point& p, const Rgb8& c) {
    soup.xyz.insert(soup.xyz.end(), p.begin(), p.end());
    soup.rgb.insert(soup.rgb.end(), {c.r, c.g, c.b});
  }

  void add_simplex(const std::array<BallIndex, 1>& vertex, const Rgb8& colour) {
    const Point middle = centre(vertex[0]);
    const auto corner = [&middle](int axis, float by) {
      Point p = middle;
      p[axis] += by;
      return p;
    };
    for (int octant = 0; octant < 8; ++octant) {
      for (int axis = 0; axis < 3; ++axis) {
        add_point(faces, corner(axis, (octant >> axis) & 1 ? kVertexSize : -kVertexSize), colour);
      }
    }
  }

  void add_simplex(const std::array<BallIndex, 2>& edge, const Rgb8& colour) {
    for (const BallIndex v : edge) add_point(edges, centre(v), colour);
  }

  void add_simplex(const std::array<BallIndex, 3>& triangle, const Rgb8& colour) {
    for (const BallIndex v : triangle) add_point(faces, centre(v), colour);
  }

  void add_simplex(const std::array<BallIndex, 4>& t, const Rgb8& colour) {
    add_simplex(std::array{t[0], t[1], t[2]}, colour);
    add_simplex(std::array{t[0], t[1], t[3]}, colour);
    add_simplex(std::array{t[0], t[2], t[3]}, colour);
    add_simplex(std::array{t[1], t[2], t[3]}, colour);
  }

  const BallGeometry& balls_;
};

}  // namespace alphascope
