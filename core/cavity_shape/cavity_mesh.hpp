// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of a cavity's tetrahedra as a mesh, for programs that draw meshes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/cavity/cavities.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

// Each triangle is counterclockwise when seen from outside the cavity.
struct CavityMesh {
  std::vector<RealPoint> points;  // Å; centres of balls, each once, ordered by index
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// The mesh of cavity `index` of `found`. It is closed for a void and open at the mouths of a
// pocket. For a part of a network it is also open at the passages.
CavityMesh cavity_mesh(const CavityGround& ground, const Cavities& found, std::uint32_t index);

}  // namespace alphascope
