// Exact area and volume of a union of balls, grown by alpha, from its alpha complex alone: in all,
// of each ball and its power cell, and their derivatives. Sets of any dimension; hidden, tangent
// and equal balls. Results are the same bits for any number of threads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// By the index of the ball; balls that are not in the complex have none of either.
struct UnionMeasures {
  double area_angstrom2 = 0;
  double volume_angstrom3 = 0;
  std::vector<double> ball_area_angstrom2;    // of the ball's sphere, outside all other balls
  std::vector<double> ball_volume_angstrom3;  // of the ball, within its power cell
};

struct Gradient {
  double x = 0, y = 0, z = 0;
};
// Of the total area and volume, with alpha fixed. A derivative by a radius r is by that of the file
// or with its solvent, not by sqrt(r² + alpha). Where spheres touch in one point the area has no
// derivative, and these are on one side or the other.
struct UnionDerivatives {
  std::vector<Gradient> area_by_centre_angstrom;     // Å² per Å
  std::vector<Gradient> volume_by_centre_angstrom2;  // Å³ per Å
  std::vector<double> area_by_radius_angstrom;
  std::vector<double> volume_by_radius_angstrom2;
};

struct MeasureOptions {
  int threads = 0;  // those of the caller's task arena; outside of any, as many as the machine has
  // When not null, filled as well; takes about twice the time.
  UnionDerivatives* derivatives = nullptr;
};

// `complex` is of the same balls, whole. Throws Cancelled, and std::invalid_argument when it has
// only its tetrahedra or is of other balls.
UnionMeasures measure_union(const BallSet& balls, const AlphaComplex& complex,
                            const MeasureOptions& options = {}, const RunContext& context = {});

// Of each ball's whole sphere, grown: what its area is when no other ball is there. 0 where the
// ball is empty.
std::vector<double> free_areas_angstrom2(const BallSet& balls,
                                         const LatticeAlpha& alpha_on_lattice);

// Throws what measure_union() does of a complex that it cannot measure.
void require_same_balls(const BallSet& balls, const AlphaComplex& complex);

// The component of the complex that each ball is in: components are numbered by their lowest ball.
// kNoGroup for balls that are not in the complex.
inline constexpr std::uint32_t kNoGroup = 0xffffffff;
struct Components {
  std::uint32_t count = 0;  // Betti number 0
  std::vector<std::uint32_t> of_ball;
};
Components components(std::size_t balls, const AlphaComplex& complex);

// Sums by residue, chain, component, or whatever else `group` says of each value, compensated and
// in the order of the values. Values of kNoGroup are left out; std::invalid_argument for other
// groups from `groups` on, or when the lengths differ.
std::vector<double> sums_by_group(std::span<const double> values,
                                  std::span<const std::uint32_t> group, std::size_t groups);

}  // namespace alphascope
