// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the graph of empty tetrahedra.
#include "core/channel/way_graph.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "core/predicates/exact_alpha.hpp"
#include "core/run/parallel.hpp"
#include "core/triangulation/indices_where.hpp"

namespace alphascope {
namespace {

enum WayKind : std::uint8_t { kWayFull, kWayInside, kWayOutside };

// A place outside all balls, far enough away to change nothing near them.
LatticePoint beside(const BallSet& balls) {
  LatticePoint low = balls.centres.front();
  for (const LatticePoint& p : balls.centres) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  }
  const std::int32_t largest = *std::max_element(balls.radii.begin(), balls.radii.end());
  const auto away = static_cast<std::int32_t>(2 * largest + balls.lattice.nearest_units(1));
  return {low.x - away, low.y - away, low.z - away};
}

}  // namespace

WayAxis::WayAxis(const BallSet& balls, const std::vector<BallIndex>& part, const RealPoint& axis)
    : axis_(axis),
      low_(std::numeric_limits<double>::infinity()),
      high_(-std::numeric_limits<double>::infinity()) {
  const double unit = balls.lattice.unit_angstrom();
  for (const BallIndex ball : part) {
    const RealPoint p = unit * real_point(balls.centres[ball]);
    middle_ = middle_ + p;
    low_ = std::min(low_, along(p));
    high_ = std::max(high_, along(p));
  }
  middle_ = (1 / static_cast<double>(part.size())) * middle_;
  // Each slab is averaged with two neighbours on both sides. A single slab has too few atoms to
  // locate the part.
  constexpr std::size_t kBeside = 2;
  near_.assign(static_cast<std::size_t>((high_ - low_) / kSlab) + 1, 0);
  std::vector<double> count(near_.size(), 0);
  for (const BallIndex ball : part) {
    const RealPoint p = unit * real_point(balls.centres[ball]);
    const double away = from_axis(p);
    const std::size_t slab = slab_of(along(p));
    const std::size_t last = std::min(slab + kBeside, near_.size() - 1);
    for (std::size_t n = slab > kBeside ? slab - kBeside : 0; n <= last; ++n) {
      near_[n] += away * away;
      ++count[n];
    }
  }
  for (std::size_t n = 0; n < near_.size(); ++n) {
    near_[n] = count[n] > 0 ? std::sqrt(near_[n] / count[n]) / 2 : 0;
  }
}

std::size_t WayAxis::slab_of(double along) const {
  return std::min(static_cast<std::size_t>(std::max(0.0, along - low_) / kSlab), near_.size() - 1);
}

double WayAxis::from_axis(const RealPoint& x) const {
  const RealPoint away = x - middle_;
  return length(away - dot(axis_, away) * axis_);
}

int WayAxis::zone(const RealPoint& x) const {
  const double third = (high_ - low_) / 3, at = along(x);
  return at < low_ + third ? -1 : at > high_ - third ? 1 : 0;
}

bool WayAxis::is_near(const RealPoint& x) const {
  return from_axis(x) <= near_[slab_of(along(x))];
}

bool WayAxis::stays_near_axis(const RealPoint& from, const RealPoint& to) const {
  const double third = (high_ - low_) / 3, low = low_ + third, high = high_ - third;
  const double begin = along(from), end = along(to);
  if (std::max(begin, end) < low || std::min(begin, end) > high) return true;
  if (begin == end) return is_near(from) && is_near(to);
  const auto place = [&](double height) {
    return from + ((std::clamp(height, low, high) - begin) / (end - begin)) * (to - from);
  };
  return is_near(place(begin)) && is_near(place(end));
}

// Face k of tetrahedron `from` is face `back` of tetrahedron `to`; indices of the triangulation.
struct WayGraph::OpenFace {
  std::uint32_t from, to;
  std::uint8_t k, back;
  float power, gap_angstrom;
  double ring_angstrom;  // WayRing::clearance_angstrom; -1 if ways do not cross there
};

