// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the triangles and edges of a triangulation from its tetrahedra, sorted by their first ball
// in parallel.
#include "core/triangulation/incidence.hpp"

#include <algorithm>
#include <atomic>
#include <vector>

#include "core/complex/count_limits.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

// The bounds of each ball's part in an array that is ordered by balls. Threads count the items of
// each ball, and then place them. So the order within a part is arbitrary.
class Buckets {
 public:
  explicit Buckets(std::size_t balls) : first_(balls + 1, 0) {}

  void count(BallIndex ball, std::uint32_t things) { add(first_[ball + 1], things); }
  void end_counting() {
    for (std::size_t b = 1; b < first_.size(); ++b) first_[b] += first_[b - 1];
    next_.assign(first_.begin(), first_.end() - 1);
  }
  std::uint32_t place_for(BallIndex ball) { return add(next_[ball], 1); }

  std::size_t balls() const { return first_.size() - 1; }
  std::uint32_t begin(std::size_t ball) const { return first_[ball]; }
  std::uint32_t end(std::size_t ball) const { return first_[ball + 1]; }
  std::uint32_t things() const { return first_.back(); }

 private:
  static std::uint32_t add(std::uint32_t& to, std::uint32_t things) {
    return std::atomic_ref(to).fetch_add(things, std::memory_order_relaxed);
  }
  std::vector<std::uint32_t> first_, next_;
};

// A triangle, recorded by the lower one of its tetrahedra: by the corner of the tetrahedron that it
// lacks. Records are in buckets by the triangle's first ball.
struct TriangleRecord {
  std::uint64_t rest;  // the second ball, then the third
  std::uint32_t tetrahedron, corner;
  bool operator<(const TriangleRecord& other) const { return rest < other.rest; }
};

// Visits the triangles of which t is the lower tetrahedron, or the only one. So each triangle is
// visited once.
template <class Visit>
void for_own_triangles(const Triangulation& triangulation, std::size_t t, const Visit& visit) {
  for (std::uint32_t k = 0; k < 4; ++k) {
    const Neighbour across = triangulation.neighbours[t][k];
    if (across.is_hull() || t < across.index()) visit(k);
  }
}

TriangleRecord triangle_record(const std::array<BallIndex, 4>& balls, std::uint32_t tetrahedron,
                               std::uint32_t corner) {
  const std::uint64_t second = balls[corner < 2 ? 2 : 1], third = balls[corner < 3 ? 3 : 2];
  return {second << 32 | third, tetrahedron, corner};
}

// Collects distinct balls in place. There are few, and each occurs many times.
class DistinctBalls {
 public:
  using Place = ResultArray<BallIndex>::iterator;
  explicit DistinctBalls(Place begin) : begin_(begin), end_(begin) {}

  // Adds a ball. Overwrites the array at `begin`, but only items that were added before.
  void add(BallIndex ball) {
    // A linear search is faster than sorting later, unless there are very many balls.
    constexpr std::ptrdiff_t kWorthALook = 48;
    if (end_ - begin_ < kWorthALook && std::find(begin_, end_, ball) != end_) return;
    *end_++ = ball;
  }
  // Sorts the balls and returns their number.
  std::uint32_t sort() {
    std::sort(begin_, end_);
    return static_cast<std::uint32_t>(std::unique(begin_, end_) - begin_);
  }

 private:
  const Place begin_;
  Place end_;
};

class IncidenceMaker {
 public:
  IncidenceMaker(const Triangulation& triangulation, const CancelToken& cancel)
      : triangulation_(triangulation),
        cancel_(cancel),
        balls_(std::size_t{triangulation.vertices.back()} + 1),
        triangles_by_ball_(balls_) {}

  Incidence make() {
    make_triangles();
    make_edges();
    return std::move(result_);
  }

 private:
  void make_triangles() {
    const Simplices<4>& tetrahedra = triangulation_.tetrahedra;
    const auto for_records = [&](const auto& visit) {
      parallel_many(tetrahedra.size(), cancel_, [&](std::size_t t) {
        for_own_triangles(triangulation_, t, [&](std::uint32_t corner) {
          visit(tetrahedra[t][corner == 0 ? 1 : 0], static_cast<std::uint32_t>(t), corner);
        });
      });
    };
    for_records([&](BallIndex first, auto...) { triangles_by_ball_.count(first, 1); });
    triangles_by_ball_.end_counting();
    ResultArray<TriangleRecord> records(triangles_by_ball_.things());
    for_records([&](BallIndex first, std::uint32_t t, std::uint32_t corner) {
      records[triangles_by_ball_.place_for(first)] = triangle_record(tetrahedra[t], t, corner);
    });
    result_.triangles.resize(records.size());
    result_.tetrahedra_of_triangle.resize(records.size());
    result_.triangles_of_tetrahedron.resize(tetrahedra.size());
    for_balls([&](std::size_t v) {
      const std::uint32_t begin = triangles_by_ball_.begin(v), end = triangles_by_ball_.end(v);
      std::sort(records.begin() + begin, records.begin() + end);
      for (std::uint32_t f = begin; f < end; ++f) {
        set_triangle(f, static_cast<BallIndex>(v), records[f]);
      }
    });
  }

