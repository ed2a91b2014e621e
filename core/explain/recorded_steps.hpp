// SPDX-License-Identifier: GPL-3.0-or-later
// An engine's comparison, made in one arithmetic after another and recorded. The order is single
// precision (as on a GPU), double precision, integers, perturbation. The first step that decides is
// the last one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/ball_set.hpp"

namespace alphascope {

enum class Arithmetic : std::uint8_t { single_filter, double_filter, integers, perturbation };

struct ArithmeticStep {
  Arithmetic by = Arithmetic::integers;
  int sign = 0;  // 0: the step does not decide, or integers found a tie
  // The number whose sign is asked for (Å²), and the proven bound of its error (0: exact). Some
  // filters do not compute that number; then `has_number` is false.
  bool has_number = false;
  double value_angstrom2 = 0, error_angstrom2 = 0;
};

// Records whether ball m is outside (+1) or inside (-1) the smallest orthosphere of 1 to 4 affinely
// independent balls. Ball m is none of them. Numbers are positive outside.
std::vector<ArithmeticStep> steps_of_margin(const BallSet& balls,
                                            std::span<const BallIndex> simplex, BallIndex m);

// Records the sign of rho - alpha for such balls.
std::vector<ArithmeticStep> steps_of_rho(const BallSet& balls, std::span<const BallIndex> simplex,
                                         const LatticeAlpha& alpha_on_lattice);

}  // namespace alphascope
