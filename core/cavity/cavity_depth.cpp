// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the depth of a pocket: distances of its lining atoms from the triangles of its openings.
#include "core/cavity/cavity_depth.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

#include "core/cavity/cavity_ground.hpp"
#include "core/complex/face_class.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/measure/triangle_distance.hpp"
#include "core/predicates/orthosphere.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

using Vector = Vector3<double>;

// A triangle with a ball around it. Lattice units.
struct Shutter {
  Vector corner[3], middle;
  double reach;
};

class Shutters {
 public:
  Shutters(const CavityGround& ground, const Cavity& cavity) {
    for (const auto* openings : {&cavity.mouths, &cavity.passages}) {
      for (const Mouth& opening : *openings) {
        for (const std::uint32_t f : opening.triangles) {
          const auto& balls = ground.incidence.triangles[f];
          add(centre(ground, balls[0]), centre(ground, balls[1]), centre(ground, balls[2]));
        }
      }
    }
  }
  static Vector centre(const CavityGround& ground, BallIndex i) {
    const LatticePoint& p = ground.balls->centres[i];
    return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
  }

  // The square distance from p to the nearest triangle, in square lattice units. The search stops
  // at a triangle whose square distance is at most `enough`. It begins at index `first`. If a
  // triangle is near enough, its index becomes `first`, because the next point is mostly near p.
  double square_distance(const Vector& p, double enough, std::size_t& first) const {
    double nearest = std::numeric_limits<double>::infinity(), distance = nearest;
    for (std::size_t n = 0, at = first; n < all_.size(); ++n, ++at) {
      if (at == all_.size()) at = 0;
      const Shutter& shutter = all_[at];
      const Vector to = difference(shutter.middle, p);
      const double most = distance + shutter.reach;
      if (dot(to, to) > most * most) continue;
      const double square =
          square_from_triangle(difference(shutter.corner[0], p), difference(shutter.corner[1], p),
                               difference(shutter.corner[2], p));
      if (square >= nearest) continue;
      nearest = square;
      distance = std::sqrt(square);
      if (square > enough) continue;
      first = at;
      break;
    }
    return nearest;
  }

 private:
  void add(const Vector& a, const Vector& b, const Vector& c) {
    Shutter shutter{
        {a, b, c}, {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3}, 0};
    for (const Vector& corner : shutter.corner) {
      const Vector from = difference(corner, shutter.middle);
      shutter.reach = std::max(shutter.reach, 1.000001 * std::sqrt(dot(from, from)));
    }
    all_.push_back(shutter);
  }
  std::vector<Shutter> all_;
};

}  // namespace

double depth_angstrom(const CavityGround& ground, const Cavity& cavity,
                      std::span<const BallIndex> lining, const CancelToken& cancel) {
  if (cavity.is_void()) return 0;
  const Shutters shutters(ground, cavity);
  // The depth is the largest distance, so a distance below the largest one so far need not be
  // exact.
  std::atomic<double> farthest = 0;
  constexpr std::size_t kGrain = 64;
  parallel_ranges(0, lining.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    std::size_t first = 0;
    for (std::size_t n = begin; n != end && !cancel.cancelled(); ++n) {
      double known = farthest.load(std::memory_order_relaxed);
      const double square =
          shutters.square_distance(Shutters::centre(ground, lining[n]), known, first);
      while (square > known && !farthest.compare_exchange_weak(known, square)) {
      }
    }
  });
  cancel.throw_if_cancelled();
  return std::sqrt(farthest.load()) * ground.balls->lattice.unit_angstrom();
}

}  // namespace alphascope
