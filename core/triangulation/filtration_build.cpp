// SPDX-License-Identifier: GPL-3.0-or-later
// Building a filtration: of a complex, of a triangulation below dimension 3, or by
// fill_filtration().
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "core/complex/alpha_complex.hpp"
#include "core/complex/face_class.hpp"
#include "core/complex/face_groups.hpp"
#include "core/complex/simplex_count.hpp"
#include "core/complex/triangulation.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/run/parallel.hpp"
#include "core/run/stage_timer.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/filtration_parts.hpp"
#include "core/triangulation/memory_need.hpp"
#include "core/triangulation/triangulation_maker.hpp"
#include "core/triangulation/triangulation_report.hpp"

namespace alphascope {
namespace {

// The alpha value of a face: its own ortho-radius, or the least value of its cofaces if the apex of
// a coface is in conflict with its orthosphere. Apexes of cofaces are the only balls that need this
// test, also where there are ties.
template <int N>
float alpha_value(const BallSet& balls, const std::array<BallIndex, N>& face,
                  const FaceGroups<N>& groups, std::size_t group,
                  const SimplexList<N + 1>& cofaces) {
  bool attached = false;
  float least = std::numeric_limits<float>::infinity();
  groups.for_cofaces(group, [&](std::uint32_t c) {
    least = std::min(least, cofaces.alpha_values[c]);
    attached = attached || conflict_with_smallest_orthosphere(
                               balls, face, apex<N>(cofaces.simplices[c], face)) < 0;
  });
  return face_value(attached ? 0 : kUnattached, least,
                    [&] { return ortho_radius_rounded(balls, face); });
}

// The index in the list of each group's face. The faces are a subsequence of the list from `at` on.
// Afterwards `at` is behind the last of them.
template <int N>
std::vector<std::uint32_t> positions_in(const Simplices<N>& list, const FaceGroups<N>& groups,
                                        const CancelToken& cancel, std::uint32_t& at) {
  require_at_most(list.size(), kMostIndices, "simplices");
  std::vector<std::uint32_t> position(groups.size());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (g % 65536 == 0) cancel.throw_if_cancelled();
    while (at < list.size() && list[at] != groups.faces()[g]) ++at;
    if (at == list.size()) {
      throw std::invalid_argument(
          "faces of some simplices are missing in the complex; compute it again");
    }
    position[g] = at++;
  }
  return position;
}

// The simplices of the next higher dimension. Tetrahedra have no levels: they are interior from
// their alpha values on.
template <int N>
struct Cofaces {
  const SimplexList<N + 1>& list;
  const ClassLevels* levels = nullptr;
};

// Sets the levels of the faces of `groups`; position[g] is the index of face g.
template <int N>
void set_levels(const FaceGroups<N>& groups, const std::vector<std::uint32_t>& position,
                const Cofaces<N>& cofaces, const CancelToken& cancel, ClassLevels& levels) {
  parallel_many(groups.size(), cancel, [&](std::size_t g) {
    FaceLevels face;
    groups.for_cofaces(g, [&](std::uint32_t c) {
      const float value = cofaces.list.alpha_values[c];
      face.add(value, cofaces.levels ? cofaces.levels->interior_from[c] : value);
    });
    if (N == 3 && groups.coface_count(g) != 2) face.lie_on_hull();
    levels.regular_from[position[g]] = face.regular_from;
    levels.interior_from[position[g]] = face.interior_from;
  });
}

void resize(ClassLevels& levels, std::size_t count) {
  levels.regular_from.resize(count, kNever);
  levels.interior_from.resize(count, kNever);
}

// The levels of a list that has all its simplices.
template <int N>
ClassLevels class_levels(const SimplexList<N>& list, const Cofaces<N>& cofaces,
                         const CancelToken& cancel) {
  ClassLevels levels;
  resize(levels, list.size());
  std::uint32_t at = 0;
  for_face_groups<N>(cofaces.list.simplices, cancel, [&](const FaceGroups<N>& groups) {
    const auto position = positions_in<N>(list.simplices, groups, cancel, at);
    set_levels<N>(groups, position, cofaces, cancel, levels);
  });
  return levels;
}

void set_classes(const ClassLevels& levels, ResultArray<SimplexClass>& classes) {
  classes.resize(levels.regular_from.size());
  constexpr float kAll = std::numeric_limits<float>::infinity();
  for (std::size_t n = 0; n < classes.size(); ++n) {
    classes[n] = class_at({levels.regular_from[n], levels.interior_from[n]}, kAll);
  }
}

template <int N>
void append(const Simplices<N>& faces, const CancelToken& cancel, SimplexList<N>& list,
            ClassLevels& levels) {
  const std::size_t before = list.size();
  list.simplices.resize(before + faces.size());
  parallel_many(faces.size(), cancel,
                [&](std::size_t n) { list.simplices[before + n] = faces[n]; });
  list.alpha_values.resize(list.size());
  resize(levels, list.size());
}

template <int N>
void reserve(std::size_t count, SimplexList<N>& list, ClassLevels& levels) {
  list.simplices.reserve(count);
  list.alpha_values.reserve(count);
  levels.regular_from.reserve(count);
  levels.interior_from.reserve(count);
}

// Alpha values, levels and classes of one dimension of a triangulation with `count` simplices. The
// list holds the simplices if they are maximal. Else it is empty, and the faces of the cofaces fill
// it.
template <int N>
ClassLevels build_dimension(const BallSet& balls, const Cofaces<N>& cofaces, std::size_t count,
                            const CancelToken& cancel, SimplexList<N>& list) {
  const bool of_cofaces = list.simplices.empty();
  ClassLevels levels;
  reserve<N>(count, list, levels);
  list.alpha_values.resize(list.size());
  resize(levels, list.size());
  if (cofaces.list.size() == 0) {  // a single vertex, or no simplex of higher dimension
    for (std::size_t n = 0; n < list.size(); ++n) {
      list.alpha_values[n] = ortho_radius_rounded(balls, list.simplices[n]);
    }
  }
  std::uint32_t at = 0;
  for_face_groups<N>(cofaces.list.simplices, cancel, [&](const FaceGroups<N>& groups) {
    if (of_cofaces) append<N>(groups.faces(), cancel, list, levels);
    const auto position = positions_in<N>(list.simplices, groups, cancel, at);
    parallel_many(groups.size(), cancel, [&](std::size_t g) {
      const std::uint32_t n = position[g];
      list.alpha_values[n] = alpha_value<N>(balls, list.simplices[n], groups, g, cofaces.list);
    });
    set_levels<N>(groups, position, cofaces, cancel, levels);
  });
  set_classes(levels, list.classes);
  return levels;
}

template <int N>
void classify_faces(const SimplexList<N + 1>& cofaces, SimplexList<N>& list) {
  const FaceGroups<N> groups(cofaces.simplices);
  std::uint32_t at = 0;
  const auto position = positions_in<N>(list.simplices, groups, {}, at);
  list.classes.assign(list.size(), face_class(0));
  for (std::size_t g = 0; g < groups.size(); ++g) {
    std::uint32_t flags = N == 3 ? triangle_flags(groups.coface_count(g)) : 0;
    groups.for_cofaces(g, [&](std::uint32_t c) { flags |= coface_flags(cofaces.classes[c]); });
    list.classes[position[g]] = face_class(flags);
  }
}

std::size_t bytes(const ClassLevels& levels) {
  return (levels.regular_from.capacity() + levels.interior_from.capacity()) * sizeof(float);
}

}  // namespace

