// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the rounds. `open_` are the known tetrahedra with an unsaturated ball. A tetrahedron that is
// still unknown has unsaturated balls only, as a saturated one knows its whole star.
//
// Which balls a round needs. Let U be the unsaturated balls, and S those of U and of open_. If i of
// U is a vertex of T, then S has all its neighbours in T: the edge to a neighbour is in a known
// tetrahedron, which is in open_, or in unknown ones only, and then the neighbour is in U. So the
// cell of i is the same for S as for all balls, and so are the tetrahedra with i. Ties do not
// matter, as the perturbation follows the order of the centres, which S keeps.
//
// A hidden ball has no cell among all balls, but may have one in S, which can lack those that hide
// it. If one vertex of a tetrahedron of S is a vertex of T, the tetrahedron is in T, and all its
// balls are vertices of T. So a false one has hidden balls only, and none of its balls is in a true
// tetrahedron. keep_certain() therefore keeps what hangs together, ball by ball, with a ball of a
// known tetrahedron. A round that would lose something this way computes all balls instead. The
// star completion loses only false ones: T hangs together through its faces, so every unknown
// tetrahedron does so with a known one.
#include "core/rounds/thesis_rounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

#include "core/complex/alpha_complex.hpp"
#include "core/complex/face_code.hpp"
#include "core/complex/triangulation.hpp"
#include "core/engine/engine.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/predicates/spanning_balls.hpp"
#include "core/run/parallel.hpp"
#include "core/run/stage_timer.hpp"
#include "core/run/work_threads.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "core/triangulation/outer_faces.hpp"
#include "core/triangulation/union_find.hpp"

namespace alphascope {
namespace {

using Tetrahedron = std::array<BallIndex, 4>;

constexpr double kFirstAlpha = 2.5;  // Å²
constexpr double kFactor = 4;
constexpr const char* kCompletionRoute =
    "triangulation of the unsaturated balls and their neighbours";

enum class BallState : std::uint8_t {
  unseen,  // in no known tetrahedron: hidden, or its star is not reached yet
  open,    // in a known tetrahedron, but the star is not closed
  saturated
};

// Some of the balls, in their order.
struct Part {
  std::shared_ptr<const BallSet> balls;
  std::vector<BallIndex> original;  // empty: all balls
  bool is_all() const { return original.empty(); }
};

Part part_of(const std::shared_ptr<const BallSet>& balls, std::vector<BallIndex> chosen) {
  if (chosen.size() == balls->size()) return {balls, {}};
  auto part = std::make_shared<BallSet>();
  part->lattice = balls->lattice;
  part->centres.reserve(chosen.size());
  part->radii.reserve(chosen.size());
  for (const BallIndex i : chosen) {
    part->centres.push_back(balls->centres[i]);
    part->radii.push_back(balls->radii[i]);
  }
  return {std::move(part), std::move(chosen)};
}

class Rounds {
 public:
  Rounds(std::shared_ptr<const BallSet> balls, const std::shared_ptr<WorkThreads>& threads,
         const RunContext& context)
      : balls_(std::move(balls)),
        threads_(threads),
        context_(context),
        states_(balls_->size(), BallState::unseen) {}

  ThesisRounds run() {
    StageTimes times;
    StageTimer timer(times);
    ThesisRounds result;
    result.dimension = dimension_of_centres(*balls_);
    context_.cancel.throw_if_cancelled();
    if (result.dimension == 3) {
      for (std::size_t n = 1; n <= kMostRounds; ++n) {
        context_.report("round " + std::to_string(n), 0);
        result.rounds.push_back(timed([&](ThesisRound& round) { grow(alpha_of_round(n), round); }));
        if (known_ > 0 && !changed_) break;
      }
      context_.report("star completion", 0);
      result.completion = timed([&](ThesisRound& round) { complete(round); });
    }
    result.tetrahedra = in_order();
    const auto count = [&](BallState state) {
      return static_cast<std::size_t>(std::count(states_.begin(), states_.end(), state));
    };
    result.on_hull = count(BallState::open);
    result.hidden = result.dimension == 3 ? count(BallState::unseen) : 0;
    timer.finish();
    result.milliseconds = times.wall_milliseconds;
    return result;
  }

