// See the header.
#include "ui/scene/difference_mesh.hpp"

#include <stdexcept>

namespace alphascope {
namespace {

constexpr float kVertexSize = 0.5f;  // Å, from the centre of an octahedron to its corners

using Point = std::array<float, 3>;

class DifferenceBuilder {
 public:
  explicit DifferenceBuilder(const BallGeometry& balls) : balls_(balls) {}

  template <int N>
  void add(const SetDifference<N>& difference) {
    for (const auto& simplex : difference.missing) add_simplex(simplex, kMissingColour);
    for (const auto& simplex : difference.extra) add_simplex(simplex, kExtraColour);
  }

  DifferenceMesh mesh;

 private:
  const Point& centre(BallIndex v) const {
    if (v >= balls_.centres.size()) {
      throw std::invalid_argument("the comparison and the balls do not belong together");
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
        add_point(mesh.faces, corner(axis, (octant >> axis) & 1 ? kVertexSize : -kVertexSize),
                  colour);
      }
    }
  }

  void add_simplex(const std::array<BallIndex, 2>& edge, const Rgb8& colour) {
    for (const BallIndex v : edge) add_point(mesh.edges, centre(v), colour);
  }

  void add_simplex(const std::array<BallIndex, 3>& triangle, const Rgb8& colour) {
    for (const BallIndex v : triangle) add_point(mesh.faces, centre(v), colour);
  }

  void add_simplex(const std::array<BallIndex, 4>& t, const Rgb8& colour) {
    add_simplex(std::array{t[0], t[1], t[2]}, colour);
    add_simplex(std::array{t[0], t[1], t[3]}, colour);
    add_simplex(std::array{t[0], t[2], t[3]}, colour);
    add_simplex(std::array{t[1], t[2], t[3]}, colour);
  }

  const BallGeometry& balls_;
};

}  // namespace

DifferenceMesh build_difference_mesh(const BallGeometry& balls, const Comparison& comparison) {
  DifferenceBuilder builder(balls);
  builder.add(comparison.tetrahedra);
  builder.add(comparison.triangles);
  builder.add(comparison.edges);
  builder.add(comparison.vertices);
  return std::move(builder.mesh);
}

}  // namespace alphascope
