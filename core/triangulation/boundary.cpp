// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary is followed through the solid: from a triangle, around a side, through tetrahedra,
// to the next triangle of the boundary. So two sheets that touch along an edge stay separate, and
// each encloses its own side.
#include "core/triangulation/boundary.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "core/complex/face_groups.hpp"
#include "core/complex/outward_face.hpp"
#include "core/triangulation/union_find.hpp"

namespace alphascope {
namespace {

constexpr const char* kStage = "boundary";
// Flag in Builder::beyond_: the face is on the boundary. The other bits are then its index in
// faces_.
constexpr std::uint32_t kOuter = std::uint32_t{1} << 31;
constexpr std::uint32_t kNone = ~std::uint32_t{0};

// Face `face` of a tetrahedron, which lies opposite its ball `face`.
struct Face {
  std::uint32_t tetrahedron, face;
};

class Builder {
  // Middle vertices by triangle and side.
  using Middles = std::map<std::pair<std::uint32_t, std::size_t>, std::uint32_t>;

 public:
  Builder(const BallSet& balls, const Simplices<4>& tetrahedra, const RunContext& context)
      : balls_(balls), tetrahedra_(tetrahedra), context_(context) {}

  Boundary build() {
    step(0);
    find_neighbours();
    step(0.5);
    find_solids();
    step(0.6);
    list_faces();
    step(0.7);
    UnionFind corners = join_corners();
    step(0.9);
    write(corners);
    return std::move(boundary_);
  }

 private:
  void step(double share) const {
    context_.cancel.throw_if_cancelled();
    context_.report(kStage, share);
  }

  std::uint32_t& beyond(std::uint32_t t, std::size_t face) {
    return beyond_[4 * std::size_t{t} + face];
  }

  void find_neighbours() {
    beyond_.assign(4 * tetrahedra_.size(), kOuter);
    for_face_groups<3>(tetrahedra_, context_.cancel, [&](const FaceGroups<3>& groups) {
      for (std::size_t f = 0; f < groups.size(); ++f) {
        if (groups.coface_count(f) != 2) continue;
        std::array<std::uint32_t, 2> pair;
        std::size_t n = 0;
        groups.for_cofaces(f, [&](std::uint32_t t) { pair[n++] = t; });
        for (const auto& [t, other] : {std::pair(pair[0], pair[1]), std::pair(pair[1], pair[0])}) {
          beyond(t, index_of(t, apex<3>(tetrahedra_[t], groups.faces()[f]))) = other;
        }
      }
    });
  }

  std::size_t index_of(std::uint32_t t, BallIndex ball) const {
    const auto& corners = tetrahedra_[t];
    return static_cast<std::size_t>(std::find(corners.begin(), corners.end(), ball) -
                                    corners.begin());
  }

  // Finds the solids one after the other, in the order of their first tetrahedra, and then sorts
  // them by volume.
  void find_solids() {
    solid_.assign(tetrahedra_.size(), kNone);
    std::vector<std::uint32_t> waiting;
    std::vector<BoundarySolid> found;
    for (std::uint32_t first = 0; first < tetrahedra_.size(); ++first) {
      if (solid_[first] != kNone) continue;
      const auto id = static_cast<std::uint32_t>(found.size());
      BoundarySolid& solid = found.emplace_back();
      Int128 six_volumes = 0;  // 93 bits each, so 2^30 of them fit into 128 bits
      solid_[first] = id;
      waiting.push_back(first);
      while (!waiting.empty()) {
        const std::uint32_t t = waiting.back();
        waiting.pop_back();
        six_volumes += add_tetrahedron(t, solid);
        for (std::size_t k = 0; k < 4; ++k) {
          const std::uint32_t next = beyond(t, k);
          if (next == kOuter || solid_[next] == id) continue;
          solid_[next] = id;
          waiting.push_back(next);
        }
      }
      solid.volume_cubic_units = static_cast<double>(six_volumes) / 6;
    }
    sort_by_volume(found);
  }

  // Counts the tetrahedron and its boundary faces. Returns six times its volume.
  Int128 add_tetrahedron(std::uint32_t t, BoundarySolid& solid) {
    const auto& corners = tetrahedra_[t];
    const auto from = [&](std::size_t k) { return lifted_vector(balls_, corners[0], corners[k]); };
    ++solid.tetrahedra;
    for (std::size_t k = 0; k < 4; ++k) solid.triangles += beyond(t, k) == kOuter;
    const Int128 six = determinant(from(1), from(2), from(3));
    return six < 0 ? -six : six;
  }

