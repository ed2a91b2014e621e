// SPDX-License-Identifier: GPL-3.0-or-later
// Intersects tetrahedra with the planes of a cut.
#include "ui/scene/mesh/cap_mesh.hpp"

#include <array>

#include "core/geometry/alpha.hpp"
#include "core/molecule/rgb8.hpp"
#include "ui/scene/mesh/simplex_colours.hpp"

namespace alphascope {
namespace {

using Point = std::array<float, 3>;

constexpr double kEdgeShade = 0.55;  // of the face's colour

Rgb8 darker(const Rgb8& c) {
  const auto shade = [](std::uint8_t v) { return static_cast<std::uint8_t>(kEdgeShade * v); };
  return {shade(c.r), shade(c.g), shade(c.b)};
}

void add_point(CellSoup& soup, const Point& p, const Rgb8& c) {
  soup.xyz.insert(soup.xyz.end(), p.begin(), p.end());
  soup.rgb.insert(soup.rgb.end(), {c.r, c.g, c.b});
}

// Makes the caps in one plane.
class CapBuilder {
 public:
  CapBuilder(const HalfSpace& space, CapMesh& mesh) : space_(space), mesh_(mesh) {}

  // A corner in the plane counts as kept. So a face in the plane that two tetrahedra share is drawn
  // once.
  void add(const std::array<Point, 4>& corners, std::uint32_t tetrahedron, const Rgb8& colour) {
    std::array<double, 4> depth;
    std::array<int, 4> inside{}, outside{};
    int count_in = 0, count_out = 0;
    for (int i = 0; i < 4; ++i) {
      depth[i] = space_.depth(corners[i]);
      (depth[i] >= 0 ? inside[count_in++] : outside[count_out++]) = i;
    }
    if (count_in == 0 || count_out == 0) return;
    const auto crossing = [&](int in, int out) {
      const double share = depth[in] / (depth[in] - depth[out]);
      Point p;
      for (int k = 0; k < 3; ++k) {
        p[k] = static_cast<float>(corners[in][k] + share * (corners[out][k] - corners[in][k]));
      }
      return p;
    };
    std::array<Point, 4> polygon;
    int size = 3;
    if (count_in == 2) {
      size = 4;
      polygon = {crossing(inside[0], outside[0]), crossing(inside[0], outside[1]),
                 crossing(inside[1], outside[1]), crossing(inside[1], outside[0])};
    } else {
      for (int i = 0; i < 3; ++i) {
        polygon[i] =
            count_in == 1 ? crossing(inside[0], outside[i]) : crossing(inside[i], outside[0]);
      }
    }
    add_polygon(polygon, size, tetrahedron, colour);
  }

 private:
  void add_polygon(const std::array<Point, 4>& polygon, int size, std::uint32_t tetrahedron,
                   const Rgb8& colour) {
    for (int i = 2; i < size; ++i) {
      for (const int corner : {0, i - 1, i}) add_point(mesh_.faces, polygon[corner], colour);
      mesh_.faces.source.push_back(4 * tetrahedron);
    }
    const Rgb8 dark = darker(colour);
    for (int i = 0; i < size; ++i) {
      for (const int corner : {i, (i + 1) % size}) {
        add_point(mesh_.edges, polygon[corner], dark);
      }
    }
  }
  const HalfSpace& space_;
  CapMesh& mesh_;
};

}  // namespace

bool has_caps(const MeshOptions& options) {
  return options.tetrahedra || options.boundary;
}

CapMesh build_cap_mesh(const BallGeometry& balls, const std::vector<Rgb8>& colours,
                       const AlphaComplex& complex, const MeshOptions& options,
                       const std::optional<AlphaScale>& scale, const Cut& cut,
                       const CancelToken& cancel) {
  CapMesh mesh;
  if (!has_caps(options) || (options.colouring == ComplexColouring::alpha && !scale)) return mesh;
  const auto& list = complex.tetrahedra;
  // The boundary belongs to tetrahedra that are not shrunk.
  const float shrink = options.boundary ? 0 : static_cast<float>(options.shrink);
  for (const HalfSpace& space : cut.kept) {
    cancel.throw_if_cancelled();
    // Most tetrahedra lie on one side of the plane. The signs of their balls tell so without
    // further tests.
    std::vector<bool> kept(balls.centres.size());
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = space.depth(balls.centres[i]) >= 0;
    CapBuilder caps(space, mesh);
    for (std::size_t t = 0; t < list.size(); ++t) {
      const auto& s = list.simplices[t];
      const bool first = kept[s[0]];
      if (kept[s[1]] == first && kept[s[2]] == first && kept[s[3]] == first) continue;
      const float alpha = t < list.alpha_values.size() ? list.alpha_values[t] : 0.0f;
      caps.add(shrunk_corners(balls, s, shrink), static_cast<std::uint32_t>(t),
               simplex_colour(s, {alpha}, options, colours, scale ? &*scale : nullptr));
    }
  }
  return mesh;
}

}  // namespace alphascope
