// SPDX-License-Identifier: GPL-3.0-or-later
// Regular triangulations on a CUDA device. Plain C++.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/triangulation/device_triangulator.hpp"

namespace alphascope {

// For a usable device only. Throws std::bad_alloc and ExecutorFailed.
std::unique_ptr<DeviceTriangulator> make_gpu_triangulator(FindSeed find_seed);

namespace gpu {

// A triangulation before it is certified, as tests spoil it. [t]: four slots of balls, of which the
// first has the top bit set for a negative determinant; and for each corner four times the
// neighbour across the opposite face plus the corner there, or ~0. There may be fewer afterwards.
struct Uncertified {
  std::vector<std::array<std::uint32_t, 4>> quads, neighbours;
};
std::unique_ptr<DeviceTriangulator> make_spoilt_triangulator(
    FindSeed find_seed, std::function<void(Uncertified&)> spoil);

}  // namespace gpu
}  // namespace alphascope
