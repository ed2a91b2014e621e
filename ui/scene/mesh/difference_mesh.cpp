// SPDX-License-Identifier: GPL-3.0-or-later
// Collects the missing and the extra simplices of a comparison, each in its colour.
#include "ui/scene/mesh/difference_mesh.hpp"

#include <utility>

#include "ui/scene/mesh/simplex_soup.hpp"

namespace alphascope {
namespace {

template <int N>
void add(const SetDifference<N>& difference, SimplexSoup& soup) {
  soup.add(difference.missing, kMissingColour);
  soup.add(difference.extra, kExtraColour);
}

}  // namespace

DifferenceMesh build_difference_mesh(const BallGeometry& balls, const Comparison& comparison) {
  SimplexSoup soup(balls);
  add(comparison.tetrahedra, soup);
  add(comparison.triangles, soup);
  add(comparison.edges, soup);
  add(comparison.vertices, soup);
  return {std::move(soup.faces), std::move(soup.edges)};
}

}  // namespace alphascope