  void sort_by_volume(const std::vector<BoundarySolid>& found) {
    std::vector<std::uint32_t> order(found.size()), rank(found.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return found[a].volume_cubic_units > found[b].volume_cubic_units;
    });
    std::uint32_t triangles = 0;
    for (std::uint32_t place = 0; place < order.size(); ++place) {
      rank[order[place]] = place;
      BoundarySolid& solid = boundary_.solids.emplace_back(found[order[place]]);
      solid.first_triangle = triangles;
      triangles += solid.triangles;
    }
    for (std::uint32_t& solid : solid_) solid = rank[solid];
  }

  void list_faces() {
    std::vector<std::uint32_t> next;
    std::size_t count = 0;
    for (const BoundarySolid& solid : boundary_.solids) {
      next.push_back(solid.first_triangle);
      count += solid.triangles;
    }
    require_face_records(count, 3);
    faces_.resize(count);
    for (std::uint32_t t = 0; t < tetrahedra_.size(); ++t) {
      for (std::uint32_t k = 0; k < 4; ++k) {
        if (beyond(t, k) != kOuter) continue;
        const std::uint32_t place = next[solid_[t]]++;
        faces_[place] = {t, k};
        beyond(t, k) = kOuter | place;
      }
    }
    solid_ = {};
  }

  // The triangle of the boundary that follows `from` around one of its sides. The side is named by
  // `c`: the index in the tetrahedron of the ball of `from` that is not on the side.
  std::uint32_t across(Face from, std::size_t c) {
    std::uint32_t t = from.tetrahedron;
    std::size_t k = from.face;
    while ((beyond(t, c) & kOuter) == 0) {
      const BallIndex turned = tetrahedra_[t][k];
      const std::uint32_t next = beyond(t, c);
      k = 0;
      while (beyond(next, k) != t) ++k;
      t = next;
      c = index_of(t, turned);
    }
    return beyond(t, c) & ~kOuter;
  }

  // The index of a corner of face `face`, which lies opposite ball k of its tetrahedron. The corner
  // is ball j of the tetrahedron; the face is not yet turned outwards.
  static std::uint32_t corner(std::uint32_t face, std::size_t k, std::size_t j) {
    return 3 * face + static_cast<std::uint32_t>(j < k ? j : j - 1);
  }

  UnionFind join_corners() {
    UnionFind corners(3 * faces_.size());
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      const auto [t, k] = faces_[f];
      for (std::size_t c = 0; c < 4; ++c) {
        if (c == k) continue;
        const std::uint32_t g = across(faces_[f], c);
        if (g < f) continue;  // joined already, from triangle g
        for (std::size_t j = 0; j < 4; ++j) {
          if (j == k || j == c) continue;
          const Face& other = faces_[g];
          const std::size_t there = index_of(other.tetrahedron, tetrahedra_[t][j]);
          corners.unite(corner(f, k, j), corner(g, other.face, there));
        }
      }
    }
    return corners;
  }

  void write(UnionFind& corners) {
    vertex_.assign(3 * faces_.size(), kNone);
    // A growing array is copied, and both copies need memory. So the arrays are reserved: closed
    // surfaces have half as many vertices as triangles, and rarely more.
    boundary_.triangles.reserve(faces_.size());
    boundary_.vertices.reserve(faces_.size() / 2);
    for (BoundarySolid& solid : boundary_.solids) {
      context_.cancel.throw_if_cancelled();
      first_face_ = solid.first_triangle;
      triangles_.clear();
      solid.first_vertex = static_cast<std::uint32_t>(boundary_.vertices.size());
      solid.first_triangle = static_cast<std::uint32_t>(boundary_.triangles.size());
      triangles_.reserve(solid.triangles);
      for (std::uint32_t n = 0; n < solid.triangles; ++n) add_triangle(first_face_ + n, corners);
      write_triangles();
      solid.vertices = static_cast<std::uint32_t>(boundary_.vertices.size()) - solid.first_vertex;
      solid.triangles =
          static_cast<std::uint32_t>(boundary_.triangles.size()) - solid.first_triangle;
    }
  }

  std::uint32_t add_vertex(BallIndex ball, BallIndex other) {
    boundary_.vertices.push_back({ball, other});
    return static_cast<std::uint32_t>(boundary_.vertices.size() - 1);
  }

  void add_triangle(std::uint32_t f, UnionFind& corners) {
    const auto [t, k] = faces_[f];
    const std::array<BallIndex, 3> outwards = outward_face(balls_, tetrahedra_[t], k);
    std::array<std::uint32_t, 3>& triangle = triangles_.emplace_back();
    for (std::size_t n = 0; n < 3; ++n) {
      std::uint32_t& at = vertex_[corners.root(corner(f, k, index_of(t, outwards[n])))];
      if (at == kNone) at = add_vertex(outwards[n], outwards[n]);
      triangle[n] = at;
    }
  }

