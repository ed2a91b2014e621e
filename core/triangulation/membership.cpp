// SPDX-License-Identifier: GPL-3.0-or-later
// Membership in K_alpha by a threshold of the filtration, or directly from flow and incidence.
#include "core/triangulation/membership.hpp"

#include <atomic>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/complex/triangulation.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/run/parallel.hpp"
#include "core/triangulation/flow.hpp"
#include "core/triangulation/incidence.hpp"
#include "core/triangulation/ties.hpp"

namespace alphascope {
namespace {

std::size_t count_in(const Membership::Marks& marks) {
  return parallel_sum(0, marks.size(), 1 << 15, [&](std::size_t first, std::size_t end) {
    unsigned in = 0;
    for (std::size_t n = first; n != end; ++n) in += marks[n];
    return in;
  });
}

template <int N>
Membership::Marks marks_of(const SimplexList<N>& list, float limit, const Ties<N>& ties) {
  Membership::Marks marks(list.size());
  const float* values = list.alpha_values.data();
  parallel_many(list.size(), {}, [&](std::size_t n) { marks[n] = values[n] < limit; });
  std::size_t tie = 0;
  for (std::size_t n = 0; tie < ties.in_complex.size(); ++n) {
    if (values[n] == limit) marks[n] = static_cast<std::uint8_t>(ties.in_complex[tie++]);
  }
  return marks;
}

// Edges or vertices: such a simplex is in K_alpha if a coface is, or if it is unattached and rho <=
// alpha. Cofaces set the marks of their faces, so no list of a face's cofaces is needed. Several
// threads may store to one mark at once; all store the same value.
class FaceMarks {
 public:
  FaceMarks(std::size_t count, const CancelToken& cancel) : marks_(count, kOut), cancel_(cancel) {}

  void set_coface_in(std::size_t n) { mark(n).store(kIn, std::memory_order_relaxed); }
  // Tests all simplices without a coface in K_alpha; within(n) is rho <= alpha.
  template <class Within>
  void ask_the_others(const Within& within) {
    parallel_many(marks_.size(), cancel_, [&](std::size_t n) {
      if (marks_[n] == kOut && within(n)) marks_[n] = kInUnlessAttached;
    });
  }
  bool is_in_unless_attached(std::size_t n) {
    return mark(n).load(std::memory_order_relaxed) == kInUnlessAttached;
  }
  void set_attached(std::size_t n) { mark(n).store(kOut, std::memory_order_relaxed); }
  Membership::Marks take() {
    parallel_many(marks_.size(), cancel_, [&](std::size_t n) { marks_[n] = marks_[n] != kOut; });
    return std::move(marks_);
  }

 private:
  static constexpr std::uint8_t kOut = 0, kIn = 1, kInUnlessAttached = 2;
  std::atomic_ref<std::uint8_t> mark(std::size_t n) { return std::atomic_ref(marks_[n]); }

  Membership::Marks marks_;
  const CancelToken& cancel_;
};

class DirectMembership {
 public:
  DirectMembership(const BallSet& balls, const Triangulation& triangulation,
                   const Incidence& incidence, const LatticeAlpha& alpha, const CancelToken& cancel)
      : balls_(balls),
        triangulation_(triangulation),
        incidence_(incidence),
        alpha_(alpha),
        cancel_(cancel) {}

  Membership make(const Flow& flow) {
    set_tetrahedra(flow);
    set_triangles(flow);
    set_edges();
    set_vertices();
    return std::move(in_);
  }

 private:
  void set_tetrahedra(const Flow& flow) {
    const float limit = alpha_.nearest_float();
    in_.tetrahedra.resize(triangulation_.tetrahedra.size());
    parallel_many(in_.tetrahedra.size(), cancel_, [&](std::size_t t) {
      const float value = flow.alpha_values[t];
      in_.tetrahedra[t] = value < limit || (value == limit && within(triangulation_.tetrahedra[t]));
    });
  }

  void set_triangles(const Flow& flow) {
    in_.triangles.resize(incidence_.triangles.size());
    parallel_many(in_.triangles.size(), cancel_, [&](std::size_t f) {
      bool coface_in = false, attached = false;
      for (const std::uint32_t t : incidence_.tetrahedra_of_triangle[f]) {
        if (t == Incidence::kOutside) continue;
        coface_in = coface_in || in_.tetrahedra[t];
        std::size_t k = 0;
        while (incidence_.triangles_of_tetrahedron[t][k] != f) ++k;
        attached = attached || flow.through(t, k);
      }
      in_.triangles[f] = coface_in || (!attached && within(incidence_.triangles[f]));
    });
  }

