// SPDX-License-Identifier: GPL-3.0-or-later
// The steps in which an engine finds the simplices of one ball, as data: numbers, and the simplices
// kept and dropped. Sentences are made of them in core/document/explain/steps_text.hpp.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/explain/steps_engine.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/real_point.hpp"
#include "core/run/cancel_token.hpp"
#include "core/tuples/tuple_options.hpp"

namespace alphascope {

struct BallSet;

enum class StepKind : std::uint8_t {
  left_out,  // the ball is not in the grid
  grid,
  cube,
  pairs,    // edge optimisation
  triples,  // edge optimisation
  tuples,   // edge optimisation
  alpha,    // alpha optimisation
  places,   // prefix sum
  filter,   // kernel II
  exact,    // kernel III
  faces,    // the same tests for pairs, triples and the ball alone
  // Only in the dual-edge engine, which also has grid and exact:
  neighbours,  // kernel I: balls whose grown balls meet that of the ball
  discs,       // kernel I: culling of long lists
  edges,       // tests whether a ball conflicts with an edge
  triangles,   // three balls that meet in pairs
  clipping,    // kernel II: clipping of the triangles' dual edges
  ends,        // triangles and tetrahedra, decided by the ends of dual edges
  vertex,
  beyond_range,  // alpha is too large for this engine
  too_many,
  result
};

// A number that a step counts. `here` counts the tuples that the engine makes at this ball. In
// these the ball has the lowest place in the grid. Other tuples are made at another of their balls.
// The dual-edge engine finds a simplex at its ball of the lowest index.
struct StepCount {
  std::string_view id;  // an identifier from the list below
  std::uint64_t all = 0;
  std::uint64_t here = 0;
};

namespace step_count {
inline constexpr std::string_view kBalls = "balls_in_grid", kCells = "cells", kPlace = "place",
                                  kInCell = "balls_in_cell", kCellsSearched = "cells_searched",
                                  kBallsTested = "balls_tested", kNeighbours = "neighbours",
                                  kMade = "made", kDropped = "dropped", kKept = "kept",
                                  kTested = "tested", kConflict = "in_conflict",
                                  kAboveAlpha = "above_alpha", kFlat = "flat", kValid = "valid",
                                  kBand = "band", kLowerBand = "lower_band", kReserved = "reserved",
                                  kVertices = "vertices", kEdges = "edges",
                                  kTriangles = "triangles", kTetrahedra = "tetrahedra",
                                  kAttached = "attached", kNearest = "nearest",
                                  kForgotten = "forgotten", kOutside = "outside", kLeft = "left",
                                  kHeld = "balls_held", kFar = "balls_too_far",
                                  kMoved = "ends_moved", kIntegers = "in_integers";
}  // namespace step_count

enum class StepMark : std::uint8_t { chosen, kept, dropped, undecided };

// Simplices to draw and list: the first kMostMarked of each dimension, and the number of the
// others.
struct MarkedSimplices {
  StepMark mark = StepMark::kept;
  Simplices<1> vertices = {};
  Simplices<2> edges = {};
  Simplices<3> triangles = {};
  Simplices<4> tetrahedra = {};
  std::uint64_t left_out = 0;  // number of simplices that are not in the lists

  static constexpr std::size_t kMostMarked = 4000;
};

struct StepBox {
  StepMark mark = StepMark::kept;
  RealPoint low_angstrom, high_angstrom;
};

struct StepSphere {
  StepMark mark = StepMark::kept;
  RealPoint centre_angstrom;
  double radius_angstrom = 0;
};

// The rest of a dual edge after clipping.
struct StepSegment {
  StepMark mark = StepMark::kept;
  std::array<BallIndex, 3> triangle{};
  RealPoint from_angstrom, to_angstrom;
};

// The effect of a ball on the rest of a dual edge. For too_far its plane is certainly beyond both
// ends. For unclear the filter cannot tell which of two balls ends the rest.
enum class CutKind : std::uint8_t { too_far, nothing, moves_end, unclear, takes_rest };
struct StepCut {
  BallIndex ball = 0;
  CutKind kind = CutKind::nothing;
  // The rest after this ball: Å along `direction`, from `foot`. For takes_rest: the rest before it.
  double low_angstrom = 0, high_angstrom = 0;
};
// One dual edge with the balls that clip it, in the engine's order.
struct StepDualEdge {
  StepMark mark = StepMark::kept;  // undecided: kernel III decides
  std::array<BallIndex, 3> triangle{};
  // The point of equal power in the centres' plane, and the unit vector along the line of equal
  // power.
  RealPoint foot_angstrom, direction;
  double low_angstrom = 0, high_angstrom = 0;  // the part within alpha, before all cuts
  std::vector<StepCut> cuts;

  // The number of balls after which nothing changes any more.
  std::size_t settled_after() const;
};

// A ball in conflict with simplices of the step, and their number. It ends the test of each.
struct StepConflict {
  BallIndex ball = 0;
  std::uint64_t simplices = 0;
  std::vector<BallIndex> first;  // one of these simplices
};

// The number of tuples made of a triple, and the place of the first.
struct StepPlace {
  std::array<BallIndex, 3> triple{};
  std::uint64_t tuples = 0, place = 0;
};

struct Step {
  StepKind kind = StepKind::grid;
  bool off = false;  // whether the step's optimisation is switched off
  std::vector<StepCount> counts;
  std::vector<MarkedSimplices> marks;
  std::vector<StepBox> boxes;
  std::vector<StepConflict> removers;  // by falling number of simplices
  std::vector<StepPlace> places;       // only the first few
  // Grid: side of a cell; cube: half its side; neighbours: the grown radius
  double length_angstrom = 0;
  // Only in the dual-edge engine:
  std::vector<StepSphere> spheres;
  std::vector<StepSegment> segments;     // at most MarkedSimplices::kMostMarked
  std::vector<StepDualEdge> dual_edges;  // the first few of each fate

  // Throws std::out_of_range if the step has no such count.
  const StepCount& count(std::string_view id) const;
};

// The reason why a ball takes no part.
enum class LeftOutReason : std::uint8_t { no, empty, hidden };

struct BallSteps {
  StepsEngine engine = StepsEngine::tuples;
  BallIndex ball = 0;
  Lattice lattice;
  LatticeAlpha alpha_on_lattice;
  TupleOptions options;  // of the tuple engine
  LeftOutReason left_out = LeftOutReason::no;
  std::vector<Step> steps;
  // The simplices of the alpha complex that contain the ball; empty after `too_many`.
  AlphaComplex star;

  const Step* find(StepKind kind) const;  // null if there is none
};

// The bound for 4-tuples of one ball; above it the steps end with `too_many`.
inline constexpr std::uint64_t kMostTuplesOfBall = 1'000'000;

// The steps of the tuple engine. Throws std::invalid_argument if there is no such ball or alpha is
// NaN, and Cancelled.
BallSteps tuple_steps(const BallSet& balls, BallIndex ball, const LatticeAlpha& alpha_on_lattice,
                      const TupleOptions& options, const RunContext& context = {});

// The bound for dual edges of one ball; above it the steps end with `too_many`.
inline constexpr std::uint64_t kMostDualEdgesOfBall = 200'000;

// The steps of the dual-edge engine as it runs on the CPU for a whole complex. Throws as
// tuple_steps().
BallSteps dual_edge_steps(const BallSet& balls, BallIndex ball,
                          const LatticeAlpha& alpha_on_lattice, const RunContext& context = {});

}  // namespace alphascope
