// SPDX-License-Identifier: GPL-3.0-or-later
// Collects points of cavities from the tables that were followed.
#include "core/cavity_identity/cavity_trace.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/cavity_identity/cavity_numbers.hpp"

namespace alphascope {
namespace {

using Point = std::shared_ptr<const TracedPoint>;

Point point_of(const CavityNumbers& numbers) {
  const CavityTable& table = *numbers.table;
  TracedPoint point;
  point.solvent_radius_angstrom = table.question.solvent_radius_angstrom;
  point.cavities.reserve(numbers.of.size());
  for (std::size_t c = 0; c < numbers.of.size(); ++c) {
    const CavityMeasures& m = table.measures[c];
    const Cavity& cavity = table.found.cavities[c];
    const auto mouths = static_cast<std::uint32_t>(cavity.mouths.size());
    point.cavities.push_back({m.volume_sa_angstrom3, m.area_sa_angstrom2, numbers.of[c], mouths});
    TracedTotals& totals = cavity.is_void() ? point.voids : point.pockets;
    totals.volume_sa_angstrom3 += m.volume_sa_angstrom3;
    totals.area_sa_angstrom2 += m.area_sa_angstrom2;
    totals.mouths += mouths;
  }
  std::sort(point.cavities.begin(), point.cavities.end(),
            [](const TracedCavity& a, const TracedCavity& b) { return a.number < b.number; });
  return std::make_shared<const TracedPoint>(std::move(point));
}

bool differ_in_radius_at_most(CavityParameters a, const CavityParameters& b) {
  a.solvent_radius_angstrom = b.solvent_radius_angstrom;
  return a == b;
}

// The distance between the neighbours of a point. Infinite at the ends.
double gap_around(const std::vector<Point>& points, std::size_t n) {
  if (n == 0 || n + 1 == points.size()) return HUGE_VAL;
  return points[n + 1]->solvent_radius_angstrom - points[n - 1]->solvent_radius_angstrom;
}

std::size_t cavities_in(const std::vector<Point>& points) {
  std::size_t cavities = 0;
  for (const Point& point : points) cavities += point->cavities.size();
  return cavities;
}

void thin_out(std::vector<Point>& points, const Point& newest, const TraceLimits& limits) {
  std::size_t cavities = cavities_in(points);
  while (points.size() > 1 && (points.size() > limits.points || cavities > limits.cavities)) {
    std::size_t least = points.size();
    for (std::size_t n = 0; n < points.size(); ++n) {
      if (points[n] == newest) continue;
      if (least == points.size() || gap_around(points, n) < gap_around(points, least)) least = n;
    }
    cavities -= points[least]->cavities.size();
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(least));
  }
}

}  // namespace

const TracedCavity* TracedPoint::find(std::uint32_t number) const {
  const auto at =
      std::lower_bound(cavities.begin(), cavities.end(), number,
                       [](const TracedCavity& c, std::uint32_t n) { return c.number < n; });
  return at != cavities.end() && at->number == number ? &*at : nullptr;
}

std::shared_ptr<const CavityTrace> next_trace(const CavityTrace* before,
                                              const CavityNumbers& numbers,
                                              const TraceLimits& limits) {
  CavityTrace trace;
  trace.question = numbers.table->question;
  const bool goes_on = before != nullptr && numbers.steps > 0 &&
                       differ_in_radius_at_most(before->question, trace.question);
  if (goes_on) trace.points = before->points;
  const Point newest = point_of(numbers);
  const auto at =
      std::lower_bound(trace.points.begin(), trace.points.end(), newest->solvent_radius_angstrom,
                       [](const Point& p, double r) { return p->solvent_radius_angstrom < r; });
  if (at != trace.points.end() &&
      (*at)->solvent_radius_angstrom == newest->solvent_radius_angstrom) {
    *at = newest;
  } else {
    trace.points.insert(at, newest);
  }
  thin_out(trace.points, newest, limits);
  return std::make_shared<const CavityTrace>(std::move(trace));
}

std::uint64_t bytes_of(const CavityTrace& trace) {
  constexpr std::size_t kPoint = sizeof(TracedPoint) + sizeof(Point);
  return trace.points.size() * kPoint + cavities_in(trace.points) * sizeof(TracedCavity);
}

}  // namespace alphascope
