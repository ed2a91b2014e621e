// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the bottlenecks of many places with one search for each. All searches share each
// triangulation of the grown balls.
#include "core/channel/bottlenecks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "core/channel/passage.hpp"
#include "core/clearance/clearance.hpp"
#include "core/clearance/empty_space.hpp"
#include "core/clearance/equal_clearance.hpp"
#include "core/clearance/grown_triangulation.hpp"

namespace alphascope {
namespace {

// The search for one distinct place. Lengths are in lattice units; growths are multiples of the
// step.
struct End {
  // Largest growth known to connect the place to the outside; negative: not even 0
  std::int64_t open_at = -1;
  std::int64_t closed_at = 0;  // smallest growth known to cut the place off
  bool way_known = false;
  double width = 0;     // of the widest way found at open_at
  RealPoint narrowest;  // Å, where that way has this width
  // Number of growths above `width` that were open, so that `width` was a guess too low
  int too_low = 0;

  bool done(std::int64_t step) const { return closed_at - open_at <= step; }
};

class Finder {
 public:
  Finder(const BallSet& balls, const std::vector<RealPoint>& places, const RunContext& context)
      : balls_(on_passage_lattice(balls, places)), clearance_(balls_), context_(context) {
    const std::int64_t fine = passage_step(balls_.lattice);
    const auto wanted =
        static_cast<std::int64_t>(balls_.lattice.nearest_units(kBottleneckStepAngstrom));
    step_ = std::max(fine, wanted / fine * fine);
    for (const RealPoint& p : places) add(p);
    if (points_.empty()) return;
    scene_ends_.from = points_.front();
    scene_ends_.others.assign(points_.begin() + 1, points_.end());
    scenes_.emplace(balls_, scene_ends_);
  }

  Bottlenecks find();

 private:
  static constexpr std::size_t kCovered = ~std::size_t{0};

  void add(const RealPoint& place);
  std::optional<std::int64_t> next_growth() const;
  void ask(std::int64_t growth);
  WayWidth width_in(const GrownTriangulation& scene, std::int64_t growth) const;
  EqualClearance gap_of(const GrownTriangulation& scene,
                        const std::array<BallIndex, 3>& triangle) const;
  RealPoint narrowest_of(const GrownTriangulation& scene, const EmptySpace::WayOut& way) const;
  Bottleneck answer(std::size_t place) const;

