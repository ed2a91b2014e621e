// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the hash of a complex and the bytes that it holds.
#include "core/complex/alpha_complex.hpp"

#include <cstdio>

#include "core/complex/simplex_hash.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

// One thread is as fast as all for fewer simplices than this.
constexpr std::size_t kManySimplices = 1 << 15;

template <int N>
void add(const SimplexList<N>& list, HashSums& sums) {
  const auto sum = [&](std::size_t begin, std::size_t end) {
    std::uint64_t all = 0;
    for (std::size_t s = begin; s < end; ++s) all += simplex_hash<N>(list.simplices[s].data());
    return all;
  };
  sums.count[N - 1] = list.size();
  if (list.size() < kManySimplices) {
    sums.sum[N - 1] = sum(0, list.size());
    return;
  }
  sums.sum[N - 1] = parallel_sum(0, list.size(), kManySimplices, sum);
}

template <int N>
std::uint64_t bytes(const SimplexList<N>& list) {
  return list.simplices.capacity() * sizeof(list.simplices[0]) +
         list.alpha_values.capacity() * sizeof(float) +
         list.classes.capacity() * sizeof(SimplexClass);
}

}  // namespace

std::uint64_t bytes_of(const AlphaComplex& complex) {
  return bytes(complex.vertices) + bytes(complex.edges) + bytes(complex.triangles) +
         bytes(complex.tetrahedra) + (complex.outside ? complex.outside->faces.size_bytes() : 0);
}

std::uint64_t tetrahedra_hash(const AlphaComplex& complex) {
  HashSums sums;
  add(complex.tetrahedra, sums);
  return sums.combined(true);
}

std::uint64_t complex_hash(const AlphaComplex& complex) {
  if (complex.tetrahedra_only) return tetrahedra_hash(complex);
  HashSums sums;
  add(complex.vertices, sums);
  add(complex.edges, sums);
  add(complex.triangles, sums);
  add(complex.tetrahedra, sums);
  return sums.combined(false);
}

std::string hash_text(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace alphascope
