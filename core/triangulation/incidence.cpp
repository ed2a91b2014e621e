// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the triangles and edges of a triangulation from its tetrahedra, ball by ball in parallel.
#include "core/triangulation/incidence.hpp"

#include <algorithm>
#include <vector>

#include "core/complex/count_limits.hpp"
#include "core/run/parallel.hpp"
#include "core/triangulation/buckets.hpp"

namespace alphascope {
namespace {

// A triangle in the list of its first ball: the lower one of its tetrahedra, and the corner of that
// one which it lacks.
struct TriangleRecord {
  std::uint64_t rest;  // the second ball, then the third
  std::uint32_t tetrahedron, corner;
  bool operator<(const TriangleRecord& other) const { return rest < other.rest; }
};

TriangleRecord triangle_record(const std::array<BallIndex, 4>& balls, std::uint32_t tetrahedron,
                               std::uint32_t corner) {
  const std::uint64_t second = balls[corner < 2 ? 2 : 1], third = balls[corner < 3 ? 3 : 2];
  return {second << 32 | third, tetrahedron, corner};
}

// Distinct balls with their places in ascending order. There are few, and each is added many times.
class DistinctBalls {
 public:
  void clear() {
    for (const std::size_t at : taken_) entries_[at].ball = kNone;
    taken_.clear();
    balls_.clear();
  }
  void add(BallIndex ball) {
    Entry& at = entry(ball);
    if (at.ball == ball) return;
    take(at, ball);
    balls_.push_back(ball);
    if (2 * balls_.size() > entries_.size()) grow();
  }
  void sort() {
    std::sort(balls_.begin(), balls_.end());
    for (std::uint32_t place = 0; place < balls_.size(); ++place)
      entry(balls_[place]).place = place;
  }
  // The balls, in ascending order after sort().
  const std::vector<BallIndex>& balls() const { return balls_; }
  // Of a ball that was added before sort().
  std::uint32_t place(BallIndex ball) { return entry(ball).place; }

 private:
  static constexpr BallIndex kNone = ~BallIndex{0};
  struct Entry {
    BallIndex ball = kNone;
    std::uint32_t place = 0;
  };

  // The entry of a ball, or a free one. Half of the entries are free.
  Entry& entry(BallIndex ball) {
    std::size_t at = ball * 0x9e3779b1u >> shift_;
    while (entries_[at].ball != ball && entries_[at].ball != kNone) at = (at + 1) % entries_.size();
    return entries_[at];
  }
  void take(Entry& at, BallIndex ball) {
    at.ball = ball;
    taken_.push_back(static_cast<std::size_t>(&at - entries_.data()));
  }
  void grow() {
    entries_.assign(2 * entries_.size(), {});
    --shift_;
    taken_.clear();
    for (const BallIndex ball : balls_) take(entry(ball), ball);
  }

  int shift_ = 32 - 7;
  std::vector<Entry> entries_ = std::vector<Entry>(std::size_t{1} << 7);
  std::vector<std::size_t> taken_;  // entries
  std::vector<BallIndex> balls_;
};

// Simplices of dimension 3 and 2 are in lexicographic order. So those whose first ball is `v` are
// next to each other. A face that lacks this first ball belongs to the list of a higher ball, which
// is told of it.
class IncidenceMaker {
 public:
  IncidenceMaker(const Triangulation& triangulation, const CancelToken& cancel)
      : triangulation_(triangulation),
        cancel_(cancel),
        balls_(std::size_t{triangulation.vertices.back()} + 1),
        first_triangle_(balls_ + 1, 0) {}

  Incidence make() {
    make_triangles();
    make_edges();
    return std::move(result_);
  }

 private:
  // A triangle is recorded by the lower one of its tetrahedra, or the only one.
  bool records(std::size_t t, std::size_t corner) const {
    const Neighbour across = triangulation_.neighbours[t][corner];
    return across.is_hull() || t < across.index();
  }