WayGraph::WayGraph(const BallSet& balls, const Envelope& envelope, const RunContext& context)
    : balls_(balls), way_cost_{} {
  const PassageEnds ends{beside(balls), {}, {}};
  scene_ = GrownTriangulations(balls, ends).at(0, context);
  space_.emplace(scene_->balls, scene_->triangulation);
  const Simplices<4>& tetrahedra = scene_->triangulation.tetrahedra;
  const std::size_t count = tetrahedra.size();
  const double unit = balls.lattice.unit_angstrom();
  std::vector<std::uint8_t> kinds(count, kWayFull);
  std::vector<RealPoint> corners(count);
  std::vector<float> powers(count);  // square lattice units
  parallel_many(count, context.cancel, [&](std::size_t n) {
    const auto t = static_cast<std::uint32_t>(n);
    if (!space_->is_empty(t)) return;
    corners[t] = unit * space_->corner(t);
    kinds[t] = envelope.holds(corners[t]) ? kWayInside : kWayOutside;
    powers[t] = ortho_radius_rounded(scene_->balls, tetrahedra[t]);
  });
  const ResultArray<OpenFace> open = sorted(open_faces(kinds, powers, context.cancel));
  std::vector<std::uint32_t> number(count, kNothing);
  for (const OpenFace& face : open) {
    for (const std::uint32_t t : {face.from, face.to}) {
      if (number[t] != kNothing) continue;
      number[t] = static_cast<std::uint32_t>(original_.size());
      original_.push_back(t);
    }
  }
  corner_.resize(original_.size());
  is_outside_.resize(original_.size());
  links_.resize(original_.size());
  parallel_many(original_.size(), context.cancel, [&](std::size_t t) {
    corner_[t] = corners[original_[t]];
    is_outside_[t] = kinds[original_[t]] == kWayOutside ? 1 : 0;
    links_[t].fill({kNothing, 0, 0, std::numeric_limits<float>::infinity()});
  });
  faces_.resize(open.size());
  parallel_many(open.size(), context.cancel, [&](std::size_t n) {
    const OpenFace& face = open[n];
    const std::uint32_t a = number[face.from], b = number[face.to];
    const auto own = static_cast<std::uint32_t>(n);
    links_[a][face.k] = {b, own, face.power, face.gap_angstrom};
    links_[b][face.back] = {a, own, face.power, face.gap_angstrom};
    faces_[n] = {std::min(a, b), std::max(a, b), face.power};
  });
  const auto is_ring = [&](std::size_t n) { return open[n].ring_angstrom >= 0; };
  for (const std::uint32_t n : indices_where(open.size(), is_ring, context.cancel)) {
    rings_.push_back({n, open[n].ring_angstrom, 0});
  }
  double widest = 0;
  for (auto ring = rings_.rbegin(); ring != rings_.rend(); ++ring) {
    ring->widest_angstrom = widest = std::max(widest, ring->clearance_angstrom);
  }
  constexpr double kLeast = 0.1, kEnough = 10;  // Å
  way_cost_ = {static_cast<double>(balls.lattice.nearest_units(kLeast)),
               static_cast<double>(balls.lattice.nearest_units(kEnough)),
               static_cast<BallIndex>(scene_->original.size())};
  costs_ = std::vector<std::atomic<double>>(faces_.size());
}

// By falling power, then as listed. Bits of floats that are not negative rise with these.
ResultArray<WayGraph::OpenFace> WayGraph::sorted(const ResultArray<OpenFace>& faces) {
  ResultArray<std::uint64_t> order(faces.size());
  parallel_many(faces.size(), {}, [&](std::size_t n) {
    order[n] = std::uint64_t{~std::bit_cast<std::uint32_t>(faces[n].power)} << 32 | n;
  });
  tbb::parallel_sort(order.begin(), order.end());
  ResultArray<OpenFace> result(faces.size());
  parallel_many(faces.size(), {},
                [&](std::size_t n) { result[n] = faces[static_cast<std::uint32_t>(order[n])]; });
  return result;
}

EqualClearance WayGraph::gap_of(const std::array<BallIndex, 3>& triangle) const {
  if (triangle[2] >= scene_->original.size()) return {};
  return equal_clearance(balls_, {scene_->original[triangle[0]], scene_->original[triangle[1]],
                                  scene_->original[triangle[2]]});
}