  // The sides from vertex `from` to vertex `to` that occur in several pairs of triangles.
  std::vector<std::uint64_t> shared_sides() const {
    std::vector<std::uint64_t> sides, shared;
    sides.reserve(3 * triangles_.size() / 2);
    for (const auto& t : triangles_) {
      for (std::size_t n = 0; n < 3; ++n) {
        if (t[n] < t[(n + 1) % 3]) sides.push_back(side_of(t, n));
      }
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t n = 1; n < sides.size(); ++n) {
      if (sides[n] == sides[n - 1]) shared.push_back(sides[n]);
    }
    return shared;
  }
  static std::uint64_t side_of(const std::array<std::uint32_t, 3>& t, std::size_t n) {
    return std::uint64_t{t[n]} << 32 | t[(n + 1) % 3];
  }

  // Writes the triangles. Where several pairs of triangles share a side, all pairs but one get a
  // vertex in the middle of that side.
  void write_triangles() {
    Middles middles;
    const std::vector<std::uint64_t> shared = shared_sides();
    std::vector<bool> one_is_whole(shared.size(), false);
    for (std::uint32_t f = 0; !shared.empty() && f < triangles_.size(); ++f) {
      for (std::size_t n = 0; n < 3; ++n) {
        const auto at = std::lower_bound(shared.begin(), shared.end(), side_of(triangles_[f], n));
        if (at == shared.end() || *at != side_of(triangles_[f], n)) continue;
        const auto place = static_cast<std::size_t>(at - shared.begin());
        if (one_is_whole[place]) divide(f, n, middles);
        one_is_whole[place] = true;
      }
    }
    for (std::uint32_t f = 0; f < triangles_.size(); ++f) write_divided(f, middles);
  }

  void divide(std::uint32_t f, std::size_t n, Middles& middles) {
    const std::array<std::uint32_t, 3>& t = triangles_[f];
    const BallIndex a = boundary_.vertices[t[n]].ball, b = boundary_.vertices[t[(n + 1) % 3]].ball,
                    opposite = boundary_.vertices[t[(n + 2) % 3]].ball;
    const Face& face = faces_[first_face_ + f];
    const std::uint32_t other = across(face, index_of(face.tetrahedron, opposite)) - first_face_;
    const auto& back = triangles_[other];
    std::size_t there = 0;
    while (back[there] != t[(n + 1) % 3] || back[(there + 1) % 3] != t[n]) ++there;
    middles[{f, n}] = middles[{other, there}] = add_vertex(a, b);
  }

  void write_divided(std::uint32_t f, const Middles& middles) {
    const auto& t = triangles_[f];
    std::vector<std::uint32_t>& outline = outline_;
    outline.clear();
    std::size_t first = 0;  // a middle vertex if there is one: then no triangle of the fan is flat
    for (std::size_t n = 0; n < 3; ++n) {
      outline.push_back(t[n]);
      if (middles.empty()) continue;
      const auto middle = middles.find({f, n});
      if (middle == middles.end()) continue;
      first = outline.size();
      outline.push_back(middle->second);
    }
    for (std::size_t n = 1; n + 1 < outline.size(); ++n) {
      const auto corner_at = [&](std::size_t k) { return outline[(first + k) % outline.size()]; };
      boundary_.triangles.push_back({corner_at(0), corner_at(n), corner_at(n + 1)});
    }
  }

  const BallSet& balls_;
  const Simplices<4>& tetrahedra_;
  const RunContext& context_;
  // Per 4 × tetrahedron + face: the tetrahedron beyond, or kOuter and the index in faces_.
  std::vector<std::uint32_t> beyond_;
  std::vector<std::uint32_t> solid_;   // the solid of each tetrahedron
  std::vector<Face> faces_;            // faces of the boundary, solid by solid
  std::vector<std::uint32_t> vertex_;  // the vertex of each root of corners, or kNone
  // Data of the solid that is being written; faces are counted from first_face_.
  std::uint32_t first_face_ = 0;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<std::uint32_t> outline_;
  Boundary boundary_;
};

}  // namespace

RealPoint place_angstrom(const BallSet& balls, const BoundaryVertex& vertex) {
  const LatticePoint &a = balls.centres[vertex.ball], &b = balls.centres[vertex.other];
  const auto middle = [&](std::int32_t u, std::int32_t v) {
    return balls.lattice.angstrom((static_cast<double>(u) + v) / 2);
  };
  return {middle(a.x, b.x), middle(a.y, b.y), middle(a.z, b.z)};
}

Boundary make_boundary(const BallSet& balls, const Simplices<4>& tetrahedra,
                       const RunContext& context) {
  return Builder(balls, tetrahedra, context).build();
}

}  // namespace alphascope
