// The engines' own comparisons, made one arithmetic after another and written down: what single
// precision says (as on a GPU), then double, then integers, then the perturbation. The first that
// decides is the last of the steps.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/ball_set.hpp"

namespace alphascope {

enum class Arithmetic : std::uint8_t { single_filter, double_filter, integers, perturbation };

struct ArithmeticStep {
  Arithmetic by = Arithmetic::integers;
  int sign = 0;  // 0: it does not decide, or integers found a tie
  // The number whose sign is asked for, Å², and the bound that is proven for its error (0: exact).
  // Not every filter computes that number; such a step has none.
  bool has_number = false;
  double value_angstrom2 = 0, error_angstrom2 = 0;
};

// Is ball m outside (+1) or inside (-1) the smallest orthosphere of 1 to 4 affinely independent
// balls, none of which it is? Numbers are positive outside.
std::vector<ArithmeticStep> steps_of_margin(const BallSet& balls,
                                            std::span<const BallIndex> simplex, BallIndex m);

// The sign of rho - alpha of such balls.
std::vector<ArithmeticStep> steps_of_rho(const BallSet& balls, std::span<const BallIndex> simplex,
                                         const LatticeAlpha& alpha_on_lattice);

}  // namespace alphascope
