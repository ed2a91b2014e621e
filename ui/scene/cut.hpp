// The clip as the scene needs it: half-spaces around the origin of its coordinates, for drawing and
// for picking. No VTK.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "core/document/settings/clip.hpp"
#include "ui/scene/pick/box_tree.hpp"

namespace alphascope {

// A stretch of a ray, in lengths of its direction.
struct Stretch {
  double from = 0, to = std::numeric_limits<double>::infinity();
  bool empty() const { return !(from <= to); }
  bool has(double depth) const { return depth >= from && depth <= to; }
};

// What a picture keeps: what is in all half-spaces. Everything, when there is none.
struct Cut {
  std::vector<HalfSpace> kept;  // at most two; Å, relative to BallGeometry::origin

  Cut() = default;
  Cut(const Clip& clip, const std::array<double, 3>& origin) : kept(kept_by(clip)) {
    for (HalfSpace& space : kept) space.offset = space.depth(origin);
  }

  bool on() const { return !kept.empty(); }
  template <class Point>
  bool keeps(const Point& x) const {
    return std::all_of(kept.begin(), kept.end(),
                       [&x](const HalfSpace& space) { return space.depth(x) >= 0; });
  }
  // Where a ray is in what is kept.
  Stretch along(const Ray& ray) const {
    Stretch stretch;
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

// Caps of balls lie before the plane by a little that grows with how deep in the ball they are, so
// that of caps in one plane the one shows whose ball has the least power distance: the cut shows
// the power cells. Å for each Å² of power, and at least; picking does the same.
inline constexpr double kCapLift = 0.002, kLeastCapLift = 0.002;

}  // namespace alphascope
