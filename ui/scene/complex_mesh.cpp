// Filling of the arrays: one pass per kind of simplex, plus a sort for the faces that occur once.
#include "ui/scene/complex_mesh.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/complex/count_limits.hpp"
#include "ui/scene/simplex_colours.hpp"

namespace alphascope {
namespace {

using Point = std::array<float, 3>;

// The face opposite to each corner of a tetrahedron.
constexpr int kFaces[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};

class MeshBuilder {
 public:
  MeshBuilder(const BallGeometry& balls, const std::vector<Rgb8>& colours,
              const AlphaComplex& complex, const MeshOptions& options)
      : balls_(balls),
        colours_(colours),
        complex_(complex),
        options_(options),
        scale_(complex,
               {options.tetrahedra || options.boundary, options.triangles, options.edges}) {}

  ComplexMesh build() {
    ComplexMesh mesh;
    if (options_.tetrahedra) {
      mesh.tetrahedra_drawn = complex_.tetrahedra.size();
      const bool only_outside = options_.shrink <= 0 && !options_.translucent;
      if (only_outside) {
        add_boundary(mesh.tetrahedra);
      } else {
        add_tetrahedra(mesh.tetrahedra);
      }
    }
    if (options_.boundary) add_boundary(mesh.boundary);
    if (options_.triangles) add_list(complex_.triangles, mesh.triangles);
    if (options_.edges) add_list(complex_.edges, mesh.edges);
    if (options_.colouring == ComplexColouring::alpha && mesh.points() > 0) mesh.scale = scale_;
    return mesh;
  }

 private:
  template <std::size_t N>
  Rgb8 colour_of(const std::array<BallIndex, N>& simplex, float alpha_value) const {
    return simplex_colour(simplex, alpha_value, options_, colours_, &scale_);
  }

  static void add_point(CellSoup& soup, const Point& p, const Rgb8& c) {
    soup.xyz.insert(soup.xyz.end(), p.begin(), p.end());
    soup.rgb.insert(soup.rgb.end(), {c.r, c.g, c.b});
  }

  // Exactly: growing arrays would take three times as much for a moment.
  static void reserve(CellSoup& soup, std::size_t points) {
    soup.xyz.reserve(3 * points);
    soup.rgb.reserve(3 * points);
  }

  static float alpha_value(const ResultArray<float>& values, std::size_t i) {
    return i < values.size() ? values[i] : 0.0f;
  }

  void add_tetrahedra(CellSoup& soup) const {
    const auto& list = complex_.tetrahedra;
    reserve(soup, 12 * list.size());
    const float shrink = static_cast<float>(options_.shrink);
    for (std::size_t t = 0; t < list.size(); ++t) {
      const auto& simplex = list.simplices[t];
      std::array<Point, 4> p;
      Point centre{};
      for (int i = 0; i < 4; ++i) {
        p[i] = balls_.centres[simplex[i]];
        for (int k = 0; k < 3; ++k) centre[k] += 0.25f * p[i][k];
      }
      for (Point& corner : p) {
        for (int k = 0; k < 3; ++k) corner[k] += shrink * (centre[k] - corner[k]);
      }
      const Rgb8 colour = colour_of(simplex, alpha_value(list.alpha_values, t));
      for (const auto& face : kFaces) {
        for (const int i : face) add_point(soup, p[i], colour);
      }
    }
  }

  void add_boundary(CellSoup& soup) const;

  template <int N>
  void add_list(const SimplexList<N>& list, CellSoup& soup) const {
    const auto drawn = [&](SimplexClass c) {
      return !options_.singular_only || c == SimplexClass::singular;
    };
    const auto count =
        static_cast<std::size_t>(std::count_if(list.classes.begin(), list.classes.end(), drawn));
    reserve(soup, N * count);
    const bool all = count == list.size();
    if (!all) soup.source.reserve(count);
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (!drawn(list.classes[i])) continue;
      if (!all) soup.source.push_back(static_cast<std::uint32_t>(i));
      const auto& simplex = list.simplices[i];
      const Rgb8 colour = colour_of(simplex, alpha_value(list.alpha_values, i));
      for (const BallIndex v : simplex) add_point(soup, balls_.centres[v], colour);
    }
  }

