// SPDX-License-Identifier: GPL-3.0-or-later
// Compares two complexes by one merge of their sorted lists in each dimension.
#include "core/complex/compare.hpp"

#include <bit>

#include "core/geometry/alpha.hpp"

namespace alphascope {
namespace {

// -0 and 0 count as equal; all other values must agree in every bit.
bool same_value(float a, float b) {
  return a == b || std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

template <int N>
void merge(const SimplexList<N>& candidate, const SimplexList<N>& reference, bool whole,
           SetDifference<N>& difference, Comparison& comparison) {
  std::size_t c = 0, r = 0;
  while (c < candidate.size() && r < reference.size()) {
    const auto order = candidate.simplices[c] <=> reference.simplices[r];
    if (order < 0) {
      difference.extra.push_back(candidate.simplices[c++]);
    } else if (order > 0) {
      difference.missing.push_back(reference.simplices[r++]);
    } else {
      ++difference.common;
      if (whole) {
        comparison.alpha_values_differing +=
            !same_value(candidate.alpha_values[c], reference.alpha_values[r]);
        comparison.classes_differing += candidate.classes[c] != reference.classes[r];
      }
      ++c, ++r;
    }
  }
  difference.extra.insert(difference.extra.end(), candidate.simplices.begin() + c,
                          candidate.simplices.end());
  difference.missing.insert(difference.missing.end(), reference.simplices.begin() + r,
                            reference.simplices.end());
}

}  // namespace

Comparison compare(const AlphaComplex& candidate, const AlphaComplex& reference) {
  Comparison comparison;
  const bool whole = !candidate.tetrahedra_only && !reference.tetrahedra_only;
  comparison.tetrahedra_only = !whole;
  comparison.both_rest_on_cgal = candidate.engine.rests_on_cgal && reference.engine.rests_on_cgal;
  merge(candidate.tetrahedra, reference.tetrahedra, whole, comparison.tetrahedra, comparison);
  if (whole) {
    merge(candidate.triangles, reference.triangles, whole, comparison.triangles, comparison);
    merge(candidate.edges, reference.edges, whole, comparison.edges, comparison);
    merge(candidate.vertices, reference.vertices, whole, comparison.vertices, comparison);
  }
  return comparison;
}

}  // namespace alphascope
