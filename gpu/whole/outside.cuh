// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of tetrahedra outside the balls (core/cavity/outside_body.hpp), with the CPU's bits.
#pragma once

#include "core/cavity/order_balls.hpp"
#include "core/cavity/outside_body.hpp"
#include "gpu/whole/membership.cuh"

namespace alphascope::gpu {

// Balls are taken by their centres, so that the order of the file changes no bit. No ball of them
// may be smaller than the solvent radius (lattice units) when it is grown.
__global__ void __launch_bounds__(128, 4)
    measure_outside(MembershipAt m, const std::uint32_t* tetrahedra, std::uint32_t count,
                    double solvent, OutsidePart* parts) {
  const std::uint32_t n = grid_thread();
  if (n >= count) return;
  const std::uint32_t t = tetrahedra[n];
  const uint4 balls = m.of.tetrahedra[t];
  const int4 centre[4] = {m.of.balls[balls.x], m.of.balls[balls.y], m.of.balls[balls.z],
                          m.of.balls[balls.w]};
  unsigned order[4];
  order_balls(order, [&](unsigned a, unsigned b) {
    const int4 &p = centre[a], &q = centre[b];
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
  });
  const std::uint32_t* const faces = m.of_tetrahedron + std::size_t{4} * t;
  FacesIn in;
  GrownBall grown[4];
  for (unsigned k = 0, e = 0; k < 4; ++k) {
    const int4& p = centre[order[k]];
    grown[k] = grown_ball({p.x, p.y, p.z}, p.w, m.alpha);
    in.balls |= (m.vertex_in[part(balls, order[k])] != kOut ? 1u : 0u) << k;
    in.triangles |= (m.triangle_in[faces[order[k]]] != kOut ? 1u : 0u) << k;
    for (unsigned l = k + 1; l < 4; ++l, ++e) {
      const unsigned first = min(order[k], order[l]), second = max(order[k], order[l]);
      // As edge_of_tetrahedron().
      const unsigned c = first > 0 ? 0 : second > 1 ? 1 : 2, d = 6 - first - second - c;
      const std::uint32_t edge =
          m.edges_of_triangle[std::size_t{3} * faces[c] + (d > c ? d - 1 : d)];
      in.edges |= (m.edge_in[edge] != kOut ? 1u : 0u) << e;
    }
  }
  OutsidePart of = OutsideBody<NoSmallBalls>(grown, in, solvent).part();
  double area[4];
  for (unsigned k = 0; k < 4; ++k) area[order[k]] = of.area[k];
  for (unsigned k = 0; k < 4; ++k) of.area[k] = area[k];
  parts[n] = of;
}

}  // namespace alphascope::gpu
