// SPDX-License-Identifier: GPL-3.0-or-later
// Layers that can be picked: cells in trees of boxes, and their intersections with a ray.
#include "ui/scene/pick/pick.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"

namespace alphascope {
namespace {

using Vector = std::array<double, 3>;

constexpr double kNowhere = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-3;  // Å: more than any error by which rounding moves a point out of
                                    // its flat box

using Point = std::array<float, 3>;

Vector vector(const Point& p) {
  return {p[0], p[1], p[2]};
}
Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Index in the list from which the cell was taken. Without sources, cells and list have the same
// order.
template <class Source>
std::size_t number_in(const Source& source, std::size_t cell) {
  return source.empty() ? cell : source[cell];
}

// Triangles of layers and caps.
struct SoupCells {
  static constexpr std::size_t corners = 3;
  std::shared_ptr<const CellSoup> soup;

  std::size_t size() const { return soup->points() / corners; }
  Point point(std::size_t cell, std::size_t corner) const {
    const float* p = &soup->xyz[3 * (corners * cell + corner)];
    return {p[0], p[1], p[2]};
  }
  std::size_t number(std::size_t cell) const { return number_in(soup->source, cell); }
};

struct EdgesOfBalls {
  static constexpr std::size_t corners = 2;
  std::shared_ptr<const EdgeCells> cells;
  std::shared_ptr<const BallGeometry> balls;

  std::size_t size() const { return cells->size(); }
  Point point(std::size_t cell, std::size_t corner) const {
    return balls->centres[cells->edges[cell].balls[corner]];
  }
  std::size_t number(std::size_t cell) const { return number_in(cells->source, cell); }
};

struct FacesOfBalls {
  static constexpr std::size_t corners = 3;
  std::shared_ptr<const FaceCells> cells;
  std::shared_ptr<const BallGeometry> balls;

  std::size_t size() const { return cells->size(); }
  Point point(std::size_t cell, std::size_t corner) const {
    return balls->centres[cells->faces[cell].balls[corner]];
  }
  std::size_t number(std::size_t cell) const { return number_in(cells->source, cell); }
};

// Cell 4 t + k is the face of tetrahedron t opposite to its corner k, shrunk towards its centre.
struct FacesOfTetrahedra {
  static constexpr std::size_t corners = 3;
  std::shared_ptr<const TetrahedronCells> cells;
  std::shared_ptr<const BallGeometry> balls;

  std::size_t size() const { return 4 * cells->size(); }
  Point point(std::size_t cell, std::size_t corner) const {
    const std::size_t lacks = cell % 4;
    return shrunk_corners(*balls, cells->balls[cell / 4],
                          cells->shrink)[corner < lacks ? corner : corner + 1];
  }
  std::size_t number(std::size_t cell) const {
    return 4 * number_in(cells->source, cell / 4) + cell % 4;
  }
};

struct CartoonCells {
  static constexpr std::size_t corners = 3;
  std::shared_ptr<const ObjectMesh> mesh;

