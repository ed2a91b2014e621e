// SPDX-License-Identifier: GPL-3.0-or-later
// Fills the arrays by all threads. Each element is written once, at a position known in advance.
#include "ui/scene/mesh/complex_mesh.hpp"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <utility>

#include "core/geometry/alpha.hpp"
#include "core/molecule/rgb8.hpp"
#include "core/run/parallel.hpp"
#include "core/triangulation/indices_where.hpp"
#include "ui/scene/mesh/simplex_colours.hpp"

namespace alphascope {
namespace {

using Point = std::array<float, 3>;

// Six times the signed volume of p0 p1 p2 p3. Only the orientation of faces depends on it, so
// floats suffice.
double orientation(const Point& p0, const Point& p1, const Point& p2, const Point& p3) {
  double a[3], b[3], c[3];
  for (int k = 0; k < 3; ++k) {
    a[k] = p1[k] - p0[k];
    b[k] = p2[k] - p0[k];
    c[k] = p3[k] - p0[k];
  }
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// The normal of a face; its length is twice the area.
Point doubled_area(const Point& p0, const Point& p1, const Point& p2) {
  const Point a{p1[0] - p0[0], p1[1] - p0[1], p1[2] - p0[2]};
  const Point b{p2[0] - p0[0], p2[1] - p0[1], p2[2] - p0[2]};
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Corners of a face, counterclockwise when seen from outside its tetrahedron.
std::array<BallIndex, 3> outward(const BallGeometry& balls, const Simplices<4>& tetrahedra,
                                 FaceCode face) {
  const auto v = face_vertices(tetrahedra, face);
  const BallIndex opposite = tetrahedra[tetrahedron_of(face)][face % 4];
  // The code has no branch here, because the processor would mispredict half of the cases.
  const std::size_t turned = orientation(balls.centres[v[0]], balls.centres[v[1]],
                                         balls.centres[v[2]], balls.centres[opposite]) > 0;
  return {v[0], v[1 + turned], v[2 - turned]};
}

class MeshBuilder {
 public:
  MeshBuilder(const BallGeometry& balls, const std::vector<Rgb8>& colours,
              const AlphaComplex& complex, const MeshOptions& options, const CancelToken& cancel)
      : balls_(balls), colours_(colours), complex_(complex), options_(options), cancel_(cancel) {
    if (options.colouring != ComplexColouring::alpha) return;
    const bool solid = options.tetrahedra || options.boundary;
    scale_.emplace(complex, AlphaScale::Drawn{solid, options.triangles, options.edges},
                   options.alpha_colours);
  }

  ComplexMesh build() {
    require_balls_of_all();
    ComplexMesh mesh;
    const bool whole = options_.whole_tetrahedra(), outside = options_.tetrahedra && !whole;
    if (options_.tetrahedra) mesh.tetrahedra_drawn = complex_.tetrahedra.size();
    if (whole) mesh.tetrahedra = tetrahedra();
    if (options_.outside()) {
      ResultArray<FaceCode> faces = outside_of_all();
      if (outside && options_.boundary) {
        mesh.boundary = faces_of_tetrahedra(faces, SimplexClass::regular);
      }
      (outside ? mesh.outside : mesh.boundary) = faces_of_tetrahedra(
          std::move(faces), outside ? SimplexClass::interior : SimplexClass::regular);
    }
    if (options_.smooth_boundary) add_normals(mesh.boundary);
    if (options_.triangles) mesh.triangles = triangles();
    if (options_.edges) mesh.edges = edges();
    if (!mesh.empty()) mesh.scale = scale_;
    return mesh;
  }

 private:
  // Finds outside faces without classes. The complex of a faulty engine may have classes that
  // contradict its tetrahedra. The comparison with CGAL must still draw it.
  ResultArray<FaceCode> outside_of_all() const {
    try {
      return outer_faces(complex_, cancel_);
    } catch (const std::invalid_argument&) {
      return outer_faces(complex_.tetrahedra.simplices, cancel_);
    }
  }

  template <int N>
  bool fits(const SimplexList<N>& list) const {
    std::atomic<bool> fits = true;
    parallel_many(list.size(), cancel_, [&](std::size_t i) {
      if (list.simplices[i].back() >= balls_.centres.size()) fits = false;
    });
    return fits;
  }

  void require_balls_of_all() const {
    const MeshOptions& o = options_;
    // Where a device found the faces outside, only their tetrahedra are read, and checked then.
    const bool solid = o.whole_tetrahedra() || (o.outside() && !complex_.outside);
    if (colours_.size() == balls_.centres.size() && (!solid || fits(complex_.tetrahedra)) &&
        (!o.triangles || fits(complex_.triangles)) && (!o.edges || fits(complex_.edges))) {
      return;
    }
    throw_not_together();
  }
  [[noreturn]] static void throw_not_together() {
    throw std::invalid_argument("the complex, the balls and their colours do not belong together");
  }

  template <int N>
  Rgb8 colour_of(const SimplexList<N>& list, std::size_t i) const {
    return colour_of(list, i, i < list.classes.size() ? list.classes[i] : SimplexClass::interior);
  }
  template <int N>
  Rgb8 colour_of(const SimplexList<N>& list, std::size_t i, SimplexClass of_class) const {
    const float value = i < list.alpha_values.size() ? list.alpha_values[i] : 0.0f;
    return simplex_colour(list.simplices[i], {value, of_class}, options_, colours_,
                          scale_ ? &*scale_ : nullptr);
  }

  TetrahedronCells tetrahedra() const {
    const auto& list = complex_.tetrahedra;
    TetrahedronCells cells;
    cells.shrink = static_cast<float>(options_.shrink);
    cells.balls.resize(list.size());
    cells.colours.resize(list.size());
    parallel_many(list.size(), cancel_, [&](std::size_t t) {
      cells.balls[t] = list.simplices[t];
      cells.colours[t] = packed(colour_of(list, t));
    });
    return cells;
  }

  // Faces have the colours of their tetrahedra. In ComplexColouring::classes they have the colour
  // of `of_class`. The boundary consists of triangles with a class of their own; outside faces
  // represent tetrahedra.
  FaceCells faces_of_tetrahedra(ResultArray<FaceCode> codes, SimplexClass of_class) const {
    const auto& list = complex_.tetrahedra;
    FaceCells cells;
    cells.faces.resize(codes.size());
    std::atomic<bool> fit = true;
    parallel_many(codes.size(), cancel_, [&](std::size_t n) {
      const std::uint32_t t = tetrahedron_of(codes[n]);
      if (t >= list.size() || list.simplices[t].back() >= balls_.centres.size()) {
        fit = false;
        return;
      }
      cells.faces[n] = {outward(balls_, list.simplices, codes[n]),
                        packed(colour_of(list, t, of_class))};
    });
    if (!fit) throw_not_together();
    cells.source = std::move(codes);
    return cells;
  }

  // One thread adds in the order of the faces, so that the sums do not depend on the number of
  // threads.
  void add_normals(FaceCells& cells) const {
    if (cells.size() == 0) return;
    cells.normals.assign(balls_.centres.size(), {});
    for (const DrawnFace& face : cells.faces) {
      cancel_.throw_if_cancelled();
      const auto doubled =
          doubled_area(balls_.centres[face.balls[0]], balls_.centres[face.balls[1]],
                       balls_.centres[face.balls[2]]);
      for (const BallIndex ball : face.balls) {
        for (std::size_t k = 0; k < 3; ++k) cells.normals[ball][k] += doubled[k];
      }
    }
  }

  // Calls prepare(count), then body(n, i) for each simplex drawn: n is its cell, i its index in
  // `list`. Returns the indices i; empty if the whole list is drawn.
  template <int N, class Prepare, class Body>
  ResultArray<std::uint32_t> for_drawn(const SimplexList<N>& list, const Prepare& prepare,
                                       const Body& body) const {
    if (!options_.singular_only) {
      prepare(list.size());
      parallel_many(list.size(), cancel_, [&](std::size_t i) { body(i, i); });
      return {};
    }
    // If all centres lie in a plane or on a line, the largest simplices are interior, but no faces
    // of larger ones.
    const bool largest = balls_.dimension < 3 && N == balls_.dimension + 1;
    const auto singular = [&](std::size_t i) {
      return largest || list.classes[i] == SimplexClass::singular;
    };
    ResultArray<std::uint32_t> places = indices_where(list.size(), singular, cancel_);
    prepare(places.size());
    parallel_many(places.size(), cancel_, [&](std::size_t n) { body(n, places[n]); });
    return places;
  }

  FaceCells triangles() const {
    const auto& list = complex_.triangles;
    FaceCells cells;
    cells.source = for_drawn(
        list, [&](std::size_t count) { cells.faces.resize(count); },
        [&](std::size_t n, std::size_t i) {
          cells.faces[n] = {list.simplices[i], packed(colour_of(list, i))};
        });
    return cells;
  }

  EdgeCells edges() const {
    const auto& list = complex_.edges;
    EdgeCells cells;
    cells.source = for_drawn(
        list, [&](std::size_t count) { cells.edges.resize(count); },
        [&](std::size_t n, std::size_t i) {
          const PackedColour colour = packed(colour_of(list, i));
          cells.edges[n] = {list.simplices[i], colour, colour};
        });
    return cells;
  }

  const BallGeometry& balls_;
  const std::vector<Rgb8>& colours_;
  const AlphaComplex& complex_;
  const MeshOptions& options_;
  const CancelToken& cancel_;
  std::optional<AlphaScale> scale_;
};

}  // namespace

ComplexMesh build_mesh(const BallGeometry& balls, const std::vector<Rgb8>& colours,
                       const AlphaComplex& complex, const MeshOptions& options,
                       const CancelToken& cancel) {
  return MeshBuilder(balls, colours, complex, options, cancel).build();
}

std::array<Point, 4> shrunk_corners(const BallGeometry& balls,
                                    const std::array<BallIndex, 4>& tetrahedron, float shrink) {
  std::array<Point, 4> p;
  Point centre{};
  for (std::size_t i = 0; i < 4; ++i) {
    p[i] = balls.centres[tetrahedron[i]];
    for (std::size_t k = 0; k < 3; ++k) centre[k] += 0.25f * p[i][k];
  }
  for (Point& corner : p) {
    for (std::size_t k = 0; k < 3; ++k) corner[k] += shrink * (centre[k] - corner[k]);
  }
  return p;
}

Simplices<3> boundary_faces(const BallGeometry& balls, const Simplices<4>& tetrahedra) {
  const auto faces = outer_faces(tetrahedra);
  Simplices<3> result(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) result[i] = outward(balls, tetrahedra, faces[i]);
  return result;
}

}  // namespace alphascope
