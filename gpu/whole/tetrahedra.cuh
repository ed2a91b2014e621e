// SPDX-License-Identifier: GPL-3.0-or-later
// Alpha values and flow of tetrahedra.
#pragma once

#include "core/triangulation/flow.hpp"
#include "core/triangulation/tetrahedron_flow.hpp"
#include "gpu/whole/whole.cuh"

namespace alphascope::gpu {

// Sets the bits Flow::kFaces and the value of each tetrahedron, and counts ties.
__global__ void __launch_bounds__(256, 3)
    find_flow(WholeTriangulation in, FlowTies ties, float* values, std::uint8_t* marks,
              std::uint32_t* tied) {
  const std::uint32_t t = grid_thread();
  if (t >= in.tetrahedron_count) return;
  const DeviceCorners corners{in.balls, in.tetrahedra[t]};
  const TetrahedronFlow tetrahedron(corners);
  std::uint32_t own_ties = 0;
  values[t] = tetrahedron.alpha_value();
  marks[t] = tetrahedron.flow(ties, own_ties);
  if (own_ties > 0) atomicAdd(tied, own_ties);
}

// Marks the tetrahedra at which ways of the flow end: at a sink, or at infinity.
__global__ void mark_ends(WholeTriangulation in, std::uint8_t* marks) {
  const std::uint32_t t = grid_thread();
  if (t >= in.tetrahedron_count) return;
  const unsigned faces = marks[t];
  unsigned ends = faces == 0 ? Flow::kReachesSink : 0;
  for (unsigned k = 0; k < 4; ++k) {
    if ((faces >> k & 1) != 0 && (part(in.neighbours[t], k) & kHullBit) != 0)
      ends |= Flow::kReachesInfinity;
  }
  marks[t] = static_cast<std::uint8_t>(faces | ends);
}

// Takes over what tetrahedra reach to which the flow leads. Marks of others may be read before or
// after they change; marks are only added, so the end is the same.
__global__ void spread_ends(WholeTriangulation in, std::uint8_t* marks, std::uint32_t* changes) {
  constexpr unsigned kBoth = Flow::kReachesSink | Flow::kReachesInfinity;
  const std::uint32_t t = grid_thread();
  if (t >= in.tetrahedron_count) return;
  const unsigned own = marks[t];
  if ((own & kBoth) == kBoth) return;
  unsigned reached = own;
  for (unsigned k = 0; k < 4; ++k) {
    const std::uint32_t across = part(in.neighbours[t], k);
    if ((own >> k & 1) != 0 && (across & kHullBit) == 0)
      reached |= static_cast<const volatile std::uint8_t*>(marks)[across] & kBoth;
  }
  if (reached == own) return;
  marks[t] = static_cast<std::uint8_t>(reached);
  *changes = 1;
}

}  // namespace alphascope::gpu
