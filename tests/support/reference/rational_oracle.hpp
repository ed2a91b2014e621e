// K_alpha straight from its definition, in rational arithmetic (GMP), for a handful of balls. Slow
// on purpose: it shares no predicate, no triangulation and no neighbour search with the program.
#pragma once

#include <gmpxx.h>

#include <map>
#include <span>
#include <vector>

#include "core/complex/alpha_complex.hpp"

namespace alphascope::testing {

using Rational = mpq_class;

Rational rational(const LatticeAlpha& alpha);  // of a finite one

// Orthocentre and ortho-radius of affinely independent balls, by elimination.
struct Orthosphere {
  Rational x, y, z, rho;
};
Orthosphere orthosphere(const BallSet& balls, std::span<const BallIndex> simplex);

// pi_m(x) at the orthocentre, minus rho.
Rational power_excess(const BallSet& balls, const Orthosphere& sphere, BallIndex m);

// Does ball m cut the cell of four affinely independent balls away in the regular triangulation of
// the symbolically perturbed balls? Never a tie.
bool perturbed_conflict(const BallSet& balls, std::span<const BallIndex> tetrahedron, BallIndex m);

// The float nearest to a rational, halves to even.
float nearest_float(const Rational& value);

class RationalOracle {
 public:
  // Tries all tuples of balls: about 16 balls is the limit of patience.
  explicit RationalOracle(const BallSet& balls);

  // Every simplex of the (symbolically perturbed) regular triangulation with its alpha value.
  const std::map<std::vector<BallIndex>, Rational>& alpha_values() const { return alpha_values_; }

  AlphaComplex complex(const LatticeAlpha& alpha_on_lattice) const;
  // With the classes of the dimension of the triangulation, in which its largest simplices are
  // interior.
  AlphaComplex own_complex(const LatticeAlpha& alpha_on_lattice) const;
  int dimension() const;

 private:
  AlphaComplex complex_with_largest(const LatticeAlpha& alpha_on_lattice, int largest) const;

  BallSet balls_;
  std::map<std::vector<BallIndex>, Rational> alpha_values_;
};

}  // namespace alphascope::testing
