// SPDX-License-Identifier: GPL-3.0-or-later
// The memory that a triangulation and a filtration will need. Callers use it to decide whether
// there is room before they make them.
#pragma once

#include <cstddef>
#include <cstdint>

namespace alphascope {

struct Triangulation;

// Memory in bytes.
struct MemoryNeed {
  std::uint64_t held = 0;  // held by the finished object
  std::uint64_t peak = 0;  // while it is made: with the object, without its input
};

// The need for a molecule with this number of balls. These are estimates with 7 tetrahedra for each
// ball. Molecules have some 6.7; other sets may have far more.
MemoryNeed triangulation_memory(std::size_t balls);
MemoryNeed filtration_memory(std::size_t balls);  // with its own copy of the tetrahedra

// The need of the filtration of this triangulation: `held` is exact, `peak` within some percent.
enum class TetrahedraOfFiltration : std::uint8_t { own, shared };  // shared with the triangulation
MemoryNeed filtration_memory(const Triangulation& triangulation,
                             TetrahedraOfFiltration tetrahedra = TetrahedraOfFiltration::own);

// Bytes that a triangulation holds.
std::uint64_t bytes_of(const Triangulation& triangulation);

}  // namespace alphascope