Filtration::Filtration(std::shared_ptr<const BallSet> balls, const Triangulation& triangulation,
                       const RunContext& context)
    : balls_(std::move(balls)) {
  build(triangulation, triangulation.tetrahedra, context, nullptr);
}

Filtration::Filtration(std::shared_ptr<const BallSet> balls,
                       std::shared_ptr<const Triangulation> triangulation,
                       const RunContext& context, TriangulationMaker* maker)
    : balls_(std::move(balls)) {
  const Triangulation& all = *triangulation;
  // Casting away const is safe, because nobody changes top_ or its tetrahedra.
  const std::span tetrahedra(const_cast<std::array<BallIndex, 4>*>(all.tetrahedra.data()),
                             all.tetrahedra.size());
  build(all, in_place(std::shared_ptr<const void>(std::move(triangulation)), tetrahedra), context,
        maker);
  shared_bytes_ = tetrahedra.size_bytes();
}

void Filtration::fill_flat(const Triangulation& triangulation, const RunContext& context,
                           AlphaComplex& top) {
  const CancelToken& cancel = context.cancel;
  const SimplexCount count = simplex_count(triangulation);
  top.triangles.simplices = triangulation.triangles;
  levels_.triangles =
      build_dimension<3>(*balls_, {top.tetrahedra}, count.triangles, cancel, top.triangles);
  context.report(stage::kClassification, 0.4);
  top.edges.simplices = triangulation.edges;
  levels_.edges = build_dimension<2>(*balls_, {top.triangles, &levels_.triangles}, count.edges,
                                     cancel, top.edges);
  top.vertices.simplices.reserve(count.vertices);
  for (const BallIndex vertex : triangulation.vertices) top.vertices.simplices.push_back({vertex});
  levels_.vertices = build_dimension<1>(*balls_, {top.edges, &levels_.edges}, count.vertices,
                                        cancel, top.vertices);
}

