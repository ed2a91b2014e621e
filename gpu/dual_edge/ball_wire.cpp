// SPDX-License-Identifier: GPL-3.0-or-later
// Packs balls for the copy to the device.
#include "gpu/dual_edge/ball_wire.cuh"

#include <algorithm>
#include <bit>

#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/run/parallel.hpp"

namespace alphascope::gpu {
namespace {

// Sets of radii have a few values. A long table would cost the device more time than it saves.
constexpr std::size_t kMostRadii = 4096;

// Words after the last record, because a field of width 0 may begin at its end.
constexpr std::size_t kPaddingWords = 2;

class BitWriter {
 public:
  explicit BitWriter(std::uint32_t* to) : to_(to) {}
  // Appends `width` bits, at most 32. The value must have no other bits.
  void put(std::uint32_t value, std::uint32_t width) {
    held_ |= std::uint64_t{value} << count_;
    count_ += width;
    if (count_ >= 32) write();
  }
  void finish() {
    if (count_ > 0) write();
  }

 private:
  void write() {
    *to_++ = static_cast<std::uint32_t>(held_);
    held_ >>= 32;
    count_ -= 32;
  }
  std::uint32_t* to_;
  std::uint64_t held_ = 0;
  std::uint32_t count_ = 0;  // number of held bits, below 32 between calls
};

std::uint32_t width_of(std::uint32_t most) {
  return static_cast<std::uint32_t>(std::bit_width(most));
}

}  // namespace

std::uint32_t RadiusTable::number_of(std::int32_t radius) {
  Recent& recent = recent_[static_cast<std::uint32_t>(radius) % recent_.size()];
  if (recent.number_and_one == 0 || recent.radius != radius) {
    const auto next = static_cast<std::uint32_t>(radii_.size());
    const auto [found, is_new] = numbers_.try_emplace(radius, next);
    if (is_new) radii_.push_back(radius);
    recent = {radius, found->second + 1};
  }
  return recent.number_and_one - 1;
}

BallPacker::BallPacker(const ShownBalls& balls) : balls_(balls) {
  if (number_radii()) lay_out();
}

bool BallPacker::pays() const {
  // Offsets are 32-bit numbers, so the packed form must be that short.
  return layout_.words > 0 && layout_.words < 4 * balls_.set.size() && layout_.words >> 32 == 0;
}

bool BallPacker::number_radii() {
  radius_numbers_.resize(balls_.set.size());
  for (BallIndex i = 0; i < radius_numbers_.size(); ++i) {
    radius_numbers_[i] = static_cast<std::uint16_t>(table_.number_of(balls_[i].w));
    if (table_.radii().size() > kMostRadii) return false;
  }
  return true;
}

void BallPacker::lay_out() {
  const std::size_t n = balls_.set.size(), radii = table_.radii().size();
  heads_.resize((n + kWireGroup - 1) / kWireGroup);
  starts_.resize((n + kWireStart - 1) / kWireStart);
  layout_.starts = static_cast<std::uint32_t>(4 * heads_.size());
  layout_.radii = layout_.starts + static_cast<std::uint32_t>(starts_.size());
  layout_.radius_width = radii == 0 ? 0 : width_of(static_cast<std::uint32_t>(radii - 1));
  parallel_each(0, heads_.size(),
                [&](std::size_t g) { heads_[g] = head_of(static_cast<std::uint32_t>(g)); });
  place_records(layout_.radii + radii);
}

void BallPacker::place_records(std::size_t at) {
  for (std::uint32_t g = 0; g < heads_.size(); ++g) {
    std::uint32_t& start = starts_[g * kWireGroup / kWireStart];
    if (g * kWireGroup % kWireStart == 0) start = static_cast<std::uint32_t>(at);
    GroupShape shape = GroupShape::of(heads_[g].w);
    shape.begin = static_cast<std::uint32_t>(at) - start;
    heads_[g].w = shape.word();
    const std::size_t width = shape.x + shape.y + shape.z + layout_.radius_width;
    at += ((group_end(g) - g * kWireGroup) * width + 31) / 32;
  }
  layout_.words = at + kPaddingWords;
}

std::uint32_t BallPacker::group_end(std::uint32_t group) const {
  return static_cast<std::uint32_t>(
      std::min(balls_.set.size(), (std::size_t{group} + 1) * kWireGroup));
}

// The head has lowest corner and widths. place_records() adds the offset of the records.
uint4 BallPacker::head_of(std::uint32_t group) const {
  const std::uint32_t begin = group * kWireGroup;
  LatticePoint low = balls_.set.centres[begin], high = low;
  for (BallIndex i = begin + 1; i < group_end(group); ++i) {
    const LatticePoint& c = balls_.set.centres[i];
    low = {std::min(low.x, c.x), std::min(low.y, c.y), std::min(low.z, c.z)};
    high = {std::max(high.x, c.x), std::max(high.y, c.y), std::max(high.z, c.z)};
  }
  uint4 head = make_uint4(static_cast<std::uint32_t>(low.x), static_cast<std::uint32_t>(low.y),
                          static_cast<std::uint32_t>(low.z), 0);
  head.w = GroupShape{width_of(static_cast<std::uint32_t>(high.x) - head.x),
                      width_of(static_cast<std::uint32_t>(high.y) - head.y),
                      width_of(static_cast<std::uint32_t>(high.z) - head.z), 0}
               .word();
  return head;
}

void BallPacker::pack(std::uint32_t* to) const {
  std::copy(heads_.begin(), heads_.end(), reinterpret_cast<uint4*>(to));
  std::copy(starts_.begin(), starts_.end(), to + layout_.starts);
  std::copy(table_.radii().begin(), table_.radii().end(), to + layout_.radii);
  parallel_each(0, heads_.size(),
                [&](std::size_t g) { pack_group(static_cast<std::uint32_t>(g), to); });
  std::fill_n(to + layout_.words - kPaddingWords, kPaddingWords, 0u);
}

void BallPacker::pack_group(std::uint32_t group, std::uint32_t* to) const {
  const uint4 head = heads_[group];
  const GroupShape shape = GroupShape::of(head.w);
  const std::uint32_t begin = group * kWireGroup;
  BitWriter writer(to + starts_[begin / kWireStart] + shape.begin);
  for (BallIndex i = begin; i < group_end(group); ++i) {
    const LatticePoint& c = balls_.set.centres[i];
    writer.put(static_cast<std::uint32_t>(c.x) - head.x, shape.x);
    writer.put(static_cast<std::uint32_t>(c.y) - head.y, shape.y);
    writer.put(static_cast<std::uint32_t>(c.z) - head.z, shape.z);
    writer.put(radius_numbers_[i], layout_.radius_width);
  }
  writer.finish();
}

}  // namespace alphascope::gpu
