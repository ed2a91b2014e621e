// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of a triangulation in lexicographic order, and the edges of its triangles. Triangles
// name edges in the list of the edge's lower ball, some of them more than once.
#pragma once

#include "core/predicates/attached_edges.hpp"
#include "gpu/whole/triangles.cuh"

namespace alphascope::gpu {

// Names by ball: the higher ball of each edge.
struct EdgeNames {
  const std::uint32_t* first;  // of each ball; one more at the end
  std::uint32_t *lower, *higher;
  std::uint8_t* is_new;  // no name before it in the list is the same
};

// `placed`: zero for each ball.
__global__ void name_edges(std::uint32_t triangles, Triangles of, EdgeNames out,
                           std::uint32_t* placed) {
  const std::uint32_t n = grid_thread();
  if (n >= triangles) return;
  const std::uint32_t* const v = of.balls + std::size_t{3} * n;
  for (unsigned k = 0; k < 3; ++k) {
    if ((of.names_edges[n] >> k & 1) == 0) continue;
    const uint2 edge = edge_without(make_uint4(v[0], v[1], v[2], 0), k);
    const std::uint32_t at = out.first[edge.x] + atomicAdd(&placed[edge.x], 1u);
    out.lower[at] = edge.x;
    out.higher[at] = edge.y;
  }
}

// One thread for each name. `balls`: their number. Counts the edges of each ball.
__global__ void find_new_names(std::uint32_t balls, EdgeNames names, std::uint32_t* edges_of_ball) {
  const std::uint32_t n = grid_thread();
  if (n >= names.first[balls]) return;
  const std::uint32_t lower = names.lower[n], higher = names.higher[n];
  bool is_new = true;
  for (std::uint32_t m = names.first[lower]; m < n && is_new; ++m)
    is_new = names.higher[m] != higher;
  names.is_new[n] = is_new ? 1 : 0;
  if (is_new) atomicAdd(&edges_of_ball[lower], 1u);
}

// `first_edge` of each ball.
__global__ void rank_edges(WholeTriangulation in, EdgeNames names, const std::uint32_t* first_edge,
                           uint2* edges) {
  const std::uint32_t n = grid_thread();
  if (n >= names.first[in.ball_count] || names.is_new[n] == 0) return;
  const std::uint32_t lower = names.lower[n], higher = names.higher[n];
  std::uint32_t rank = first_edge[lower];
  for (std::uint32_t m = names.first[lower]; m < names.first[lower + 1]; ++m)
    rank += names.is_new[m] != 0 && names.higher[m] < higher ? 1u : 0u;
  if (rank < in.edge_count) edges[rank] = make_uint2(lower, higher);
}

// The place of an edge that is there.
__device__ inline std::uint32_t place_of(const uint2& edge, const std::uint32_t* first_edge,
                                         const uint2* edges) {
  std::uint32_t low = first_edge[edge.x], high = first_edge[edge.x + 1] - 1;
  while (low < high) {
    const std::uint32_t middle = low + (high - low) / 2;
    if (edges[middle].y < edge.y) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

// Writes the edges of each triangle, if they are wanted.
__global__ void find_edges_of_triangles(std::uint32_t triangles, const std::uint32_t* balls,
                                        const std::uint32_t* first_edge, const uint2* edges,
                                        std::uint32_t* of_triangle) {
  const std::uint32_t n = grid_thread();
  if (n >= 3 * triangles) return;
  const std::uint32_t* const v = balls + n / 3 * std::size_t{3};
  of_triangle[n] =
      place_of(edge_without(make_uint4(v[0], v[1], v[2], 0), n % 3), first_edge, edges);
}

// Triangles tell their edges.
__global__ void __launch_bounds__(256, 3)
    tell_edges(WholeTriangulation in, Triangles of, const std::uint32_t* first_edge,
               const uint2* edges, Told* told, std::uint8_t* attached) {
  const std::uint32_t n = grid_thread();
  if (n >= in.triangle_count) return;
  const std::uint32_t* const v = of.balls + std::size_t{3} * n;
  const DeviceCorners corners{in.balls, make_uint4(v[0], v[1], v[2], 0)};
  const unsigned attached_here = attached_edges(corners);
  const float value = of.values.value[n], interior = of.values.interior_from[n];
  for (unsigned k = 0; k < 3; ++k) {
    const std::uint32_t e = place_of(edge_without(corners.simplex, k), first_edge, edges);
    tell(&told[e], value, interior);
    if ((attached_here >> k & 1) != 0) attached[e] = 1;
  }
}

// Sets an edge, and tells its ends.
__global__ void __launch_bounds__(256, 3)
    set_edges(WholeTriangulation in, const uint2* edges, const Told* told,
              const std::uint8_t* attached, FaceValues out, Told* told_balls,
              std::uint8_t* attached_balls) {
  const std::uint32_t e = grid_thread();
  if (e >= in.edge_count) return;
  const uint2 edge = edges[e];
  const DeviceCorners corners{in.balls, make_uint4(edge.x, edge.y, 0, 0)};
  const LiftedInt j = corners.lifted(0, 1);
  const FaceLevels levels = told[e].levels();
  const float value = face_value(attached[e] != 0 ? 0 : kUnattached, levels.regular_from, [&] {
    return rounded_rho(LiftedSimplex<2>{{j}, corners.weight(0)});
  });
  out.set(e, value, levels);
  const unsigned ends = attached_ends(j);
  if ((ends & 1) != 0) attached_balls[edge.x] = 1;
  if ((ends & 2) != 0) attached_balls[edge.y] = 1;
  tell(&told_balls[edge.x], value, levels.interior_from);
  tell(&told_balls[edge.y], value, levels.interior_from);
}

__global__ void set_vertices(WholeTriangulation in, const BallIndex* vertices, const Told* told,
                             const std::uint8_t* attached, FaceValues out) {
  const std::uint32_t n = grid_thread();
  if (n >= in.vertex_count) return;
  const BallIndex ball = vertices[n];
  const FaceLevels levels = told[ball].levels();
  const DeviceCorners corners{in.balls, make_uint4(ball, ball, ball, ball)};
  out.set(n,
          face_value(attached[ball] != 0 ? 0 : kUnattached, levels.regular_from,
                     [&] {
                       return rounded_rho(LiftedSimplex<1>{{}, corners.weight(0)});
                     }),
          levels);
}

}  // namespace alphascope::gpu