  BallSet balls_;
  Clearance clearance_;
  const RunContext& context_;
  std::int64_t step_ = 1;
  std::vector<LatticePoint> points_;  // distinct places outside all balls
  std::vector<End> ends_;             // one for each of points_
  std::vector<std::size_t> end_of_;   // for each place its index in points_, or kCovered
  std::vector<RealPoint> rounded_;    // each place on the lattice, Å
  std::map<std::tuple<int, int, int>, std::size_t> seen_;
  PassageEnds scene_ends_;
  std::optional<GrownTriangulations> scenes_;
  int triangulations_ = 0;
};

void Finder::add(const RealPoint& place) {
  const LatticePoint point = nearest_lattice_point(balls_.lattice.units_per_angstrom() * place);
  rounded_.push_back(balls_.lattice.unit_angstrom() * real_point(point));
  const auto [at, first] = seen_.try_emplace(std::tuple(point.x, point.y, point.z), points_.size());
  if (first) {
    const std::int64_t room = growth_room(balls_, point);
    if (room < 0) {
      at->second = kCovered;
    } else {
      points_.push_back(point);
      End& end = ends_.emplace_back();
      end.open_at = -step_;
      end.closed_at = room / step_ * step_ + step_;
    }
  }
  end_of_.push_back(at->second);
}

// Returns the lowest growth that any unfinished search needs next. One triangulation at a low
// growth serves all searches: a search for which it is open gets a better guess.
std::optional<std::int64_t> Finder::next_growth() const {
  constexpr int kPatience = 3;
  std::optional<std::int64_t> lowest;
  for (const End& end : ends_) {
    if (end.done(step_)) continue;
    const auto guess =
        static_cast<std::int64_t>(std::floor(end.width / static_cast<double>(step_))) * step_;
    std::int64_t growth = std::clamp(guess, end.open_at, end.closed_at - step_);
    if (growth == end.open_at) growth += step_;
    if (end.too_low > kPatience) {
      growth = end.open_at + (end.closed_at - end.open_at) / step_ / 2 * step_;
    }
    if (!lowest || growth < *lowest) lowest = growth;
  }
  return lowest;
}

// The narrowest place between the three balls of a triangle. It is not found if a corner is a
// helping ball (far away, or an end), which has a higher index.
EqualClearance Finder::gap_of(const GrownTriangulation& scene,
                              const std::array<BallIndex, 3>& triangle) const {
  if (triangle[2] >= scene.original.size()) return {};
  return equal_clearance(balls_, {scene.original[triangle[0]], scene.original[triangle[1]],
                                  scene.original[triangle[2]]});
}

WayWidth Finder::width_in(const GrownTriangulation& scene, std::int64_t growth) const {
  const double units = balls_.lattice.units_per_angstrom();
  const auto at_gap = [&, units](const std::array<BallIndex, 3>& triangle) {
    const EqualClearance gap = gap_of(scene, triangle);
    return gap.found ? std::optional(gap.clearance_angstrom * units) : std::nullopt;
  };
  return {at_gap, static_cast<double>(growth), static_cast<BallIndex>(scene.original.size())};
}

RealPoint Finder::narrowest_of(const GrownTriangulation& scene,
                               const EmptySpace::WayOut& way) const {
  const EmptySpace space(scene.balls, scene.triangulation);
  const double unit = balls_.lattice.unit_angstrom();
  if (space.is_gap(way.tetrahedron, way.face)) {
    const EqualClearance gap = gap_of(scene, space.face(way.tetrahedron, way.face));
    if (gap.found) return gap.place_angstrom;
  }
  const std::uint32_t across = scene.triangulation.neighbours[way.tetrahedron][way.face].index();
  const RealPoint own = unit * space.corner(way.tetrahedron), other = unit * space.corner(across);
  return clearance_.at(own) < clearance_.at(other) ? own : other;
}

// Updates each search with the triangulation at this growth. All tetrahedra around an end's ball
// belong to one open space, so the widest of their ways counts.
void Finder::ask(std::int64_t growth) {
  RunContext quiet;
  quiet.cancel = context_.cancel;
  const auto scene = scenes_->at(growth, quiet);
  ++triangulations_;
  const EmptySpace space(scene->balls, scene->triangulation);
  const auto ways = space.widest_ways_out(width_in(*scene, growth), context_.cancel);
  std::vector<const EmptySpace::WayOut*> widest(points_.size(), nullptr);
  const auto end = scene->from + static_cast<BallIndex>(points_.size());
  for (std::size_t t = 0; t < ways.size(); ++t) {
    for (const BallIndex ball : scene->triangulation.tetrahedra[t]) {
      if (ball < scene->from || ball >= end) continue;
      const EmptySpace::WayOut*& best = widest[ball - scene->from];
      if (best == nullptr || ways[t].width > best->width) best = &ways[t];
    }
  }
  for (std::size_t n = 0; n < ends_.size(); ++n) {
    End& e = ends_[n];
    if (e.done(step_) || growth < e.open_at || growth >= e.closed_at) continue;
    if (widest[n] == nullptr || widest[n]->width < 0) {
      e.closed_at = growth;
      continue;
    }
    e.too_low += e.open_at >= 0 && static_cast<double>(growth) > e.width;
    e.open_at = growth;
    e.width = std::min(widest[n]->width, static_cast<double>(e.closed_at));
    e.way_known = widest[n]->tetrahedron != EmptySpace::WayOut::kNoFace;
    if (e.way_known) e.narrowest = narrowest_of(*scene, *widest[n]);
  }
}

Bottleneck Finder::answer(std::size_t place) const {
  constexpr double kTouching = 0.01;  // Å
  Bottleneck bottleneck;
  if (end_of_[place] == kCovered) return bottleneck;
  const End& end = ends_[end_of_[place]];
  bottleneck.kind = Bottleneck::Kind::closed;
  if (end.open_at < 0) return bottleneck;
  const Lattice& lattice = balls_.lattice;
  const auto angstrom = [&](std::int64_t units) {
    return lattice.angstrom(static_cast<double>(units));
  };
  bottleneck.at_least_angstrom = angstrom(end.open_at);
  bottleneck.below_angstrom = angstrom(end.closed_at);
  const double room = clearance_.at(rounded_[place]);
  const bool at_end = !end.way_known || room <= lattice.unit_angstrom() * end.width;
  bottleneck.kind = at_end ? Bottleneck::Kind::end : Bottleneck::Kind::passage;
  bottleneck.place_angstrom = at_end ? rounded_[place] : end.narrowest;
  const double width = at_end ? room : lattice.unit_angstrom() * end.width;
  // The width is rounded. If it contradicts the exact bounds, the lower bound replaces it.
  const bool good = width >= bottleneck.at_least_angstrom && width < bottleneck.below_angstrom;
  bottleneck.radius_angstrom = good ? width : bottleneck.at_least_angstrom;
  std::vector<Surface> surfaces;
  clearance_.collect(bottleneck.place_angstrom,
                     clearance_.at(bottleneck.place_angstrom) + kTouching, surfaces);
  for (const Surface& surface : surfaces) bottleneck.touching.push_back(surface.ball);
  std::sort(bottleneck.touching.begin(), bottleneck.touching.end());
  return bottleneck;
}

Bottlenecks Finder::find() {
  Bottlenecks result;
  if (!points_.empty()) ask(0);
  while (const auto growth = next_growth()) {
    const auto done =
        std::count_if(ends_.begin(), ends_.end(), [&](const End& end) { return end.done(step_); });
    context_.report(kBottlenecksStage,
                    static_cast<double>(done) / static_cast<double>(ends_.size()));
    ask(*growth);
  }
  for (std::size_t n = 0; n < end_of_.size(); ++n) result.of.push_back(answer(n));
  result.triangulations = triangulations_;
  return result;
}

}  // namespace

Bottlenecks find_bottlenecks(const BallSet& balls, const std::vector<RealPoint>& places_angstrom,
                             const RunContext& context) {
  if (balls.size() == 0) throw std::invalid_argument("without balls there are no bottlenecks");
  return Finder(balls, places_angstrom, context).find();
}

}  // namespace alphascope
