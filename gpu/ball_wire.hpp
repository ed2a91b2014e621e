// Balls on their way to the device: of a million, the copy is a sixth of a small alpha's time. Most
// sets go in 8 bytes a ball instead of 16: coordinates from the lowest corner, in as many bits as
// their extent takes, and the number of the radius among those that occur. Nothing is lost; sets
// that need more bits go as they are.
#pragma once

#include <cuda_runtime.h>

#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace alphascope::gpu {

// How the 64 bits of a ball are made up: x lowest, then y, z and the radius.
struct BallPacking {
  int4 low;          // w unused
  int y, z, radius;  // where their bits begin

  __host__ __device__ std::uint64_t pack(const int4& ball, std::uint32_t radius_number) const {
    return from_low(ball.x, low.x) | from_low(ball.y, low.y) << y | from_low(ball.z, low.z) << z |
           std::uint64_t{radius_number} << radius;
  }
  __host__ __device__ int4 unpack(std::uint64_t word, const std::int32_t* radii) const {
    const auto part = [&](int begin, int end) {
      return static_cast<std::uint32_t>((word >> begin) &
                                        ((std::uint64_t{1} << (end - begin)) - 1));
    };
    return make_int4(at(low.x, part(0, y)), at(low.y, part(y, z)), at(low.z, part(z, radius)),
                     radii[word >> radius]);
  }

 private:
  static __host__ __device__ std::uint64_t from_low(std::int32_t value, std::int32_t lowest) {
    return static_cast<std::uint32_t>(value) - static_cast<std::uint32_t>(lowest);
  }
  static __host__ __device__ std::int32_t at(std::int32_t lowest, std::uint32_t offset) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(lowest) + offset);
  }
};

// The radii that occur, in the order in which they first do.
class RadiusTable {
 public:
  std::uint32_t number_of(std::int32_t radius) {
    if (!radii.empty() && radii[last_] == radius) return last_;
    const auto [found, is_new] =
        numbers_.try_emplace(radius, static_cast<std::uint32_t>(radii.size()));
    if (is_new) radii.push_back(radius);
    return last_ = found->second;
  }
  std::vector<std::int32_t> radii;

 private:
  std::unordered_map<std::int32_t, std::uint32_t> numbers_;
  std::uint32_t last_ = 0;
};

// Nothing where 64 bits do not suffice, or the table would be long.
inline std::optional<BallPacking> choose_packing(const int4& low, const int4& high,
                                                 std::size_t radii) {
  const auto bits = [](std::int32_t from, std::int32_t to) {
    return std::bit_width(static_cast<std::uint32_t>(to) - static_cast<std::uint32_t>(from));
  };
  BallPacking packing{low, static_cast<int>(bits(low.x, high.x)), 0, 0};
  packing.z = packing.y + static_cast<int>(bits(low.y, high.y));
  packing.radius = packing.z + static_cast<int>(bits(low.z, high.z));
  constexpr std::size_t kMostRadii = 4096;
  // One bit is left, so that no shift is by all 64.
  if (radii > kMostRadii || packing.radius + std::bit_width(radii) > 63) return std::nullopt;
  return packing;
}

}  // namespace alphascope::gpu
