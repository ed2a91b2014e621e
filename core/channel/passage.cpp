// SPDX-License-Identifier: GPL-3.0-or-later
// Searches the largest growth that leaves a passage open, and draws a curve through it.
#include "core/channel/passage.hpp"

#include <tbb/task_group.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "core/channel/walk.hpp"
#include "core/clearance/empty_space.hpp"
#include "core/clearance/equal_clearance.hpp"
#include "core/clearance/plane_ascent.hpp"
#include "core/geometry/alpha.hpp"
#include "core/run/internal_error.hpp"

namespace alphascope {
namespace {

// The largest g, a multiple of the step, with (radius + g)² < square; radius + g may be negative.
std::int64_t room_of_one(std::int64_t square, std::int64_t radius, std::int64_t step) {
  auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(square))) + 2;
  while (root > 0 && root * root >= square) --root;
  const std::int64_t most = square == 0 ? -radius - 1 : root - radius;
  return most >= 0 ? most / step * step : -((-most + step - 1) / step) * step;
}

class Search {
 public:
  Search(const BallSet& balls, const Clearance& clearance, const PassageEnds& ends,
         const RunContext& context)
      : balls_(balls),
        clearance_(clearance),
        ends_(ends),
        context_(context),
        step_(passage_step(balls.lattice)),
        scenes_(balls, ends) {
    most_ = growth_room(balls, ends.from);
    if (ends.to) most_ = std::min(most_, growth_room(balls, *ends.to));
  }

  Passage run();

 private:
  // An open growth: its scene and the widest way through it.
  struct Open {
    std::shared_ptr<const GrownTriangulation> scene;
    EmptySpace::Way way;
  };

  std::optional<Open> ask(std::int64_t growth, bool report) const;
  void ask_all(const std::vector<std::int64_t>& growths);
  EqualClearance gap_at_wall(const std::array<BallIndex, 2>& two) const;
  std::optional<PassageGap> gap_of(const GrownTriangulation& scene,
                                   const std::array<BallIndex, 3>& triangle) const;
  std::vector<PassageGap> gaps_on(const Open& open, const EmptySpace::Way& way) const;
  std::vector<std::int64_t> next_growths() const;
  double narrowest_on(const Open& open, double most) const;
  std::vector<RealPoint> curve_of(const Open& open, const EmptySpace::Way& way) const;
  void set_curve(const Open& open, Passage& passage) const;

  const BallSet& balls_;
  const Clearance& clearance_;
  const PassageEnds& ends_;
  const RunContext& context_;
  const std::int64_t step_;
  const GrownTriangulations scenes_;
  std::int64_t most_ = 0;  // largest growth that leaves both ends uncovered
  std::int64_t open_at_ = 0, closed_at_ = 0;
  static constexpr int kSlowRounds = 2;
  int slow_rounds_ = 0;  // number of consecutive rounds that did not halve the interval
  std::optional<Open> open_;
  int triangulations_ = 0;
};

std::optional<Search::Open> Search::ask(std::int64_t growth, bool report) const {
  RunContext quiet;
  quiet.cancel = context_.cancel;
  Open open{scenes_.at(growth, report ? context_ : quiet), {}};
  const GrownTriangulation& scene = *open.scene;
  const EmptySpace space(scene.balls, scene.triangulation);
  const double units = balls_.lattice.units_per_angstrom();
  const auto at_gap = [&](const std::array<BallIndex, 3>& triangle) -> std::optional<double> {
    const auto gap = gap_of(scene, triangle);
    if (!gap) return std::nullopt;
    return gap->clearance_angstrom * units;
  };
  std::optional<EmptySpace::Way> way = space.widest_way(
      scene.from, scene.to,
      {at_gap, static_cast<double>(growth), static_cast<BallIndex>(scene.original.size())},
      context_.cancel);
  if (!way) return std::nullopt;
  open.way = std::move(*way);
  return open;
}