bool Filtration::fill_by_device(const Triangulation& triangulation, Simplices<4>& tetrahedra,
                                const RunContext& context, TriangulationMaker& maker,
                                AlphaComplex& top) {
  std::optional<FiltrationParts> made = maker.filtration_parts(*balls_, triangulation, context);
  if (!made) return false;
  top.tetrahedra.simplices = std::move(tetrahedra);
  top.tetrahedra.alpha_values = std::move(made->tetrahedron_values);
  top.tetrahedra.classes.resize(top.tetrahedra.size());
  parallel_many(top.tetrahedra.size(), context.cancel,
                [&](std::size_t t) { top.tetrahedra.classes[t] = SimplexClass::interior; });
  top.triangles = std::move(made->triangles);
  top.edges = std::move(made->edges);
  top.vertices = std::move(made->vertices);
  top.vertices.simplices.resize(triangulation.vertices.size());
  parallel_many(triangulation.vertices.size(), context.cancel,
                [&](std::size_t n) { top.vertices.simplices[n] = {triangulation.vertices[n]}; });
  levels_ = std::move(made->levels);
  hash_steps_ = std::move(made->hash_steps);
  device_ = std::move(made->device);
  return true;
}

void Filtration::build(const Triangulation& triangulation, Simplices<4> all_tetrahedra,
                       const RunContext& context, TriangulationMaker* maker) {
  const auto top = std::make_shared<AlphaComplex>();
  const CancelToken& cancel = context.cancel;
  top->lattice = balls_->lattice;
  top->alpha_on_lattice = std::numeric_limits<double>::infinity();
  top->engine.of_whole = true;
  top->engine.rests_on_cgal = made_by_cgal(triangulation);

  context.report(stage::kClassification, 0);
  if (maker != nullptr && fill_by_device(triangulation, all_tetrahedra, context, *maker, *top)) {
    top_ = top;
    return;
  }
  if (triangulation.dimension == 3) {
    fill_filtration(*balls_, triangulation, std::move(all_tetrahedra), context, *top, levels_);
  } else {
    fill_flat(triangulation, context, *top);
  }
  hash_steps_ = HashStepsByDimension(*top, cancel);
  top_ = top;
}

Filtration::Filtration(std::shared_ptr<const BallSet> balls,
                       std::shared_ptr<const AlphaComplex> top, const RunContext& context)
    : balls_(std::move(balls)), top_(std::move(top)) {
  if (top_->tetrahedra_only) {
    throw std::invalid_argument("a filtration needs a whole complex, not only its tetrahedra");
  }
  const CancelToken& cancel = context.cancel;
  context.report(stage::kClassification, 0);
  levels_.triangles = class_levels<3>(top_->triangles, {top_->tetrahedra}, cancel);
  context.report(stage::kClassification, 0.4);
  levels_.edges = class_levels<2>(top_->edges, {top_->triangles, &levels_.triangles}, cancel);
  context.report(stage::kClassification, 0.8);
  levels_.vertices = class_levels<1>(top_->vertices, {top_->edges, &levels_.edges}, cancel);
  hash_steps_ = HashStepsByDimension(*top_, cancel);
}

const LatticeAlpha& Filtration::alpha_max_on_lattice() const {
  return top_->alpha_on_lattice;
}

std::size_t Filtration::level_bytes() const {
  return bytes(levels_.vertices) + bytes(levels_.edges) + bytes(levels_.triangles);
}

std::size_t Filtration::top_bytes() const {
  return bytes_of(*top_) - shared_bytes_;
}

void classify(AlphaComplex& complex) {
  complex.tetrahedra.classes.assign(complex.tetrahedra.size(), SimplexClass::interior);
  classify_faces<3>(complex.tetrahedra, complex.triangles);
  classify_faces<2>(complex.triangles, complex.edges);
  classify_faces<1>(complex.edges, complex.vertices);
}

}  // namespace alphascope
