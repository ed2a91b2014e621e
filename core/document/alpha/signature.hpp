// SPDX-License-Identifier: GPL-3.0-or-later
// The signature of a molecule: numbers of simplices of each dimension, and the Euler number, as
// functions of alpha. It is made from the filtration, for all alphas at once.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/geometry/lattice.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

class Filtration;
template <class T>
struct Definition;

struct Signature {
  Lattice lattice;
  // Alpha values of the simplices of dimension 0 to 3, ascending, in square lattice units.
  std::array<std::vector<float>, 4> values;

  // Number of simplices of one dimension with an alpha value of at most `alpha` (Å²). Alpha values
  // are rounded to floats here. So simplices within that rounding of alpha may be counted wrongly;
  // the complex itself decides them exactly.
  std::size_t count(int dimension, double alpha) const;
  // Vertices - edges + triangles - tetrahedra = components - tunnels + voids.
  long long euler(double alpha) const;
  // The least alpha (Å²) with a nonempty complex; 0 without balls.
  double least_alpha() const;
};

Signature make_signature(const Filtration& filtration, const RunContext& context = {});

const Definition<Signature>& whole_signature();

}  // namespace alphascope
