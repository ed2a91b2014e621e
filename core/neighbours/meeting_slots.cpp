// SPDX-License-Identifier: GPL-3.0-or-later
// The loops over balls, compiled once for each kind of processor (Highway).
#include "core/neighbours/meeting_slots.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/neighbours/meeting_slots.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace alphascope::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<std::int32_t, kVectorRoom> kInts;
constexpr hn::RebindToFloat<decltype(kInts)> kFloats;
constexpr hn::RebindToUnsigned<decltype(kInts)> kSlots;
using Ints = hn::Vec<decltype(kInts)>;
using Slots = hn::Vec<decltype(kSlots)>;
using Floats = hn::Vec<decltype(kFloats)>;

// One ball against a vector of balls. The operations and their order are those of
// grown_balls_may_meet(), and none is fused.
class Meeting {
 public:
  HWY_ATTR explicit Meeting(const GrownBall& ball)
      : x_(hn::Set(kInts, ball.x)),
        y_(hn::Set(kInts, ball.y)),
        z_(hn::Set(kInts, ball.z)),
        reach_(hn::Set(kFloats, ball.reach)) {}

  HWY_ATTR hn::Mask<decltype(kFloats)> with(const BallColumns& columns, std::size_t at) const {
    const auto difference = [](const std::int32_t* from, Ints own) HWY_ATTR {
      return hn::ConvertTo(kFloats, hn::Sub(hn::LoadU(kInts, from), own));
    };
    const Floats x = difference(columns.x + at, x_), y = difference(columns.y + at, y_),
                 z = difference(columns.z + at, z_);
    const Floats sum = hn::Add(reach_, hn::LoadU(kFloats, columns.reach + at));
    const Floats square = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
    return hn::Le(square, hn::Mul(sum, sum));
  }

 private:
  Ints x_, y_, z_;
  Floats reach_;
};

HWY_ATTR std::size_t find(const BallColumns& columns, const SlotRange* ranges, std::size_t count,
                          const GrownBall& ball, std::uint32_t self, std::uint32_t* slots) {
  const std::size_t lanes = hn::Lanes(kInts);
  const Meeting meeting(ball);
  const Slots numbers = hn::Iota(kSlots, 0), own = hn::Set(kSlots, self);
  std::uint32_t* to = slots;
  for (std::size_t r = 0; r < count; ++r) {
    const std::size_t end = ranges[r].end;
    for (std::size_t at = ranges[r].begin; at < end; at += lanes) {
      const Slots slot = hn::Add(numbers, hn::Set(kSlots, static_cast<std::uint32_t>(at)));
      const auto others = hn::And(hn::Ne(slot, own), hn::FirstN(kSlots, end - at));
      const auto takes = hn::And(others, hn::RebindMask(kSlots, meeting.with(columns, at)));
      hn::StoreU(hn::Compress(slot, takes), kSlots, to);
      to += hn::CountTrue(kSlots, takes);
    }
  }
  return static_cast<std::size_t>(to - slots);
}

HWY_ATTR void mark(const BallColumns& columns, std::size_t count, const GrownBall& ball,
                   std::uint32_t* bits) {
  constexpr std::size_t kBits = 32;
  const std::size_t lanes = hn::Lanes(kInts);
  const Meeting meeting(ball);
  for (std::size_t word = 0; word < count; word += kBits) {
    std::uint32_t all = 0;
    for (std::size_t bit = 0; bit < kBits && word + bit < count; bit += lanes) {
      std::uint8_t some[8] = {};
      hn::StoreMaskBits(kFloats, meeting.with(columns, word + bit), some);
      all |= (std::uint32_t{some[0]} | std::uint32_t{some[1]} << 8) << bit;
    }
    const std::size_t left = count - word;
    bits[word / kBits] = left < kBits ? all & ((std::uint32_t{1} << left) - 1) : all;
  }
}

// Counts for each key how many are less, which is its place.
HWY_ATTR void place(const std::uint32_t* keys, std::size_t count, const std::uint32_t* slots,
                    std::uint32_t* sorted) {
  const std::size_t lanes = hn::Lanes(kSlots);
  for (std::size_t k = 0; k < count; ++k) {
    const auto key = hn::Set(kSlots, keys[k]);
    std::size_t less = 0;
    for (std::size_t at = 0; at < count; at += lanes) {
      auto is_less = hn::Lt(hn::LoadU(kSlots, keys + at), key);
      if (count - at < lanes) is_less = hn::And(is_less, hn::FirstN(kSlots, count - at));
      less += hn::CountTrue(kSlots, is_less);
    }
    sorted[less] = slots[k];
  }
}

}  // namespace
}  // namespace alphascope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace alphascope {

namespace {

void sort_many(std::span<const std::uint32_t> keys, const std::uint32_t* slots,
               std::uint32_t* sorted) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  // a key, and its slot
  pairs.reserve(keys.size());
  for (std::size_t n = 0; n < keys.size(); ++n) pairs.emplace_back(keys[n], slots[n]);
  std::sort(pairs.begin(), pairs.end());
  for (std::size_t n = 0; n < keys.size(); ++n) sorted[n] = pairs[n].second;
}

}  // namespace

HWY_EXPORT(find);
HWY_EXPORT(mark);
HWY_EXPORT(place);

std::size_t find_meeting(const BallColumns& columns, std::span<const SlotRange> ranges,
                         const GrownBall& ball, std::uint32_t self, std::uint32_t* slots) {
  return HWY_DYNAMIC_DISPATCH(find)(columns, ranges.data(), ranges.size(), ball, self, slots);
}

void mark_meeting(const BallColumns& columns, std::size_t count, const GrownBall& ball,
                  std::uint32_t* bits) {
  HWY_DYNAMIC_DISPATCH(mark)(columns, count, ball, bits);
}

void sort_by_key(std::span<const std::uint32_t> keys, const std::uint32_t* slots,
                 std::uint32_t* sorted) {
  // Counting takes time with the square of the number.
  constexpr std::size_t kMostCounted = 128;
  if (keys.size() > kMostCounted) return sort_many(keys, slots, sorted);
  HWY_DYNAMIC_DISPATCH(place)(keys.data(), keys.size(), slots, sorted);
}

}  // namespace alphascope
#endif
