// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the widest places: in a cavity by ascent from a sink, in a mouth by refined grids.
#include "core/cavity_shape/cavity_places.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "core/cavity/cavities.hpp"
#include "core/cavity/cavity_ground.hpp"
#include "core/clearance/empty_space.hpp"
#include "core/clearance/plane_ascent.hpp"

namespace alphascope {
namespace {

// Ascends in one plane after the other until none leads higher. If a cavity widens outwards, the
// ascent would leave it: an ascent that leads farther than kFarthest from the start returns the
// start.
WidestPlace climbed(const Clearance& clearance, const RealPoint& start) {
  constexpr double kFarthest = 1.5, kStep = 0.2, kShortest = 1e-5, kGain = 1e-5;  // Å
  constexpr int kMostRounds = 40;
  static const RealPoint kNormals[] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1}, {1, 1, 1},
                                       {1, -1, 1}, {1, 1, -1}, {-1, 1, 1}};
  const WidestPlace from{start, clearance.at(start)};
  WidestPlace best = from;
  for (int round = 0; round < kMostRounds; ++round) {
    const double before = best.clearance_angstrom;
    for (const RealPoint& normal : kNormals) {
      const Ascent ascent =
          ascend_in_plane(clearance, best.place_angstrom, unit_vector(normal),
                          {kStep, kShortest, std::numeric_limits<double>::max(), kFarthest});
      if (length(ascent.place - start) > kFarthest) return from;
      best = {ascent.place, clearance.at(ascent.place)};
    }
    if (best.clearance_angstrom - before < kGain) break;
  }
  return best;
}

class MouthSearch {
 public:
  MouthSearch(const Clearance& clearance, const std::array<RealPoint, 3>& corners)
      : clearance_(clearance), corners_(corners) {}

  // Searches a grid over the triangle, then finer grids around the best place.
  WidestPlace find() {
    constexpr int kSide = 8, kRefined = 4;
    for (int a = 0; a <= kSide; ++a) {
      for (int b = 0; a + b <= kSide; ++b) look(1.0 * a / kSide, 1.0 * b / kSide);
    }
    double step = 1.0 / kSide;
    for (int round = 0; round < kRefined; ++round) {
      step /= 3;
      const double a = a_, b = b_;
      for (int i = -3; i <= 3; ++i) {
        for (int k = -3; k <= 3; ++k) look(a + i * step, b + k * step);
      }
    }
    return best_;
  }

 private:
  void look(double a, double b) {
    if (a < 0 || b < 0 || a + b > 1 + 1e-12) return;
    const RealPoint place = a * corners_[0] + b * corners_[1] + (1 - a - b) * corners_[2];
    const double here = clearance_.at(place);
    if (here <= best_.clearance_angstrom) return;
    best_ = {place, here};
    a_ = a;
    b_ = b;
  }

  const Clearance& clearance_;
  const std::array<RealPoint, 3> corners_;
  WidestPlace best_{{}, -std::numeric_limits<double>::infinity()};
  double a_ = 0, b_ = 0;
};

}  // namespace

WidestPlace widest_place(const CavityGround& ground, const Cavity& cavity,
                         const Clearance& clearance) {
  const EmptySpace space(*ground.balls, *ground.triangulation);
  const double unit = ground.balls->lattice.unit_angstrom();
  // Only the orthocentre of a sink lies within its tetrahedron. So only these are certainly in the
  // cavity.
  WidestPlace best{{}, -std::numeric_limits<double>::infinity()};
  for (const std::uint32_t t : cavity.tetrahedra) {
    if (!ground.flow.is_sink(t)) continue;
    const RealPoint corner = unit * space.corner(t);
    const double here = clearance.at(corner);
    if (here > best.clearance_angstrom) best = {corner, here};
  }
  return climbed(clearance, best.place_angstrom);
}

WidestPlace widest_place(const CavityGround& ground, const Mouth& mouth,
                         const Clearance& clearance) {
  const double unit = ground.balls->lattice.unit_angstrom();
  WidestPlace best{{}, -std::numeric_limits<double>::infinity()};
  for (const std::uint32_t f : mouth.triangles) {
    std::array<RealPoint, 3> corners;
    for (std::size_t n = 0; n < 3; ++n) {
      corners[n] = unit * real_point(ground.balls->centres[ground.incidence.triangles[f][n]]);
    }
    const WidestPlace here = MouthSearch(clearance, corners).find();
    if (here.clearance_angstrom > best.clearance_angstrom) best = here;
  }
  return best;
}

}  // namespace alphascope
