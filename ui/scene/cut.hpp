// SPDX-License-Identifier: GPL-3.0-or-later
// The clip as half-spaces relative to BallGeometry::origin, for drawing and for picking. No VTK.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "core/document/settings/clip.hpp"
#include "ui/scene/pick/box_tree.hpp"

namespace alphascope {

// An interval of a ray, in lengths of its direction.
struct RayInterval {
  double from = 0, to = std::numeric_limits<double>::infinity();
  bool empty() const { return !(from <= to); }
  bool has(double depth) const { return depth >= from && depth <= to; }
};

// The clip keeps the intersection of its half-spaces. Without half-spaces it keeps everything.
struct Cut {
  std::vector<HalfSpace> kept;  // at most two; Å, relative to BallGeometry::origin

  Cut() = default;
  Cut(const Clip& clip, const std::array<double, 3>& origin) : kept(kept_half_spaces(clip)) {
    for (HalfSpace& space : kept) space.offset = space.depth(origin);
  }

  bool on() const { return !kept.empty(); }
  template <class Point>
  bool keeps(const Point& x) const {
    return std::all_of(kept.begin(), kept.end(),
                       [&x](const HalfSpace& space) { return space.depth(x) >= 0; });
  }
  // The interval in which a ray is inside all half-spaces.
  RayInterval along(const Ray& ray) const {
    RayInterval stretch;
    for (const HalfSpace& space : kept) {
      const double at = space.depth(ray.start);
      const double by = space.depth(ray.direction) - space.offset;
      if (by > 0) {
        stretch.from = std::max(stretch.from, -at / by);
      } else if (by < 0) {
        stretch.to = std::min(stretch.to, at / -by);
      } else if (at < 0) {
        stretch.to = -1;
      }
    }
    return stretch;
  }
  friend bool operator==(const Cut&, const Cut&) = default;
};

// Each cap of a ball is drawn a little in front of the cutting plane. The shift is kLeastCapLift Å
// and kCapLift Å more for each Å² of power at that point. So where caps overlap, the ball with the
// least power distance shows, and the cut shows power cells. Picking uses the same shift.
inline constexpr double kCapLift = 0.002, kLeastCapLift = 0.002;

}  // namespace alphascope
