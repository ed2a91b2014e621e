// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the rounds. `open_` are the known tetrahedra with an unsaturated ball. A tetrahedron that is
// still unknown has unsaturated balls only, as a saturated one knows its whole star.
//
// Which balls a round needs. Let U be the balls that are neither saturated nor known to be hidden,
// and S those of U and of open_. The tetrahedra of S that have balls of U only are in T.
// Proof. Let i be such a ball.
// 1. If i is a vertex of T, then S has all its neighbours in T: the edge to a neighbour is in a
//    known tetrahedron, which is in open_, or in unknown ones only, and then the neighbour is in U.
//    So the cell of i is the same for S as for all balls, and so are the tetrahedra with i.
// 2. If i is hidden, its centre lies in a tetrahedron of T that is not known yet, since otherwise i
//    would be known to be hidden. That tetrahedron has balls of U only. No ball is in conflict with
//    it, so it is a tetrahedron of S, too. It contains the centre of i, so i is no vertex for S.
// Ties do not matter, as the perturbation follows the order of the centres, which S keeps. ∎
// So hidden balls leave when a tetrahedron around them is known. A ball is hidden if its centre is
// in a tetrahedron of T of which it is no corner, as two simplices of T share faces only.
#include "core/rounds/thesis_rounds.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

#include "core/complex/alpha_complex.hpp"
#include "core/complex/face_code.hpp"
#include "core/complex/triangulation.hpp"
#include "core/engine/engine.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/predicates/perturbation.hpp"
#include "core/predicates/spanning_balls.hpp"
#include "core/run/parallel.hpp"
#include "core/run/stage_timer.hpp"
#include "core/run/work_threads.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "core/triangulation/outer_faces.hpp"

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
  saturated,
  hidden  // its centre is in a known tetrahedron of other balls
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

struct Unseen {
  LatticePoint centre;
  BallIndex ball;
};

