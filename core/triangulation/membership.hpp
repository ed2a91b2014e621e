// SPDX-License-Identifier: GPL-3.0-or-later
// Marks the simplices of a triangulation that are in K_alpha, without alpha values or classes. The
// answer is exact and equals that of threshold().
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/complex/simplices.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

class Filtration;
struct BallSet;
struct Flow;
struct Incidence;
struct LatticeAlpha;
struct Triangulation;

// 1 for a simplex in K_alpha, 0 for any other. Indices are those of the triangulation's tetrahedra,
// of its Incidence and, for vertices, of the balls.
struct Membership {
  using Marks = ResultArray<std::uint8_t>;
  Marks tetrahedra, triangles, edges, vertices;

  std::array<std::size_t, 4> counts() const;  // by dimension
  friend bool operator==(const Membership&, const Membership&) = default;
};

// Membership from the filtration of a whole triangulation of dimension 3, else
// std::invalid_argument.
Membership membership(const Filtration& filtration, const LatticeAlpha& alpha_on_lattice);

// Membership at one alpha from a triangulation of dimension 3, without a filtration. It computes
// only what no coface decides. Works in the caller's task arena. Throws Cancelled.
Membership membership(const BallSet& balls, const Triangulation& triangulation,
                      const Incidence& incidence, const Flow& flow,
                      const LatticeAlpha& alpha_on_lattice, const CancelToken& cancel = {});

}  // namespace alphascope