  void set_edges() {
    FaceMarks edges(incidence_.edges.size(), cancel_);
    parallel_many(in_.triangles.size(), cancel_, [&](std::size_t f) {
      if (!in_.triangles[f]) return;
      for (const std::uint32_t e : incidence_.edges_of_triangle[f]) edges.set_coface_in(e);
    });
    edges.ask_the_others([&](std::size_t e) { return within(incidence_.edges[e]); });
    parallel_many(in_.triangles.size(), cancel_, [&](std::size_t f) {
      if (in_.triangles[f]) return;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t e = incidence_.edges_of_triangle[f][k];
        if (edges.is_in_unless_attached(e) &&
            conflict(incidence_.edges[e], incidence_.triangles[f][k])) {
          edges.set_attached(e);
        }
      }
    });
    in_.edges = edges.take();
  }

  void set_vertices() {
    FaceMarks vertices(balls_.size(), cancel_);
    parallel_many(in_.edges.size(), cancel_, [&](std::size_t e) {
      if (!in_.edges[e]) return;
      for (const BallIndex v : incidence_.edges[e]) vertices.set_coface_in(v);
    });
    std::vector<std::uint8_t> visible(balls_.size(), 0);
    for (const BallIndex v : triangulation_.vertices) visible[v] = 1;
    vertices.ask_the_others(
        [&](std::size_t v) { return visible[v] && within(std::array{static_cast<BallIndex>(v)}); });
    parallel_many(in_.edges.size(), cancel_, [&](std::size_t e) {
      if (in_.edges[e]) return;
      const auto [a, b] = incidence_.edges[e];
      if (vertices.is_in_unless_attached(a) && conflict(std::array{a}, b)) vertices.set_attached(a);
      if (vertices.is_in_unless_attached(b) && conflict(std::array{b}, a)) vertices.set_attached(b);
    });
    in_.vertices = vertices.take();
  }

  template <std::size_t N>
  bool within(const std::array<BallIndex, N>& simplex) const {
    return compare_ortho_radius(balls_, simplex, alpha_) <= 0;
  }
  template <std::size_t N>
  bool conflict(const std::array<BallIndex, N>& simplex, BallIndex m) const {
    return conflict_with_smallest_orthosphere(balls_, simplex, m) < 0;
  }

  const BallSet& balls_;
  const Triangulation& triangulation_;
  const Incidence& incidence_;
  const LatticeAlpha alpha_;
  const CancelToken& cancel_;
  Membership in_;
};

}  // namespace

std::array<std::size_t, 4> Membership::counts() const {
  return {count_in(vertices), count_in(edges), count_in(triangles), count_in(tetrahedra)};
}

Membership membership(const Filtration& filtration, const LatticeAlpha& alpha) {
  const AlphaComplex& top = filtration.top();
  if (!std::isinf(filtration.alpha_max_on_lattice().below) || top.tetrahedra.size() == 0) {
    throw std::invalid_argument(
        "membership needs the filtration of a triangulation of dimension 3");
  }
  const float limit = alpha.nearest_float();
  const AllTies ties = decide_ties(filtration, alpha, false);
  Membership in;
  in.tetrahedra = marks_of(top.tetrahedra, limit, ties.tetrahedra);
  in.triangles = marks_of(top.triangles, limit, ties.triangles);
  in.edges = marks_of(top.edges, limit, ties.edges);
  const Membership::Marks vertices = marks_of(top.vertices, limit, ties.vertices);
  in.vertices.assign(filtration.balls().size(), 0);
  for (std::size_t n = 0; n < vertices.size(); ++n) {
    in.vertices[top.vertices.simplices[n][0]] = vertices[n];
  }
  return in;
}

Membership membership(const BallSet& balls, const Triangulation& triangulation,
                      const Incidence& incidence, const Flow& flow, const LatticeAlpha& alpha,
                      const CancelToken& cancel) {
  if (triangulation.dimension < 3) {
    throw std::invalid_argument("membership needs a triangulation of dimension 3");
  }
  return DirectMembership(balls, triangulation, incidence, alpha, cancel).make(flow);
}

}  // namespace alphascope
