// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of one ball in the tuple engine. They use the engine's own templates in the engine's
// order, with sinks. All tuples that contain the ball are made from its list of neighbours. The
// engine itself makes at a ball only those in which the ball has the lowest place. These are
// counted apart.
#include <algorithm>
#include <cmath>
#include <memory_resource>
#include <stdexcept>

#include "core/explain/ball_steps.hpp"
#include "core/explain/step_tallies.hpp"
#include "core/neighbours/coincident.hpp"
#include "core/tuples/tuple_pipeline.hpp"

namespace alphascope {
namespace {

class TupleTrace {
 public:
  TupleTrace(const BallSet& balls, BallIndex ball, const LatticeAlpha& alpha,
             const TupleOptions& options, const RunContext& context)
      : balls_(balls), context_(context), grid_(std::pmr::new_delete_resource()) {
    result_.ball = ball;
    result_.lattice = balls.lattice;
    result_.alpha_on_lattice = alpha;
    result_.options = options;
    result_.star.lattice = balls.lattice;
    result_.star.alpha_on_lattice = alpha;
  }

  BallSteps run() {
    if (!make_grid()) return std::move(result_);
    grid_step();
    find_neighbours();
    test(BallTuple<1>{slot_, {0}});
    make_pairs();
    for (const BallTuple<2>& pair : pairs_) {
      context_.cancel.throw_if_cancelled();
      if (too_many()) break;
      test(pair);
      extend(pair);
    }
    if (too_many()) {
      add_step(StepKind::too_many).counts = {counted(step_count::kMade, possible()),
                                             counted(step_count::kKept, choices_[2].kept)};
      return std::move(result_);
    }
    optimisation_steps();
    test_steps();
    result_step();
    return std::move(result_);
  }

 private:
  using Scene = TupleInput<PlainReader>;

  Step& add_step(StepKind kind) {
    result_.steps.emplace_back().kind = kind;
    return result_.steps.back();
  }
  bool make_grid();
  void grid_step();
  void find_neighbours();
  void make_pairs();
  void optimisation_steps();
  void test_steps();
  void faces_step();
  void result_step();

  BallIndex ball(std::uint32_t slot) const { return grid_.ball[slot]; }
  RealPoint angstrom(const RealPoint& units) const {
    return balls_.lattice.unit_angstrom() * units;
  }
  // The number of all 4-tuples of the ball and three neighbours.
  std::uint64_t possible() const {
    const std::uint64_t n = slots_.size();
    return n < 3 ? 0 : n * (n - 1) / 2 * (n - 2) / 3;
  }
  bool too_many() const { return choices_[2].kept.all > kMostTuplesOfBall; }
  template <int N>
  bool is_here(const BallTuple<N>& tuple) const {
    return N == 1 || lists_.slots[tuple.at[0]] > slot_;
  }
  template <int N>
  std::array<BallIndex, N> simplex(const BallTuple<N>& tuple) const {
    std::array<BallIndex, N> s;
    for (int n = 0; n < N; ++n) s[n] = ball(tuple.slot(lists_, n));
    std::sort(s.begin(), s.end());
    return s;
  }

  // Kernel I: makes all tuples with one more neighbour.
  template <int N>
  void extend(const BallTuple<N>& base) {
    const bool here = is_here(base);
    const auto with = [&](std::uint32_t at) {
      BallTuple<N + 1> tuple;
      tuple.first = base.first;
      std::copy_n(base.at, N - 1, tuple.at);
      tuple.at[N - 1] = at;
      return simplex(tuple);
    };
    OptimisationTallies& by_edges = choices_[N - 1];
    std::uint64_t made = 0;
    const std::uint32_t considered = for_extensions<N>(
        scene_, lists_, base,
        [&](const BallTuple<N + 1>& tuple) {
          if (too_many()) return;
          ++made;
          add<N + 1>(by_edges.left, simplex(tuple));
          if constexpr (N == 3) {
            by_alpha_.kept.add(here);
            add<4>(by_alpha_.left, simplex(tuple));
          }
          test(tuple);
          if constexpr (N == 2) extend(tuple);
        },
        [&](Optimisation by, std::uint32_t at) {
          OptimisationTallies& choice = by == Optimisation::alpha ? by_alpha_ : by_edges;
          choice.dropped.add(here);
          add<N + 1>(choice.gone, with(at));
          if (by == Optimisation::alpha) add<N + 1>(by_edges.left, with(at));
        });
    by_edges.kept.add(here, considered);
    if constexpr (N == 3) {
      if (here) note_place(base, made);
    }
  }
  void note_place(const BallTuple<3>& triple, std::uint64_t tuples) {
    constexpr std::size_t kMostPlaces = 6;
    if (places_.size() < kMostPlaces) places_.push_back({simplex(triple), tuples, next_place_});
    next_place_ += tuples;
  }

