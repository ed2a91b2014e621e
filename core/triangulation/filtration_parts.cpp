// SPDX-License-Identifier: GPL-3.0-or-later
// Alpha values and levels of a triangulation of dimension 3, from tetrahedra down to vertices.
// Triangles read their two tetrahedra. Triangles tell their edges what follows for these, and edges
// tell their vertices.
#include "core/triangulation/filtration_parts.hpp"

#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/complex/face_class.hpp"
#include "core/complex/triangulation.hpp"
#include "core/geometry/ordered_bits.hpp"
#include "core/predicates/attached_edges.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/predicates/simplex_corners.hpp"
#include "core/run/parallel.hpp"
#include "core/run/stage_timer.hpp"
#include "core/triangulation/incidence.hpp"
#include "core/triangulation/tetrahedron_flow.hpp"

namespace alphascope {
namespace {

template <int N>
void resize_all(SimplexList<N>& list, ClassLevels& levels) {
  list.alpha_values.resize(list.size());
  list.classes.resize(list.size());
  levels.regular_from.resize(list.size());
  levels.interior_from.resize(list.size());
}

template <int N>
void set_levels(std::size_t n, const FaceLevels& face, SimplexList<N>& list, ClassLevels& levels) {
  levels.regular_from[n] = face.regular_from;
  levels.interior_from[n] = face.interior_from;
  list.classes[n] = class_at(face, std::numeric_limits<float>::infinity());
}

// What the cofaces of faces have told about them so far. Any thread may add; the order of additions
// has no effect.
class ToldByCofaces {
 public:
  ToldByCofaces(std::size_t faces, const CancelToken& cancel) : told_(faces) {
    parallel_many(faces, cancel, [&](std::size_t n) { told_[n] = {kNoValue, 0, 0}; });
  }

  void add(std::size_t face, float coface_value, float coface_interior_from) {
    Told& told = told_[face];
    lower(told.least, ordered_bits(coface_value));
    raise(told.interior_from,
          std::isnan(coface_interior_from) ? kNoValue : ordered_bits(coface_interior_from));
  }
  void attach(std::size_t face) {
    std::atomic_ref(told_[face].attached).store(1, std::memory_order_relaxed);
  }
  // When all cofaces of the face have told; each face has one.
  bool is_attached(std::size_t face) const { return told_[face].attached != 0; }
  float least(std::size_t face) const { return from_ordered_bits(told_[face].least); }
  FaceLevels levels(std::size_t face) const {
    const std::uint32_t interior = told_[face].interior_from;
    return {least(face), interior == kNoValue ? kNever : from_ordered_bits(interior)};
  }

 private:
  // Without initial values, which one thread would write before all do.
  struct Told {
    std::uint32_t least;          // ordered bits of the least value
    std::uint32_t interior_from;  // ordered bits of the largest level; kNoValue: never
    std::uint32_t attached;
  };
  static void lower(std::uint32_t& number, std::uint32_t to) {
    std::atomic_ref<std::uint32_t> at(number);
    std::uint32_t now = at.load(std::memory_order_relaxed);
    while (to < now && !at.compare_exchange_weak(now, to, std::memory_order_relaxed)) {
    }
  }
  static void raise(std::uint32_t& number, std::uint32_t to) {
    std::atomic_ref<std::uint32_t> at(number);
    std::uint32_t now = at.load(std::memory_order_relaxed);
    while (to > now && !at.compare_exchange_weak(now, to, std::memory_order_relaxed)) {
    }
  }

  ResultArray<Told> told_;
};

class FiltrationMaker {
 public:
  FiltrationMaker(const BallSet& balls, const Triangulation& triangulation,
                  const RunContext& context, AlphaComplex& top, ClassLevelsByDimension& levels)
      : balls_(balls),
        triangulation_(triangulation),
        context_(context),
        cancel_(context.cancel),
        top_(top),
        levels_(levels) {}

  void make(Simplices<4> tetrahedra) {
    incidence_ = make_incidence(triangulation_, cancel_);
    context_.report(stage::kClassification, 0.3);
    set_tetrahedra(std::move(tetrahedra));
    set_triangles();
    context_.report(stage::kClassification, 0.6);
    set_edges();
    context_.report(stage::kClassification, 0.9);
    set_vertices();
  }

