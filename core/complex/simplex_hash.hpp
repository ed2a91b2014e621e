// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of complex_hash(), for host and device: a sum over the simplices of each dimension,
// which does not depend on their order.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/geometry/host_device.hpp"

namespace alphascope {

// Finaliser of splitmix64 (Steele, Lea, Flood, OOPSLA 2014): a bijection that mixes all bits.
ALPHASCOPE_INLINE std::uint64_t mix_bits(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// The term of one simplex.
template <int N>
ALPHASCOPE_INLINE std::uint64_t simplex_hash(const std::uint32_t* vertices) {
  std::uint64_t h = N;
  for (int v = 0; v < N; ++v) h = mix_bits(h ^ vertices[v]);
  return h;
}

// The sum of the terms and the number of simplices, for each dimension 0 to 3.
struct HashSums {
  std::uint64_t sum[4] = {0, 0, 0, 0};
  std::size_t count[4] = {0, 0, 0, 0};

  // The hash of the whole complex, or of its tetrahedra alone.
  std::uint64_t combined(bool tetrahedra_only) const {
    const auto set = [&](int dimension) { return mix_bits(sum[dimension] ^ count[dimension]); };
    std::uint64_t h = set(3);
    for (int d = 2; d >= 0 && !tetrahedra_only; --d) h = mix_bits(h ^ set(d));
    return h;
  }
};

}  // namespace alphascope