  // Kernels II and III: tests a tuple.
  template <int N>
  void test(const BallTuple<N>& tuple) {
    const bool here = is_here(tuple);
    const auto s = simplex(tuple);
    Verdict verdict = note_fate(filter_fates(N), s, here, [&](const auto& sink) {
      return filter_tuple<N>(scene_, lists_, tuple, sink);
    });
    if constexpr (N > 1) {
      if (verdict == Verdict::band) {
        verdict = note_fate(exact_fates(N), s, here, [&](const auto& sink) {
          return decide_tuple<N>(scene_, lists_, tuple, sink);
        });
      }
    }
    if (verdict == Verdict::valid) emit(tuple);
  }
  TestTallies& filter_fates(int balls) { return balls == 4 ? filter_ : faces_; }
  TestTallies& exact_fates(int balls) { return balls == 4 ? exact_ : exact_faces_; }

  template <std::size_t N, class Kernel>
  Verdict note_fate(TestTallies& fates, const std::array<BallIndex, N>& s, bool here,
                    const Kernel& kernel) {
    fates.tested.add(here);
    const auto note = [&](TupleNote what, auto... at) {
      if (what == TupleNote::above_alpha) fates.above_alpha.add(here);
      if (what == TupleNote::flat) fates.flat.add(here);
      if (what != TupleNote::conflict) return;
      fates.conflict.add(here);
      (fates.template remove<N>(ball(lists_.slots[at]), s), ...);
    };
    const Verdict verdict = kernel(note);
    if (verdict == Verdict::valid) fates.valid.add(here);
    if (verdict == Verdict::band) fates.band.add(here);
    add<N>(verdict == Verdict::valid  ? fates.kept
           : verdict == Verdict::band ? fates.open
                                      : fates.gone,
           s);
    return verdict;
  }

  template <int N>
  UnattachedSimplices<N>& own_list() {
    if constexpr (N == 1) return own_.vertices;
    if constexpr (N == 2) return own_.edges;
    if constexpr (N == 3) return own_.triangles;
    if constexpr (N == 4) return own_.tetrahedra;
  }
  template <int N>
  void emit(const BallTuple<N>& tuple) {
    const Verdict valid = Verdict::valid;
    const std::uint64_t place = 0;
    std::array<BallIndex, N> s;
    float value = 0;
    EmitSimplices<N, PlainReader>{scene_, lists_, &tuple, &valid, &place, s.data(), &value}(0);
    own_list<N>().simplices.push_back(s);
    own_list<N>().values.push_back(value);
  }