 private:
  void set_tetrahedra(Simplices<4> simplices) {
    SimplexList<4>& list = top_.tetrahedra;
    list.simplices = std::move(simplices);
    list.alpha_values.resize(list.size());
    list.classes.assign(list.size(), SimplexClass::interior);
    attached_to_.resize(list.size());
    parallel_many(list.size(), cancel_, [&](std::size_t t) {
      const SimplexCorners<4> corners{balls_, list.simplices[t]};
      const TetrahedronFlow tetrahedron(corners);
      std::uint32_t ties = 0;
      list.alpha_values[t] = tetrahedron.alpha_value();
      attached_to_[t] = tetrahedron.flow(FlowTies::strict, ties);
    });
  }

  void set_triangles() {
    SimplexList<3>& list = top_.triangles;
    list.simplices = std::move(incidence_.triangles);
    resize_all(list, levels_.triangles);
    parallel_many(list.size(), cancel_, [&](std::size_t f) {
      FaceLevels levels;
      bool attached = false;
      for (const std::uint32_t t : incidence_.tetrahedra_of_triangle[f]) {
        if (t == Incidence::kOutside) {
          levels.lie_on_hull();
          continue;
        }
        const float value = top_.tetrahedra.alpha_values[t];
        levels.add(value, value);
        std::size_t k = 0;
        while (incidence_.triangles_of_tetrahedron[t][k] != f) ++k;
        attached = attached || (attached_to_[t] >> k & 1) != 0;
      }
      list.alpha_values[f] = face_value(attached ? 0 : kUnattached, levels.regular_from, [&] {
        return ortho_radius_rounded(balls_, list.simplices[f]);
      });
      set_levels(f, levels, list, levels_.triangles);
    });
    // Edges do not need what triangles needed.
    incidence_.triangles_of_tetrahedron = {};
    incidence_.tetrahedra_of_triangle = {};
    attached_to_ = {};
  }

  void set_edges() {
    SimplexList<2>& list = top_.edges;
    list.simplices = std::move(incidence_.edges);
    resize_all(list, levels_.edges);
    ToldByCofaces told(list.size(), cancel_);
    const SimplexList<3>& triangles = top_.triangles;
    parallel_many(triangles.size(), cancel_, [&](std::size_t f) {
      const unsigned attached = attached_edges(SimplexCorners<3>{balls_, triangles.simplices[f]});
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t e = incidence_.edges_of_triangle[f][k];
        told.add(e, triangles.alpha_values[f], levels_.triangles.interior_from[f]);
        if (attached >> k & 1) told.attach(e);
      }
    });
    incidence_.edges_of_triangle = {};
    parallel_many(list.size(), cancel_,
                  [&](std::size_t e) { set_face(e, e, told, list, levels_.edges); });
  }

  void set_vertices() {
    SimplexList<1>& list = top_.vertices;
    list.simplices.reserve(triangulation_.vertices.size());
    for (const BallIndex vertex : triangulation_.vertices) list.simplices.push_back({vertex});
    resize_all(list, levels_.vertices);
    ToldByCofaces told(balls_.size(), cancel_);  // by ball
    const SimplexList<2>& edges = top_.edges;
    parallel_many(edges.size(), cancel_, [&](std::size_t e) {
      const auto [i, j] = edges.simplices[e];
      const unsigned attached = attached_ends(lifted_vector(balls_, i, j));
      if (attached & 1) told.attach(i);
      if (attached & 2) told.attach(j);
      for (const BallIndex ball : {i, j})
        told.add(ball, edges.alpha_values[e], levels_.edges.interior_from[e]);
    });
    parallel_many(list.size(), cancel_, [&](std::size_t n) {
      set_face(n, triangulation_.vertices[n], told, list, levels_.vertices);
    });
  }

  // Sets face n of a list, about which its cofaces told as of `place`.
  template <int N>
  void set_face(std::size_t n, std::size_t place, const ToldByCofaces& told, SimplexList<N>& list,
                ClassLevels& levels) {
    list.alpha_values[n] =
        face_value(told.is_attached(place) ? 0 : kUnattached, told.least(place),
                   [&] { return ortho_radius_rounded(balls_, list.simplices[n]); });
    set_levels(n, told.levels(place), list, levels);
  }

  const BallSet& balls_;
  const Triangulation& triangulation_;
  const RunContext& context_;
  const CancelToken& cancel_;
  AlphaComplex& top_;
  ClassLevelsByDimension& levels_;
  Incidence incidence_;
  // Of each tetrahedron: the faces that are attached to it, as bits.
  ResultArray<std::uint8_t> attached_to_;
};

}  // namespace

void fill_filtration(const BallSet& balls, const Triangulation& triangulation,
                     Simplices<4> tetrahedra, const RunContext& context, AlphaComplex& top,
                     ClassLevelsByDimension& levels) {
  FiltrationMaker(balls, triangulation, context, top, levels).make(std::move(tetrahedra));
}

}  // namespace alphascope
