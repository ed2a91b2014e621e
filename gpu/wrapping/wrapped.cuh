// SPDX-License-Identifier: GPL-3.0-or-later
// A triangulation in device memory, as wrapping leaves it.
#pragma once

#include "gpu/memory/work_stream.cuh"
#include "gpu/wrapping/front.cuh"

namespace alphascope::gpu {

// Valid until the next run.
struct Wrapped {
  const WorkStream* stream = nullptr;
  Faces faces{};
  std::uint32_t count = 0;  // tetrahedra
  std::uint32_t hull = 0;   // faces before which no ball was found
  const int4* balls = nullptr;
  std::uint32_t slots = 0;  // of balls
  const std::uint32_t* ball_of_slot = nullptr;
  std::uint32_t* found = nullptr;  // of each slot, as hidden.cuh has it, by the known tetrahedra
  float scale = 1;                 // the tree's
  FaceRef* spare = nullptr;        // memory for each face of each tetrahedron
};

}  // namespace alphascope::gpu
