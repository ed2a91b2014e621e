// SPDX-License-Identifier: GPL-3.0-or-later
// Facts on an atom or a simplex and its surroundings in the complex on screen, as a derived result.
// It takes one pass over the lists of simplices.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/complex/face_class.hpp"
#include "core/document/store/derived.hpp"
#include "core/geometry/ball_index.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct AlphaComplex;
struct BallSet;

struct NeighbourBall {
  BallIndex ball = 0;
  double distance_angstrom = 0;  // between centres
};

struct SimplexDetails {
  std::vector<BallIndex> balls;  // 1 to 4, ascending
  // If only tetrahedra were computed, a smaller simplex counts only if it is a face of one.
  bool in_complex = false;
  std::optional<double> alpha_value_angstrom2;  // none: not in the complex, or not computed
  // Class in the dimension of all centres (core/complex/own_dimension.hpp).
  std::optional<SimplexClass> simplex_class;
  // Numbers of larger simplices of the complex that have it as a face. Index: number of their balls
  // less one.
  std::array<std::size_t, 4> cofaces{};
  // For a vertex: the ends of its edges, nearest first. If only tetrahedra were computed, their
  // edges count.
  std::vector<NeighbourBall> neighbours;
  // For an edge or triangle: the simplices with one ball more. For a tetrahedron: those that share
  // a triangle with it. At most kMostListed.
  std::vector<std::vector<BallIndex>> beside;
  static constexpr std::size_t kMostListed = 1000;
};

// Throws Cancelled.
SimplexDetails find_details(const BallSet& balls, const AlphaComplex& complex,
                            const std::vector<BallIndex>& simplex, const RunContext& context = {});

Definition<SimplexDetails> simplex_details(const std::vector<BallIndex>& simplex);

}  // namespace alphascope
