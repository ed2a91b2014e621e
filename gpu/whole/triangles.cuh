// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles of a triangulation in lexicographic order. The lower of its tetrahedra records a
// triangle in the list of the triangle's first ball. Its rank there is the number of lower records.
#pragma once

#include "core/predicates/orthosphere.hpp"
#include "gpu/whole/whole.cuh"

namespace alphascope::gpu {

// Records by ball. A code is four times a tetrahedron plus the corner opposite the face.
struct TriangleRecords {
  const std::uint32_t* first;  // of each ball; one more at the end
  std::uint64_t* rest;         // the second ball, then the third
  FaceCode* code;
};

__global__ void count_triangles(WholeTriangulation in, std::uint32_t* of_ball) {
  const std::uint32_t t = grid_thread();
  if (t >= in.tetrahedron_count) return;
  const uint4 balls = in.tetrahedra[t];
  const unsigned own =
      (in.owns(t, 1) ? 1u : 0u) + (in.owns(t, 2) ? 1u : 0u) + (in.owns(t, 3) ? 1u : 0u);
  if (own > 0) atomicAdd(&of_ball[balls.x], own);
  if (in.owns(t, 0)) atomicAdd(&of_ball[balls.y], 1u);
}

// `placed`: zero for each ball.
__global__ void record_triangles(WholeTriangulation in, TriangleRecords out,
                                 std::uint32_t* placed) {
  const std::uint32_t t = grid_thread();
  if (t >= in.tetrahedron_count) return;
  const uint4 balls = in.tetrahedra[t];
  const auto record = [&](std::uint32_t at, unsigned k) {
    const std::uint64_t second = part(balls, k < 2 ? 2 : 1), third = part(balls, k < 3 ? 3 : 2);
    out.rest[at] = second << 32 | third;
    out.code[at] = 4 * t + k;
  };
  unsigned own = 0;
  for (unsigned k = 1; k < 4; ++k) own += in.owns(t, k) ? 1u : 0u;
  if (own > 0) {
    std::uint32_t at = out.first[balls.x] + atomicAdd(&placed[balls.x], own);
    for (unsigned k = 1; k < 4; ++k) {
      if (in.owns(t, k)) record(at++, k);
    }
  }
  if (in.owns(t, 0)) record(out.first[balls.y] + atomicAdd(&placed[balls.y], 1u), 0);
}

// Writes the code of each triangle.
__global__ void rank_triangles(WholeTriangulation in, TriangleRecords records,
                               FaceCode* code_of_triangle) {
  const std::uint32_t n = grid_thread();
  if (n >= in.triangle_count) return;
  const FaceCode code = records.code[n];
  const std::uint32_t ball = part(in.tetrahedra[code / 4], code % 4 == 0 ? 1 : 0);
  const std::uint64_t own = records.rest[n];
  std::uint32_t rank = records.first[ball];
  for (std::uint32_t m = records.first[ball]; m < records.first[ball + 1]; ++m)
    rank += records.rest[m] < own ? 1u : 0u;
  code_of_triangle[rank] = code;
}

// What is written of triangles. Null arrays are not wanted.
struct Triangles {
  std::uint32_t* balls;           // three for each
  uint2* tetrahedra;              // Incidence::tetrahedra_of_triangle
  std::uint32_t* of_tetrahedron;  // four for each tetrahedron
  FaceValues values;
  std::uint8_t* names_edges;  // bits, as edges.cuh says
};

__device__ inline unsigned corner_towards(const uint4& neighbours, std::uint32_t t) {
  return neighbours.x == t ? 0 : neighbours.y == t ? 1 : neighbours.z == t ? 2 : 3;
}

// A triangle and the tetrahedra on both sides of it.
struct TriangleAt {
  std::uint32_t own, across;  // kNoTetrahedron: outside
  unsigned face, face_across;
  uint4 balls;                      // three of them
  std::uint32_t apex, apex_across;  // ~0: none

  __device__ TriangleAt(const WholeTriangulation& in, FaceCode code)
      : own(code / 4),
        across(part(in.neighbours[code / 4], code % 4)),
        face(code % 4),
        face_across(0),
        apex_across(~0u) {
    const uint4 all = in.tetrahedra[own];
    balls = make_uint4(part(all, face == 0 ? 1 : 0), part(all, face < 2 ? 2 : 1),
                       part(all, face < 3 ? 3 : 2), 0);
    apex = part(all, face);
    if ((across & kHullBit) != 0) {
      across = kNoTetrahedron;
      return;
    }
    face_across = corner_towards(in.neighbours[across], own);
    apex_across = part(in.tetrahedra[across], face_across);
  }
};

// Bit k: the triangle names its edge without ball k, because both triangles next to it around the
// edge have a higher third ball. So the lowest triangle around an edge names it, and few others.
__device__ inline unsigned edges_to_name(const TriangleAt& f) {
  unsigned names = 0;
  for (unsigned k = 0; k < 3; ++k) {
    const std::uint32_t third = part(f.balls, k);
    if (third < f.apex && third < f.apex_across) names |= 1u << k;
  }
  return names;
}
// The lower ball of the edge without ball k of a triangle, and the higher one.
__device__ inline uint2 edge_without(const uint4& triangle, unsigned k) {
  return make_uint2(k == 0 ? triangle.y : triangle.x, k == 2 ? triangle.y : triangle.z);
}

// `marks` has the strict flow, if values are wanted. `edges_of_ball` counts the edges named.
__global__ void __launch_bounds__(256, 3)
    set_triangles(WholeTriangulation in, const FaceCode* codes, const float* tetrahedron_values,
                  const std::uint8_t* marks, Triangles out, std::uint32_t* edges_of_ball) {
  const std::uint32_t n = grid_thread();
  if (n >= in.triangle_count) return;
  const TriangleAt f(in, codes[n]);
  const bool inside = f.across != kNoTetrahedron;
  out.balls[std::size_t{3} * n] = f.balls.x;
  out.balls[std::size_t{3} * n + 1] = f.balls.y;
  out.balls[std::size_t{3} * n + 2] = f.balls.z;
  const unsigned names = edges_to_name(f);
  out.names_edges[n] = static_cast<std::uint8_t>(names);
  for (unsigned k = 0; k < 3; ++k) {
    if ((names >> k & 1) != 0) atomicAdd(&edges_of_ball[edge_without(f.balls, k).x], 1u);
  }
  if (out.tetrahedra != nullptr) {
    out.tetrahedra[n] = make_uint2(f.own, f.across);
    out.of_tetrahedron[std::size_t{4} * f.own + f.face] = n;
    if (inside) out.of_tetrahedron[std::size_t{4} * f.across + f.face_across] = n;
  }
  if (out.values.value == nullptr) return;
  FaceLevels levels;
  const float own = tetrahedron_values[f.own];
  levels.add(own, own);
  bool attached = (marks[f.own] >> f.face & 1) != 0;
  if (inside) {
    const float other = tetrahedron_values[f.across];
    levels.add(other, other);
    attached = attached || (marks[f.across] >> f.face_across & 1) != 0;
  } else {
    levels.lie_on_hull();
  }
  const DeviceCorners corners{in.balls, f.balls};
  out.values.set(n,
                 face_value(attached ? 0 : kUnattached, levels.regular_from,
                            [&] {
                              return rounded_rho(LiftedSimplex<3>{
                                  {corners.lifted(0, 1), corners.lifted(0, 2)}, corners.weight(0)});
                            }),
                 levels);
}

}  // namespace alphascope::gpu
