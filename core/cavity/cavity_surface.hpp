// The surface of a cavity's tetrahedra, for programs that draw meshes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/cavity/cavities.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

// Each triangle is counterclockwise when seen from outside the cavity.
struct CavitySurface {
  std::vector<RealPoint> points;  // Å; each once: centres of balls, by their index
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// Of a void it is closed. Of a pocket it is open at the mouths.
CavitySurface cavity_surface(const CavityGround& ground, const Cavity& cavity);

}  // namespace alphascope