// Tests all growths at once. `growths` must rise. Only the caller's thread reports progress.
void Search::ask_all(const std::vector<std::int64_t>& growths) {
  std::vector<std::optional<Open>> answers(growths.size());
  tbb::task_group others;
  for (std::size_t n = 1; n < growths.size(); ++n) {
    others.run([&, n] { answers[n] = ask(growths[n], false); });
  }
  try {
    answers[0] = ask(growths[0], true);
  } catch (...) {
    others.cancel();
    others.wait();
    throw;
  }
  others.wait();
  triangulations_ += static_cast<int>(growths.size());
  for (std::size_t n = 0; n < growths.size(); ++n) {
    if (answers[n]) {
      open_at_ = growths[n];
      open_ = std::move(answers[n]);
    } else {
      closed_at_ = std::min(closed_at_, growths[n]);
    }
  }
}

// The wall is nearly flat. So the place is searched in the plane that touches the wall at the last
// place found, a few times.
EqualClearance Search::gap_at_wall(const std::array<BallIndex, 2>& two) const {
  Plane plane{real_point(ends_.from), *ends_.direction};
  EqualClearance place = equal_clearance_in_plane(balls_, two, plane);
  const RealPoint centre = real_point(scenes_.wall()->centre);
  for (int n = 0; n < 3 && place.found; ++n) {
    const RealPoint at = balls_.lattice.units_per_angstrom() * place.place_angstrom;
    plane.normal = unit_vector(at - centre);
    plane.point = centre + static_cast<double>(scenes_.wall()->radius) * plane.normal;
    place = equal_clearance_in_plane(balls_, two, plane);
  }
  return place;
}

// The gap between three balls, or between two balls and the plane.
std::optional<PassageGap> Search::gap_of(const GrownTriangulation& scene,
                                         const std::array<BallIndex, 3>& triangle) const {
  const auto ball_end = static_cast<BallIndex>(scene.original.size());
  const bool at_wall = scenes_.wall() && triangle[2] + 1 == scene.balls.size();
  if (triangle[1] >= ball_end || (triangle[2] >= ball_end && !at_wall)) return std::nullopt;
  const auto ball = [&](std::size_t n) { return scene.original[triangle[n]]; };
  const EqualClearance place = at_wall ? gap_at_wall({ball(0), ball(1)})
                                       : equal_clearance(balls_, {ball(0), ball(1), ball(2)});
  if (!place.found) return std::nullopt;
  return PassageGap{place.place_angstrom, place.clearance_angstrom, at_wall};
}

std::vector<PassageGap> Search::gaps_on(const Open& open, const EmptySpace::Way& way) const {
  std::vector<PassageGap> gaps;
  const EmptySpace space(open.scene->balls, open.scene->triangulation);
  for (const auto& triangle : space.gaps(way)) {
    if (const auto gap = gap_of(*open.scene, triangle)) gaps.push_back(*gap);
  }
  return gaps;
}

// Guesses the growth at which the way closes (lattice units), at most `most`. The guess is its
// least clearance after narrow places were moved to local maxima. Only places narrower than all
// before are moved.
double Search::narrowest_on(const Open& open, double most) const {
  constexpr double kStep = 0.1, kFarthest = 2, kSame = 0.02;  // Å
  const double unit = balls_.lattice.unit_angstrom();
  double narrowest = most * unit;
  RealPoint place;
  const std::vector<RealPoint> curve = curve_of(open, open.way);
  for (Walk walk(curve); !walk.at_end();) {
    context_.cancel.throw_if_cancelled();
    const double here = clearance_.at(walk.place());
    if (here < narrowest) {
      const Ascent ascent = ascend_in_plane(clearance_, walk.place(), walk.direction(),
                                            {0.2, 1e-4, narrowest, kFarthest});
      const double risen = clearance_.at(ascent.place);
      if (risen < narrowest) {
        narrowest = risen;
        place = ascent.place;
      }
    }
    walk.advance(std::max(here - narrowest, kStep));
  }
  std::vector<Surface> near;
  clearance_.collect(place, narrowest + kSame, near);
  if (narrowest < most * unit && near.size() >= 3) {
    const EqualClearance exact =
        equal_clearance(balls_, {near[0].ball, near[1].ball, near[2].ball});
    if (exact.found && std::fabs(exact.clearance_angstrom - narrowest) < kSame) {
      narrowest = exact.clearance_angstrom;
    }
  }
  for (const PassageGap& gap : gaps_on(open, open.way)) {
    if (gap.at_wall) narrowest = std::min(narrowest, gap.clearance_angstrom);
  }
  return narrowest / unit;
}

