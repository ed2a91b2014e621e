// SPDX-License-Identifier: GPL-3.0-or-later
// K_alpha straight from its definition, in rational arithmetic (GMP), for a handful of balls. It is
// slow on purpose, as it shares no predicate, triangulation or neighbour search with the program.
#pragma once

#include <gmpxx.h>

#include <map>
#include <span>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/geometry/ball_set.hpp"

namespace alphascope::testing {

using Rational = mpq_class;

Rational rational(const LatticeAlpha& alpha);  // alpha must be finite

// Orthocentre and ortho-radius of affinely independent balls, by elimination.
struct Orthosphere {
  Rational x, y, z, rho;
};
Orthosphere orthosphere(const BallSet& balls, std::span<const BallIndex> simplex);

// pi_m(x) at the orthocentre, minus rho.
Rational power_excess(const BallSet& balls, const Orthosphere& sphere, BallIndex m);

// True when ball m removes the cell of four affinely independent balls from the regular
// triangulation. Balls are symbolically perturbed, so there is never a tie.
bool perturbed_conflict(const BallSet& balls, std::span<const BallIndex> tetrahedron, BallIndex m);

// The float nearest to a rational, halves to even.
float nearest_float(const Rational& value);

class RationalOracle {
 public:
  // Tries all tuples of balls, so about 16 balls are the practical limit.
  explicit RationalOracle(const BallSet& balls);

  // Every simplex of the (symbolically perturbed) regular triangulation, with its alpha value.
  const std::map<std::vector<BallIndex>, Rational>& alpha_values() const { return alpha_values_; }

  AlphaComplex complex(const LatticeAlpha& alpha_on_lattice) const;
  // K_alpha with classes by the dimension of the triangulation, whose largest simplices are
  // interior.
  AlphaComplex own_complex(const LatticeAlpha& alpha_on_lattice) const;
  int dimension() const;

 private:
  AlphaComplex complex_with_largest(const LatticeAlpha& alpha_on_lattice, int largest) const;

  BallSet balls_;
  std::map<std::vector<BallIndex>, Rational> alpha_values_;
};

}  // namespace alphascope::testing
