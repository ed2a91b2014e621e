// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels of OuterFaceFinder. Each face of each tetrahedron finds itself among the triangles of
// its first vertex. If the triangle is regular, the face is stored as its owner.
#pragma once

#include "core/complex/face_code.hpp"
#include "gpu/memory/device_complex.hpp"

namespace alphascope::gpu {

// The consecutive triangles whose first vertex is a given ball.
struct TriangleRange {
  std::uint32_t begin, end;
};

__device__ inline std::size_t thread_number() {
  return std::size_t{blockIdx.x} * blockDim.x + threadIdx.x;
}

// `of_ball` must be zero before.
__global__ void find_ranges(DeviceSimplices triangles, TriangleRange* of_ball) {
  const std::size_t t = thread_number();
  if (t >= triangles.count) return;
  const BallIndex own = triangles.vertices[3 * t];
  const bool first = t == 0 || triangles.vertices[3 * (t - 1)] != own;
  const bool last = t + 1 == triangles.count || triangles.vertices[3 * (t + 1)] != own;
  if (first) of_ball[own].begin = static_cast<std::uint32_t>(t);
  if (last) of_ball[own].end = static_cast<std::uint32_t>(t + 1);
}

// `owner`: by triangle; written only for regular ones.
__global__ void find_owners(DeviceSimplices triangles, DeviceSimplices tetrahedra,
                            const TriangleRange* of_ball, FaceCode* owner) {
  const std::size_t n = thread_number();
  if (n >= 4 * tetrahedra.count) return;
  const auto code = static_cast<FaceCode>(n);
  const BallIndex* t = tetrahedra.vertices + 4 * (n / 4);
  const BallIndex second = t[face_corner(code, 1)], third = t[face_corner(code, 2)];
  TriangleRange range = of_ball[t[face_corner(code, 0)]];
  while (range.begin < range.end) {
    const std::uint32_t middle = range.begin + (range.end - range.begin) / 2;
    const BallIndex* v = triangles.vertices + 3 * std::size_t{middle};
    if (v[1] == second && v[2] == third) {
      if (triangles.classes[middle] == SimplexClass::regular) {
        owner[middle] = code;
      }
      return;
    }
    const bool before = v[1] < second || (v[1] == second && v[2] < third);
    (before ? range.begin : range.end) = before ? middle + 1 : middle;
  }
}

// 1 for each regular triangle, else 0; 0 after the last.
struct IsRegular {
  const SimplexClass* classes;
  std::uint32_t count;

  __device__ std::uint32_t operator()(std::uint32_t t) const {
    return t < count && classes[t] == SimplexClass::regular ? 1 : 0;
  }
};

// `places`: sums of IsRegular.
__global__ void gather_owners(DeviceSimplices triangles, const std::uint32_t* places,
                              const FaceCode* owner, FaceCode* outside) {
  const std::size_t t = thread_number();
  if (t >= triangles.count || triangles.classes[t] != SimplexClass::regular) return;
  outside[places[t]] = owner[t];
}

}  // namespace alphascope::gpu
