// SPDX-License-Identifier: GPL-3.0-or-later
// Estimates of memory from numbers of simplices, and the numbers of simplices in a triangulation.
#include "core/triangulation/memory_need.hpp"

#include <algorithm>

#include "core/complex/alpha_complex.hpp"
#include "core/complex/face_groups.hpp"
#include "core/complex/simplex_count.hpp"
#include "core/complex/triangulation.hpp"

namespace alphascope {
namespace {

// PDB entries 1K4C, 1AON and 3J6R have 6.6 to 6.8.
constexpr std::uint64_t kTetrahedraPerBall = 7;
// Bytes while a triangulation is made: cells of 64, some of them free or at infinity, 40 to put a
// tetrahedron in order, and 32 of the result. CGAL took as many.
constexpr std::uint64_t kMakingBytesPerTetrahedron = 144;

SimplexCount count_of_molecule(std::size_t balls) {
  const std::uint64_t tetrahedra = kTetrahedraPerBall * balls;
  return {balls, tetrahedra + balls, 2 * tetrahedra, tetrahedra};
}

constexpr std::uint64_t bytes_of_simplex(std::uint64_t balls) {
  return balls * sizeof(BallIndex) + sizeof(float) + sizeof(SimplexClass);
}
constexpr std::uint64_t kLevels = 2 * sizeof(float);  // from where on regular, and interior

// Bytes while the faces of a triangulation below dimension 3 are grouped: the list with its levels;
// the cofaces around each vertex; and the groups of faces in memory at a time, with their positions
// in the list.
std::uint64_t bytes_while_grouping(std::uint64_t faces, std::uint64_t cofaces,
                                   std::uint64_t vertices, std::uint64_t balls) {
  constexpr std::uint64_t kIndex = sizeof(std::uint32_t);
  const std::uint64_t record = balls > 2 ? 16 : 8, around = 2 * cofaces;
  const std::uint64_t all_groups =
      cofaces * (balls + 1) * record + faces * (balls * sizeof(BallIndex) + 2 * kIndex);
  const std::uint64_t groups =
      around <= kSimplicesAtATime ? all_groups : all_groups / (around / kSimplicesAtATime);
  return (around + 2 * vertices) * kIndex + groups + faces * (bytes_of_simplex(balls) + kLevels);
}

// Bytes while a filtration is made of a triangulation of dimension 3, beside what it holds in the
// end: Incidence and what it is made of, then what cofaces tell their faces. The lists of one
// dimension after the other are complete.
std::uint64_t peak_of_solid(const SimplexCount& c) {
  constexpr std::uint64_t kIndex = sizeof(std::uint32_t), kTold = 3 * kIndex;
  const std::uint64_t tetrahedra = c.tetrahedra * sizeof(std::array<BallIndex, 4>);
  const std::uint64_t lists_of_tetrahedra = c.tetrahedra * bytes_of_simplex(4);
  const std::uint64_t triangles = c.triangles * (bytes_of_simplex(3) + kLevels);
  const std::uint64_t edges = c.edges * (bytes_of_simplex(2) + kLevels);
  // Indices of triangles' balls, tetrahedra and edges; while edges are found, those who tell of
  // edges and the ends of these.
  const std::uint64_t incidence = c.triangles * (3 + 2 + 3) * kIndex + c.tetrahedra * 4 * kIndex;
  const std::uint64_t ends = c.triangles * (1 + 3) * kIndex;
  return std::max(
      {tetrahedra + incidence + ends,
       lists_of_tetrahedra + c.tetrahedra + incidence - c.triangles * 3 * kIndex + triangles +
           c.edges * 2 * kIndex,
       lists_of_tetrahedra + triangles + c.triangles * 3 * kIndex + edges + c.edges * kTold,
       lists_of_tetrahedra + triangles + edges +
           c.vertices * (bytes_of_simplex(1) + kLevels + kTold)});
}

MemoryNeed need(const SimplexCount& c) {
  const std::uint64_t tetrahedra = c.tetrahedra * bytes_of_simplex(4);
  const std::uint64_t triangles = c.triangles * (bytes_of_simplex(3) + kLevels);
  const std::uint64_t edges = c.edges * (bytes_of_simplex(2) + kLevels);
  const std::uint64_t vertices = c.vertices * (bytes_of_simplex(1) + kLevels);
  const std::uint64_t held = tetrahedra + triangles + edges + vertices;
  if (c.tetrahedra > 0) return {held, peak_of_solid(c)};
  return {held,
          std::max(triangles + bytes_while_grouping(c.edges, c.triangles, c.vertices, 2),
                   triangles + edges + bytes_while_grouping(c.vertices, c.edges, c.vertices, 1))};
}

}  // namespace

MemoryNeed triangulation_memory(std::size_t balls) {
  const SimplexCount c = count_of_molecule(balls);
  const std::uint64_t tetrahedron = sizeof(std::array<BallIndex, 4>) + 4 * sizeof(Neighbour);
  const std::uint64_t held = c.tetrahedra * tetrahedron + balls * sizeof(BallIndex);
  return {held, c.tetrahedra * kMakingBytesPerTetrahedron};
}

MemoryNeed filtration_memory(std::size_t balls) {
  return need(count_of_molecule(balls));
}

MemoryNeed filtration_memory(const Triangulation& triangulation,
                             TetrahedraOfFiltration tetrahedra) {
  MemoryNeed all = need(simplex_count(triangulation));
  if (tetrahedra == TetrahedraOfFiltration::own) return all;
  const std::uint64_t shared = triangulation.tetrahedra.size() * sizeof(std::array<BallIndex, 4>);
  return {all.held - shared, all.peak - shared};
}

std::uint64_t bytes_of(const Triangulation& t) {
  const auto bytes = [](const auto& array) { return array.capacity() * sizeof(array[0]); };
  return bytes(t.tetrahedra) + bytes(t.neighbours) + bytes(t.hull) + bytes(t.triangles) +
         bytes(t.edges) + bytes(t.vertices) + bytes(t.hidden);
}

}  // namespace alphascope