  void set_triangle(std::uint32_t f, BallIndex first, const TriangleRecord& record) {
    result_.triangles[f] = {first, static_cast<BallIndex>(record.rest >> 32),
                            static_cast<BallIndex>(record.rest)};
    const Neighbour across = triangulation_.neighbours[record.tetrahedron][record.corner];
    result_.triangles_of_tetrahedron[record.tetrahedron][record.corner] = f;
    result_.tetrahedra_of_triangle[f] = {record.tetrahedron,
                                         across.is_hull() ? Incidence::kOutside : across.index()};
    if (across.is_hull()) return;
    const auto& back = triangulation_.neighbours[across.index()];
    std::size_t k = 0;
    while (back[k] != Neighbour::tetrahedron(record.tetrahedron)) ++k;
    result_.triangles_of_tetrahedron[across.index()][k] = f;
  }

  // Makes the edges. Triangle abc gives edges from a to b and c, and from b to c.
  void make_edges() {
    const Simplices<3>& triangles = result_.triangles;
    Buckets ends(balls_);  // upper ends of the edges of each ball, with repetitions
    parallel_many(triangles.size(), cancel_,
                  [&](std::size_t f) { ends.count(triangles[f][1], 1); });
    for (std::size_t v = 0; v < balls_; ++v) {
      ends.count(static_cast<BallIndex>(v),
                 2 * (triangles_by_ball_.end(v) - triangles_by_ball_.begin(v)));
    }
    ends.end_counting();
    ResultArray<BallIndex> end_of(ends.things());
    parallel_many(triangles.size(), cancel_, [&](std::size_t f) {
      end_of[ends.place_for(triangles[f][1])] = triangles[f][2];
    });
    Buckets edges(balls_);
    for_balls([&](std::size_t v) {
      DistinctBalls distinct(end_of.begin() + ends.begin(v));
      const std::uint32_t first = triangles_by_ball_.begin(v), last = triangles_by_ball_.end(v);
      const std::uint32_t told = ends.end(v) - ends.begin(v) - 2 * (last - first);
      for (std::uint32_t n = 0; n < told; ++n) distinct.add(end_of[ends.begin(v) + n]);
      for (std::uint32_t f = first; f < last; ++f) {
        distinct.add(triangles[f][1]);
        distinct.add(triangles[f][2]);
      }
      edges.count(static_cast<BallIndex>(v), distinct.sort());
    });
    edges.end_counting();
    result_.edges.resize(edges.things());
    for_balls([&](std::size_t v) {
      std::uint32_t from = ends.begin(v);
      for (std::uint32_t e = edges.begin(v); e < edges.end(v); ++e) {
        result_.edges[e] = {static_cast<BallIndex>(v), end_of[from++]};
      }
    });
    set_edges_of_triangles(edges);
  }

  void set_edges_of_triangles(const Buckets& edges) {
    // The index of edge ab; `from` is the first candidate among the edges of a.
    const auto edge = [&](BallIndex a, BallIndex b, std::uint32_t from) {
      const auto begin = result_.edges.begin() + from, end = result_.edges.begin() + edges.end(a);
      const auto before = [b](const std::array<BallIndex, 2>& e) { return e[1] < b; };
      // For few edges counting is faster, since it has no branch to predict.
      constexpr std::ptrdiff_t kFew = 24;
      const auto skipped = end - begin <= kFew ? std::count_if(begin, end, before)
                                               : std::partition_point(begin, end, before) - begin;
      return from + static_cast<std::uint32_t>(skipped);
    };
    result_.edges_of_triangle.resize(result_.triangles.size());
    parallel_many(result_.triangles.size(), cancel_, [&](std::size_t f) {
      const auto [a, b, c] = result_.triangles[f];
      const std::uint32_t ab = edge(a, b, edges.begin(a));
      result_.edges_of_triangle[f] = {edge(b, c, edges.begin(b)), edge(a, c, ab + 1), ab};
    });
  }

  template <class Body>
  void for_balls(const Body& body) {
    parallel_many(balls_, cancel_, body);
  }

  const Triangulation& triangulation_;
  const CancelToken& cancel_;
  const std::size_t balls_;  // balls after the last vertex are hidden
  Buckets triangles_by_ball_;
  Incidence result_;
};

}  // namespace

Incidence make_incidence(const Triangulation& triangulation, const CancelToken& cancel) {
  if (triangulation.dimension < 3) return {};
  // There are at most two triangles for each tetrahedron and one more for each face of the hull.
  // Each triangle gives two or three ends of edges.
  require_at_most(triangulation.tetrahedra.size(), kMostIndices / 8, "tetrahedra");
  return IncidenceMaker(triangulation, cancel).make();
}

}  // namespace alphascope