  std::size_t size() const { return mesh->cartoon.triangles(); }
  Point point(std::size_t cell, std::size_t corner) const {
    const SmoothMesh& surface = mesh->cartoon.surface;
    const auto at = static_cast<std::size_t>(surface.corners[corners * cell + corner]);
    const float* p = &surface.xyz[3 * at];
    return {p[0], p[1], p[2]};
  }
  std::size_t number(std::size_t cell) const { return mesh->cartoon.atom_of(cell); }
};

// Number of consecutive cells that have one box in the tree.
template <class Cells>
constexpr std::size_t kCellsInBox = 1;
template <>
constexpr std::size_t kCellsInBox<FacesOfTetrahedra> = 4;

template <class Cells>
Box box_of(const Cells& cells, std::size_t cell) {
  Box box = Box::empty();
  for (std::size_t i = 0; i < cells.corners; ++i) {
    const Point p = cells.point(cell, i);
    box.add({p, p});
  }
  return box;
}
Box box_of(const FacesOfTetrahedra& cells, std::size_t tetrahedron) {
  Box box = Box::empty();
  for (const Point& p :
       shrunk_corners(*cells.balls, cells.cells->balls[tetrahedron], cells.cells->shrink)) {
    box.add({p, p});
  }
  return box;
}

// Möller and Trumbore, "Fast, minimum storage ray-triangle intersection" (1997). Both sides of the
// triangle count.
template <class Cells>
double triangle_depth(const Cells& cells, std::size_t cell, const Ray& ray) {
  const Vector a = vector(cells.point(cell, 0));
  const Vector e1 = minus(vector(cells.point(cell, 1)), a);
  const Vector e2 = minus(vector(cells.point(cell, 2)), a);
  const Vector p = cross(ray.direction, e2), s = minus(ray.start, a);
  const double determinant = dot(e1, p);
  if (determinant == 0) return kNowhere;
  const double u = dot(s, p) / determinant;
  if (!(u >= 0 && u <= 1)) return kNowhere;
  const Vector q = cross(s, e1);
  const double v = dot(ray.direction, q) / determinant;
  if (!(v >= 0 && u + v <= 1)) return kNowhere;
  const double t = dot(e2, q) / determinant;
  return t >= 0 ? t : kNowhere;
}

// Depth at which the ray passes closest to a line; infinity if it does not pass close enough. Lines
// are drawn over the faces that they bound, so the depth is reduced by the distance still accepted.
template <class Cells>
double line_depth(const Cells& cells, std::size_t cell, const PickLine& line) {
  const Vector a = vector(cells.point(cell, 0)), along = minus(vector(cells.point(cell, 1)), a);
  const Vector& d = line.ray.direction;
  const Vector from = minus(a, line.ray.start);
  const double dd = dot(d, d), dl = dot(d, along), ll = dot(along, along);
  const double determinant = dd * ll - dl * dl;
  double share = 0;  // of the way along the line
  if (determinant > 0) share = (dl * dot(d, from) - dd * dot(along, from)) / determinant;
  share = std::clamp(share, 0.0, 1.0);
  Vector to = from;
  for (std::size_t k = 0; k < 3; ++k) to[k] += share * along[k];
  const double t = dot(d, to) / dd;
  if (!(t > 0)) return kNowhere;
  for (std::size_t k = 0; k < 3; ++k) to[k] -= t * d[k];
  const double near_enough = std::max(line.spread * t, line.rod_radius);
  return dot(to, to) <= near_enough * near_enough ? std::max(0.0, t - near_enough) : kNowhere;
}

// A depth that no point of the box exceeds. It bounds the width of lines in the box.
double farthest_depth(const Box& box, const Ray& ray) {
  Vector to{};
  for (std::size_t k = 0; k < 3; ++k) {
    to[k] = std::max(std::fabs(box.low[k] - ray.start[k]), std::fabs(box.high[k] - ray.start[k]));
  }
  return std::sqrt(dot(to, to) / dot(ray.direction, ray.direction));
}

// Tells for which simplices the cells of a layer stand.
struct Meaning {
  std::string_view id;
  int corners;            // of the simplices
  bool faces_of = false;  // the number of a cell is 4 × tetrahedron + opposite corner
  bool as_face = false;   // cells stand for that face, not for the tetrahedron
  bool in_cut = false;    // the layer lies in a plane of the cut, which does not cut it
};

Hit hit_of(const Meaning& meaning, std::size_t number, double depth) {
  Hit hit{meaning.id, meaning.corners, number, std::nullopt, depth, {}};
  if (meaning.faces_of) hit.index = number / 4;
  if (meaning.as_face) hit.opposite = static_cast<int>(number % 4);
  return hit;
}

template <class Cells>
PickLayer layer_of(const Cells& cells, const Meaning& meaning, const CancelToken& cancel = {}) {
  constexpr std::size_t in_box = kCellsInBox<Cells>;
  auto tree = std::make_shared<const BoxTree>(
      cells.size() / in_box, [&](std::size_t n) { return box_of(cells, n); }, cancel);
  return {
      meaning.id, [cells, meaning, tree](const PickLine& line) {
        constexpr bool lines = Cells::corners == 2;
        double nearest = kNowhere;
        std::size_t found = 0;
        const auto enter = [&](const Box& box) {
          const double beside =
              lines ? std::max(line.spread * farthest_depth(box, line.ray), line.rod_radius) : 0.0;
          const double margin = beside + kRounding;
          return meets(line.ray, box, margin, nearest + 2 * margin);
        };
        const auto try_cell = [&](std::size_t cell) {
          const double depth =
              lines ? line_depth(cells, cell, line) : triangle_depth(cells, cell, line.ray);
          if (!meaning.in_cut && !line.kept.has(depth)) return;
          if (depth > nearest || (depth == nearest && cell >= found)) return;
          nearest = depth;
          found = cell;
        };
        tree->visit(enter, [&](std::size_t n) {
          for (std::size_t k = 0; k < in_box; ++k) try_cell(in_box * n + k);
        });
        return std::isfinite(nearest) ? std::optional(hit_of(meaning, cells.number(found), nearest))
                                      : std::nullopt;
      }};
}

template <std::size_t N, int M>
std::optional<std::size_t> find_in(const SimplexList<M>& list,
                                   const std::vector<BallIndex>& balls) {
  static_assert(N == M);
  std::array<BallIndex, N> wanted{};
  std::copy(balls.begin(), balls.end(), wanted.begin());
  const auto at = std::lower_bound(list.simplices.begin(), list.simplices.end(), wanted);
  if (at == list.simplices.end() || *at != wanted) return std::nullopt;
  return static_cast<std::size_t>(at - list.simplices.begin());
}

template <int N>
void describe(const SimplexList<N>& list, std::size_t i, const Lattice& lattice, HitSimplex& to) {
  to.balls.assign(list.simplices.at(i).begin(), list.simplices.at(i).end());
  if (i < list.alpha_values.size()) to.angstrom2 = lattice.square_angstrom(list.alpha_values[i]);
  if (i < list.classes.size()) to.kind = list.classes[i];
}

}  // namespace

PickLayers mesh_layers(const std::shared_ptr<const ComplexMesh>& mesh,
                       const std::shared_ptr<const BallGeometry>& balls,
                       const CancelToken& cancel) {
  PickLayers layers;
  if (!mesh) return layers;
  const auto add = [&](const auto& cells, const Meaning& meaning) {
    if (cells.size() > 0) layers.push_back(layer_of(cells, meaning, cancel));
  };
  const auto faces = [&](const FaceCells& cells) {
    return FacesOfBalls{std::shared_ptr<const FaceCells>(mesh, &cells), balls};
  };
  add(EdgesOfBalls{std::shared_ptr<const EdgeCells>(mesh, &mesh->edges), balls}, {"edges", 2});
  add(faces(mesh->triangles), {"triangles", 3});
  add(faces(mesh->boundary), {"boundary", 3, true, true});
  add(faces(mesh->outside), {"tetrahedra", 4, true});
  add(FacesOfTetrahedra{std::shared_ptr<const TetrahedronCells>(mesh, &mesh->tetrahedra), balls},
      {"tetrahedra", 4, true});
  return layers;
}

PickLayer cap_layer(const std::shared_ptr<const CapMesh>& mesh) {
  return layer_of(SoupCells{std::shared_ptr<const CellSoup>(mesh, &mesh->faces)},
                  {"tetrahedra", 4, true, false, true});
}

PickLayer ball_layer(std::string_view id, std::shared_ptr<const BallGeometry> balls, int corners) {
  auto picker = std::make_shared<const BallPicker>(balls);
  return {id, [id, balls, corners, picker](const PickLine& line) -> std::optional<Hit> {
            const auto ball = picker->pick(balls->radii, kRounding, line.ray, line.kept);
            if (!ball) return std::nullopt;
            return Hit{id, corners, ball->ball, {}, ball->depth, {}};
          }};
}

namespace {

// The same hits, with the panel's layer as index. `ends` belongs to `mesh`.
PickLayer by_layer(PickLayer things, std::shared_ptr<const LayerMesh> mesh, const LayerEnds& ends) {
  return {things.id,
          [pick = std::move(things.pick), mesh = std::move(mesh), &ends](const PickLine& line) {
            std::optional<Hit> hit = pick(line);
            if (hit) hit->index = layer_at(ends, hit->index);
            return hit;
          }};
}

}  // namespace

PickLayers body_layers(const std::shared_ptr<const LayerMesh>& mesh) {
  PickLayers layers;
  if (!mesh) return layers;
  for (const LayerBodies* bodies : {&mesh->opaque, &mesh->translucent}) {
    if (bodies->faces.points() > 0) {
      const auto faces = std::shared_ptr<const CellSoup>(mesh, &bodies->faces);
      layers.push_back(by_layer(layer_of(SoupCells{faces}, {kBodies, 0}), mesh, bodies->face_ends));
    }
    if (bodies->spheres) {
      layers.push_back(
          by_layer(ball_layer(kBodies, bodies->spheres, 0), mesh, bodies->sphere_ends));
    }
  }
  if (mesh->tubes.points() > 0) {
    auto tubes = std::make_shared<CellSoup>();
    for (const std::int32_t corner : mesh->tubes.corners) {
      const float* p = &mesh->tubes.xyz[3 * static_cast<std::size_t>(corner)];
      tubes->xyz.insert(tubes->xyz.end(), p, p + 3);
    }
    layers.push_back(
        by_layer(layer_of(SoupCells{std::move(tubes)}, {kTubes, 0}), mesh, mesh->tube_ends));
  }
  return layers;
}

std::optional<PickLayer> atom_layer(const std::shared_ptr<const LayerMesh>& mesh) {
  if (!mesh || !mesh->atoms) return std::nullopt;
  const PickLayer balls = ball_layer(kAtomInFront, mesh->atoms, 1);
  return PickLayer{balls.id, [mesh, balls](const PickLine& line) {
                     std::optional<Hit> hit = balls.pick(line);
                     if (hit) hit->index = mesh->atom_of.at(hit->index);
                     return hit;
                   }};
}

namespace {

PickLayer stick_layer(const std::shared_ptr<const ObjectMesh>& mesh) {
  const PickLayer rods = layer_of(
      EdgesOfBalls{std::shared_ptr<const EdgeCells>(mesh, &mesh->sticks.rods), mesh->sticks.places},
      {kAtomOfObject, 1});
  return {kAtomOfObject, [mesh, rods](const PickLine& line) {
            PickLine thick = line;
            thick.rod_radius = mesh->sticks.radius;
            std::optional<Hit> hit = rods.pick(thick);
            if (!hit) return hit;
            Vector at = line.ray.start;
            for (std::size_t k = 0; k < 3; ++k) at[k] += hit->depth * line.ray.direction[k];
            const auto& ends = mesh->sticks.rods.edges[hit->index].balls;
            const auto away = [&](BallIndex end) {
              const Vector to = minus(vector(mesh->sticks.places->centres[end]), at);
              return dot(to, to);
            };
            hit->index = mesh->sticks.atom_of_place[ends[away(ends[1]) < away(ends[0]) ? 1 : 0]];
            return hit;
          }};
}

PickLayer atoms_of_object(std::shared_ptr<const BallGeometry> balls,
                          std::shared_ptr<const std::vector<std::uint32_t>> atoms) {
  const PickLayer layer = ball_layer(kAtomOfObject, std::move(balls), 1);
  return {kAtomOfObject, [layer, atoms](const PickLine& line) {
            std::optional<Hit> hit = layer.pick(line);
            if (hit) hit->index = atoms->at(hit->index);
            return hit;
          }};
}

}  // namespace

PickLayers object_layers(const std::shared_ptr<const ObjectMesh>& mesh) {
  using Atoms = const std::vector<std::uint32_t>;
  constexpr float kDot = 0.3F;  // Å
  PickLayers layers;
  if (!mesh) return layers;
  if (mesh->cartoon.triangles() > 0) {
    layers.push_back(layer_of(CartoonCells{mesh}, {kAtomOfObject, 1}));
  }
  if (mesh->sticks.places) layers.push_back(stick_layer(mesh));
  if (mesh->spheres) {
    layers.push_back(
        atoms_of_object(mesh->spheres, std::shared_ptr<Atoms>(mesh, &mesh->atom_of_sphere)));
  }
  if (mesh->dots.points() > 0) {
    BallGeometry dots;
    for (std::size_t i = 0; i < mesh->dots.points(); ++i) {
      const float* p = &mesh->dots.xyz[3 * i];
      dots.centres.push_back({p[0], p[1], p[2]});
    }
    dots.radii.assign(dots.centres.size(), kDot);
    layers.push_back(atoms_of_object(std::make_shared<const BallGeometry>(std::move(dots)),
                                     std::shared_ptr<Atoms>(mesh, &mesh->dots.source)));
  }
  return layers;
}

std::optional<Hit> nearest_hit(const PickLayers& layers, const PickLine& line) {
  std::optional<Hit> nearest;
  for (const PickLayer& layer : layers) {
    const std::optional<Hit> hit = layer.pick(line);
    if (hit && (!nearest || hit->depth < nearest->depth)) nearest = hit;
  }
  if (!nearest) return nearest;
  for (std::size_t k = 0; k < 3; ++k) {
    nearest->at[k] = line.ray.start[k] + nearest->depth * line.ray.direction[k];
  }
  return nearest;
}

HitSimplex hit_simplex(const Hit& hit, const AlphaComplex& complex) {
  HitSimplex simplex;
  if (hit.opposite) {
    const auto& tetrahedron = complex.tetrahedra.simplices.at(hit.index);
    for (int k = 0; k < 4; ++k) {
      if (k != *hit.opposite) simplex.balls.push_back(tetrahedron[static_cast<std::size_t>(k)]);
    }
    const auto place = find_in<3>(complex.triangles, simplex.balls);
    if (place) describe(complex.triangles, *place, complex.lattice, simplex);
  } else if (hit.corners == 2) {
    describe(complex.edges, hit.index, complex.lattice, simplex);
  } else if (hit.corners == 3) {
    describe(complex.triangles, hit.index, complex.lattice, simplex);
  } else if (hit.corners == 4) {
    describe(complex.tetrahedra, hit.index, complex.lattice, simplex);
  }
  return simplex;
}

bool has_simplex(const AlphaComplex& complex, const std::vector<BallIndex>& balls) {
  if (balls.size() == 4) return find_in<4>(complex.tetrahedra, balls).has_value();
  if (complex.tetrahedra_only) return true;
  if (balls.size() == 3) return find_in<3>(complex.triangles, balls).has_value();
  if (balls.size() == 2) return find_in<2>(complex.edges, balls).has_value();
  return false;
}

}  // namespace alphascope
