// Building a filtration: alpha values of all simplices of a triangulation, and the levels at which
// their classes change.
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/complex/face_groups.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/parallel_ranges.hpp"

namespace alphascope {
namespace {

// Own ortho-radius unless a coface's apex is in conflict with the orthosphere: then the least of
// the cofaces. That only neighbours in the triangulation need to be asked holds for ties as well.
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

// Position in the list of each group's face; the faces are a subsequence of the list.
template <int N>
std::vector<std::uint32_t> positions_in(const Simplices<N>& list, const FaceGroups<N>& groups,
                                        const CancelToken& cancel) {
  require_at_most(list.size(), kMostIndices, "simplices");
  std::vector<std::uint32_t> position(groups.size());
  std::uint32_t at = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (g % 65536 == 0) cancel.throw_if_cancelled();
    while (at < list.size() && list[at] != groups.faces()[g]) ++at;
    if (at == list.size()) {
      throw std::invalid_argument("a complex lacks faces of its simplices; recompute it");
    }
    position[g] = at++;
  }
  return position;
}

// The interior_from of cofaces; of tetrahedra (levels == nullptr) their alpha values.
template <int N>
ClassLevels class_levels(const CancelToken& cancel, const SimplexList<N>& list,
                         const FaceGroups<N>& groups, const SimplexList<N + 1>& cofaces,
                         const ClassLevels* coface_levels) {
  const std::vector<std::uint32_t> position = positions_in<N>(list.simplices, groups, cancel);
  const std::size_t count = list.size();
  ClassLevels levels;
  levels.regular_from.assign(count, kNever);
  levels.interior_from.assign(count, kNever);
  parallel_ranges(groups.size(), cancel, [&](std::size_t g) {
    FaceLevels face;
    groups.for_cofaces(g, [&](std::uint32_t c) {
      const float value = cofaces.alpha_values[c];
      face.add(value, coface_levels ? coface_levels->interior_from[c] : value);
    });
    if (N == 3 && groups.coface_count(g) != 2) face.lie_on_hull();
    levels.regular_from[position[g]] = face.regular_from;
    levels.interior_from[position[g]] = face.interior_from;
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

// One dimension of a triangulation: faces of the next higher one, or maximal simplices themselves.
template <int N>
ClassLevels build_dimension(const BallSet& balls, const CancelToken& cancel, Simplices<N> maximal,
                            const SimplexList<N + 1>& cofaces, const ClassLevels* coface_levels,
                            SimplexList<N>& list) {
  FaceGroups<N> groups(cofaces.simplices, cancel);
  if (maximal.empty()) maximal = groups.faces();
  list.simplices = std::move(maximal);
  const std::vector<std::uint32_t> position = positions_in<N>(list.simplices, groups, cancel);
  list.alpha_values.resize(list.size());
  if (groups.size() != list.size()) {  // a single vertex, or no simplex of higher dimension
    for (std::size_t n = 0; n < list.size(); ++n) {
      list.alpha_values[n] = ortho_radius_rounded(balls, list.simplices[n]);
    }
  }
  parallel_ranges(groups.size(), cancel, [&](std::size_t g) {
    const std::uint32_t at = position[g];
    list.alpha_values[at] = alpha_value<N>(balls, list.simplices[at], groups, g, cofaces);
  });
  ClassLevels levels = class_levels<N>(cancel, list, groups, cofaces, coface_levels);
  set_classes(levels, list.classes);
  return levels;
}

template <int N>
void classify_faces(const SimplexList<N + 1>& cofaces, SimplexList<N>& list) {
  const FaceGroups<N> groups(cofaces.simplices);
  const std::vector<std::uint32_t> position = positions_in<N>(list.simplices, groups, {});
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
  const auto top = std::make_shared<AlphaComplex>();
  const CancelToken& cancel = context.cancel;
  top->lattice = balls_->lattice;
  top->alpha_on_lattice = std::numeric_limits<double>::infinity();
  top->engine.rests_on_cgal = true;  // as every triangulation does that there is

  context.report(stage::kClassification, 0);
  SimplexList<4>& tetrahedra = top->tetrahedra;
  tetrahedra.simplices = triangulation.tetrahedra;
  tetrahedra.alpha_values.resize(tetrahedra.size());
  tetrahedra.classes.assign(tetrahedra.size(), SimplexClass::interior);
  parallel_ranges(tetrahedra.size(), cancel, [&](std::size_t n) {
    tetrahedra.alpha_values[n] = ortho_radius_rounded(*balls_, tetrahedra.simplices[n]);
  });

  context.report(stage::kClassification, 0.2);
  levels_.triangles = build_dimension<3>(*balls_, cancel, triangulation.triangles, tetrahedra,
                                         nullptr, top->triangles);
  context.report(stage::kClassification, 0.6);
  levels_.edges = build_dimension<2>(*balls_, cancel, triangulation.edges, top->triangles,
                                     &levels_.triangles, top->edges);
  Simplices<1> vertices(triangulation.vertices.size());
  for (std::size_t n = 0; n < vertices.size(); ++n) vertices[n] = {triangulation.vertices[n]};
  levels_.vertices = build_dimension<1>(*balls_, cancel, std::move(vertices), top->edges,
                                        &levels_.edges, top->vertices);
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
  levels_.triangles =
      class_levels<3>(cancel, top_->triangles, FaceGroups<3>(top_->tetrahedra.simplices, cancel),
                      top_->tetrahedra, nullptr);
  context.report(stage::kClassification, 0.4);
  levels_.edges =
      class_levels<2>(cancel, top_->edges, FaceGroups<2>(top_->triangles.simplices, cancel),
                      top_->triangles, &levels_.triangles);
  context.report(stage::kClassification, 0.8);
  levels_.vertices =
      class_levels<1>(cancel, top_->vertices, FaceGroups<1>(top_->edges.simplices, cancel),
                      top_->edges, &levels_.edges);
  hash_steps_ = HashStepsByDimension(*top_, cancel);
}

std::size_t Filtration::level_bytes() const {
  return bytes(levels_.vertices) + bytes(levels_.edges) + bytes(levels_.triangles);
}

std::size_t Filtration::top_bytes() const {
  return bytes_of(*top_);
}

void classify(AlphaComplex& complex) {
  complex.tetrahedra.classes.assign(complex.tetrahedra.size(), SimplexClass::interior);
  classify_faces<3>(complex.tetrahedra, complex.triangles);
  classify_faces<2>(complex.triangles, complex.edges);
  classify_faces<1>(complex.edges, complex.vertices);
}

}  // namespace alphascope
