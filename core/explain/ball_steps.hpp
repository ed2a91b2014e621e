// How an engine finds the simplices of one ball, step after step, as data: numbers, and what is
// kept and dropped. Sentences are made of them by core/document/explain/steps_text.hpp.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"
#include "core/run/cancel_token.hpp"
#include "core/tuples/tuple_options.hpp"

namespace alphascope {

enum class StepsEngine : std::uint8_t { tuples, dual_edges };

enum class StepKind : std::uint8_t {
  left_out,  // the ball is not in the grid at all
  grid,
  cube,
  pairs,    // edge optimisation
  triples,  // edge optimisation
  tuples,   // edge optimisation
  alpha,    // alpha optimisation
  places,   // prefix sum
  filter,   // kernel II
  exact,    // kernel III
  faces,    // the same tests of pairs, triples and the ball alone
  // Of the dual-edge engine, which has grid and exact as well:
  neighbours,  // kernel I: whose grown balls meet that of the ball
  discs,       // kernel I: long lists are culled
  edges,       // is anybody in conflict with an edge
  triangles,   // three balls that meet in pairs
  clipping,    // kernel II: their dual edges
  ends,        // what their ends decide: triangles and tetrahedra
  vertex,
  beyond_range,  // alpha is too large for this engine
  too_many,
  result
};

// What a step counts. `here`: of tuples, those that the engine makes at this ball, because it is in
// the lowest place of the grid; the others are made at another ball of theirs. The dual-edge engine
// finds a simplex at its ball of the lowest index.
struct StepCount {
  std::string_view id;  // of the list below
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

// For drawing and listing: the first kMostMarked tetrahedra or so, and how many there are.
struct MarkedSimplices {
  StepMark mark = StepMark::kept;
  Simplices<1> vertices = {};
  Simplices<2> edges = {};
  Simplices<3> triangles = {};
  Simplices<4> tetrahedra = {};
  std::uint64_t left_out = 0;  // not in the lists

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

// What is left of a dual edge.
struct StepSegment {
  StepMark mark = StepMark::kept;
  std::array<BallIndex, 3> triangle{};
  RealPoint from_angstrom, to_angstrom;
};

// What a ball does to what is left of a dual edge. too_far: its plane is certainly beyond both
// ends. unclear: the filter cannot tell which of two balls ends it.
enum class CutKind : std::uint8_t { too_far, nothing, moves_end, unclear, takes_rest };
struct StepCut {
  BallIndex ball = 0;
  CutKind kind = CutKind::nothing;
  // What is left after it: Å along `direction`, from `foot`. After takes_rest: before it.
  double low_angstrom = 0, high_angstrom = 0;
};
// One dual edge, ball after ball, in the order of the engine.
struct StepDualEdge {
  StepMark mark = StepMark::kept;  // undecided: kernel III looks again
  std::array<BallIndex, 3> triangle{};
  RealPoint foot_angstrom, direction;          // where the three powers are equal; a unit vector
  double low_angstrom = 0, high_angstrom = 0;  // what is within alpha, before all cuts
  std::vector<StepCut> cuts;

  // From so many balls on nothing changed any more.
  std::size_t settled_after() const;
};

// A ball in conflict with so many simplices of the step: it ends the test of each.
struct StepRemover {
  BallIndex ball = 0;
  std::uint64_t simplices = 0;
  std::vector<BallIndex> first;  // one of them
};

// So many tuples are made of a triple, and this is the place of the first.
struct StepPlace {
  std::array<BallIndex, 3> triple{};
  std::uint64_t tuples = 0, place = 0;
};

struct Step {
  StepKind kind = StepKind::grid;
  bool off = false;  // its optimisation is switched off
  std::vector<StepCount> counts;
  std::vector<MarkedSimplices> marks;
  std::vector<StepBox> boxes;
  std::vector<StepRemover> removers;  // by how many, descending
  std::vector<StepPlace> places;      // the first few
  double length_angstrom = 0;  // of a cell's side; half the side of the cube; the grown radius
  // Of the dual-edge engine:
  std::vector<StepSphere> spheres;
  std::vector<StepSegment> segments;     // the first MarkedSimplices::kMostMarked
  std::vector<StepDualEdge> dual_edges;  // the first few of each fate

  // Throws std::out_of_range.
  const StepCount& count(std::string_view id) const;
};

// Why a ball takes no part.
enum class LeftOut : std::uint8_t { no, empty, hidden };

struct BallSteps {
  StepsEngine engine = StepsEngine::tuples;
  BallIndex ball = 0;
  Lattice lattice;
  LatticeAlpha alpha_on_lattice;
  TupleOptions options;  // of the tuple engine
  LeftOut left_out = LeftOut::no;
  std::vector<Step> steps;
  // The simplices of the alpha complex that contain the ball; none after `too_many`.
  AlphaComplex star;

  const Step* find(StepKind kind) const;  // null: there is none
};

// More 4-tuples of one ball are not looked at.
inline constexpr std::uint64_t kMostTuplesOfBall = 1'000'000;

// The steps of the thesis' pipeline. Throws std::invalid_argument (no such ball, alpha is NaN),
// Cancelled.
BallSteps tuple_steps(const BallSet& balls, BallIndex ball, const LatticeAlpha& alpha_on_lattice,
                      const TupleOptions& options, const RunContext& context = {});

// More dual edges of one ball are not looked at.
inline constexpr std::uint64_t kMostDualEdgesOfBall = 200'000;

// The steps of the dual-edge engine as it runs on the CPU, whole complex. The same exceptions.
BallSteps dual_edge_steps(const BallSet& balls, BallIndex ball,
                          const LatticeAlpha& alpha_on_lattice, const RunContext& context = {});

}  // namespace alphascope
