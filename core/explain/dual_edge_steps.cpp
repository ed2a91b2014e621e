// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of one ball in the dual-edge engine. They run the engine's own code (core/dual_edge)
// with a sink. The engine finds a simplex at its ball of the lowest index. So it runs for the
// chosen ball and for those neighbours of lower index. Only simplices that contain the chosen ball
// count.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "core/complex/face_class.hpp"
#include "core/dual_edge/ball_simplices.hpp"
#include "core/dual_edge/cpu_dual_edges.hpp"
#include "core/dual_edge/gather_faces.hpp"
#include "core/engines/route.hpp"
#include "core/explain/ball_steps.hpp"
#include "core/explain/dual_edge_trace.hpp"
#include "core/neighbours/coincident.hpp"
#include "core/predicates/simplex_decisions.hpp"

namespace alphascope {
namespace {

class DualEdgeSteps {
 public:
  DualEdgeSteps(const BallSet& balls, BallIndex ball, const LatticeAlpha& alpha,
                const RunContext& context)
      : balls_(balls), context_(context) {
    result_.engine = StepsEngine::dual_edges;
    result_.ball = ball;
    result_.lattice = balls.lattice;
    result_.alpha_on_lattice = alpha;
    result_.star.lattice = balls.lattice;
    result_.star.alpha_on_lattice = alpha;
  }

  BallSteps run() {
    if (!make_grid()) return std::move(result_);
    grid_step();
    find_neighbours_step();
    try {
      find_simplices();
    } catch (const TooManyDualEdges&) {
      add_step(StepKind::too_many).counts = {counted(step_count::kNeighbours, list_.size())};
      return std::move(result_);
    }
    discs_step();
    edges_step();
    triangles_step();
    clipping_step();
    exact_step();
    ends_step();
    vertex_step();
    result_step();
    return std::move(result_);
  }

 private:
  Step& add_step(StepKind kind) {
    result_.steps.emplace_back().kind = kind;
    return result_.steps.back();
  }
  bool make_grid();
  bool beyond_range(std::uint64_t balls);
  void grid_step();
  void find_neighbours_step();
  void find_simplices();
  void discs_step();
  void edges_step();
  void triangles_step();
  void clipping_step();
  void exact_step();
  void ends_step();
  void vertex_step();
  void gather();
  void add_tetrahedra();
  void result_step();

  BallIndex ball(std::uint32_t slot) const { return grid_.ball[slot]; }
  // Returns whether the neighbour has a higher index. Simplices with it are then found at this
  // ball.
  bool is_later(std::uint32_t slot) const { return ball(slot) > result_.ball; }
  Tally neighbours() const {
    Tally all;
    for (const std::uint32_t t : list_) all.add(is_later(t));
    return all;
  }
  RealPoint angstrom(const RealPoint& units) const {
    return balls_.lattice.unit_angstrom() * units;
  }
  RealPoint centre() const { return real_point(balls_.centres[result_.ball]); }
  RealPoint corner(int x, int y, int z) const {
    const double w = grid_.cell_width;
    return angstrom(real_point(grid_.origin) + RealPoint{w * x, w * y, w * z});
  }

