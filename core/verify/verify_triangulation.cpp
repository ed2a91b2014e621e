// SPDX-License-Identifier: GPL-3.0-or-later
// Proves a triangulation. This is why the checks are enough, in dimension d, where a cell has d + 1
// balls and a facet has d of them:
//
//  1. No cell is flat. Each facet belongs to two cells, whose other balls are on opposite sides of
//     it, or to one cell, and then it is a facet of the hull. So the number of cells that cover a
//     point changes only where the point crosses a facet of the hull.
//  2. All vertices of the hull are behind each of its facets, or in its plane. So the facets lie on
//     the boundary of a convex body C, no cell covers a point outside of C, and all points inside
//     are covered equally often.
//  3. The middle of one cell is in no other cell, so each point is covered once. So the cells are a
//     triangulation of C, and all vertices are in C.
//  4. At each inner facet the other ball of one cell is not in conflict with the orthosphere of the
//     other cell (perturbed if there is a tie). A triangulation of a convex body that is regular at
//     each of its facets is regular (H. Edelsbrunner, Geometry and Topology for Mesh Generation,
//     2001, chapters 2 and 5), so it is the regular triangulation of its vertices.
//  5. Each other ball has the centre of a vertex that precedes it, or it is in a cell and not in
//     conflict with that cell's orthosphere. In both cases it would not be a vertex.
//
// The Euler number follows from these; it is checked all the same.
#include "core/verify/verify_triangulation.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "core/complex/face_groups.hpp"
#include "core/verify/findings.hpp"
#include "core/verify/verify_orthosphere.hpp"
#include "core/verify/verify_run.hpp"