  void make_triangles() {
    const Simplices<4>& tetrahedra = triangulation_.tetrahedra;
    const std::vector<std::uint32_t> first_tetrahedron = starts(tetrahedra);
    Buckets told(balls_);  // tetrahedra that record the triangle without their first ball
    for_balls([&](std::size_t v) {
      std::uint32_t own = 0;
      for (std::uint32_t t = first_tetrahedron[v]; t < first_tetrahedron[v + 1]; ++t) {
        for (std::size_t k = 1; k < 4; ++k) own += records(t, k);
        if (records(t, 0)) told.count(tetrahedra[t][1], 1);
      }
      first_triangle_[v + 1] = own;
    });
    told.end_counting();
    ResultArray<std::uint32_t> teller(told.things());
    parallel_many(tetrahedra.size(), cancel_, [&](std::size_t t) {
      if (records(t, 0)) teller[told.place_for(tetrahedra[t][1])] = static_cast<std::uint32_t>(t);
    });
    for (std::size_t v = 0; v < balls_; ++v)
      first_triangle_[v + 1] += first_triangle_[v] + told.end(v) - told.begin(v);
    result_.triangles.resize(first_triangle_.back());
    result_.tetrahedra_of_triangle.resize(first_triangle_.back());
    result_.triangles_of_tetrahedron.resize(tetrahedra.size());
    parallel_ranges(0, balls_, kBalls, [&](std::size_t first, std::size_t end) {
      std::vector<TriangleRecord> of_ball;
      for (std::size_t v = first; v != end && !cancel_.cancelled(); ++v) {
        of_ball.clear();
        for (std::uint32_t t = first_tetrahedron[v]; t < first_tetrahedron[v + 1]; ++t) {
          for (std::uint32_t k = 1; k < 4; ++k) {
            if (records(t, k)) of_ball.push_back(triangle_record(tetrahedra[t], t, k));
          }
        }
        for (std::uint32_t n = told.begin(v); n < told.end(v); ++n)
          of_ball.push_back(triangle_record(tetrahedra[teller[n]], teller[n], 0));
        std::sort(of_ball.begin(), of_ball.end());
        for (std::uint32_t n = 0; n < of_ball.size(); ++n)
          set_triangle(first_triangle_[v] + n, static_cast<BallIndex>(v), of_ball[n]);
      }
    });
    cancel_.throw_if_cancelled();
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

  // Triangle abc has edges from a to b and c, and one from b to c, of which b is told.
  void make_edges() {
    const Simplices<3>& triangles = result_.triangles;
    Buckets told(balls_);
    parallel_many(triangles.size(), cancel_,
                  [&](std::size_t f) { told.count(triangles[f][1], 1); });
    told.end_counting();
    ResultArray<std::uint32_t> teller(told.things());
    parallel_many(triangles.size(), cancel_, [&](std::size_t f) {
      teller[told.place_for(triangles[f][1])] = static_cast<std::uint32_t>(f);
    });
    // Upper ends of the edges of each ball, which lie where there is room for all that were named.
    ResultArray<BallIndex> end_of(2 * triangles.size() + told.things());
    const auto room_of = [&](std::size_t v) {
      return 2 * std::size_t{first_triangle_[v]} + told.begin(v);
    };
    std::vector<std::uint32_t> first_edge(balls_ + 1, 0);
    result_.edges_of_triangle.resize(triangles.size());
    parallel_ranges(0, balls_, kBalls, [&](std::size_t first, std::size_t end) {
      DistinctBalls distinct;
      for (std::size_t v = first; v != end && !cancel_.cancelled(); ++v) {
        distinct.clear();
        const std::uint32_t begin = first_triangle_[v], last = first_triangle_[v + 1];
        for (std::uint32_t f = begin; f < last; ++f) {
          distinct.add(triangles[f][1]);
          distinct.add(triangles[f][2]);
        }
        for (std::uint32_t n = told.begin(v); n < told.end(v); ++n)
          distinct.add(triangles[teller[n]][2]);
        distinct.sort();
        // For now, edges have their numbers among those of their ball.
        for (std::uint32_t f = begin; f < last; ++f) {
          result_.edges_of_triangle[f][1] = distinct.place(triangles[f][2]);
          result_.edges_of_triangle[f][2] = distinct.place(triangles[f][1]);
        }
        for (std::uint32_t n = told.begin(v); n < told.end(v); ++n)
          result_.edges_of_triangle[teller[n]][0] = distinct.place(triangles[teller[n]][2]);
        std::copy(distinct.balls().begin(), distinct.balls().end(), end_of.begin() + room_of(v));
        first_edge[v + 1] = static_cast<std::uint32_t>(distinct.balls().size());
      }
    });
    cancel_.throw_if_cancelled();
    for (std::size_t v = 0; v < balls_; ++v) first_edge[v + 1] += first_edge[v];
    result_.edges.resize(first_edge.back());
    for_balls([&](std::size_t v) {
      std::size_t from = room_of(v);
      for (std::uint32_t e = first_edge[v]; e < first_edge[v + 1]; ++e)
        result_.edges[e] = {static_cast<BallIndex>(v), end_of[from++]};
    });
    parallel_many(triangles.size(), cancel_, [&](std::size_t f) {
      auto& edges = result_.edges_of_triangle[f];
      edges[0] += first_edge[triangles[f][1]];
      edges[1] += first_edge[triangles[f][0]];
      edges[2] += first_edge[triangles[f][0]];
    });
  }

  // For each ball, the first tetrahedron whose first ball is not lower.
  std::vector<std::uint32_t> starts(const Simplices<4>& tetrahedra) const {
    std::vector<std::uint32_t> first(balls_ + 1, static_cast<std::uint32_t>(tetrahedra.size()));
    parallel_many(tetrahedra.size(), cancel_, [&](std::size_t t) {
      const BallIndex before = t == 0 ? 0 : tetrahedra[t - 1][0] + 1;
      for (BallIndex v = before; v <= tetrahedra[t][0]; ++v)
        first[v] = static_cast<std::uint32_t>(t);
    });
    return first;
  }

  template <class Body>
  void for_balls(const Body& body) {
    parallel_many(balls_, cancel_, body);
  }

  static constexpr std::size_t kBalls = 64;  // that one thread takes at once

  const Triangulation& triangulation_;
  const CancelToken& cancel_;
  const std::size_t balls_;                    // balls after the last vertex are hidden
  std::vector<std::uint32_t> first_triangle_;  // of each ball
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
