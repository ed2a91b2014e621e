// Going along a polyline.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/real_point.hpp"

namespace alphascope {

// A place on a polyline, which must live longer and have a place.
class Walk {
 public:
  explicit Walk(const std::vector<RealPoint>& line) : corners_(&line) { advance(0); }
  bool at_end() const { return segment_ + 1 >= corners_->size(); }
  RealPoint place() const {
    if (at_end()) return corners_->back();
    const RealPoint along = corner(1) - corner(0);
    return corner(0) + (passed_ / length(along)) * along;
  }
  // Unit vector; not at the end.
  RealPoint direction() const { return unit_vector(corner(1) - corner(0)); }
  std::size_t segment() const { return segment_; }  // it has a length, and the place is not its end
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
  double passed_ = 0;  // of this segment
};

}  // namespace alphascope