  const BallSet& balls_;
  const RunContext& context_;
  TupleGrid grid_;
  Scene scene_{};
  std::uint32_t slot_ = 0;
  std::vector<std::uint64_t> starts_;  // starts for a single list
  std::vector<std::uint32_t> slots_;   // the list
  NeighbourLists lists_{};
  std::vector<BallTuple<2>> pairs_;
  OptimisationTallies choices_[3];  // edge optimisation of pairs, triples and 4-tuples
  OptimisationTallies by_alpha_;
  // Two for 4-tuples, two for smaller tuples.
  TestTallies filter_, exact_, faces_, exact_faces_;
  std::vector<StepPlace> places_;
  std::uint64_t next_place_ = 0;
  UnattachedSimplicesByDimension own_;
  BallSteps result_;
};

bool TupleTrace::make_grid() {
  const std::vector<bool> hidden = coincident_hidden(balls_);
  make_tuple_grid(balls_, result_.alpha_on_lattice, hidden, result_.options.grid, grid_);
  const auto at = std::find(grid_.ball.begin(), grid_.ball.end(), result_.ball);
  if (at == grid_.ball.end()) {
    result_.left_out =
        !hidden.empty() && hidden[result_.ball] ? LeftOutReason::hidden : LeftOutReason::empty;
    add_step(StepKind::left_out).counts = {counted(step_count::kBalls, grid_.size())};
    return false;
  }
  slot_ = static_cast<std::uint32_t>(at - grid_.ball.begin());
  scene_ = make_tuple_input(
      TupleUpload<PlainReader>{
          {grid_.records.data(), grid_.reach.data()}, grid_.cell_start.data(), grid_.ball.data()},
      grid_, result_.options, result_.alpha_on_lattice);
  return true;
}

void TupleTrace::grid_step() {
  const TupleGridView& g = scene_.grid;
  const BallRecord b = scene_.read.ball(slot_);
  const int x = g.cell(0, b.x), y = g.cell(1, b.y), z = g.cell(2, b.z);
  const auto corner = [&](int dx, int dy, int dz) {
    const auto edge = [&](int axis, int cell) {
      return g.origin[axis] + static_cast<double>(g.width[axis]) * cell;
    };
    return angstrom({edge(0, x + dx), edge(1, y + dy), edge(2, z + dz)});
  };
  const std::int64_t cell = (static_cast<std::int64_t>(x) * g.cells[1] + y) * g.cells[2] + z;
  Step& step = add_step(StepKind::grid);
  step.length_angstrom = balls_.lattice.angstrom(g.width[0]);
  step.counts = {counted(step_count::kBalls, grid_.size()),
                 counted(step_count::kCells, static_cast<std::uint64_t>(g.cells[0]) *
                                                 static_cast<std::uint64_t>(g.cells[1]) *
                                                 static_cast<std::uint64_t>(g.cells[2])),
                 counted(step_count::kInCell, g.cell_start[cell + 1] - g.cell_start[cell]),
                 counted(step_count::kPlace, slot_)};
  step.boxes = {{StepMark::chosen, corner(0, 0, 0), corner(1, 1, 1)}};
  MarkedSimplices& in_cell = step.marks.emplace_back();
  for (std::uint32_t s = g.cell_start[cell]; s < g.cell_start[cell + 1]; ++s) {
    if (s != slot_) add<1>(in_cell, {ball(s)});
  }
}

void TupleTrace::find_neighbours() {
  std::vector<std::uint32_t> looked_at;
  for_balls_in_cube(
      scene_, slot_, [&](std::uint32_t t) { slots_.push_back(t); },
      [&](std::uint32_t t) { looked_at.push_back(t); });
  starts_.assign(grid_.size() + std::size_t{1}, 0);
  starts_[slot_ + std::size_t{1}] = slots_.size();
  lists_ = {slots_.data(), starts_.data(), 0};

  const TupleGridView& g = scene_.grid;
  const BallRecord b = scene_.read.ball(slot_);
  const std::int64_t side = cube_half_side(scene_.read.reach(slot_), scene_.largest_reach);
  std::uint64_t cells = 1;
  const std::int32_t centre[3] = {b.x, b.y, b.z};
  double low[3], high[3];
  for (int a = 0; a < 3; ++a) {
    const int first = g.cell(a, centre[a] - side), last = g.cell(a, centre[a] + side);
    cells *= static_cast<std::uint64_t>(last - first + 1);
    low[a] = g.origin[a] + static_cast<double>(g.width[a]) * first;
    high[a] = g.origin[a] + static_cast<double>(g.width[a]) * (last + 1);
  }
  Step& step = add_step(StepKind::cube);
  const RealPoint middle{static_cast<double>(b.x), static_cast<double>(b.y),
                         static_cast<double>(b.z)};
  const double s = static_cast<double>(side);
  step.length_angstrom = balls_.lattice.angstrom(s);
  step.boxes = {{StepMark::undecided, angstrom({low[0], low[1], low[2]}),
                 angstrom({high[0], high[1], high[2]})},
                {StepMark::kept, angstrom(middle - RealPoint{s, s, s}),
                 angstrom(middle + RealPoint{s, s, s})}};
  Tally neighbours;
  MarkedSimplices outside{.mark = StepMark::dropped}, inside{.mark = StepMark::kept};
  for (const std::uint32_t t : looked_at) {
    if (t == slot_) continue;
    const bool found = std::binary_search(slots_.begin(), slots_.end(), t);
    add<1>(found ? inside : outside, {ball(t)});
  }
  for (const std::uint32_t t : slots_) neighbours.add(t > slot_);
  step.counts = {counted(step_count::kCellsSearched, cells),
                 counted(step_count::kBallsTested, looked_at.size() - 1),
                 counted(step_count::kNeighbours, neighbours)};
  step.marks = {std::move(outside), std::move(inside)};
}

void TupleTrace::make_pairs() {
  for (std::uint32_t at = 0; at < slots_.size(); ++at) {
    const BallTuple<2> pair{slot_, {at}};
    const bool left = is_pair_kept(scene_, slot_, slots_[at]);
    OptimisationTallies& choice = choices_[0];
    (left ? choice.kept : choice.dropped).add(is_here(pair));
    add<2>(left ? choice.left : choice.gone, simplex(pair));
    if (left) pairs_.push_back(pair);
  }
}

void TupleTrace::optimisation_steps() {
  const auto add_choice = [&](StepKind kind, OptimisationTallies& choice, bool on) {
    Step& step = add_step(kind);
    step.off = !on;
    Tally made = choice.kept;
    made += choice.dropped;
    step.counts = {counted(step_count::kMade, made), counted(step_count::kDropped, choice.dropped),
                   counted(step_count::kKept, choice.kept)};
    step.marks = {std::move(choice.gone), std::move(choice.left)};
  };
  add_choice(StepKind::pairs, choices_[0], scene_.edge_optimisation);
  add_choice(StepKind::triples, choices_[1], scene_.edge_optimisation);
  add_choice(StepKind::tuples, choices_[2], scene_.edge_optimisation);
  add_choice(StepKind::alpha, by_alpha_, scene_.alpha_optimisation);
  Step& places = add_step(StepKind::places);
  places.counts = {counted(step_count::kReserved, possible()),
                   counted(step_count::kKept, by_alpha_.kept)};
  places.places = std::move(places_);
  places.marks = {result_.steps[result_.steps.size() - 2].marks.back()};
}

void TupleTrace::test_steps() {
  Step& filter = add_step(StepKind::filter);
  filter.counts = {counted(step_count::kTested, filter_.tested),
                   counted(step_count::kConflict, filter_.conflict),
                   counted(step_count::kAboveAlpha, filter_.above_alpha),
                   counted(step_count::kValid, filter_.valid),
                   counted(step_count::kBand, filter_.band)};
  filter_.give_to(filter);
  Step& exact = add_step(StepKind::exact);
  exact.counts = {
      counted(step_count::kTested, exact_.tested), counted(step_count::kConflict, exact_.conflict),
      counted(step_count::kAboveAlpha, exact_.above_alpha), counted(step_count::kFlat, exact_.flat),
      counted(step_count::kValid, exact_.valid)};
  exact_.give_to(exact);
  faces_step();
}

void TupleTrace::faces_step() {
  Tally conflict = faces_.conflict, above_alpha = faces_.above_alpha;
  conflict += exact_faces_.conflict;
  above_alpha += exact_faces_.above_alpha;
  Step& faces = add_step(StepKind::faces);
  faces.counts = {counted(step_count::kTested, faces_.tested),
                  counted(step_count::kConflict, conflict),
                  counted(step_count::kAboveAlpha, above_alpha),
                  counted(step_count::kLowerBand, faces_.band),
                  counted(step_count::kVertices, own_.vertices.simplices.size()),
                  counted(step_count::kEdges, own_.edges.simplices.size()),
                  counted(step_count::kTriangles, own_.triangles.simplices.size())};
  MarkedSimplices valid;
  for (const auto& s : own_.vertices.simplices) add<1>(valid, s);
  for (const auto& s : own_.edges.simplices) add<2>(valid, s);
  for (const auto& s : own_.triangles.simplices) add<3>(valid, s);
  faces_.give_to(faces);
  faces.marks = {std::move(valid)};
}

void TupleTrace::result_step() {
  AlphaComplex& star = result_.star;
  const std::size_t own = own_.vertices.simplices.size() + own_.edges.simplices.size() +
                          own_.triangles.simplices.size() + own_.tetrahedra.simplices.size();
  complete_complex(std::move(own_), balls_.size(), star);
  keep_simplices_with(result_.ball, star.vertices);
  keep_simplices_with(result_.ball, star.edges);
  keep_simplices_with(result_.ball, star.triangles);
  keep_simplices_with(result_.ball, star.tetrahedra);
  const std::size_t all =
      star.vertices.size() + star.edges.size() + star.triangles.size() + star.tetrahedra.size();
  Step& step = add_step(StepKind::result);
  step.counts = {counted(step_count::kVertices, star.vertices.size()),
                 counted(step_count::kEdges, star.edges.size()),
                 counted(step_count::kTriangles, star.triangles.size()),
                 counted(step_count::kTetrahedra, star.tetrahedra.size()),
                 counted(step_count::kAttached, all - own)};
  MarkedSimplices& in = step.marks.emplace_back();
  for (const auto& s : star.vertices.simplices) add<1>(in, s);
  for (const auto& s : star.edges.simplices) add<2>(in, s);
  for (const auto& s : star.triangles.simplices) add<3>(in, s);
  for (const auto& s : star.tetrahedra.simplices) add<4>(in, s);
}

}  // namespace

BallSteps tuple_steps(const BallSet& balls, BallIndex ball, const LatticeAlpha& alpha_on_lattice,
                      const TupleOptions& options, const RunContext& context) {
  if (ball >= balls.size()) throw std::invalid_argument("there is no such ball");
  if (std::isnan(alpha_on_lattice.below)) throw std::invalid_argument("alpha is not a number");
  return TupleTrace(balls, ball, alpha_on_lattice, options, context).run();
}

}  // namespace alphascope
