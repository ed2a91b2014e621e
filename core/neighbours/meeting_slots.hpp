// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the grown balls that may meet one grown ball, by vector instructions of the processor at
// hand. The results are those of grown_balls_may_meet() (core/predicates/grown_balls.hpp), bit by
// bit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace alphascope {

// The arrays of the balls, one element a slot. Centres in lattice units; reach as grown_reach().
struct BallColumns {
  const std::int32_t *x, *y, *z;
  const float* reach;
};

// The ball whose neighbours are searched.
struct GrownBall {
  std::int32_t x, y, z;
  float reach;
};

// Vectors are read and written whole. All arrays that these functions read are longer by this many
// elements, and so is `slots` of find_meeting().
constexpr std::size_t kVectorRoom = 16;

// Slots `begin` to `end` - 1.
struct SlotRange {
  std::uint32_t begin, end;
};

// Writes the slots of the ranges whose balls may meet `ball`, in the order of the ranges, without
// the slot `self`. Returns their number. `slots` has room for all slots of the ranges
// and kVectorRoom more.
std::size_t find_meeting(const BallColumns& columns, std::span<const SlotRange> ranges,
                         const GrownBall& ball, std::uint32_t self, std::uint32_t* slots);

// Sets bit k of `bits` if ball k may meet `ball`, for k < count, and clears the other bits of the
// (count + 31) / 32 words.
void mark_meeting(const BallColumns& columns, std::size_t count, const GrownBall& ball,
                  std::uint32_t* bits);

// Sorts slots by their keys, which differ. The keys are longer by kVectorRoom. `sorted` has room
// for keys.size() slots.
void sort_by_key(std::span<const std::uint32_t> keys, const std::uint32_t* slots,
                 std::uint32_t* sorted);

}  // namespace alphascope
