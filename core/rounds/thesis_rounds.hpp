// SPDX-License-Identifier: GPL-3.0-or-later
// The rounds of the thesis' Part I and of its chapter on future work: alpha grows, and saturated
// balls leave. An engine of its own for the benchmark. Triangulations for all other purposes are
// made by core/triangulation, which is faster.
//
// Definitions. The star of ball i are the tetrahedra of the regular triangulation T with vertex i.
// Ball i is saturated at alpha if its power cell is bounded and lies inside the ball grown to
// sqrt(r² + alpha). Then no ball farther away can cut the cell, so the star is final.
//
// Proposition. Ball i is saturated at alpha if and only if it is a vertex of a tetrahedron of
// K_alpha, and each triangle of such a tetrahedron that contains i belongs to two of them.
// Proof. The corners of the cell of i are the orthocentres of its star. The cell is convex, so it
// lies in the convex set π_i <= alpha if and only if it is bounded and each corner has
// π_i = ρ <= alpha. The cell is bounded if and only if i is not on the hull. So ball i is saturated
// if and only if it is not on the hull and its whole star is in K_alpha. Then each triangle
// has two tetrahedra. Conversely, let each triangle have two. The star is connected through such
// triangles, so a walk from the one tetrahedron reaches the whole star, all of it in K_alpha. It
// meets no facet of the hull, so i is not on the hull. With the perturbation, cells are those of
// the perturbed weights, and ρ is the limit. ∎
// So the class of the vertex in K_alpha is "interior" (docs/algorithm.md, proposition 5).
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/complex/simplices.hpp"
#include "core/geometry/alpha.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

class WorkThreads;
struct BallSet;

// The alpha of round n, from 1, in Å²: 2.5, 10, 40, … The thesis adds the side of a cell of its
// grid each time; a factor needs far fewer rounds.
Alpha alpha_of_round(std::size_t n);
inline constexpr std::size_t kMostRounds = 24;  // the last alpha is 1.8e14 Å²

// One round, or the star completion.
struct ThesisRound {
  Alpha alpha_angstrom2;           // Å²; infinite for the star completion
  std::size_t balls = 0;           // that were computed
  std::size_t saturated = 0;       // after it
  std::size_t hidden = 0;          // known to be so after it
  std::size_t unsaturated = 0;     // all others after it: |U|
  std::size_t tetrahedra = 0;      // known after it
  std::size_t new_tetrahedra = 0;  // of these, unknown before it
  std::string route;               // of the engine (EngineInfo::route)
  double milliseconds = 0;         // wall time
};

struct ThesisRounds {
  int dimension = -1;               // of the centres; below 3 no ball is ever saturated
  std::vector<ThesisRound> rounds;  // empty below dimension 3
  ThesisRound completion;           // nothing below dimension 3
  Simplices<4> tetrahedra;          // all of the triangulation, in lexicographic order
  std::size_t on_hull = 0;          // balls of the hull, which are never saturated
  double milliseconds = 0;          // wall time of all, with the final order
};

// Makes the triangulation by rounds. The first computes all balls. Each further one computes
// the unsaturated balls, and the balls that share a known tetrahedron with one of them. A hidden
// ball leaves when a tetrahedron around it is known. The rounds end when one changes nothing. The
// star completion then makes the whole triangulation of such balls, by core/triangulation, and
// takes what was missing. The result equals that of make_triangulation(). Works on `threads`.
// Throws Cancelled, std::bad_alloc, and std::length_error for more balls or tetrahedra than can be
// handled.
ThesisRounds make_thesis_rounds(const std::shared_ptr<const BallSet>& balls,
                                const std::shared_ptr<WorkThreads>& threads,
                                const RunContext& context = {});

// Marks the balls whose star is closed in these tetrahedra of T, by the proposition. For a ball of
// interest the list must have all of K_alpha with that ball. Works in the caller's task arena.
// Throws Cancelled.
std::vector<bool> saturated_balls(std::size_t balls, const Simplices<4>& tetrahedra,
                                  const CancelToken& cancel = {});

}  // namespace alphascope
