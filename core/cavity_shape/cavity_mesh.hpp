// The surface of a cavity's tetrahedra, for programs that draw meshes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/cavity/cavities.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

// Each triangle is counterclockwise when seen from outside the cavity.
struct CavityMesh {
  std::vector<RealPoint> points;  // Å; each once: centres of balls, by their index
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// Of cavity `index` of `found`. Of a void it is closed, of a pocket open at the mouths, of
// a part of a network at the passages as well.
CavityMesh cavity_mesh(const CavityGround& ground, const Cavities& found, std::uint32_t index);

}  // namespace alphascope
