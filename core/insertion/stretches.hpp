// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers from 0, shared out among threads: each has a stretch of its own, far from the others, and
// helps another one when it is done.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace alphascope {

class Stretches {
 public:
  struct Range {
    std::uint32_t begin, end;
    bool empty() const { return begin == end; }
  };

  Stretches(std::size_t count, std::size_t stretches) : left_(stretches) {
    for (std::size_t s = 0; s < stretches; ++s) {
      const std::size_t begin = s * count / stretches, end = (s + 1) * count / stretches;
      left_[s].range = packed({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)});
    }
  }

  Range left(std::size_t stretch) const { return unpacked(left_[stretch].range.load()); }
  // At most `most` numbers, which nobody else takes: the first of the own stretch, or the last of
  // the one with most left. Empty when all are taken.
  Range take(std::size_t own, std::uint32_t most) {
    if (const Range range = take_from(own, most, true); !range.empty()) return range;
    while (true) {
      std::size_t longest = own;
      for (std::size_t s = 0; s < left_.size(); ++s) {
        if (length(left(s)) > length(left(longest))) longest = s;
      }
      if (left(longest).empty()) return {0, 0};
      if (const Range range = take_from(longest, most, false); !range.empty()) return range;
    }
  }

 private:
  // Begin and end in one number. Aligned, so that threads do not write to one cache line.
  struct alignas(64) Stretch {
    std::atomic<std::uint64_t> range{0};
  };
  static std::uint64_t packed(Range r) { return std::uint64_t{r.begin} << 32 | r.end; }
  static Range unpacked(std::uint64_t range) {
    return {static_cast<std::uint32_t>(range >> 32), static_cast<std::uint32_t>(range)};
  }
  static std::uint32_t length(Range r) { return r.end - r.begin; }

  Range take_from(std::size_t stretch, std::uint32_t most, bool first) {
    std::atomic<std::uint64_t>& range = left_[stretch].range;
    std::uint64_t before = range.load();
    while (true) {
      const Range all = unpacked(before);
      const std::uint32_t count = std::min(most, length(all));
      const Range taken =
          first ? Range{all.begin, all.begin + count} : Range{all.end - count, all.end};
      const Range rest = first ? Range{taken.end, all.end} : Range{all.begin, taken.begin};
      if (range.compare_exchange_weak(before, packed(rest))) return taken;
    }
  }

  std::vector<Stretch> left_;
};

}  // namespace alphascope
