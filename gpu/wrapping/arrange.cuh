// SPDX-License-Identifier: GPL-3.0-or-later
// Puts a triangulation on the device into the order of a Triangulation: tetrahedra of ascending
// balls in lexicographic order, with their neighbours; vertices and hidden balls.
#pragma once

#include "gpu/wrapping/hidden.cuh"

namespace alphascope::gpu {

// The balls of a tetrahedron, ascending, and the corner of each.
struct AscendingBalls {
  std::uint32_t ball[4];
  int corner[4];

  __device__ AscendingBalls(const Quad& q, const std::uint32_t* ball_of_slot)
      : ball{ball_of_slot[ball_at(q, 0)], ball_of_slot[q.y], ball_of_slot[q.z], ball_of_slot[q.w]},
        corner{0, 1, 2, 3} {
    order<0, 1>();
    order<2, 3>();
    order<0, 2>();
    order<1, 3>();
    order<1, 2>();
  }

 private:
  template <int A, int B>
  __device__ void order() {
    if (ball[A] <= ball[B]) return;
    const std::uint32_t kept = ball[A];
    ball[A] = ball[B];
    ball[B] = kept;
    const int kept_corner = corner[A];
    corner[A] = corner[B];
    corner[B] = kept_corner;
  }
};

// Keys of the two lower and the two higher balls. `bits`: of a ball index.
__global__ void find_keys(const Quad* quads, std::uint32_t count, const std::uint32_t* ball_of_slot,
                          int bits, std::uint64_t* lower, std::uint64_t* higher,
                          std::uint32_t* index) {
  const std::uint32_t n = grid_thread();
  if (n >= count) return;
  const AscendingBalls b(quads[n], ball_of_slot);
  lower[n] = std::uint64_t{b.ball[0]} << bits | b.ball[1];
  higher[n] = std::uint64_t{b.ball[2]} << bits | b.ball[3];
  index[n] = n;
}
__global__ void gather_keys(const std::uint64_t* keys, const std::uint32_t* order,
                            std::uint32_t count, std::uint64_t* gathered) {
  const std::uint32_t n = grid_thread();
  if (n < count) gathered[n] = keys[order[n]];
}
__global__ void invert_order(const std::uint32_t* order, std::uint32_t count,
                             std::uint32_t* after) {
  const std::uint32_t n = grid_thread();
  if (n < count) after[order[n]] = n;
}

// Results as they are copied to the host.
struct Arranged {
  uint4* tetrahedra;
  uint4* neighbours;    // as Neighbour has them; any number for a face on the hull
  std::uint32_t* hull;  // four times the tetrahedron plus the corner, in any order
  std::uint32_t hull_room;
  std::uint32_t* hull_count;
  uint4* hull_balls;  // the tetrahedron of each of these faces, and after them the first one of all
};

// The result is not certified yet, so neighbours may be any numbers.
__global__ void arrange_quads(Faces faces, std::uint32_t count, const std::uint32_t* ball_of_slot,
                              const std::uint32_t* order, const std::uint32_t* after,
                              Arranged out) {
  const std::uint32_t n = grid_thread();
  const bool has = n < count;
  std::uint32_t across[4] = {0, 0, 0, 0};
  if (has) {
    const std::uint32_t from = order[n];
    const AscendingBalls b(faces.quads[from], ball_of_slot);
    out.tetrahedra[n] = make_uint4(b.ball[0], b.ball[1], b.ball[2], b.ball[3]);
    for (int k = 0; k < 4; ++k) {
      const FaceRef other =
          faces.neighbours[std::size_t{4} * from + static_cast<unsigned>(b.corner[k])];
      across[k] = other >> 2 < count ? after[other >> 2] : kOpen;
    }
    out.neighbours[n] = make_uint4(across[0], across[1], across[2], across[3]);
  }
  for (std::uint32_t k = 0; k < 4; ++k)
    append(has && across[k] == kOpen, 4 * n + k, out.hull, out.hull_room, out.hull_count);
}

// One thread for each face on the hull, and one more.
__global__ void gather_hull(Arranged out) {
  const std::uint32_t n = grid_thread();
  if (n > out.hull_room) return;
  const bool listed = n < min(*out.hull_count, out.hull_room);
  out.hull_balls[n] = out.tetrahedra[listed ? out.hull[n] / 4 : 0];
  if (!listed && n < out.hull_room) out.hull[n] = 0;
}

// Marks each vertex by its index.
__global__ void mark_vertices(const std::uint32_t* found, const std::uint32_t* ball_of_slot,
                              std::uint32_t slots, std::uint32_t* is_vertex) {
  const std::uint32_t n = grid_thread();
  if (n < slots) is_vertex[ball_of_slot[n]] = found[n] != 0 && found[n] != kHiddenBall ? 1 : 0;
}
// Writes vertices, and after them all other balls. `place`: the number of vertices before each
// ball; one more at the end.
__global__ void list_balls(const std::uint32_t* is_vertex, const std::uint32_t* place,
                           std::uint32_t count, std::uint32_t* listed) {
  const std::uint32_t n = grid_thread();
  if (n >= count) return;
  listed[is_vertex[n] != 0 ? place[n] : place[count] + n - place[n]] = n;
}

}  // namespace alphascope::gpu
