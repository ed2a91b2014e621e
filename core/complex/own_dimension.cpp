// SPDX-License-Identifier: GPL-3.0-or-later
// Classes of a complex whose centres are in a plane, on a line or at a point, by counting cofaces.
#include "core/complex/own_dimension.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/predicates/spanning_balls.hpp"

namespace alphascope {
namespace {

void make_interior(ResultArray<SimplexClass>& classes) {
  std::fill(classes.begin(), classes.end(), SimplexClass::interior);
}

// Calls visit(index of the face in its list) for each face with one vertex less.
template <std::size_t N, class List, class Visit>
void for_faces(const std::array<BallIndex, N>& simplex, const List& faces, const Visit& visit) {
  for (std::size_t left_out = 0; left_out < N; ++left_out) {
    std::array<BallIndex, N - 1> face;
    for (std::size_t n = 0; n + 1 < N; ++n) face[n] = simplex[n < left_out ? n : n + 1];
    const auto at = std::lower_bound(faces.simplices.begin(), faces.simplices.end(), face);
    visit(static_cast<std::size_t>(at - faces.simplices.begin()));
  }
}

// Sets the classes of the faces of the largest simplices, by the rule for triangles and tetrahedra.
template <class Faces, class Largest>
void by_number(Faces& faces, const Largest& largest) {
  std::vector<std::size_t> count(faces.size(), 0);
  for (const auto& simplex : largest.simplices) {
    for_faces(simplex, faces, [&](std::size_t face) { ++count[face]; });
  }
  for (std::size_t n = 0; n < count.size(); ++n) {
    faces.classes[n] = face_class(triangle_flags(count[n]));
  }
}

template <class Faces, class Cofaces>
void by_cofaces(Faces& faces, const Cofaces& cofaces) {
  std::vector<std::uint32_t> flags(faces.size(), 0);
  for (std::size_t c = 0; c < cofaces.size(); ++c) {
    for_faces(cofaces.simplices[c], faces,
              [&](std::size_t face) { flags[face] |= coface_flags(cofaces.classes[c]); });
  }
  for (std::size_t n = 0; n < flags.size(); ++n) {
    faces.classes[n] = face_class(flags[n]);
  }
}

}  // namespace

void set_classes_in(int dimension, AlphaComplex& complex) {
  if (complex.tetrahedra_only) return;
  switch (dimension) {
    case 2:
      make_interior(complex.triangles.classes);
      by_number(complex.edges, complex.triangles);
      return by_cofaces(complex.vertices, complex.edges);
    case 1:
      make_interior(complex.edges.classes);
      return by_number(complex.vertices, complex.edges);
    case 0:
      return make_interior(complex.vertices.classes);
    default:
      return;
  }
}

InOwnDimension::InOwnDimension(const BallSet& balls, const AlphaComplex& complex)
    : complex_(complex), dimension_(dimension_of_centres(balls)) {
  if (dimension_ == 3) return;
  copy_ = complex;
  set_classes_in(dimension_, *copy_);
}

std::array<ClassCounts, 4> class_counts(const AlphaComplex& complex) {
  const auto counts = [](const auto& list) {
    const auto of = [&list](SimplexClass one) {
      return static_cast<std::size_t>(std::count(list.classes.begin(), list.classes.end(), one));
    };
    return ClassCounts{of(SimplexClass::singular), of(SimplexClass::regular),
                       of(SimplexClass::interior)};
  };
  return {counts(complex.vertices), counts(complex.edges), counts(complex.triangles),
          counts(complex.tetrahedra)};
}

}  // namespace alphascope