EqualClearance WayGraph::gap_at(std::uint32_t tetrahedron, std::size_t link) const {
  return gap_of(space_->face(original_[tetrahedron], link));
}

std::size_t WayGraph::link_to(std::uint32_t from, std::uint32_t to) const {
  std::size_t k = 0;
  while (links_[from][k].to != to) ++k;
  return k;
}

// Sets the width of a face that is a gap. Returns whether it is open.
bool WayGraph::set_gap(OpenFace& face) const {
  const std::array<BallIndex, 3> triangle = space_->face(face.from, face.k);
  if (!space_->is_open_gap(triangle)) return false;
  face.power = ortho_radius_rounded(scene_->balls, triangle);
  const EqualClearance gap = gap_of(triangle);
  if (gap.found && gap.clearance_angstrom >= 0) {
    face.gap_angstrom = static_cast<float>(gap.clearance_angstrom);
    if (space_->is_ringed_gap(triangle)) face.ring_angstrom = gap.clearance_angstrom;
  } else {
    const auto ball_end = static_cast<BallIndex>(scene_->original.size());
    const double units = space_->width_by_power(triangle, 0, ball_end);
    face.gap_angstrom = static_cast<float>(balls_.lattice.unit_angstrom() * std::max(units, 0.0));
  }
  return true;
}

// Visits each face once, from the tetrahedron of the lower index. The list is in their order.
ResultArray<WayGraph::OpenFace> WayGraph::open_faces(const std::vector<std::uint8_t>& kinds,
                                                     const std::vector<float>& powers,
                                                     const CancelToken& cancel) const {
  const auto& neighbours = scene_->triangulation.neighbours;
  const auto add_faces = [&](std::uint32_t t, std::vector<OpenFace>& out) {
    if (kinds[t] == kWayFull) return;
    for (std::uint8_t k = 0; k < 4; ++k) {
      const Neighbour across = neighbours[t][k];
      if (across.is_hull() || across.index() < t || kinds[across.index()] == kWayFull) continue;
      // Ways end at the first tetrahedron outside, so faces between two of them are not needed.
      if (kinds[t] == kWayOutside && kinds[across.index()] == kWayOutside) continue;
      OpenFace face{t, across.index(), k, 0, 0, std::numeric_limits<float>::infinity(), -1};
      if (space_->is_gap(t, k)) {
        if (!set_gap(face)) continue;
      } else {
        face.power = std::min(powers[t], powers[across.index()]);
      }
      if (!(face.power > 0)) face.power = 0;  // also for -0
      while (neighbours[across.index()][face.back] != Neighbour::tetrahedron(t)) ++face.back;
      out.push_back(face);
    }
  };
  constexpr std::size_t kPart = 4096;
  std::vector<std::vector<OpenFace>> parts((kinds.size() + kPart - 1) / kPart);
  parallel_each(0, parts.size(), [&](std::size_t n) {
    cancel.throw_if_cancelled();
    const std::size_t end = std::min((n + 1) * kPart, kinds.size());
    for (std::size_t t = n * kPart; t < end; ++t) {
      add_faces(static_cast<std::uint32_t>(t), parts[n]);
    }
  });
  std::vector<std::size_t> first{0};
  for (const std::vector<OpenFace>& part : parts) first.push_back(first.back() + part.size());
  ResultArray<OpenFace> faces(first.back());
  parallel_each(0, parts.size(), [&](std::size_t n) {
    std::copy(parts[n].begin(), parts[n].end(),
              faces.begin() + static_cast<std::ptrdiff_t>(first[n]));
    parts[n] = {};
  });
  return faces;
}

double WayGraph::cost_across(std::uint32_t tetrahedron, std::size_t link) const {
  std::atomic<double>& known = costs_[links_[tetrahedron][link].face];
  double cost = known.load(std::memory_order_relaxed);
  if (cost == 0) {
    cost = space_->cost_across(original_[tetrahedron], link, way_cost_);
    known.store(cost, std::memory_order_relaxed);
  }
  return cost;
}

}  // namespace alphascope
