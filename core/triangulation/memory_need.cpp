#include "core/triangulation/memory_need.hpp"

#include <algorithm>

#include "core/complex/alpha_complex.hpp"

namespace alphascope {
namespace {

struct Counts {
  std::uint64_t vertices = 0, edges = 0, triangles = 0, tetrahedra = 0;
};

// 1K4C, 1AON and 3J6R have 6.6 to 6.8.
constexpr std::uint64_t kTetrahedraPerBall = 7;
// CGAL's cells, its vertices and what is left unused of its blocks of memory. Measured per
// tetrahedron, at the end of its making: 1K4C 136, 1AON and 3J6R 135.
constexpr std::uint64_t kCgalBytesPerTetrahedron = 140;

Counts counts_of_molecule(std::size_t balls) {
  const std::uint64_t tetrahedra = kTetrahedraPerBall * balls;
  return {balls, tetrahedra + balls, 2 * tetrahedra, tetrahedra};
}

// V - E + F - T = 1, and each tetrahedron has four faces that two share, but for the hull's.
Counts counts_of(const Triangulation& t) {
  Counts c;
  c.vertices = t.vertices.size();
  c.tetrahedra = t.tetrahedra.size();
  c.triangles = t.dimension == 2 ? t.triangles.size() : (4 * c.tetrahedra + t.hull.size()) / 2;
  if (t.dimension >= 1) c.edges = c.vertices + c.triangles - c.tetrahedra - 1;
  return c;
}

constexpr std::uint64_t bytes_of_simplex(std::uint64_t balls) {
  return balls * sizeof(BallIndex) + sizeof(float) + sizeof(SimplexClass);
}
constexpr std::uint64_t kLevels = 2 * sizeof(float);  // from where on regular, and interior

// The faces of all cofaces in groups, then the list, its positions in the groups (twice) and its
// levels: the most is there when the list's levels are being set.
std::uint64_t bytes_while_grouping(std::uint64_t faces, std::uint64_t cofaces,
                                   std::uint64_t balls) {
  const std::uint64_t record = balls > 2 ? 16 : 8, index = sizeof(std::uint32_t);
  const std::uint64_t face = balls * sizeof(BallIndex);
  return cofaces * (balls + 1) * record +
         faces * (face + index + 2 * index + bytes_of_simplex(balls) + kLevels);
}

MemoryNeed need(const Counts& c) {
  const std::uint64_t tetrahedra = c.tetrahedra * bytes_of_simplex(4);
  const std::uint64_t triangles = c.triangles * (bytes_of_simplex(3) + kLevels);
  const std::uint64_t edges = c.edges * (bytes_of_simplex(2) + kLevels);
  const std::uint64_t vertices = c.vertices * (bytes_of_simplex(1) + kLevels);
  const std::uint64_t peak =
      std::max({tetrahedra + bytes_while_grouping(c.triangles, c.tetrahedra, 3),
                tetrahedra + triangles + bytes_while_grouping(c.edges, c.triangles, 2),
                tetrahedra + triangles + edges + bytes_while_grouping(c.vertices, c.edges, 1)});
  return {tetrahedra + triangles + edges + vertices, peak};
}

}  // namespace

MemoryNeed triangulation_memory(std::size_t balls) {
  const Counts c = counts_of_molecule(balls);
  const std::uint64_t tetrahedron = sizeof(std::array<BallIndex, 4>) + 4 * sizeof(Neighbour);
  const std::uint64_t held = c.tetrahedra * tetrahedron + balls * sizeof(BallIndex);
  return {held, c.tetrahedra * kCgalBytesPerTetrahedron};
}

MemoryNeed filtration_memory(std::size_t balls) {
  return need(counts_of_molecule(balls));
}

MemoryNeed filtration_memory(const Triangulation& triangulation) {
  return need(counts_of(triangulation));
}

std::uint64_t bytes_of(const Triangulation& t) {
  const auto bytes = [](const auto& array) { return array.capacity() * sizeof(array[0]); };
  return bytes(t.tetrahedra) + bytes(t.neighbours) + bytes(t.hull) + bytes(t.triangles) +
         bytes(t.edges) + bytes(t.vertices) + bytes(t.hidden);
}

}  // namespace alphascope