 private:
  template <class Body>
  ThesisRound timed(const Body& body) {
    StageTimes times;
    StageTimer timer(times);
    ThesisRound round;
    body(round);
    round.tetrahedra = known_;
    round.saturated = saturated_;
    round.unsaturated = balls_->size() - saturated_;
    timer.finish();
    round.milliseconds = times.wall_milliseconds;
    return round;
  }

  void grow(const Alpha& alpha, ThesisRound& round) {
    round.alpha_angstrom2 = alpha;
    Part part = part_of(balls_, needed());
    Simplices<4> found = tetrahedra_of(part, alpha, round);
    if (!part.is_all() && keep_certain(found)) {
      part = {balls_, {}};
      found = tetrahedra_of(part, alpha, round);
    }
    round.new_tetrahedra = take(std::move(found));
  }

  void complete(ThesisRound& round) {
    round.alpha_angstrom2 = Alpha(HUGE_VAL);
    const Part part = part_of(balls_, needed());
    Triangulation made = make_triangulation(*part.balls, 0, context_);
    round.balls = part.balls->size();
    round.route = kCompletionRoute;
    Simplices<4> found = unsaturated_of(part, std::move(made.tetrahedra));
    if (!part.is_all()) keep_certain(found);
    round.new_tetrahedra = take(std::move(found));
  }

  // The balls that the next round computes, ascending.
  std::vector<BallIndex> needed() const {
    std::vector<bool> in(states_.size());
    for (std::size_t i = 0; i < states_.size(); ++i) in[i] = states_[i] != BallState::saturated;
    for (const Tetrahedron& t : open_) {
      for (const BallIndex i : t) in[i] = true;
    }
    std::vector<BallIndex> chosen;
    for (std::size_t i = 0; i < in.size(); ++i) {
      if (in[i]) chosen.push_back(static_cast<BallIndex>(i));
    }
    return chosen;
  }

  // The tetrahedra of the part's alpha complex that have unsaturated balls only.
  Simplices<4> tetrahedra_of(const Part& part, const Alpha& alpha, ThesisRound& round) const {
    context_.cancel.throw_if_cancelled();
    const auto engine =
        make_cpu_engine(part.balls, {.threads = threads_->asked(), .shared = threads_});
    AlphaComplex complex = engine->compute({alpha, true}, context_);
    round.balls = part.balls->size();
    round.route = complex.engine.route;
    return unsaturated_of(part, std::move(complex.tetrahedra.simplices));
  }

  Simplices<4> unsaturated_of(const Part& part, Simplices<4> tetrahedra) const {
    context_.cancel.throw_if_cancelled();
    if (!part.is_all()) {
      parallel_many(tetrahedra.size(), context_.cancel, [&](std::size_t n) {
        for (BallIndex& i : tetrahedra[n]) i = part.original[i];
      });
    }
    std::erase_if(tetrahedra, [&](const Tetrahedron& t) {
      return std::any_of(t.begin(), t.end(),
                         [&](BallIndex i) { return states_[i] == BallState::saturated; });
    });
    return tetrahedra;
  }

  // Keeps the tetrahedra that are certainly in T; see above. Returns whether any was dropped.
  bool keep_certain(Simplices<4>& found) const {
    if (known_ == 0) return false;
    UnionFind sets(balls_->size());
    for (const Tetrahedron& t : found) {
      for (std::size_t k = 1; k < 4; ++k) sets.unite(t[0], t[k]);
    }
    std::vector<bool> certain(balls_->size());
    for (std::size_t i = 0; i < states_.size(); ++i) {
      if (states_[i] == BallState::open) certain[sets.root(static_cast<BallIndex>(i))] = true;
    }
    return std::erase_if(found, [&](const Tetrahedron& t) { return !certain[sets.root(t[0])]; }) >
           0;
  }

