// SPDX-License-Identifier: GPL-3.0-or-later
// The discrete flow of a triangulation: a tetrahedron flows out through each face beyond which its
// orthocentre lies. Ortho-radii never fall along the flow. Source: H. Edelsbrunner, M. Facello, J.
// Liang, On the definition and the construction of pockets in macromolecules, Discrete Appl. Math.
// 88 (1998).
#pragma once

#include <array>
#include <cstdint>

#include "core/complex/triangulation.hpp"
#include "core/predicates/flow_ties.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct BallSet;

// The flow of the tetrahedra of a triangulation of dimension 3. It does not depend on alpha: a
// tetrahedron outside K_alpha flows only to tetrahedra outside K_alpha.
struct Flow {
  // Bit k of marks[t]: t flows out through the face opposite its ball k, and that face is attached
  // to t.
  static constexpr std::uint8_t kFaces = 15;
  static constexpr std::uint8_t kReachesSink = 16;      // on some path, or is a sink
  static constexpr std::uint8_t kReachesInfinity = 32;  // on some path
  ResultArray<std::uint8_t> marks;
  // Ortho-radii, which are the alpha values: square lattice units, rounded to the nearest float.
  ResultArray<float> alpha_values;
  std::size_t ties = 0;  // faces in whose plane the orthocentre of a tetrahedron lies

  bool is_sink(std::size_t t) const { return (marks[t] & kFaces) == 0; }
  bool through(std::size_t t, std::size_t face) const { return (marks[t] >> face & 1) != 0; }
};

// Makes the flow in the caller's task arena. Throws Cancelled.
Flow make_flow(const BallSet& balls, const Triangulation& triangulation, FlowTies ties,
               const CancelToken& cancel = {});

}  // namespace alphascope
