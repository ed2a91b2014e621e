// The discrete flow of a triangulation (H. Edelsbrunner, M. Facello, J. Liang, On the definition
// and the construction of pockets in macromolecules, Discrete Appl. Math. 88, 1998): a tetrahedron
// flows out through each face beyond which its orthocentre lies. Ortho-radii never fall on the way.
#pragma once

#include <array>
#include <cstdint>

#include "core/complex/triangulation.hpp"
#include "core/predicates/flow_predicate.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// Of the tetrahedra of a triangulation of dimension 3. Nothing here depends on alpha: what a
// tetrahedron outside K_alpha flows to is outside K_alpha, too.
struct Flow {
  // marks[t], bit k: t flows out through the face opposite its ball k, which it is attached to.
  static constexpr std::uint8_t kFaces = 15;
  static constexpr std::uint8_t kReachesSink = 16;      // on some way, or is one
  static constexpr std::uint8_t kReachesInfinity = 32;  // on some way
  ResultArray<std::uint8_t> marks;
  // Ortho-radii, square lattice units, rounded to the nearest float: the alpha values.
  ResultArray<float> alpha_values;
  std::size_t ties = 0;  // faces in whose plane the orthocentre of a tetrahedron lies

  bool is_sink(std::size_t t) const { return (marks[t] & kFaces) == 0; }
  bool through(std::size_t t, std::size_t face) const { return (marks[t] >> face & 1) != 0; }
};

// Works in the caller's task arena. Throws Cancelled.
Flow make_flow(const BallSet& balls, const Triangulation& triangulation, FlowTies ties,
               const CancelToken& cancel = {});

}  // namespace alphascope
