// SPDX-License-Identifier: GPL-3.0-or-later
// A list in groups, made by all threads. Within each group the order stays.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/complex/simplices.hpp"
#include "core/run/cancel_token.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {

struct Grouped {
  std::vector<std::size_t> first;  // of each group; one more at the end
  ResultArray<std::uint32_t> items;

  std::span<const std::uint32_t> of(std::size_t group) const {
    return {items.data() + first[group], first[group + 1] - first[group]};
  }
};

// Puts items[n] into group group_of(n), below `groups`. `group_of` is called twice for each, from
// any thread. Throws Cancelled.
template <class GroupOf>
Grouped grouped(std::span<const std::uint32_t> items, std::size_t groups, const GroupOf& group_of,
                const CancelToken& cancel = {}) {
  // Each block of items counts for itself, as long as this takes little memory.
  constexpr std::size_t kBlock = 4096, kMostCounts = std::size_t{1} << 22;
  const std::size_t wanted = (items.size() + kBlock - 1) / kBlock,
                    blocks = std::clamp<std::size_t>(kMostCounts / std::max<std::size_t>(groups, 1),
                                                     1, std::max<std::size_t>(wanted, 1)),
                    size = (items.size() + blocks - 1) / blocks;
  const auto each_in = [&](std::size_t block, const auto& body) {
    if (cancel.cancelled()) return;
    const std::size_t end = std::min(items.size(), (block + 1) * size);
    for (std::size_t n = block * size; n < end; ++n) body(n);
  };
  std::vector<std::uint32_t> count(blocks * groups, 0);
  parallel_each(0, blocks, [&](std::size_t block) {
    each_in(block, [&](std::size_t n) { ++count[block * groups + group_of(n)]; });
  });
  cancel.throw_if_cancelled();
  Grouped result;
  result.first.reserve(groups + 1);
  std::size_t sum = 0;
  for (std::size_t g = 0; g < groups; ++g) {
    result.first.push_back(sum);
    for (std::size_t block = 0; block < blocks; ++block) {
      std::uint32_t& own = count[block * groups + g];
      const std::uint32_t counted = own;
      own = static_cast<std::uint32_t>(sum);  // now its place
      sum += counted;
    }
  }
  result.first.push_back(sum);
  result.items.resize(items.size());
  parallel_each(0, blocks, [&](std::size_t block) {
    each_in(block,
            [&](std::size_t n) { result.items[count[block * groups + group_of(n)]++] = items[n]; });
  });
  cancel.throw_if_cancelled();
  return result;
}

}  // namespace alphascope
