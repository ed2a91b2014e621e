// SPDX-License-Identifier: GPL-3.0-or-later
// Balls that have all grown by one length, with helping balls. The helping balls stand for the
// ends, a plane and infinity, so that these are parts of the triangulation.
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

// Lengths are in lattice units. `from` and `to`, if set, are outside all balls and differ.
struct PassageEnds {
  LatticePoint from;
  std::optional<LatticePoint> to;  // none: infinity
  // Unit vector. The way stays on this side of the plane through `from` that is normal to it. Not
  // allowed with `to`.
  std::optional<RealPoint> direction;
  // More places to examine. They are distinct; each may lie in a ball.
  std::vector<LatticePoint> others = {};
};

// The wall is a ball of this radius (lattice units) that does not grow. It keeps a way on its side
// of the plane. At distance x from `from` its surface is x² / (2 · kWallRadius) behind the plane.
inline constexpr std::int32_t kWallRadius = 30'000'000;

// The largest allowed extent of balls and ends (Å), far above that of any molecule.
inline constexpr double kLargestExtent = 100'000;

// The number of digits, at most 4, of the finest lattice for passages between these balls and ends
// (Å). It leaves room for the helping balls far away. Throws std::invalid_argument if the extent is
// above kLargestExtent.
int passage_digits(const BallSet& balls, const std::vector<RealPoint>& ends_angstrom);
// The same balls on that lattice, rounded if their own is finer.
BallSet on_passage_lattice(const BallSet& balls, const std::vector<RealPoint>& ends_angstrom);

// A ball that touches the plane from behind. `from` is outside it by at most a lattice unit.
struct Wall {
  LatticePoint centre;
  std::int64_t radius;
};

// The balls grown by one length, with helping balls, and their triangulation.
struct GrownTriangulation {
  BallSet balls;
  // For each remaining ball its index in the input, ordered by centre. So equally good ways do not
  // depend on the order of the file. The helping balls follow after these.
  std::vector<BallIndex> original;
  BallIndex from, to;  // indices of the ends, balls of radius 0; `to` may be EmptySpace::kOutside
  BallIndex others;    // index of the first of PassageEnds::others, also balls of radius 0
  Triangulation triangulation;
};

class GrownTriangulations {
 public:
  // Both must outlive this object.
  GrownTriangulations(const BallSet& balls, const PassageEnds& ends);

  // The scene with this added to every radius (lattice units, may be negative). Throws Cancelled.
  std::shared_ptr<const GrownTriangulation> at(std::int64_t growth,
                                               const RunContext& context) const;
  const std::optional<Wall>& wall() const { return wall_; }

 private:
  // A box around all centres and ends, lattice units.
  struct Box {
    RealPoint low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    void add(const RealPoint& p) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    RealPoint centre() const { return 0.5 * (low + high); }
    double diagonal() const { return length(high - low); }
    // A ball with its centre in the box grows at most until it covers an end. Its radius is then at
    // most the diagonal. It reaches at most 3/2 of the diagonal from the box's centre, which is
    // below this distance.
    double far_away(const Lattice& lattice) const {
      return 3 * diagonal() + 20 * lattice.units_per_angstrom();
    }
  };

  friend int passage_digits(const BallSet&, const std::vector<RealPoint>&);
  static void add_far_balls(const Box& box, BallSet& balls);

  const BallSet& balls_;
  const PassageEnds& ends_;
  std::vector<BallIndex> by_centre_;  // all balls, ordered by centre
  Box box_;
  std::optional<Wall> wall_;  // the last ball of each scene
};

}  // namespace alphascope
