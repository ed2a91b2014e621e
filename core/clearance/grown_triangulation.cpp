// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the grown balls of a passage with their helping balls, and chooses the lattice for them.
#include "core/clearance/grown_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "core/clearance/empty_space.hpp"
#include "core/geometry/alpha.hpp"
#include "core/run/internal_error.hpp"
#include "core/triangulation/make_triangulation.hpp"

namespace alphascope {
namespace {

constexpr int kMostDigits = 4;

BallIndex add_point(const LatticePoint& point, BallSet& balls) {
  balls.centres.push_back(point);
  balls.radii.push_back(0);
  return static_cast<BallIndex>(balls.size() - 1);
}

Wall wall_behind(const LatticePoint& from, const RealPoint& direction) {
  Wall wall;
  wall.centre =
      nearest_lattice_point(real_point(from) - static_cast<double>(kWallRadius) * direction);
  const std::int64_t square = square_distance(from, wall.centre);
  wall.radius = static_cast<std::int64_t>(std::sqrt(static_cast<double>(square))) + 2;
  while (wall.radius * wall.radius >= square) --wall.radius;
  return wall;
}

// Returns whether the ball lies within the wall, and so covers nothing that the wall leaves free.
bool is_within(const LatticePoint& centre, std::int64_t radius, const Wall& wall) {
  const std::int64_t room = wall.radius - radius;
  return room >= 0 && square_distance(centre, wall.centre) <= room * room;
}

}  // namespace

// Adds 12 small balls far away, at the corners of an icosahedron. They block nothing. Everything
// near the balls lies within their hull, even if the balls are few or flat.
void GrownTriangulations::add_far_balls(const Box& box, BallSet& balls) {
  constexpr double kGolden = 1.6180339887498949;
  const double size = box.far_away(balls.lattice) / std::sqrt(1 + kGolden * kGolden);
  const RealPoint centre = box.centre();
  for (const double one : {-1.0, 1.0}) {
    for (const double golden : {-kGolden, kGolden}) {
      for (const RealPoint& corner :
           {RealPoint{0, one, golden}, RealPoint{one, golden, 0}, RealPoint{golden, 0, one}}) {
        balls.centres.push_back(nearest_lattice_point(centre + size * corner));
        balls.radii.push_back(1);
      }
    }
  }
}

GrownTriangulations::GrownTriangulations(const BallSet& balls, const PassageEnds& ends)
    : balls_(balls), ends_(ends) {
  for (const LatticePoint& p : balls.centres) box_.add(real_point(p));
  box_.add(real_point(ends.from));
  if (ends.to) box_.add(real_point(*ends.to));
  for (const LatticePoint& p : ends.others) box_.add(real_point(p));
  if (ends.direction) wall_ = wall_behind(ends.from, *ends.direction);
  by_centre_.resize(balls.size());
  std::iota(by_centre_.begin(), by_centre_.end(), BallIndex{0});
  std::stable_sort(by_centre_.begin(), by_centre_.end(), [&](BallIndex a, BallIndex b) {
    return balls.centres[a] != balls.centres[b] ? balls.centres[a] < balls.centres[b]
                                                : balls.radii[a] > balls.radii[b];
  });
}

std::shared_ptr<const GrownTriangulation> GrownTriangulations::at(std::int64_t growth,
                                                                  const RunContext& context) const {
  auto scene = std::make_shared<GrownTriangulation>();
  scene->balls.lattice = balls_.lattice;
  for (const BallIndex i : by_centre_) {
    const std::int64_t radius = balls_.radii[i] + growth;
    if (radius <= 0 || (wall_ && is_within(balls_.centres[i], radius, *wall_))) continue;
    scene->balls.centres.push_back(balls_.centres[i]);
    scene->balls.radii.push_back(static_cast<std::int32_t>(radius));
    scene->original.push_back(i);
  }
  add_far_balls(box_, scene->balls);
  scene->from = add_point(ends_.from, scene->balls);
  scene->to = ends_.to ? add_point(*ends_.to, scene->balls) : EmptySpace::kOutside;
  scene->others = static_cast<BallIndex>(scene->balls.size());
  for (const LatticePoint& p : ends_.others) add_point(p, scene->balls);
  if (wall_) {
    scene->balls.centres.push_back(wall_->centre);
    scene->balls.radii.push_back(static_cast<std::int32_t>(wall_->radius));
  }
  scene->triangulation = make_triangulation(scene->balls, 0, context);
  if (scene->triangulation.dimension != 3) {
    throw InternalError("The helping balls of a passage are flat.");
  }
  return scene;
}

int passage_digits(const BallSet& balls, const std::vector<RealPoint>& ends_angstrom) {
  const Lattice angstrom{0};
  GrownTriangulations::Box box;
  for (const LatticePoint& p : balls.centres) {
    box.add(balls.lattice.unit_angstrom() * real_point(p));
  }
  for (const RealPoint& p : ends_angstrom) {
    if (!std::isfinite(p.x + p.y + p.z)) {
      throw std::invalid_argument("an end of the channel is not a finite number");
    }
    box.add(p);
  }
  if (box.diagonal() > kLargestExtent) {
    throw std::invalid_argument(
        "balls and ends of a channel are more than 100,000 Å apart; choose ends near the balls");
  }
  const RealPoint centre = box.centre();
  const double middle = std::max({std::fabs(centre.x), std::fabs(centre.y), std::fabs(centre.z)});
  const auto has_room = [&](int digits) {
    const double units = Lattice{digits}.units_per_angstrom();
    const double far_away = box.far_away(angstrom) * units + 1;
    return middle * units + far_away + kWallRadius < kMaxLatticeCoordinate &&
           far_away < kMaxLatticeRadius;
  };
  int digits = std::min(balls.lattice.digits, kMostDigits);
  while (!has_room(digits)) --digits;
  return digits;
}

BallSet on_passage_lattice(const BallSet& balls, const std::vector<RealPoint>& ends_angstrom) {
  const int digits = passage_digits(balls, ends_angstrom);
  BallSet result = balls;
  result.lattice.digits = digits;
  const double factor = std::pow(10.0, digits - balls.lattice.digits);
  if (factor == 1) return result;
  for (LatticePoint& p : result.centres) p = nearest_lattice_point(factor * real_point(p));
  for (std::int32_t& r : result.radii) {
    r = std::max(1, static_cast<std::int32_t>(std::lround(factor * r)));
  }
  return result;
}

}  // namespace alphascope
