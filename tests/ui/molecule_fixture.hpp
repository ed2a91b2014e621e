// SPDX-License-Identifier: GPL-3.0-or-later
// A small invented molecule for tests of the window: a rod of atoms in two colours. Making it needs
// neither a file nor OpenGL.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "core/engine/engine.hpp"
#include "core/molecule/rgb8.hpp"
#include "ui/scene/mesh/ball_geometry.hpp"

namespace alphascope::testing {

inline constexpr Rgb8 kRed{220, 40, 40}, kBlue{40, 90, 230};

// A rod of 4 x 4 x `length` atoms along z. Radii are 1.7 Å, and distances about 1.8 Å with some
// disorder. So K_0 has tetrahedra and no ties.
inline std::shared_ptr<const BallSet> rod(int length = 14) {
  auto balls = std::make_shared<BallSet>();
  std::uint32_t state = 12345;
  const auto jitter = [&state] {  // -300 to 299 lattice units
    state = state * 1664525u + 1013904223u;
    return static_cast<std::int32_t>((state >> 16) % 600) - 300;
  };
  for (int z = 0; z < length; ++z) {
    for (int i = 0; i < 16; ++i) {
      const std::int32_t x = 1800 * (i % 4) + jitter(), y = 1800 * (i / 4) + jitter();
      balls->centres.push_back({x, y, 1800 * z + jitter()});
      balls->radii.push_back(1700);
    }
  }
  return balls;
}

inline std::vector<Rgb8> two_colours(std::size_t count) {
  std::vector<Rgb8> colours(count, kRed);
  for (std::size_t i = count / 2; i < count; ++i) colours[i] = kBlue;
  return colours;
}

inline AlphaComplex complex_of(std::shared_ptr<const BallSet> balls, double alpha_angstrom2,
                               bool tetrahedra_only = false) {
  return make_cpu_engine(std::move(balls))->compute({alpha_angstrom2, tetrahedra_only}, {});
}

}  // namespace alphascope::testing