  const BallGeometry& balls_;
  const std::vector<Rgb8>& colours_;
  const AlphaComplex& complex_;
  const MeshOptions& options_;
  AlphaScale scale_;
};

// A face of a tetrahedron and where it comes from.
struct Face {
  std::array<BallIndex, 3> vertices;
  std::uint32_t origin;  // 4 * tetrahedron + opposite corner
};

// Faces that occur once, in lexicographic order: a counting sort by the smallest vertex leaves only
// a few dozen faces to each comparison sort.
std::vector<Face> single_faces(const Simplices<4>& tetrahedra, std::size_t ball_count) {
  require_face_records(tetrahedra.size(), 4);
  std::vector<std::uint32_t> start(ball_count + 1, 0);
  for (const auto& t : tetrahedra) {
    start[t[0] + 1] += 3;
    start[t[1] + 1] += 1;
  }
  for (std::size_t i = 0; i < ball_count; ++i) start[i + 1] += start[i];
  std::vector<Face> faces(4 * tetrahedra.size());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
    for (int opposite = 0; opposite < 4; ++opposite) {
      Face face;
      for (int k = 0; k < 3; ++k) face.vertices[k] = tetrahedra[t][kFaces[opposite][k]];
      face.origin = static_cast<std::uint32_t>(4 * t + opposite);
      faces[next[face.vertices[0]]++] = face;
    }
  }
  std::vector<Face> result;
  for (std::size_t v = 0; v < ball_count; ++v) {
    const auto begin = faces.begin() + start[v], end = faces.begin() + start[v + 1];
    std::sort(begin, end, [](const Face& a, const Face& b) { return a.vertices < b.vertices; });
    for (auto it = begin; it != end;) {
      const bool twice = it + 1 != end && (it + 1)->vertices == it->vertices;
      if (!twice) result.push_back(*it);
      it += twice ? 2 : 1;
    }
  }
  return result;
}

// Six times the signed volume of p0 p1 p2 p3; only for the direction in which a face looks.
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

std::array<BallIndex, 3> outward(const BallGeometry& balls, const Face& face,
                                 const Simplices<4>& tetrahedra) {
  auto v = face.vertices;
  const BallIndex opposite = tetrahedra[face.origin / 4][face.origin % 4];
  if (orientation(balls.centres[v[0]], balls.centres[v[1]], balls.centres[v[2]],
                  balls.centres[opposite]) > 0) {
    std::swap(v[1], v[2]);
  }
  return v;
}

void MeshBuilder::add_boundary(CellSoup& soup) const {
  const auto& list = complex_.tetrahedra;
  const std::vector<Face> faces = single_faces(list.simplices, balls_.centres.size());
  reserve(soup, 3 * faces.size());
  soup.source.reserve(faces.size());
  for (const Face& face : faces) {
    soup.source.push_back(face.origin);
    const std::size_t t = face.origin / 4;  // its tetrahedron, whose colour it has
    const Rgb8 colour = colour_of(list.simplices[t], alpha_value(list.alpha_values, t));
    for (const BallIndex v : outward(balls_, face, list.simplices)) {
      add_point(soup, balls_.centres[v], colour);
    }
  }
}

template <int N>
bool fits(const SimplexList<N>& list, std::size_t balls) {
  return std::all_of(list.simplices.begin(), list.simplices.end(),
                     [balls](const auto& s) { return s.back() < balls; });
}

}  // namespace

ComplexMesh build_mesh(const BallGeometry& balls, const std::vector<Rgb8>& colours,
                       const AlphaComplex& complex, const MeshOptions& options) {
  const std::size_t count = balls.centres.size();
  if (colours.size() != count || !fits(complex.edges, count) || !fits(complex.triangles, count) ||
      !fits(complex.tetrahedra, count)) {
    throw std::invalid_argument("the complex, the balls and their colours do not belong together");
  }
  return MeshBuilder(balls, colours, complex, options).build();
}

Simplices<3> boundary_faces(const BallGeometry& balls, const Simplices<4>& tetrahedra) {
  Simplices<3> result;
  for (const Face& face : single_faces(tetrahedra, balls.centres.size())) {
    result.push_back(outward(balls, face, tetrahedra));
  }
  return result;
}

}  // namespace alphascope
