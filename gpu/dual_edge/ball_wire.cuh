// SPDX-License-Identifier: GPL-3.0-or-later
// The packed form of balls for the copy to the device, without loss. The bus limits the copy, so a
// smaller form is faster. A group is 32 consecutive balls, which are close together in a molecule.
// It has its own lowest corner and its own widths of x, y and z above it. Radii are indices into a
// table. All is in one piece of memory, in words of 32 bits:
//
//   heads   4 words per group: lowest x, y, z; the widths, 6 bits each, and in the upper 14 the
//           offset of its records, in words after the start of its 128 groups
//   starts  1 word per 128 groups: where their records begin
//   radii   in the order in which they first occur
//   records of a group's balls one after the other, all of one width, x lowest, then y, z and the
//           index of the radius; 32 of b bits are b words, so every group begins with a whole one
//   two words that are read but not used
//
// A ball of a molecule takes 5.8 to 6.1 bytes on a lattice of 10^-3 Å, of which the heads are half
// a byte. On a lattice of 10^-4 Å it takes 7.2 bytes. Sets that would take 16 or more are sent
// unpacked.
#pragma once

#include <cuda_runtime.h>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/geometry/ball_set.hpp"

namespace alphascope::gpu {

// Number of balls in a group, and in the groups that share a start.
inline constexpr std::uint32_t kWireGroup = 32;
inline constexpr std::uint32_t kWireStart = 128 * kWireGroup;

// The last word of a group's head.
struct GroupShape {
  std::uint32_t x, y, z;  // widths, bits
  std::uint32_t begin;    // offset of its records, in words after the start of its 128 groups

  static __host__ __device__ GroupShape of(std::uint32_t word) {
    return {word & 63, word >> 6 & 63, word >> 12 & 63, word >> 18};
  }
  std::uint32_t word() const { return x | y << 6 | z << 12 | begin << 18; }
};

struct WireLayout {
  std::uint32_t starts = 0, radii = 0;  // offsets in words; the heads come first
  std::uint32_t radius_width = 0;       // bits
  std::size_t words = 0;                // total number
};

// Balls in packed form on the device.
struct PackedBalls {
  const std::uint32_t* data;  // aligned to 16 bytes; null: the balls came unpacked
  WireLayout layout;

  __host__ __device__ int4 operator[](std::uint32_t i) const {
    const uint4 head = reinterpret_cast<const uint4*>(data)[i / kWireGroup];
    const GroupShape shape = GroupShape::of(head.w);
    const std::uint32_t records = data[layout.starts + i / kWireStart] + shape.begin;
    const std::uint32_t y = shape.x, z = y + shape.y, radius = z + shape.z;
    const std::uint32_t at = i % kWireGroup * (radius + layout.radius_width);
    const std::uint32_t number = bits(records, at + radius, layout.radius_width);
    return make_int4(static_cast<int>(head.x + bits(records, at, shape.x)),
                     static_cast<int>(head.y + bits(records, at + y, shape.y)),
                     static_cast<int>(head.z + bits(records, at + z, shape.z)),
                     static_cast<int>(data[layout.radii + number]));
  }

 private:
  // Reads up to 32 bits from two words, both of which always exist.
  __host__ __device__ std::uint32_t bits(std::uint32_t records, std::uint32_t at,
                                         std::uint32_t width) const {
    const std::uint32_t* word = data + (records + at / 32);
    const std::uint64_t two = std::uint64_t{word[1]} << 32 | word[0];
    return static_cast<std::uint32_t>((two >> at % 32) & ~(~std::uint64_t{0} << width));
  }
};

// A set's balls as the device needs them: x, y, z and radius. A hidden ball has radius -1.
struct ShownBalls {
  const BallSet& set;
  const std::vector<bool>& hidden;  // empty: no ball is hidden

  int4 operator[](BallIndex i) const {
    const LatticePoint& c = set.centres[i];
    return make_int4(c.x, c.y, c.z, !hidden.empty() && hidden[i] ? -1 : set.radii[i]);
  }
};

// The different radii of a set, in the order of their first occurrence.
class RadiusTable {
 public:
  std::uint32_t number_of(std::int32_t radius);
  const std::vector<std::int32_t>& radii() const { return radii_; }

 private:
  struct Recent {
    std::int32_t radius;
    std::uint32_t number_and_one;  // 0: unused
  };
  // Cache by a radius' lowest bits, because a molecule has few radii.
  std::array<Recent, 64> recent_{};
  std::unordered_map<std::int32_t, std::uint32_t> numbers_;
  std::vector<std::int32_t> radii_;
};

// Packs the balls of a set. The set must outlive it.
class BallPacker {
 public:
  explicit BallPacker(const ShownBalls& balls);
  // Returns whether there is a packed form that is smaller than the unpacked balls.
  bool pays() const;
  const WireLayout& layout() const { return layout_; }
  void pack(std::uint32_t* to) const;  // writes layout().words words, which must not be 0

 private:
  bool number_radii();
  void lay_out();
  void place_records(std::size_t at);
  std::uint32_t group_end(std::uint32_t group) const;
  uint4 head_of(std::uint32_t group) const;
  void pack_group(std::uint32_t group, std::uint32_t* to) const;

  ShownBalls balls_;
  RadiusTable table_;
  std::vector<std::uint16_t> radius_numbers_;
  std::vector<uint4> heads_;
  std::vector<std::uint32_t> starts_;
  WireLayout layout_;
};

}  // namespace alphascope::gpu
