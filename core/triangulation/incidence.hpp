// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles and edges of a triangulation of dimension 3, and which simplex is a face of which.
#pragma once

#include <array>
#include <cstdint>

#include "core/complex/triangulation.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// Indices are those of the lists here and of Triangulation::tetrahedra. Face k of a simplex is the
// one opposite its ball k.
struct Incidence {
  // The second tetrahedron of a triangle on the hull.
  static constexpr std::uint32_t kOutside = ~std::uint32_t{0};

  Simplices<3> triangles;  // both lists in lexicographic order, the balls of each ascend
  Simplices<2> edges;
  ResultArray<std::array<std::uint32_t, 4>> triangles_of_tetrahedron;
  ResultArray<std::array<std::uint32_t, 2>> tetrahedra_of_triangle;  // ascending
  ResultArray<std::array<std::uint32_t, 3>> edges_of_triangle;

  friend bool operator==(const Incidence&, const Incidence&) = default;
};

// The edge of balls a < b (0 to 3) of a tetrahedron.
inline std::uint32_t edge_of_tetrahedron(const Incidence& incidence, std::size_t tetrahedron,
                                         std::size_t a, std::size_t b) {
  // The edge is a face of the triangle that lacks another ball c, and there it lacks the fourth
  // ball d.
  const std::size_t c = a > 0 ? 0 : b > 1 ? 1 : 2, d = 6 - a - b - c;
  const std::uint32_t triangle = incidence.triangles_of_tetrahedron[tetrahedron][c];
  return incidence.edges_of_triangle[triangle][d > c ? d - 1 : d];
}

// Makes the incidence, empty below dimension 3. Works in the caller's task arena. The result does
// not depend on the number of threads. Throws Cancelled.
Incidence make_incidence(const Triangulation& triangulation, const CancelToken& cancel = {});

}  // namespace alphascope