namespace alphascope {
namespace {

using Vector = std::array<std::int64_t, 3>;

Vector position(const BallSet& balls, BallIndex i) {
  const LatticePoint& p = balls.centres[i];
  return {p.x, p.y, p.z};
}
Vector difference(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector cross_product(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
// Coordinates below 2^32 give cross products below 2^65, so each term is computed in 128 bits.
Int128 triple_product(const Vector& a, const Vector& b, const Vector& c) {
  const auto term = [&](int x, int y, int z) {
    return (Int128{a[y]} * b[z] - Int128{a[z]} * b[y]) * c[x];
  };
  return term(0, 1, 2) + term(1, 2, 0) + term(2, 0, 1);
}

// The affine hull of all centres, and axes onto which it projects without losing a dimension.
struct AffineHull {
  int dimension = -1;
  std::array<int, 3> axes{0, 1, 2};  // the first `dimension` axes are used
};

int largest_axis(const Vector& v) {
  int axis = 0;
  for (int a = 1; a < 3; ++a) {
    if (std::abs(v[a]) > std::abs(v[axis])) axis = a;
  }
  return axis;
}

AffineHull affine_hull(const BallSet& balls) {
  AffineHull hull;
  if (balls.size() == 0) return hull;
  hull.dimension = 0;
  Vector along{}, normal{};
  for (BallIndex i = 1; i < balls.size() && hull.dimension < 3; ++i) {
    const Vector d = difference(position(balls, i), position(balls, 0));
    if (hull.dimension == 0 && d != Vector{}) {
      hull = {1, {largest_axis(d), 1, 2}};
      along = d;
    } else if (hull.dimension == 1 && cross_product(along, d) != Vector{}) {
      normal = cross_product(along, d);
      const int dropped = largest_axis(normal);
      hull = {2, {(dropped + 1) % 3, (dropped + 2) % 3, dropped}};
    } else if (hull.dimension == 2 &&
               Int128{normal[0]} * d[0] + Int128{normal[1]} * d[1] + Int128{normal[2]} * d[2] !=
                   0) {
      hull = {3, {0, 1, 2}};
    }
  }
  return hull;
}

template <int D>
class TriangulationProof {
 public:
  using Cell = std::array<BallIndex, D + 1>;
  using Facet = std::array<BallIndex, D>;

  TriangulationProof(const BallSet& balls, const Triangulation& triangulation,
                     const Simplices<D + 1>& cells, const AffineHull& hull,
                     const RunContext& context, Findings& findings)
      : balls_(balls),
        triangulation_(triangulation),
        cells_(cells),
        axes_(hull.axes),
        context_(context),
        findings_(findings) {}

  void run() {
    if (!check_order<D + 1>(balls_, cells_, findings_)) return;
    findings_.check(!cells_.empty(), "no simplices of the dimension of the centres");
    verify_all(cells_.size(), context_, [&](std::size_t c) {
      findings_.check<D + 1>(orientation(cells_[c]) != 0, cells_[c], "flat");
    });
    if (!findings_.good()) return;
    facets_.emplace(cells_, context_.cancel);
    check_vertices();
    check_facets();
    if (!findings_.good()) return;
    check_hull();
    check_covered_once();
    check_euler_number();
    if (findings_.good()) check_hidden();
  }

 private:
  static constexpr std::uint32_t kOutside = ~std::uint32_t{0};
  using Points = std::array<Vector, D + 1>;

  // Sign of the determinant of the edges from the first of D + 1 points; 0 if they are flat.
  int orientation(const Points& points) const {
    Vector edge[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int n = 0; n < D; ++n) {
      const Vector d = difference(points[n + 1], points[0]);
      for (int a = 0; a < D; ++a) edge[n][a] = d[axes_[a]];
    }
    return sign_of(triple_product(edge[0], edge[1], edge[2]));
  }
  int orientation(const Cell& cell) const {
    Points points;
    for (int n = 0; n <= D; ++n) points[n] = position(balls_, cell[n]);
    return orientation(points);
  }
  // The side of a facet on which a ball is: -1 or 1, or 0 for its plane.
  int side(const Facet& facet, BallIndex m) const {
    Cell cell{};
    std::copy(facet.begin(), facet.end(), cell.begin());
    cell[D] = m;
    return orientation(cell);
  }

  // Is ball m neither in conflict with the cell's orthosphere nor preferred to the cell in a tie?
  bool stays_out(const Cell& cell, BallIndex m) const {
    const Orthosphere<D + 1> sphere(balls_, cell);
    const int side = sphere.side(m);
    return side > 0 || (side == 0 && sphere.tie(m) == Tie::harmless);
  }

  static int corner_of(const Cell& cell, BallIndex ball) {
    return static_cast<int>(std::find(cell.begin(), cell.end(), ball) - cell.begin());
  }

  void check_vertices() {
    std::vector<bool> used(balls_.size(), false);
    for (const Cell& cell : cells_) {
      for (const BallIndex v : cell) used[v] = true;
    }
    for (BallIndex i = 0; i < balls_.size(); ++i) {
      const auto& list = used[i] ? triangulation_.vertices : triangulation_.hidden;
      findings_.check<1>(std::binary_search(list.begin(), list.end(), i), {i},
                         used[i] ? "not listed as a vertex" : "not listed as hidden");
    }
  }

  void check_facets() {
    across_.assign(cells_.size(), {});
    verify_all(facets_->size(), context_, [&](std::size_t f) {
      const Facet& facet = facets_->faces()[f];
      std::uint32_t cell[2] = {0, 0};
      std::size_t count = 0;
      facets_->for_cofaces(f,
                           [&](std::uint32_t c) { cell[std::min<std::size_t>(count++, 1)] = c; });
      findings_.check<D>(count <= 2, facet, "a face of more than two simplices");
      if (count > 2) return;
      const BallIndex apex_0 = apex<D>(cells_[cell[0]], facet);
      if (count == 1) {
        across_[cell[0]][corner_of(cells_[cell[0]], apex_0)] = kOutside;
        return;
      }
      const BallIndex apex_1 = apex<D>(cells_[cell[1]], facet);
      across_[cell[0]][corner_of(cells_[cell[0]], apex_0)] = cell[1];
      across_[cell[1]][corner_of(cells_[cell[1]], apex_1)] = cell[0];
      findings_.check<D>(side(facet, apex_0) == -side(facet, apex_1), facet,
                         "its two simplices are on the same side of it");
      findings_.check<D>(stays_out(cells_[cell[0]], apex_1), facet,
                         "not regular: the ball beyond it is in conflict with its simplex");
    });
    for (std::size_t f = 0; f < facets_->size(); ++f) {
      if (facets_->coface_count(f) == 1) hull_.push_back(facets_->faces()[f]);
    }
    if constexpr (D == 3) check_neighbours();
  }

  // Checks that the lists of neighbours and of the hull agree with the facets.
  void check_neighbours() {
    findings_.check(triangulation_.neighbours.size() == cells_.size(),
                    "the neighbours are not four for each tetrahedron");
    findings_.check(triangulation_.hull.size() == hull_.size(),
                    "the hull has not as many facets as tetrahedra have faces without a neighbour");
    if (!findings_.good()) return;
    for (std::size_t h = 0; h < hull_.size(); ++h) {
      findings_.check<D>(triangulation_.hull[h].ascending() == hull_[h], hull_[h],
                         "not a facet of the hull, or out of order there");
    }
    if (!findings_.good()) return;  // a facet may name balls that do not exist
    verify_all(cells_.size(), context_, [&](std::size_t c) {
      for (int corner = 0; corner < 4; ++corner) check_neighbour(c, corner);
    });
  }
  void check_neighbour(std::size_t c, int corner) {
    const Neighbour neighbour = triangulation_.neighbours[c][corner];
    const bool outside = across_[c][corner] == kOutside;
    const bool right = outside ? neighbour.is_hull() && neighbour.index() < hull_.size()
                               : neighbour == Neighbour::tetrahedron(across_[c][corner]);
    findings_.check<D + 1>(right, cells_[c], "a neighbour is wrong");
    if (!right || !outside) return;
    const HullFacet& facet = triangulation_.hull[neighbour.index()];
    const bool opposite =
        facet.tetrahedron == c && apex<D>(cells_[c], facet.ascending()) == cells_[c][corner];
    findings_.check<D>(opposite, facet.balls, "the hull's facet is another tetrahedron's");
    findings_.check<D>(side(facet.balls, cells_[c][corner]) < 0, facet.balls,
                       "not counterclockwise when seen from outside");
  }

  void check_hull() {
    if constexpr (D > 1) {
      const FaceGroups<D - 1> ridges(hull_);
      for (std::size_t r = 0; r < ridges.size(); ++r) {
        findings_.check<D - 1>(ridges.coface_count(r) == 2, ridges.faces()[r],
                               "the hull is not closed there");
      }
    }
    std::vector<BallIndex> vertices;
    for (const Facet& facet : hull_) vertices.insert(vertices.end(), facet.begin(), facet.end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    verify_all(facets_->size(), context_, [&](std::size_t f) {
      if (facets_->coface_count(f) != 1) return;
      const Facet& facet = facets_->faces()[f];
      int inside = 0;
      facets_->for_cofaces(
          f, [&](std::uint32_t c) { inside = side(facet, apex<D>(cells_[c], facet)); });
      const bool convex = std::all_of(vertices.begin(), vertices.end(),
                                      [&](BallIndex v) { return side(facet, v) != -inside; });
      findings_.check<D>(convex, facet, "the hull is not convex there");
    });
  }

  // Checks that the middle of the first cell is in no other cell. All coordinates are multiplied by
  // D + 1. They are below 2^33 then, and differences below 2^32, because centres are within 2^29.
  void check_covered_once() {
    Vector middle{};
    for (const BallIndex v : cells_[0]) {
      for (int a = 0; a < 3; ++a) middle[a] += position(balls_, v)[a];
    }
    verify_all(cells_.size(), context_, [&](std::size_t c) {
      if (c > 0)
        findings_.check<D + 1>(!contains(cells_[c], middle), cells_[c], "overlaps another");
    });
  }
  bool contains(const Cell& cell, const Vector& middle) const {
    Points points;
    for (int n = 0; n <= D; ++n) {
      points[n] = position(balls_, cell[n]);
      for (std::int64_t& x : points[n]) x *= D + 1;
    }
    const int whole = orientation(points);
    for (int n = 0; n <= D; ++n) {
      const Vector corner = std::exchange(points[n], middle);
      if (orientation(points) == -whole) return false;
      points[n] = corner;
    }
    return true;
  }

  // V - E + F of the facets and their faces, down to the vertices.
  template <int N>
  static long long euler_number(const Simplices<N>& simplices) {
    const auto count = static_cast<long long>(simplices.size());
    if constexpr (N == 1) {
      return count;
    } else {
      return euler_number<N - 1>(FaceGroups<N - 1>(simplices).faces()) +
             (N % 2 == 0 ? -count : count);
    }
  }
  void check_euler_number() {
    const auto count = static_cast<long long>(cells_.size());
    findings_.check(euler_number<D>(facets_->faces()) + (D % 2 == 0 ? count : -count) == 1,
                    "the Euler number is not 1, as that of a convex body");
  }

  void check_hidden() {
    std::vector<BallIndex> by_centre = triangulation_.vertices;
    const auto centre_less = [&](BallIndex a, BallIndex b) {
      return balls_.centres[a] < balls_.centres[b];
    };
    std::sort(by_centre.begin(), by_centre.end(), centre_less);
    verify_all(triangulation_.hidden.size(), context_, [&](std::size_t n) {
      const BallIndex h = triangulation_.hidden[n];
      const auto same = std::lower_bound(by_centre.begin(), by_centre.end(), h, centre_less);
      if (same != by_centre.end() && balls_.centres[*same] == balls_.centres[h]) {
        findings_.check<1>(
            std::pair(-balls_.weight(*same), *same) < std::pair(-balls_.weight(h), h), {h},
            "hidden by a ball of the same centre that does not go before it");
        return;
      }
      const std::uint32_t cell = cell_around(h);
      findings_.check<1>(cell != kOutside && stays_out(cells_[cell], h), {h},
                         "hidden, but it would be a vertex");
    });
  }
  // Walks to the cell that contains a ball, across any facet that the ball is beyond. In a regular
  // triangulation the walk visits no cell twice. Returns kOutside if it leaves the hull.
  std::uint32_t cell_around(BallIndex ball) const {
    std::uint32_t at = 0;
    for (std::size_t step = 0; step < cells_.size() && at != kOutside; ++step) {
      const int beyond = corner_facing(cells_[at], ball);
      if (beyond < 0) return at;
      at = across_[at][beyond];
    }
    return kOutside;
  }
  // The corner whose opposite facet has the ball beyond it, or -1 if the ball is in the cell.
  int corner_facing(const Cell& cell, BallIndex ball) const {
    const int whole = orientation(cell);
    for (int corner = 0; corner <= D; ++corner) {
      Cell moved = cell;
      moved[corner] = ball;
      if (orientation(moved) == -whole) return corner;
    }
    return -1;
  }

  const BallSet& balls_;
  const Triangulation& triangulation_;
  const Simplices<D + 1>& cells_;
  const std::array<int, 3> axes_;
  const RunContext& context_;
  Findings& findings_;
  std::optional<FaceGroups<D>> facets_;
  // Per cell and corner, like the neighbours: a cell or kOutside.
  std::vector<std::array<std::uint32_t, D + 1>> across_;
  Simplices<D> hull_;
};

// Checks that the lists of vertices and hidden balls ascend, and together hold each ball once.
void check_partition(const BallSet& balls, const Triangulation& triangulation, Findings& findings) {
  const auto &vertices = triangulation.vertices, &hidden = triangulation.hidden;
  std::vector<BallIndex> all;
  std::merge(vertices.begin(), vertices.end(), hidden.begin(), hidden.end(),
             std::back_inserter(all));
  std::vector<BallIndex> expected(balls.size());
  std::iota(expected.begin(), expected.end(), 0);
  findings.check(all == expected,
                 "the lists of vertices and hidden balls do not contain each ball once, ascending");
}

// For balls at one point: the vertex is the largest ball, and the first of equal ones.
void check_point(const BallSet& balls, const Triangulation& triangulation, Findings& findings) {
  findings.check(triangulation.vertices.size() == 1,
                 "all centres are one point, but there is not exactly one vertex");
  if (!findings.good()) return;
  const auto largest = std::max_element(balls.radii.begin(), balls.radii.end());
  findings.check<1>(balls.radii.begin() + triangulation.vertices[0] == largest,
                    {triangulation.vertices[0]}, "not the first of the largest balls");
}

}  // namespace

Verification verify_triangulation(const BallSet& balls, const Triangulation& triangulation,
                                  const RunContext& context) {
  Findings findings;
  const AffineHull hull = affine_hull(balls);
  const int d = triangulation.dimension;
  findings.check(d == hull.dimension, "the dimension is not that of the centres");
  findings.check(d == 3 || (triangulation.tetrahedra.empty() && triangulation.neighbours.empty() &&
                            triangulation.hull.empty()),
                 "tetrahedra in less than three dimensions");
  findings.check(d == 2 || triangulation.triangles.empty(), "triangles, but not in a plane");
  findings.check(d == 1 || triangulation.edges.empty(), "edges, but not on a line");
  check_partition(balls, triangulation, findings);
  if (!findings.good()) return findings.take();
  const auto prove = [&]<int D>(const Simplices<D + 1>& cells) {
    TriangulationProof<D>(balls, triangulation, cells, hull, context, findings).run();
  };
  if (d == 0) check_point(balls, triangulation, findings);
  if (d == 1) prove.template operator()<1>(triangulation.edges);
  if (d == 2) prove.template operator()<2>(triangulation.triangles);
  if (d == 3) prove.template operator()<3>(triangulation.tetrahedra);
  return findings.take();
}

}  // namespace alphascope