class Rounds {
 public:
  Rounds(std::shared_ptr<const BallSet> balls, const std::shared_ptr<WorkThreads>& threads,
         const RunContext& context)
      : balls_(std::move(balls)),
        threads_(threads),
        context_(context),
        states_(balls_->size(), BallState::unseen) {
    unseen_.reserve(balls_->size());
    for (std::size_t i = 0; i < balls_->size(); ++i) {
      unseen_.push_back({balls_->centres[i], static_cast<BallIndex>(i)});
    }
    std::sort(unseen_.begin(), unseen_.end(),
              [](const Unseen& a, const Unseen& b) { return a.centre.x < b.centre.x; });
  }

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
    result.on_hull = count(BallState::open);
    timer.finish();
    result.milliseconds = times.wall_milliseconds;
    return result;
  }

 private:
  std::size_t count(BallState state) const {
    return static_cast<std::size_t>(std::count(states_.begin(), states_.end(), state));
  }

  template <class Body>
  ThesisRound timed(const Body& body) {
    StageTimes times;
    StageTimer timer(times);
    ThesisRound round;
    body(round);
    round.tetrahedra = known_;
    round.saturated = count(BallState::saturated);
    round.hidden = count(BallState::hidden);
    round.unsaturated = balls_->size() - round.saturated - round.hidden;
    timer.finish();
    round.milliseconds = times.wall_milliseconds;
    return round;
  }

  void grow(const Alpha& alpha, ThesisRound& round) {
    round.alpha_angstrom2 = alpha;
    const Part part = part_of(balls_, needed());
    context_.cancel.throw_if_cancelled();
    const auto engine =
        make_cpu_engine(part.balls, {.threads = threads_->asked(), .shared = threads_});
    AlphaComplex complex = engine->compute({alpha, true}, context_);
    round.route = complex.engine.route;
    take(part, std::move(complex.tetrahedra.simplices), round);
  }

  void complete(ThesisRound& round) {
    round.alpha_angstrom2 = Alpha(HUGE_VAL);
    const Part part = part_of(balls_, needed());
    Triangulation made = make_triangulation(*part.balls, 0, context_);
    round.route = kCompletionRoute;
    take(part, std::move(made.tetrahedra), round);
  }

  // The balls that the next round computes, ascending.
  std::vector<BallIndex> needed() const {
    std::vector<bool> in(states_.size());
    for (std::size_t i = 0; i < states_.size(); ++i) in[i] = is_left(static_cast<BallIndex>(i));
    for (const Tetrahedron& t : open_) {
      for (const BallIndex i : t) in[i] = true;
    }
    std::vector<BallIndex> chosen;
    for (std::size_t i = 0; i < in.size(); ++i) {
      if (in[i]) chosen.push_back(static_cast<BallIndex>(i));
    }
    return chosen;
  }

  // Is ball i in U?
  bool is_left(BallIndex i) const {
    return states_[i] == BallState::unseen || states_[i] == BallState::open;
  }

  // Takes what a round has found, and notes who leaves.
  void take(const Part& part, Simplices<4> tetrahedra, ThesisRound& round) {
    context_.cancel.throw_if_cancelled();
    round.balls = part.balls->size();
    if (!part.is_all()) {
      parallel_many(tetrahedra.size(), context_.cancel, [&](std::size_t n) {
        for (BallIndex& i : tetrahedra[n]) i = part.original[i];
      });
    }
    std::erase_if(tetrahedra, [&](const Tetrahedron& t) {
      return !std::all_of(t.begin(), t.end(), [&](BallIndex i) { return is_left(i); });
    });
    Simplices<4> fresh;
    std::set_difference(tetrahedra.begin(), tetrahedra.end(), open_.begin(), open_.end(),
                        std::back_inserter(fresh));
    Simplices<4> both;
    both.reserve(open_.size() + fresh.size());
    std::merge(open_.begin(), open_.end(), fresh.begin(), fresh.end(), std::back_inserter(both));
    open_ = std::move(both);
    known_ += fresh.size();
    round.new_tetrahedra = fresh.size();
    context_.cancel.throw_if_cancelled();
    for (const Tetrahedron& t : fresh) {
      for (const BallIndex i : t) states_[i] = BallState::open;
    }
    mark_hidden(fresh);
    const bool some_left = mark_saturated();
    changed_ = !fresh.empty() || some_left;
  }

  // Finds the balls whose centres are in a new tetrahedron. They were in no older one.
  void mark_hidden(const Simplices<4>& fresh) {
    std::erase_if(unseen_, [&](const Unseen& u) { return states_[u.ball] != BallState::unseen; });
    std::vector<std::atomic<bool>> inside(unseen_.size());
    parallel_many(fresh.size(), context_.cancel, [&](std::size_t n) {
      const Box box = box_of(fresh[n]);
      auto at = std::partition_point(unseen_.begin(), unseen_.end(),
                                     [&](const Unseen& u) { return u.centre.x < box.low.x; });
      for (; at != unseen_.end() && at->centre.x <= box.high.x; ++at) {
        if (!box.contains(at->centre) || !has_inside(fresh[n], at->ball)) continue;
        inside[static_cast<std::size_t>(at - unseen_.begin())].store(true,
                                                                     std::memory_order_relaxed);
      }
    });
    for (std::size_t n = 0; n < unseen_.size(); ++n) {
      if (inside[n]) states_[unseen_[n].ball] = BallState::hidden;
    }
  }

  // The box around the corners of a tetrahedron.
  struct Box {
    LatticePoint low, high;
    bool contains(const LatticePoint& p) const {
      return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y && p.z >= low.z &&
             p.z <= high.z;
    }
  };
  Box box_of(const Tetrahedron& t) const {
    Box box{balls_->centres[t[0]], balls_->centres[t[0]]};
    for (const BallIndex i : t) {
      const LatticePoint& p = balls_->centres[i];
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
    }
    return box;
  }

  // Is the centre of ball i in the tetrahedron or on its surface? Exact.
  bool has_inside(const Tetrahedron& t, BallIndex i) const {
    const LiftedInt a = lifted_vector(*balls_, i, t[0]), b = lifted_vector(*balls_, i, t[1]),
                    c = lifted_vector(*balls_, i, t[2]), d = lifted_vector(*balls_, i, t[3]);
    // The signs of the four parts of the tetrahedron's volume that the centre makes.
    const int parts[] = {orientation(b, c, d), -orientation(a, c, d), orientation(a, b, d),
                         -orientation(a, b, c)};
    const auto [least, most] = std::minmax_element(std::begin(parts), std::end(parts));
    return *least >= 0 || *most <= 0;
  }

  // Finds the balls that are saturated now. Returns whether there are any.
  bool mark_saturated() {
    const std::vector<bool> closed = saturated_balls(states_.size(), open_, context_.cancel);
    bool any = false;
    for (std::size_t i = 0; i < states_.size(); ++i) {
      if (states_[i] != BallState::open || !closed[i]) continue;
      states_[i] = BallState::saturated;
      any = true;
    }
    const auto is_finished = [&](const Tetrahedron& t) {
      return std::none_of(t.begin(), t.end(), [&](BallIndex i) { return is_left(i); });
    };
    std::copy_if(open_.begin(), open_.end(), std::back_inserter(finished_), is_finished);
    std::erase_if(open_, is_finished);
    context_.cancel.throw_if_cancelled();
    return any;
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
  Simplices<4> open_;           // in lexicographic order
  Simplices<4> finished_;       // all of whose balls are saturated
  std::vector<Unseen> unseen_;  // by x; some may have been seen since
  std::size_t known_ = 0;
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
