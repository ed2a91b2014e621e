// SPDX-License-Identifier: GPL-3.0-or-later
// Exact decisions about ortho-radii of simplices of a BallSet. These are plain functions for the
// host. The predicates themselves are templates for host and device, in orthosphere.hpp,
// exact_rho.hpp and foot_predicate.hpp.
#pragma once

#include <span>

#include "core/geometry/ball_set.hpp"
#include "core/predicates/orthosphere.hpp"

namespace alphascope {

// The lifted vector of ball k, seen from ball i.
inline LiftedInt lifted_vector(const BallSet& balls, BallIndex i, BallIndex k) {
  return lifted_vector(balls.centres[i], balls.radii[i], balls.centres[k], balls.radii[k]);
}

// A simplex is 1 to 4 distinct, affinely independent balls, in any order. rho is its ortho-radius,
// in square lattice units. All results below are exact.

// Sign of rho - alpha.
int compare_ortho_radius(const BallSet& balls, std::span<const BallIndex> simplex,
                         const LatticeAlpha& alpha_on_lattice);

// Sign of rho(a) - rho(b) of two tetrahedra.
int compare_ortho_radii(const BallSet& balls, std::span<const BallIndex, 4> a,
                        std::span<const BallIndex, 4> b);

// Sign of rho(a) - rho(b) of two simplices of any dimensions.
int compare_ortho_radii_of(const BallSet& balls, std::span<const BallIndex> a,
                           std::span<const BallIndex> b);

// The float nearest to rho: the alpha value of an unattached simplex.
float ortho_radius_rounded(const BallSet& balls, std::span<const BallIndex> simplex);

// Sign of pi_m(x) - rho at the orthocentre x of a simplex of 1 to 3 balls: negative means that m
// attaches the simplex.
int conflict_with_smallest_orthosphere(const BallSet& balls, std::span<const BallIndex> simplex,
                                       BallIndex m);

}  // namespace alphascope
