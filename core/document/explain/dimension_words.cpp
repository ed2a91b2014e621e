// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the texts on complexes whose centres are in a plane, on a line or at one point.
#include "core/document/explain/dimension_words.hpp"

#include <algorithm>

#include "core/complex/own_dimension.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/text/grouped_number.hpp"

namespace alphascope {
namespace {

// Class counts of the faces of the largest simplices.
std::string classes_text(const ClassCounts& n) {
  return " (" + grouped(n.regular) + " on the boundary, " + grouped(n.interior) + " interior, " +
         grouped(n.singular) + " singular)";
}

}  // namespace

const char* where_text(int dimension) {
  static constexpr const char* kWhere[] = {"at the point", "on the line", "in the plane",
                                           "in space"};
  return kWhere[std::clamp(dimension, 0, 3)];
}

const char* lie_text(int dimension) {
  static constexpr const char* kLie[] = {"at one point", "on a line", "in a plane", "in space"};
  return kLie[std::clamp(dimension, 0, 3)];
}

std::string own_counts_text(const BallSet& balls, const AlphaComplex& complex) {
  if (complex.tetrahedra_only) return {};
  const InOwnDimension own(balls, complex);
  if (own.dimension() < 0 || own.dimension() == 3) return {};
  const auto [vertices, edges, triangles, tetrahedra] = class_counts(own.complex());
  std::string text = where_text(own.dimension());
  text[0] = text[0] == 'i' ? 'I' : text[0] == 'o' ? 'O' : 'A';
  text += ": " + grouped(vertices.all()) + " of " + counted(balls.size(), "centre", "centres");
  if (own.dimension() == 0) return text;
  if (own.dimension() == 1) text += classes_text(vertices);
  text += ", " + counted(edges.all(), "edge", "edges");
  if (own.dimension() == 2) {
    text += classes_text(edges) + ", " + counted(triangles.all(), "triangle", "triangles");
  }
  return text + ", Euler number " + std::to_string(complex.euler_characteristic());
}

}  // namespace alphascope
