// SPDX-License-Identifier: GPL-3.0-or-later
// Sorts the content of layers into marks, bodies, lines, tubes and atoms.
#include "ui/scene/mesh/layer_mesh.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/geometry/alpha.hpp"
#include "core/molecule/rgb8.hpp"
#include "ui/rgb8.hpp"
#include "ui/scene/mesh/simplex_soup.hpp"

namespace alphascope {
namespace {

constexpr double kEdgeShade = 0.45;  // of the colour of a body's faces

Rgb8 darker(const Rgb8& c) {
  const auto shade = [](std::uint8_t x) { return static_cast<std::uint8_t>(kEdgeShade * x); };
  return {shade(c.r), shade(c.g), shade(c.b)};
}

// Collects the bodies of either the opaque or the translucent layers.
class BodiesBuilder {
 public:
  explicit BodiesBuilder(const BallGeometry& balls)
      : balls_(balls), faces_(balls), outlines_(balls) {
    spheres_.origin = balls.origin;
  }

  void add(const Layer& layer, const Rgb8& colour) {
    if (layer.body) {
      faces_.add(layer.triangles, colour);
      add_solid(layer.tetrahedra, colour);
    }
    for (const LayerSphere& sphere : layer.spheres) {
      add_ball(sphere.centre_angstrom, sphere.radius_angstrom, spheres_);
      bodies_.sphere_colours.push_back(sphere.colour ? to_rgb8(*sphere.colour) : colour);
    }
  }

  static void add_ball(const RealPoint& centre, double radius, BallGeometry& to) {
    to.centres.push_back({static_cast<float>(centre.x - to.origin[0]),
                          static_cast<float>(centre.y - to.origin[1]),
                          static_cast<float>(centre.z - to.origin[2])});
    to.radii.push_back(static_cast<float>(radius));
  }

  void end_layer() {
    bodies_.face_ends.push_back(faces_.faces.points() / 3);
    bodies_.sphere_ends.push_back(spheres_.centres.size());
  }

  LayerBodies finish() {
    bodies_.faces = std::move(faces_.faces);
    bodies_.edges = std::move(outlines_.edges);
    if (!spheres_.centres.empty()) {
      bodies_.spheres = std::make_shared<const BallGeometry>(std::move(spheres_));
    }
    return std::move(bodies_);
  }

 private:
  // Draws only the outside, since faces between two tetrahedra cannot be seen.
  void add_solid(const Simplices<4>& tetrahedra, const Rgb8& colour) {
    if (tetrahedra.empty()) return;
    for (const auto& t : tetrahedra) {
      if (t.back() >= balls_.centres.size()) {
        throw std::invalid_argument("a tetrahedron of a layer has no ball of this molecule");
      }
    }
    const Simplices<3> faces = boundary_faces(balls_, tetrahedra);
    faces_.add(faces, colour);
    Simplices<2> edges;
    for (const auto& f : faces) {
      for (int k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(f[k], f[(k + 1) % 3]);
        edges.push_back({low, high});
      }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    outlines_.add(edges, darker(colour));
  }

  const BallGeometry& balls_;
  SimplexSoup faces_, outlines_;
  BallGeometry spheres_;
  LayerBodies bodies_;
};

class LayerBuilder {
 public:
  explicit LayerBuilder(const BallGeometry& balls)
      : balls_(balls), marks_(balls), lines_(balls), opaque_(balls), translucent_(balls) {
    atoms_.origin = balls.origin;
  }

  void add(const Layer& layer) {
    const Rgb8 colour = to_rgb8(layer.colour);
    marks_.add(layer.vertices, colour);
    (layer.body ? lines_ : marks_).add(layer.edges, colour);
    if (!layer.body) {
      marks_.add(layer.triangles, colour);
      marks_.add(layer.tetrahedra, colour);
    }
    (layer.body && layer.translucent ? translucent_ : opaque_).add(layer, colour);
    for (const auto& [from, to] : layer.lines) add_line(from, to, colour);
    for (const auto& tube : layer.tubes) add_tube(tube, balls_.origin, colour, mesh_.tubes);
    opaque_.end_layer();
    translucent_.end_layer();
    mesh_.tube_ends.push_back(mesh_.tubes.corners.size() / 3);
    for (const LayerAtom& atom : layer.atoms) {
      BodiesBuilder::add_ball(atom.centre_angstrom, atom.radius_angstrom, atoms_);
      mesh_.atom_colours.push_back(to_rgb8(atom.colour));
      mesh_.atom_of.push_back(atom.atom);
    }
    for (const LayerLabel& label : layer.labels) {
      mesh_.labels.push_back({from_origin(label.at_angstrom), label.text});
    }
    const bool any = layer.body && (!layer.triangles.empty() || !layer.tetrahedra.empty() ||
                                    !layer.spheres.empty() || !layer.tubes.empty());
    mesh_.fades_rest |= any && layer.fades_rest;
  }

  LayerMesh finish() {
    mesh_.marks = {std::move(marks_.faces), std::move(marks_.edges)};
    mesh_.opaque = opaque_.finish();
    mesh_.translucent = translucent_.finish();
    mesh_.body_lines = std::move(lines_.edges);
    if (!atoms_.centres.empty()) {
      mesh_.atoms = std::make_shared<const BallGeometry>(std::move(atoms_));
    }
    return std::move(mesh_);
  }

 private:
  std::array<double, 3> from_origin(const RealPoint& p) const {
    return {p.x - balls_.origin[0], p.y - balls_.origin[1], p.z - balls_.origin[2]};
  }

  void add_line(const RealPoint& from, const RealPoint& to, const Rgb8& colour) {
    for (const RealPoint& end : {from, to}) {
      const auto at = from_origin(end);
      marks_.add_line_end(
          {static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])},
          colour);
    }
  }

  const BallGeometry& balls_;
  SimplexSoup marks_, lines_;
  BodiesBuilder opaque_, translucent_;
  BallGeometry atoms_;
  LayerMesh mesh_;
};

}  // namespace

std::size_t layer_at(const LayerEnds& ends, std::size_t thing) {
  const auto at = std::upper_bound(ends.begin(), ends.end(), thing);
  return static_cast<std::size_t>(at - ends.begin());
}

LayerMesh build_layer_mesh(const BallGeometry& balls, const Layers& layers) {
  LayerBuilder builder(balls);
  for (const auto& layer : layers) builder.add(*layer);
  return builder.finish();
}

LayerPoints layer_points(const Layers& layers) {
  LayerPoints points;
  for (const auto& layer : layers) {
    points.faces +=
        24 * layer->vertices.size() + 3 * layer->triangles.size() + 12 * layer->tetrahedra.size();
    points.lines += 2 * layer->edges.size() + 2 * layer->lines.size() +
                    (layer->body ? 12 * layer->tetrahedra.size() : 0);
    points.balls += layer->spheres.size() + layer->atoms.size();
    for (const auto& tube : layer->tubes) points.faces += tube_points(tube.size());
  }
  return points;
}

}  // namespace alphascope
