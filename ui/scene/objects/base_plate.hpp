// SPDX-License-Identifier: GPL-3.0-or-later
// The plate of a nucleotide's base: its rings, filled. Pure C++; no VTK.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/molecule/rgb8.hpp"
#include "core/secondary/backbone.hpp"
#include "ui/scene/mesh/tube_mesh.hpp"

namespace alphascope {

inline constexpr double kPlateThickness = 0.5;  // Å

struct BasePlate {
  std::array<RealPoint, 9> outline{};  // as Nucleotide::outline; Å, relative to the origin
  std::size_t corners = 0;             // 6 or 9
  std::uint32_t atom = 0;              // index in Molecule::atoms
  Rgb8 colour;
};

// Adds the surface of a plate. Its triangles face outwards.
void add_plate(const BasePlate& plate, SmoothMesh& mesh);

}  // namespace alphascope
