// How much memory a triangulation and a filtration take, before they are made: for those who decide
// whether there is room.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/complex/triangulation.hpp"

namespace alphascope {

struct SimplexCount {
  std::uint64_t vertices = 0, edges = 0, triangles = 0, tetrahedra = 0;
};
// All of them, also those that it does not list.
SimplexCount simplex_count(const Triangulation& triangulation);

// Bytes.
struct MemoryNeed {
  std::uint64_t held = 0;  // by the object once it is made
  std::uint64_t peak = 0;  // while it is made, the object included, its input not
};

// Of a molecule with so many balls. Estimates: molecules have some 6.7 tetrahedra a ball, and these
// are reckoned with 7; other sets may have far more.
MemoryNeed triangulation_memory(std::size_t balls);
MemoryNeed filtration_memory(std::size_t balls);  // with tetrahedra of its own

// Of the filtration of this triangulation: held is exact, peak within some percent.
enum class TetrahedraOfFiltration : std::uint8_t { own, shared };  // shared: the triangulation's
MemoryNeed filtration_memory(const Triangulation& triangulation,
                             TetrahedraOfFiltration tetrahedra = TetrahedraOfFiltration::own);

// What a triangulation holds.
std::uint64_t bytes_of(const Triangulation& triangulation);

}  // namespace alphascope
