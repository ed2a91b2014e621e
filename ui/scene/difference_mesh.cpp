// See the header.
#include "ui/scene/difference_mesh.hpp"

#include <cmath>
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
    add(difference.missing, kMissingColour);
    add(difference.extra, kExtraColour);
  }
  template <class Simplices>
  void add(const Simplices& simplices, const Rgb8& colour) {
    for (const auto& simplex : simplices) add_simplex(simplex, colour);
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

DifferenceMesh build_layer_mesh(const BallGeometry& balls, const Layers& layers) {
  DifferenceBuilder builder(balls), bodies(balls);
  const auto byte = [](float x) { return static_cast<std::uint8_t>(std::lround(x * 255)); };
  for (const auto& layer : layers) {
    const Rgb8 colour{byte(layer->colour.r), byte(layer->colour.g), byte(layer->colour.b)};
    builder.add(layer->vertices, colour);
    builder.add(layer->edges, colour);
    DifferenceBuilder& faces = layer->body ? bodies : builder;
    faces.add(layer->triangles, colour);
    faces.add(layer->tetrahedra, colour);
  }
  builder.mesh.bodies = std::move(bodies.mesh.faces);
  return std::move(builder.mesh);
}

}  // namespace alphascope
