// SPDX-License-Identifier: GPL-3.0-or-later
// Builds a channel's tube: a circle of corners around each sample, joined by triangles.
#include "core/channel/channel_tube.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace alphascope {
namespace {

constexpr std::uint32_t kCorners = 32;  // of each circle

class Tube {
 public:
  explicit Tube(const Channel& channel) : samples_(channel.samples) {}

  ChannelTube run() {
    for (std::size_t n = 0; n < samples_.size(); ++n) {
      const std::size_t first = n;
      while (n < samples_.size() && samples_[n].radius_angstrom > 0) ++n;
      if (n - first > 1) add_piece(first, n);
    }
    return std::move(tube_);
  }

 private:
  // Adds the samples from `first` on, before `end`.
  void add_piece(std::size_t first, std::size_t end) {
    corner_ = {};
    for (std::size_t n = first; n < end; ++n) {
      const RealPoint& before = samples_[n > first ? n - 1 : n].position_angstrom;
      const RealPoint& behind = samples_[n + 1 < end ? n + 1 : n].position_angstrom;
      const RealPoint along = unit_vector(behind - before);
      // The last circle's first corner is projected into the new circle's plane, so that the tube
      // does not twist.
      corner_ = unit_vector(corner_ - dot(corner_, along) * along);
      RealPoint other;
      if (corner_ == RealPoint{}) normals_of(along, corner_, other);
      add_circle(samples_[n], along);
      if (n > first) join();
      if (n == first) close(samples_[n], false);
    }
    close(samples_[end - 1], true);
  }

  void add_point(const ChannelSample& sample, const RealPoint& from_centre) {
    tube_.points.push_back(sample.position_angstrom + from_centre);
    tube_.radii_angstrom.push_back(sample.radius_angstrom);
  }

  void add_circle(const ChannelSample& sample, const RealPoint& along) {
    const RealPoint other = cross(along, corner_);
    before_ = std::exchange(last_, static_cast<std::uint32_t>(tube_.points.size()));
    for (std::uint32_t k = 0; k < kCorners; ++k) {
      const double angle = 2 * std::numbers::pi * k / kCorners, r = sample.radius_angstrom;
      add_point(sample, r * std::cos(angle) * corner_ + r * std::sin(angle) * other);
    }
  }

  // Joins the last circle to the one before.
  void join() {
    for (std::uint32_t k = 0; k < kCorners; ++k) {
      const std::uint32_t next = (k + 1) % kCorners;
      tube_.triangles.push_back({before_ + k, before_ + next, last_ + next});
      tube_.triangles.push_back({before_ + k, last_ + next, last_ + k});
    }
  }

  // Closes the last circle with a fan around its centre. The fan faces along the line if `goes`,
  // else against it.
  void close(const ChannelSample& sample, bool goes) {
    const auto centre = static_cast<std::uint32_t>(tube_.points.size());
    add_point(sample, {});
    for (std::uint32_t k = 0; k < kCorners; ++k) {
      const std::uint32_t a = last_ + k, b = last_ + (k + 1) % kCorners;
      tube_.triangles.push_back({centre, goes ? a : b, goes ? b : a});
    }
  }

  const std::vector<ChannelSample>& samples_;
  ChannelTube tube_;
  RealPoint corner_;  // unit vector from the last centre to its circle's first corner
  std::uint32_t before_ = 0, last_ = 0;  // first points of the last two circles
};

}  // namespace

ChannelTube channel_tube(const Channel& channel) {
  return Tube(channel).run();
}

}  // namespace alphascope