  const BallSet& balls_;
  const RunContext& context_;
  UniformGrid grid_;
  std::uint32_t slot_ = 0;
  std::vector<std::uint32_t> list_;  // slots of the neighbours, ascending by ball
  DualEdgeTrace trace_;
  std::map<BallIndex, BlockOutput> found_;  // for the ball and its neighbours of lower index
  VertexState vertex_ = VertexState::absent;
  BallSteps result_;
};

bool DualEdgeSteps::beyond_range(std::uint64_t balls) {
  add_step(StepKind::beyond_range).counts = {counted(step_count::kBalls, balls)};
  return false;
}

bool DualEdgeSteps::make_grid() {
  const LatticeAlpha alpha = result_.alpha_on_lattice;
  if (alpha == std::numeric_limits<double>::infinity()) return beyond_range(balls_.size());
  const std::vector<bool> hidden = coincident_hidden(balls_);
  grid_ = make_uniform_grid(balls_, alpha, hidden);
  const auto at = std::find(grid_.ball.begin(), grid_.ball.end(), result_.ball);
  if (at == grid_.ball.end()) {
    result_.left_out =
        !hidden.empty() && hidden[result_.ball] ? LeftOutReason::hidden : LeftOutReason::empty;
    add_step(StepKind::left_out).counts = {counted(step_count::kBalls, grid_.size())};
    return false;
  }
  if (!within_clipping_reach(grid_)) return beyond_range(grid_.size());
  slot_ = static_cast<std::uint32_t>(at - grid_.ball.begin());
  return true;
}

void DualEdgeSteps::grid_step() {
  const auto [x, y, z] = grid_.cell_at(balls_.centres[result_.ball]);
  const std::size_t cell = (static_cast<std::size_t>(x) * grid_.ny + y) * grid_.nz + z;
  const std::uint32_t begin = grid_.cell_start[cell], end = grid_.cell_start[cell + 1];
  Step& step = add_step(StepKind::grid);
  step.length_angstrom = balls_.lattice.angstrom(grid_.cell_width);
  step.counts = {counted(step_count::kBalls, grid_.size()),
                 counted(step_count::kCells, grid_.cell_start.size() - 1),
                 counted(step_count::kInCell, end - begin), counted(step_count::kPlace, slot_)};
  step.boxes = {{StepMark::chosen, corner(x, y, z), corner(x + 1, y + 1, z + 1)}};
  MarkedSimplices& in_cell = step.marks.emplace_back();
  for (std::uint32_t t = begin; t < end; ++t) {
    if (t != slot_) add<1>(in_cell, {ball(t)});
  }
}

void DualEdgeSteps::find_neighbours_step() {
  std::vector<std::uint32_t> scratch;
  find_neighbours(grid_, slot_, list_, scratch);
  const UniformGrid::Cell c = grid_.cell_at(balls_.centres[result_.ball]);
  const int x0 = std::max(c.x - 1, 0), x1 = std::min(c.x + 2, grid_.nx), y0 = std::max(c.y - 1, 0),
            y1 = std::min(c.y + 2, grid_.ny), z0 = std::max(c.z - 1, 0),
            z1 = std::min(c.z + 2, grid_.nz);
  std::vector<BallIndex> found;
  for (const std::uint32_t t : list_) found.push_back(ball(t));
  MarkedSimplices outside{.mark = StepMark::dropped}, inside{.mark = StepMark::kept};
  std::uint64_t tested = 0;
  grid_.for_rows_around(c, [&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t t = begin; t < end; ++t) {
      if (t == slot_) continue;
      ++tested;
      const bool meets = std::binary_search(found.begin(), found.end(), ball(t));
      add<1>(meets ? inside : outside, {ball(t)});
    }
  });
  const double radius = std::sqrt(result_.alpha_on_lattice.plus(balls_.weight(result_.ball)));
  Step& step = add_step(StepKind::neighbours);
  step.length_angstrom = balls_.lattice.angstrom(radius);
  step.counts = {counted(step_count::kCellsSearched,
                         static_cast<std::uint64_t>((x1 - x0) * (y1 - y0) * (z1 - z0))),
                 counted(step_count::kBallsTested, tested),
                 counted(step_count::kNeighbours, neighbours())};
  step.boxes = {{StepMark::undecided, corner(x0, y0, z0), corner(x1, y1, z1)}};
  step.spheres = {{StepMark::chosen, angstrom(centre()), step.length_angstrom}};
  step.marks = {std::move(outside), std::move(inside)};
}

void DualEdgeSteps::find_simplices() {
  DualEdgeTraceSink sink(balls_, result_.ball, context_, trace_);
  BallSimplices engine(balls_, grid_, result_.alpha_on_lattice, true);
  std::vector<std::uint32_t> list, scratch;
  const auto with = [&](std::uint32_t slot) {
    list.clear();
    find_neighbours(grid_, slot, list, scratch);
    sink.start(ball(slot));
    return engine.process(slot, list, found_[ball(slot)], sink);
  };
  vertex_ = with(slot_);
  for (const std::uint32_t t : list_) {
    if (!is_later(t)) with(t);
  }
}

void DualEdgeSteps::discs_step() {
  Step& step = add_step(StepKind::discs);
  step.off = trace_.coverers == 0;
  MarkedSimplices covered{.mark = StepMark::dropped}, facing{.mark = StepMark::kept};
  Tally dropped, kept, forgotten;
  for (const std::uint32_t t : list_) {
    const BallIndex b = ball(t);
    const auto has = [&](const std::vector<BallIndex>& some) {
      return std::binary_search(some.begin(), some.end(), b);
    };
    const bool faces = has(trace_.facing);
    (faces ? kept : dropped).add(is_later(t));
    if (!has(trace_.listed)) forgotten.add(is_later(t));
    add<2>(faces ? facing : covered, {std::min(b, result_.ball), std::max(b, result_.ball)});
  }
  step.counts = {counted(step_count::kMade, neighbours()),
                 counted(step_count::kNearest, trace_.coverers),
                 counted(step_count::kDropped, dropped), counted(step_count::kForgotten, forgotten),
                 counted(step_count::kKept, kept)};
  step.marks = {std::move(covered), std::move(facing)};
}

void DualEdgeSteps::edges_step() {
  TestTallies& fates = trace_.edges;
  Step& step = add_step(StepKind::edges);
  step.counts = {counted(step_count::kMade, neighbours()),
                 counted(step_count::kTested, fates.tested),
                 counted(step_count::kConflict, fates.conflict),
                 counted(step_count::kAboveAlpha, fates.above_alpha),
                 counted(step_count::kValid, fates.valid),
                 counted(step_count::kIntegers, fates.band)};
  fates.give_to(step);
}

void DualEdgeSteps::triangles_step() {
  OptimisationTallies& choice = trace_.triples;
  Step& step = add_step(StepKind::triangles);
  Tally made = choice.kept;
  made += choice.dropped;
  step.counts = {counted(step_count::kMade, made), counted(step_count::kDropped, choice.dropped),
                 counted(step_count::kKept, choice.kept)};
  step.marks = {std::move(choice.gone), std::move(choice.left)};
}

void DualEdgeSteps::clipping_step() {
  TestTallies& fates = trace_.filter;
  Step& step = add_step(StepKind::clipping);
  step.counts = {
      counted(step_count::kTested, fates.tested),     counted(step_count::kOutside, trace_.outside),
      counted(step_count::kConflict, fates.conflict), counted(step_count::kLeft, fates.valid),
      counted(step_count::kBand, fates.band),         counted(step_count::kHeld, trace_.held),
      counted(step_count::kFar, trace_.far),          counted(step_count::kMoved, trace_.moved)};
  fates.give_to(step);
  step.segments = std::move(trace_.filter_segments);
  step.dual_edges = std::move(trace_.samples);
  step.length_angstrom = result_.find(StepKind::neighbours)->length_angstrom;
  step.spheres = result_.find(StepKind::neighbours)->spheres;
}

void DualEdgeSteps::exact_step() {
  TestTallies& fates = trace_.exact;
  Step& step = add_step(StepKind::exact);
  step.counts = {counted(step_count::kTested, fates.tested),
                 counted(step_count::kConflict, fates.conflict),
                 counted(step_count::kFlat, fates.flat), counted(step_count::kLeft, fates.valid)};
  fates.give_to(step);
  step.segments = std::move(trace_.exact_segments);
}

void DualEdgeSteps::ends_step() {
  Step& step = add_step(StepKind::ends);
  Tally tetrahedra;
  MarkedSimplices found{.mark = StepMark::kept};
  for (const auto& s : trace_.tetrahedra) {
    tetrahedra.add(s[0] == result_.ball);
    add<4>(found, s);
  }
  step.counts = {counted(step_count::kTested, trace_.left),
                 counted(step_count::kAboveAlpha, trace_.above_alpha),
                 counted(step_count::kTriangles, trace_.triangles),
                 counted(step_count::kAttached, trace_.attached),
                 counted(step_count::kTetrahedra, tetrahedra)};
  step.marks = {std::move(trace_.beyond), std::move(trace_.in), std::move(found)};
}

void DualEdgeSteps::vertex_step() {
  Step& step = add_step(StepKind::vertex);
  const auto is = [&](VertexState state) { return std::uint64_t{vertex_ == state}; };
  step.counts = {counted(step_count::kValid, is(VertexState::unattached)),
                 counted(step_count::kAttached, is(VertexState::attached))};
  add<1>(step.marks.emplace_back(), {result_.ball});
  step.marks.back().mark =
      vertex_ == VertexState::unattached ? StepMark::kept : StepMark::undecided;
}

// Completes the star as the engine does for all balls: edges follow from triangles, vertices from
// edges.
void DualEdgeSteps::gather() {
  AlphaComplex& star = result_.star;
  // Third edges, which lack the ball, belong to other balls and are not tested. All lists here, and
  // so these, are in lexicographic order.
  std::map<BallIndex, BlockOutput> others;
  for (const auto& [lowest, out] : found_) {
    for (std::size_t n = 0; n < out.triangles.simplices.size(); ++n) {
      const std::array<BallIndex, 3>& s = out.triangles.simplices[n];
      star.triangles.simplices.push_back(s);
      star.triangles.alpha_values.push_back(out.triangles.values[n]);
      star.triangles.classes.push_back(static_cast<SimplexClass>(out.triangles.states[n]));
      if (lowest == result_.ball) others[s[1]].edges.simplices.push_back({s[1], s[2]});
    }
  }
  std::vector<EdgeRange> ranges(balls_.size());
  for (auto* all : {&found_, &others}) {
    for (auto& [lowest, out] : *all) {
      SimplexBuffer<2>& edges = out.edges;
      edges.values.resize(edges.size(), HUGE_VALF);
      edges.states.resize(edges.size(), 0);
      ranges[lowest] = {&edges, 0, edges.size()};
    }
  }
  gather_edges(ranges, star);
  keep_simplices_with(result_.ball, star.edges);
  std::vector<VertexState> states(balls_.size(), VertexState::absent);
  states[result_.ball] = vertex_;
  gather_vertices(balls_, states, star);
  keep_simplices_with(result_.ball, star.vertices);
}

void DualEdgeSteps::add_tetrahedra() {
  SimplexList<4>& list = result_.star.tetrahedra;
  const auto from = [&](BallIndex i, BallIndex m) {
    return lifted_vector(balls_.centres[i], balls_.radii[i], balls_.centres[m], balls_.radii[m]);
  };
  for (const auto& s : trace_.tetrahedra) {
    const LiftedSimplex<4> lifted{{from(s[0], s[1]), from(s[0], s[2]), from(s[0], s[3])},
                                  balls_.weight(s[0])};
    float value = 0;
    decide_rho<ExactDecider>(lifted, within_bracket_limit(lifted), result_.alpha_on_lattice,
                             &value);
    list.simplices.push_back(s);
    list.alpha_values.push_back(value);
    list.classes.push_back(SimplexClass::interior);
  }
}

void DualEdgeSteps::result_step() {
  const std::uint64_t unattached = trace_.edges.valid.all + trace_.triangles.all -
                                   trace_.attached.all +
                                   (vertex_ == VertexState::unattached ? 1 : 0);
  gather();
  add_tetrahedra();
  AlphaComplex& star = result_.star;
  Step& step = add_step(StepKind::result);
  MarkedSimplices& in = step.marks.emplace_back();
  std::uint64_t all = 0;
  const auto add_list = [&]<int N>(std::string_view id, const SimplexList<N>& list) {
    Tally tally;
    for (const auto& s : list.simplices) {
      tally.add(s[0] == result_.ball);
      add<N>(in, s);
    }
    step.counts.push_back(counted(id, tally));
    all += tally.all;
  };
  add_list(step_count::kVertices, star.vertices);
  add_list(step_count::kEdges, star.edges);
  add_list(step_count::kTriangles, star.triangles);
  add_list(step_count::kTetrahedra, star.tetrahedra);
  step.counts.push_back(counted(step_count::kAttached, all - star.tetrahedra.size() - unattached));
}

}  // namespace

BallSteps dual_edge_steps(const BallSet& balls, BallIndex ball,
                          const LatticeAlpha& alpha_on_lattice, const RunContext& context) {
  if (ball >= balls.size()) throw std::invalid_argument("there is no such ball");
  if (std::isnan(alpha_on_lattice.below)) throw std::invalid_argument("alpha is not a number");
  return DualEdgeSteps(balls, ball, alpha_on_lattice, context).run();
}

}  // namespace alphascope
