// SPDX-License-Identifier: GPL-3.0-or-later
// Ascends in a plane to a local maximum of clearance, by small linear programs.
#include "core/clearance/plane_ascent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace alphascope {
namespace {

// Only this many of the nearest surfaces within reach of a step are used. More are that near only
// where many are equally far. There the step shrinks until they no longer are.
constexpr std::size_t kMostSurfaces = 14;

// A lower bound of a surface's distance near a point of the plane: value + (gx, gy)·step. It holds
// because distances from points are convex.
struct Slope {
  double value, gx, gy;
  double at(double x, double y) const { return value + gx * x + gy * y; }
};

struct Step {
  double x = 0, y = 0, value = 0;
};

// Finds the step of at most `longest` that maximises the least of all slopes. The maximum is
// limited by one slope and the length, by two slopes and the length, or by three slopes. Most
// slopes limit nothing. So the step is found for few of them, and the one that is least at its end
// is added, until that one is among them.
class BestStep {
 public:
  BestStep(const std::vector<Slope>& slopes, double longest) : slopes_(slopes), longest_(longest) {}
  Step find() {
    const Step none{0, 0, slopes_[least_at(0, 0)].at(0, 0)};
    for (std::size_t next = least_at(0, 0);; next = least_at(best_.x, best_.y)) {
      if (count_ > 0 && !(slopes_[next].at(best_.x, best_.y) < best_.value)) break;
      add(next);
    }
    return best_.value > none.value ? best_ : none;
  }

 private:
  std::size_t least_at(double x, double y) const {
    std::size_t least = 0;
    for (std::size_t n = 1; n < slopes_.size(); ++n) {
      if (slopes_[n].at(x, y) < slopes_[least].at(x, y)) least = n;
    }
    return least;
  }
  // The best step for one slope more. The new slope limits it, because it is below the last one.
  void add(std::size_t next) {
    const Slope* own = &slopes_[next];
    std::size_t place = count_++;
    for (; place > 0 && used_[place - 1] > own; --place) used_[place] = used_[place - 1];
    used_[place] = own;
    best_.value = -std::numeric_limits<double>::infinity();
    try_step(0, 0);
    const double size = std::hypot(own->gx, own->gy);
    if (size > 0) try_step(own->gx / size * longest_, own->gy / size * longest_);
    for (std::size_t a = 0; a < count_; ++a) {
      for (std::size_t b = a + 1; b < count_; ++b) {
        if (a == place || b == place) try_equal(*used_[a], *used_[b]);
        for (std::size_t c = b + 1; c < count_; ++c) {
          if (a == place || b == place || c == place) try_corner(*used_[a], *used_[b], *used_[c]);
        }
      }
    }
  }
  void try_step(double x, double y) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < count_; ++n) {
      least = std::min(least, used_[n]->at(x, y));
      if (!(least > best_.value)) return;
    }
    best_ = {x, y, least};
  }
  // The line a = b is { n·x = c }.
  void try_equal(const Slope& a, const Slope& b) {
    const double nx = a.gx - b.gx, ny = a.gy - b.gy, c = b.value - a.value;
    const double square = nx * nx + ny * ny;
    if (!(square > 1e-24)) return;
    const double x = c * nx / square, y = c * ny / square;
    const double rest = longest_ * longest_ - (x * x + y * y);
    if (!(rest > 0)) return;
    const double along = std::sqrt(rest / square);
    try_step(x - ny * along, y + nx * along);
    try_step(x + ny * along, y - nx * along);
  }
  void try_corner(const Slope& a, const Slope& b, const Slope& c) {
    const double bx = a.gx - b.gx, by = a.gy - b.gy, bc = b.value - a.value;
    const double cx = a.gx - c.gx, cy = a.gy - c.gy, cc = c.value - a.value;
    const double determinant = bx * cy - by * cx;
    if (determinant == 0) return;
    const double over_x = bc * cy - by * cc, over_y = bx * cc - bc * cx;
    // Most corners are out of reach. Those that are so beyond rounding need no division.
    constexpr double kBeyond = 1 + 1e-9;
    const double reach = longest_ * determinant;
    if (over_x * over_x + over_y * over_y > kBeyond * (reach * reach)) return;
    const double x = over_x / determinant, y = over_y / determinant;
    if (x * x + y * y <= longest_ * longest_) try_step(x, y);
  }

  const std::vector<Slope>& slopes_;
  double longest_;
  std::array<const Slope*, kMostSurfaces> used_;
  std::size_t count_ = 0;
  Step best_;
};

}  // namespace

Ascent ascend_in_plane(const Clearance& clearance, const RealPoint& x, const RealPoint& normal,
                       const AscentLimits& limits) {
  ClearanceNearby nearby(clearance);
  return ascend_in_plane(nearby, x, normal, limits);
}

Ascent ascend_in_plane(ClearanceNearby& nearby, const RealPoint& x, const RealPoint& normal,
                       const AscentLimits& limits) {
  constexpr int kMostSteps = 4000;
  constexpr double kRounding = 1e-9;  // Å
  RealPoint first, second;
  normals_of(normal, first, second);
  Ascent ascent{x, nearby.look_around(x, 0), false};
  std::vector<Surface> surfaces;
  std::vector<Slope> slopes;
  double step_length = limits.longest_step_angstrom;
  double& value = ascent.clearance_angstrom;
  for (int n = 0; n < kMostSteps; ++n) {
    if (value >= limits.most_clearance_angstrom) return ascent;
    if (length(ascent.place - x) >= limits.farthest_angstrom) return ascent;
    // What may be nearest at the end of the step is among these as well.
    nearby.look_around(ascent.place, 2 * step_length + kRounding);
    nearby.collect(ascent.place, value + 2 * step_length + kRounding, kMostSurfaces, surfaces);
    slopes.clear();
    for (const Surface& s : surfaces) {
      slopes.push_back({s.distance_angstrom, dot(s.away, first), dot(s.away, second)});
    }
    const Step step = BestStep(slopes, step_length).find();
    const RealPoint next = ascent.place + step.x * first + step.y * second;
    const double risen = step.value > value ? nearby.at(next) : value;
    const double rise = risen - value;
    if (rise > 0) {
      ascent.place = next;
      value = risen;
    }
    // Shortens the step if it gains little for its length. The ascent then ends between three
    // balls.
    if (rise < 1e-3 * step_length) step_length /= 4;
    if (step_length < limits.shortest_step_angstrom) {
      ascent.settled = true;
      return ascent;
    }
  }
  return ascent;
}

}  // namespace alphascope