  // Adds the tetrahedra that are new, and finds who is saturated now. Returns the number of new
  // ones.
  std::size_t take(Simplices<4> found) {
    context_.cancel.throw_if_cancelled();
    const std::size_t before = open_.size();
    if (open_.empty()) {
      open_ = std::move(found);
    } else {
      Simplices<4> both;
      both.reserve(open_.size() + found.size());
      std::set_union(open_.begin(), open_.end(), found.begin(), found.end(),
                     std::back_inserter(both));
      open_ = std::move(both);
    }
    const std::size_t fresh = open_.size() - before, had = saturated_;
    known_ += fresh;
    mark_saturated();
    changed_ = fresh > 0 || saturated_ > had;
    return fresh;
  }

  void mark_saturated() {
    for (const Tetrahedron& t : open_) {
      for (const BallIndex i : t) {
        if (states_[i] == BallState::unseen) states_[i] = BallState::open;
      }
    }
    const std::vector<bool> closed = saturated_balls(states_.size(), open_, context_.cancel);
    for (std::size_t i = 0; i < states_.size(); ++i) {
      if (states_[i] != BallState::open || !closed[i]) continue;
      states_[i] = BallState::saturated;
      ++saturated_;
    }
    const auto is_open = [&](const Tetrahedron& t) {
      return std::any_of(t.begin(), t.end(),
                         [&](BallIndex i) { return states_[i] != BallState::saturated; });
    };
    std::copy_if(open_.begin(), open_.end(), std::back_inserter(finished_),
                 [&](const Tetrahedron& t) { return !is_open(t); });
    std::erase_if(open_, [&](const Tetrahedron& t) { return !is_open(t); });
    context_.cancel.throw_if_cancelled();
  }

  // All known tetrahedra in lexicographic order: dealt out by their first ball, then sorted.
  Simplices<4> in_order() const {
    std::vector<std::size_t> first(balls_->size() + 1, 0);
    for (const auto* list : {&finished_, &open_}) {
      for (const Tetrahedron& t : *list) ++first[t[0] + 1];
    }
    for (std::size_t i = 0; i < balls_->size(); ++i) first[i + 1] += first[i];
    Simplices<4> all(known_);
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for (const auto* list : {&finished_, &open_}) {
      for (const Tetrahedron& t : *list) all[next[t[0]]++] = t;
    }
    const auto at = [&](std::size_t n) { return all.begin() + static_cast<std::ptrdiff_t>(n); };
    parallel_many(balls_->size(), context_.cancel,
                  [&](std::size_t i) { std::sort(at(first[i]), at(first[i + 1])); });
    return all;
  }

  std::shared_ptr<const BallSet> balls_;
  std::shared_ptr<WorkThreads> threads_;
  const RunContext& context_;
  std::vector<BallState> states_;
  Simplices<4> open_;      // in lexicographic order
  Simplices<4> finished_;  // all of whose balls are saturated
  std::size_t known_ = 0, saturated_ = 0;
  bool changed_ = false;  // by the latest round
};

}  // namespace

Alpha alpha_of_round(std::size_t n) {
  return kFirstAlpha * std::pow(kFactor, static_cast<double>(n) - 1);
}

std::vector<bool> saturated_balls(std::size_t balls, const Simplices<4>& tetrahedra,
                                  const CancelToken& cancel) {
  std::vector<bool> saturated(balls, false);
  for (const Tetrahedron& t : tetrahedra) {
    for (const BallIndex i : t) saturated[i] = true;
  }
  cancel.throw_if_cancelled();
  for (const FaceCode face : outer_faces(tetrahedra, cancel)) {
    for (const BallIndex i : face_vertices(tetrahedra, face)) saturated[i] = false;
  }
  return saturated;
}

ThesisRounds make_thesis_rounds(const std::shared_ptr<const BallSet>& balls,
                                const std::shared_ptr<WorkThreads>& threads,
                                const RunContext& context) {
  ThesisRounds result;
  threads->run([&] { result = Rounds(balls, threads, context).run(); });
  return result;
}

}  // namespace alphascope