// Tests the growth at which the widest way closes, and one step more; this is mostly the answer.
// The way itself is a guess and may be wrong. After slow rounds the middle of the interval is
// tested too, so that the search ends.
std::vector<std::int64_t> Search::next_growths() const {
  std::vector<std::int64_t> growths;
  const auto add = [&](std::int64_t growth) {
    if (growth > open_at_ && growth < closed_at_) growths.push_back(growth);
  };
  if (open_) {
    const double narrowest = narrowest_on(*open_, static_cast<double>(most_));
    const auto guess =
        static_cast<std::int64_t>(std::floor(narrowest / static_cast<double>(step_))) * step_;
    add(guess);
    add(guess + step_);
  }
  if (growths.empty() || slow_rounds_ >= kSlowRounds) {
    const std::int64_t steps = (closed_at_ - open_at_) / step_;
    add(open_at_ + steps / 2 * step_);
  }
  std::sort(growths.begin(), growths.end());
  growths.erase(std::unique(growths.begin(), growths.end()), growths.end());
  return growths;
}

Passage Search::run() {
  closed_at_ = most_ + step_;
  const std::int32_t largest = *std::max_element(balls_.radii.begin(), balls_.radii.end());
  // At this growth no ball is left, so the passage is open.
  open_at_ = -((largest + step_ - 1) / step_) * step_;
  if (0 < closed_at_) ask_all({0});
  while (closed_at_ - open_at_ > step_) {
    const std::int64_t span = closed_at_ - open_at_;
    ask_all(next_growths());
    slow_rounds_ = closed_at_ - open_at_ > span / 2 ? slow_rounds_ + 1 : 0;
  }
  if (!open_) ask_all({open_at_});
  if (!open_) throw InternalError("A passage without balls is closed.");
  Passage passage;
  passage.widest = open_at_;
  passage.ends_decide = open_at_ == most_;
  passage.triangulations = triangulations_;
  set_curve(*open_, passage);
  return passage;
}

void Search::set_curve(const Open& open, Passage& passage) const {
  const BallSet& balls = open.scene->balls;
  const EmptySpace space(balls, open.scene->triangulation);
  const auto ball_end = static_cast<BallIndex>(open.scene->original.size());
  // If the balls have hardly grown, clearances near 0 would make any detour cheap. So the growth
  // counts as at least this (Å).
  constexpr double kLeast = 0.1, kEnough = 10;  // Å
  const double grown = std::max(static_cast<double>(open_at_), balls.lattice.nearest_units(kLeast));
  const WayCost cost{grown, std::max(2 * grown, balls.lattice.nearest_units(kEnough)), ball_end};
  const GrownTriangulation& scene = *open.scene;
  const auto way = space.cheapest_way(scene.from, scene.to, cost, context_.cancel);
  if (!way) throw InternalError("An open passage has no way.");
  passage.gaps = gaps_on(open, *way);
  passage.curve = curve_of(open, *way);
}

// The corners of a way from end to end, Å.
std::vector<RealPoint> Search::curve_of(const Open& open, const EmptySpace::Way& way) const {
  const EmptySpace space(open.scene->balls, open.scene->triangulation);
  std::vector<RealPoint> places{real_point(ends_.from)};
  for (const std::uint32_t t : way) places.push_back(space.corner(t));
  if (ends_.to) places.push_back(real_point(*ends_.to));
  for (RealPoint& p : places) p = balls_.lattice.unit_angstrom() * p;
  return places;
}

}  // namespace

std::int64_t passage_step(const Lattice& lattice) {
  std::int64_t step = 1;
  for (int digits = 3; digits < lattice.digits; ++digits) step *= 10;
  return step;
}

std::int64_t growth_room(const BallSet& balls, const LatticePoint& point) {
  const std::int64_t step = passage_step(balls.lattice);
  std::int64_t room = std::numeric_limits<std::int64_t>::max();
  for (BallIndex i = 0; i < balls.size(); ++i) {
    const std::int64_t square = square_distance(point, balls.centres[i]);
    room = std::min(room, room_of_one(square, balls.radii[i], step));
  }
  return room;
}

Passage widest_passage(const BallSet& balls, const Clearance& clearance, const PassageEnds& ends,
                       const RunContext& context) {
  return Search(balls, clearance, ends, context).run();
}

}  // namespace alphascope
