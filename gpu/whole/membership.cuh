// SPDX-License-Identifier: GPL-3.0-or-later
// Which simplices of a triangulation are in K_alpha, as core/triangulation/membership.hpp finds it
// on the CPU: from tetrahedra down to vertices. Cofaces set the marks of their faces. Several
// threads may store to one mark at once; all store the same value.
#pragma once

#include "core/geometry/lattice_alpha.hpp"
#include "core/predicates/attached_edges.hpp"
#include "gpu/whole/whole.cuh"

namespace alphascope::gpu {

inline constexpr std::uint8_t kOut = 0, kIn = 1, kInUnlessAttached = 2;

// A triangulation with its incidences and flow, and the marks that are made.
struct MembershipAt {
  WholeTriangulation of;
  const float* values;       // of tetrahedra
  const std::uint8_t* flow;  // Flow::marks
  const std::uint32_t* triangles;
  const uint2* edges;
  const std::uint32_t* of_tetrahedron;
  const uint2* tetrahedra;
  const std::uint32_t* edges_of_triangle;
  LatticeAlpha alpha;
  float limit;                                                       // the float nearest to alpha
  std::uint8_t *tetrahedron_in, *triangle_in, *edge_in, *vertex_in;  // the last by ball
  std::uint8_t* is_vertex;                                           // by ball

  __device__ DeviceCorners corners(const std::uint32_t* simplex, int size) const {
    return {of.balls, make_uint4(simplex[0], simplex[size > 1 ? 1 : 0], simplex[size > 2 ? 2 : 0],
                                 simplex[size > 3 ? 3 : 0])};
  }
};

__global__ void mark_tetrahedra(MembershipAt m) {
  const std::uint32_t t = grid_thread();
  if (t >= m.of.tetrahedron_count) return;
  const float value = m.values[t];
  bool in = value < m.limit;
  if (value == m.limit) {
    const DeviceCorners c{m.of.balls, m.of.tetrahedra[t]};
    in =
        compare_rho(LiftedSimplex<4>{{c.lifted(0, 1), c.lifted(0, 2), c.lifted(0, 3)}, c.weight(0)},
                    m.alpha) <= 0;
  }
  m.tetrahedron_in[t] = in ? kIn : kOut;
}

// Marks a triangle, and the edges of one in K_alpha.
__global__ void __launch_bounds__(256, 3) mark_triangles(MembershipAt m) {
  const std::uint32_t f = grid_thread();
  if (f >= m.of.triangle_count) return;
  const uint2 sides = m.tetrahedra[f];
  bool in = false, attached = false;
  for (const std::uint32_t t : {sides.x, sides.y}) {
    if (t == kNoTetrahedron) continue;
    in = in || m.tetrahedron_in[t] != kOut;
    const std::uint32_t* const faces = m.of_tetrahedron + std::size_t{4} * t;
    const unsigned k = faces[0] == f ? 0 : faces[1] == f ? 1 : faces[2] == f ? 2 : 3;
    attached = attached || (m.flow[t] >> k & 1) != 0;
  }
  if (!in && !attached) {
    const DeviceCorners c = m.corners(m.triangles + std::size_t{3} * f, 3);
    in = compare_rho(LiftedSimplex<3>{{c.lifted(0, 1), c.lifted(0, 2)}, c.weight(0)}, m.alpha) <= 0;
  }
  m.triangle_in[f] = in ? kIn : kOut;
  if (!in) return;
  for (unsigned k = 0; k < 3; ++k) m.edge_in[m.edges_of_triangle[std::size_t{3} * f + k]] = kIn;
}

// Tests edges without a coface in K_alpha, and tells vertices.
__global__ void __launch_bounds__(256, 3) ask_edges(MembershipAt m) {
  const std::uint32_t e = grid_thread();
  if (e >= m.of.edge_count) return;
  const uint2 edge = m.edges[e];
  m.is_vertex[edge.x] = m.is_vertex[edge.y] = 1;
  if (m.edge_in[e] != kOut) return;
  const DeviceCorners c{m.of.balls, make_uint4(edge.x, edge.y, 0, 0)};
  if (compare_rho(LiftedSimplex<2>{{c.lifted(0, 1)}, c.weight(0)}, m.alpha) <= 0)
    m.edge_in[e] = kInUnlessAttached;
}
__global__ void __launch_bounds__(256, 3) leave_out_attached_edges(MembershipAt m) {
  const std::uint32_t f = grid_thread();
  if (f >= m.of.triangle_count || m.triangle_in[f] != kOut) return;
  const DeviceCorners c = m.corners(m.triangles + std::size_t{3} * f, 3);
  for (unsigned k = 0; k < 3; ++k) {
    std::uint8_t& mark = m.edge_in[m.edges_of_triangle[std::size_t{3} * f + k]];
    if (*static_cast<const volatile std::uint8_t*>(&mark) != kInUnlessAttached) continue;
    const unsigned i = k == 0 ? 1 : 0, j = k == 2 ? 1 : 2;
    if (edge_foot_cut(c.lifted(i, j), c.lifted(i, k)) > 0) mark = kOut;
  }
}
__global__ void mark_edges(MembershipAt m) {
  const std::uint32_t e = grid_thread();
  if (e >= m.of.edge_count) return;
  if (m.edge_in[e] == kOut) return;
  m.edge_in[e] = kIn;
  const uint2 edge = m.edges[e];
  m.vertex_in[edge.x] = m.vertex_in[edge.y] = kIn;
}
__global__ void ask_vertices(MembershipAt m) {
  const std::uint32_t v = grid_thread();
  if (v >= m.of.ball_count || m.vertex_in[v] != kOut || m.is_vertex[v] == 0) return;
  const DeviceCorners c{m.of.balls, make_uint4(v, v, v, v)};
  if (compare_rho(LiftedSimplex<1>{{}, c.weight(0)}, m.alpha) <= 0)
    m.vertex_in[v] = kInUnlessAttached;
}
__global__ void leave_out_attached_vertices(MembershipAt m) {
  const std::uint32_t e = grid_thread();
  if (e >= m.of.edge_count || m.edge_in[e] != kOut) return;
  const uint2 edge = m.edges[e];
  const DeviceCorners c{m.of.balls, make_uint4(edge.x, edge.y, 0, 0)};
  const unsigned attached = attached_ends(c.lifted(0, 1));
  const volatile std::uint8_t* const marks = m.vertex_in;
  if ((attached & 1) != 0 && marks[edge.x] == kInUnlessAttached) m.vertex_in[edge.x] = kOut;
  if ((attached & 2) != 0 && marks[edge.y] == kInUnlessAttached) m.vertex_in[edge.y] = kOut;
}
__global__ void mark_vertices_in(MembershipAt m) {
  const std::uint32_t v = grid_thread();
  if (v < m.of.ball_count && m.vertex_in[v] != kOut) m.vertex_in[v] = kIn;
}

}  // namespace alphascope::gpu
