// Balls that have all grown by one length, among helping balls that make an end of a passage, a
// plane and infinity parts of their triangulation.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/complex/triangulation.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// Lengths in lattice units. `from`, and `to` if there is one, are outside all balls, and differ.
struct PassageEnds {
  LatticePoint from;
  std::optional<LatticePoint> to;  // infinity when there is none
  // The walk stays on this side of the plane through `from` that is normal to it (unit vector); not
  // with `to`.
  std::optional<RealPoint> direction;
  // More places to be asked about, each of which may be covered; all differ.
  std::vector<LatticePoint> others = {};
};

// The wall that keeps a walk on its side of a plane is a ball of this radius (lattice units) that
// does not grow: at distance x from `from`, it is x² / (2 · this) behind the plane.
inline constexpr std::int32_t kWallRadius = 30'000'000;

// Balls and ends may be this far apart: far more than in any molecule.
inline constexpr double kWidestScene = 100'000;  // Å

// The finest lattice on which passages can be looked for, of at most 4 digits: around these balls,
// and ends such as these (Å), there must be room for helping balls, far away.
// Throws std::invalid_argument for what is wider than kWidestScene.
int passage_digits(const BallSet& balls, const std::vector<RealPoint>& ends_angstrom);
// The same balls on that lattice, rounded where theirs is finer.
BallSet on_passage_lattice(const BallSet& balls, const std::vector<RealPoint>& ends_angstrom);

inline std::int64_t square_distance(const LatticePoint& a, const LatticePoint& b) {
  const std::int64_t x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return x * x + y * y + z * z;
}

// Touches the plane from behind; `from` is outside it by at most a unit.
struct Wall {
  LatticePoint centre;
  std::int64_t radius;
};

// What the balls look like when all have grown by one length.
struct GrownScene {
  BallSet balls;
  // Of the balls that are left, by their centres, so that ways do not depend on the order of the
  // file where several are as good; the helping ones follow.
  std::vector<BallIndex> original;
  BallIndex from, to;  // the ends, as balls of radius 0; EmptySpace::kOutside
  BallIndex others;    // the first of PassageEnds::others, as such balls, too
  Triangulation triangulation;
};

class GrownScenes {
 public:
  // Both must live longer.
  GrownScenes(const BallSet& balls, const PassageEnds& ends);

  // With every radius longer by this (lattice units; shorter when negative). Throws Cancelled.
  std::shared_ptr<const GrownScene> at(std::int64_t growth, const RunContext& context) const;
  const std::optional<Wall>& wall() const { return wall_; }

 private:
  // A box around all centres and ends, lattice units.
  struct Surroundings {
    RealPoint low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    void add(const RealPoint& p) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    RealPoint centre() const { return 0.5 * (low + high); }
    double diagonal() const { return length(high - low); }
    // Balls with their centres in the box that grow until they cover an end have radii of at most
    // the box's diagonal, and reach to 3/2 of it from the box's centre: less than this.
    double far_away(const Lattice& lattice) const {
      return 3 * diagonal() + 20 * lattice.units_per_angstrom();
    }
  };

  friend int passage_digits(const BallSet&, const std::vector<RealPoint>&);
  static void add_far_balls(const Surroundings& surroundings, BallSet& balls);

  const BallSet& balls_;
  const PassageEnds& ends_;
  std::vector<BallIndex> by_centre_;  // all of them
  Surroundings surroundings_;
  std::optional<Wall> wall_;  // the last ball of a scene
};

}  // namespace alphascope
