// SPDX-License-Identifier: GPL-3.0-or-later
// Walking along a polyline by given distances.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/real_point.hpp"

namespace alphascope {

// A position on a polyline of at least one place. The polyline must outlive it.
class Walk {
 public:
  explicit Walk(const std::vector<RealPoint>& line) : corners_(&line) { advance(0); }
  bool at_end() const { return segment_ + 1 >= corners_->size(); }
  RealPoint place() const {
    if (at_end()) return corners_->back();
    const RealPoint along = corner(1) - corner(0);
    return corner(0) + (passed_ / length(along)) * along;
  }
  // Unit vector. Must not be called at the end.
  RealPoint direction() const { return unit_vector(corner(1) - corner(0)); }
  // Its length is not 0, and the place is before its end.
  std::size_t segment() const { return segment_; }
  void advance(double distance) {
    passed_ += distance;
    while (!at_end()) {
      const double size = length(corner(1) - corner(0));
      if (passed_ < size) return;
      passed_ -= size;
      ++segment_;
    }
  }
  void advance_to_corner() {
    passed_ = 0;
    ++segment_;
    advance(0);
  }

 private:
  const RealPoint& corner(std::size_t next) const { return (*corners_)[segment_ + next]; }

  const std::vector<RealPoint>* corners_;
  std::size_t segment_ = 0;
  double passed_ = 0;  // Å walked on this segment
};

}  // namespace alphascope
