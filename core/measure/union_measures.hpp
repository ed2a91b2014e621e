// SPDX-License-Identifier: GPL-3.0-or-later
// Exact area and volume of a union of balls, grown by alpha, from its alpha complex alone: the
// totals, those of each ball in its power cell, and their derivatives. Balls may be of any
// dimension, hidden, tangent or equal. Results have the same bits for any number of threads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/measure/measured_quantity.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct AlphaComplex;

// Measures, per ball by its index. Balls that are not in the complex have area and volume 0.
struct UnionMeasures {
  PerQuantity<double> total = {};            // Å to power_of_length()
  PerQuantity<std::vector<double>> of_ball;  // the same, by ball

  double area_angstrom2() const { return total[MeasuredQuantity::area]; }
  double volume_angstrom3() const { return total[MeasuredQuantity::volume]; }
  // The part of each ball's sphere outside all other balls.
  const std::vector<double>& ball_area_angstrom2() const { return of_ball[MeasuredQuantity::area]; }
  // The part of each ball inside its power cell.
  const std::vector<double>& ball_volume_angstrom3() const {
    return of_ball[MeasuredQuantity::volume];
  }
};

struct Gradient {
  double x = 0, y = 0, z = 0;
};
// Derivatives of the total area and volume, with alpha fixed. A derivative by radius is by the
// radius r of the file, or with its solvent, and not by sqrt(r² + alpha). Where spheres touch in
// one point the area has no derivative; these are then one-sided.
struct UnionDerivatives {
  std::vector<Gradient> area_by_centre_angstrom;     // Å² per Å
  std::vector<Gradient> volume_by_centre_angstrom2;  // Å³ per Å
  std::vector<double> area_by_radius_angstrom;
  std::vector<double> volume_by_radius_angstrom2;
};

struct MeasureOptions {
  int threads = 0;  // 0: those of the caller's task arena; outside of one, all of the machine
  // If not null, derivatives are computed as well, which takes about twice the time.
  UnionDerivatives* derivatives = nullptr;
};

// Measures a whole complex of the same balls. Throws Cancelled, and std::invalid_argument if the
// complex has only tetrahedra or is of other balls.
UnionMeasures measure_union(const BallSet& balls, const AlphaComplex& complex,
                            const MeasureOptions& options = {}, const RunContext& context = {});

// The area of each grown ball's whole sphere: its area if no other ball were there. 0 if the ball
// is empty.
std::vector<double> free_areas_angstrom2(const BallSet& balls,
                                         const LatticeAlpha& alpha_on_lattice);

// Throws std::invalid_argument, as measure_union() does, if the complex cannot be measured.
void require_same_balls(const BallSet& balls, const AlphaComplex& complex);

// The component of the complex to which each ball belongs. Components are numbered by their lowest
// ball. kNoGroup: the ball is not in the complex.
inline constexpr std::uint32_t kNoGroup = 0xffffffff;
struct Components {
  std::uint32_t count = 0;  // Betti number 0
  std::vector<std::uint32_t> of_ball;
};
Components components(std::size_t balls, const AlphaComplex& complex);

// Sums by residue, chain, component, or any other group of each value, compensated and in the order
// of the values. Values of kNoGroup are left out. std::invalid_argument for a group that is not
// below `groups`, or if the lengths differ.
std::vector<double> sums_by_group(std::span<const double> values,
                                  std::span<const std::uint32_t> group, std::size_t groups);

}  // namespace alphascope
