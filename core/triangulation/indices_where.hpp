// SPDX-License-Identifier: GPL-3.0-or-later
// The indices of the chosen elements of a long list, in order, found by all threads.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/complex/count_limits.hpp"
#include "core/complex/simplices.hpp"
#include "core/run/cancel_token.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {

// Indices below `count` for which chosen(index) is true, ascending. `chosen` is called twice for
// each, from any thread. Throws Cancelled, and std::length_error for a count beyond 32 bits.
template <class Chosen>
ResultArray<std::uint32_t> indices_where(std::size_t count, const Chosen& chosen,
                                         const CancelToken& cancel = {}) {
  require_at_most(count, kMostIndices, "simplices");
  constexpr std::size_t kBlock = 16384;
  const std::size_t blocks = (count + kBlock - 1) / kBlock;
  std::vector<std::size_t> first(blocks + 1, 0);
  const auto each_in = [&](std::size_t block, const auto& body) {
    if (cancel.cancelled()) return;
    const std::size_t end = std::min(count, (block + 1) * kBlock);
    for (std::size_t i = block * kBlock; i < end; ++i) body(i);
  };
  parallel_each(0, blocks, [&](std::size_t block) {
    std::size_t found = 0;
    each_in(block, [&](std::size_t i) { found += chosen(i) ? 1 : 0; });
    first[block + 1] = found;
  });
  for (std::size_t block = 0; block < blocks; ++block) first[block + 1] += first[block];
  cancel.throw_if_cancelled();
  ResultArray<std::uint32_t> places(first.back());
  parallel_each(0, blocks, [&](std::size_t block) {
    // The loop has no branch: it writes every index, and the next one overwrites an index that is
    // not chosen.
    std::array<std::uint32_t, kBlock> found;
    std::size_t count_found = 0;
    each_in(block, [&](std::size_t i) {
      found[count_found] = static_cast<std::uint32_t>(i);
      count_found += chosen(i) ? 1 : 0;
    });
    std::copy_n(found.begin(), count_found, places.begin() + first[block]);
  });
  cancel.throw_if_cancelled();
  return places;
}

}  // namespace alphascope
