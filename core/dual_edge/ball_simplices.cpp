// SPDX-License-Identifier: GPL-3.0-or-later
// The list of neighbours of one ball: loaded, culled and turned into rows of bits. The templates
// that find its simplices are in ball_simplices_body.hpp.
#include "core/dual_edge/ball_simplices.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/dual_edge/ball_simplices_body.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/neighbours/meeting_slots.hpp"

namespace alphascope {

void BallSimplices::Neighbours::resize(std::size_t count) {
  for (auto* column : {&x, &y, &z}) column->resize(count + kVectorRoom);
  reach.resize(count + kVectorRoom);
  radii.resize(count);
  balls.resize(count);
}

void BallSimplices::Neighbours::move(std::size_t from, std::size_t to) {
  for (auto* column : {&x, &y, &z, &radii}) (*column)[to] = (*column)[from];
  reach[to] = reach[from];
  balls[to] = balls[from];
}

void BallSimplices::load(std::uint32_t slot, std::span<const std::uint32_t> list) {
  i_ = grid_.ball[slot];
  weight_ = balls_.weight(i_);
  radius_square_ = alpha_.plus(weight_);
  // An integer above the radius of the grown ball, whatever the rounding of sqrt.
  ghost_reach_ = static_cast<std::int64_t>(std::sqrt(radius_square_) * (1 + 1e-12)) + 2;
  dead_.assign(list.size(), 0);
  take(slot, list);
  filter_ = largest_offset_ < kBracketLimit;
  lift();
  culled_ = filter_ && list.size() >= kLongList;
  if (culled_) cull();
  words_ = static_cast<int>((neighbours_.size() + 31) / 32);
  sieved_.resize(static_cast<std::size_t>(words_));
  first_ =
      static_cast<int>(std::upper_bound(neighbours_.balls.begin(), neighbours_.balls.end(), i_) -
                       neighbours_.balls.begin());
}

void BallSimplices::take(std::uint32_t slot, std::span<const std::uint32_t> list) {
  Neighbours& n = neighbours_;
  n.centre = {grid_.x[slot], grid_.y[slot], grid_.z[slot]};
  n.radius = balls_.radii[i_];
  n.resize(list.size());
  std::int32_t largest = 1;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const std::uint32_t s = list[k];
    n.x[k] = grid_.x[s];
    n.y[k] = grid_.y[s];
    n.z[k] = grid_.z[s];
    n.reach[k] = grid_.reach[s];
    n.balls[k] = grid_.ball[s];
    n.radii[k] = balls_.radii[n.balls[k]];
    largest = std::max({largest, std::abs(n.x[k] - n.centre.x), std::abs(n.y[k] - n.centre.y),
                        std::abs(n.z[k] - n.centre.z)});
  }
  largest_offset_ = largest;
}

// Within kBracketLimit doubles hold each step of c exactly. Beyond it c is rounded, and no filter
// uses it.
void BallSimplices::lift() {
  const Neighbours& n = neighbours_;
  doubles_.resize(n.size());
  double least = 1, largest = 4 * static_cast<double>(ghost_reach_);
  for (std::size_t k = 0; k < n.size(); ++k) {
    const double x = n.x[k] - n.centre.x, y = n.y[k] - n.centre.y, z = n.z[k] - n.centre.z;
    const double weights = static_cast<double>(n.radius - n.radii[k]) * (n.radius + n.radii[k]);
    const double c = x * x + y * y + z * z + weights;
    doubles_.set(k, {x, y, z, c});
    least = std::min(least, c);
    largest = std::max(largest, std::fabs(c));
  }
  constexpr double kMargin = 1 + 1e-12;
  largest_power_ = largest * kMargin;
  attached_ = least <= 0;
  if (filter_) return;
  attached_ = false;
  for (std::size_t k = 0; k < n.size(); ++k) {
    attached_ = attached_ || n.lifted(static_cast<int>(k)).c <= 0;
  }
}

// Finds the kCoverers neighbours whose radical planes are nearest to p_i, and prepares them as
// coverers.
void BallSimplices::find_nearest() {
  planes_.clear();
  for (std::size_t k = 0; k < neighbours_.size(); ++k) {
    const LiftedVector<double> v = doubles_[k];
    // The square of twice the distance, with its sign.
    planes_.emplace_back(v.c * std::fabs(v.c) / (v.x * v.x + v.y * v.y + v.z * v.z), k);
  }
  const auto end = planes_.begin() + static_cast<std::ptrdiff_t>(kCoverers);
  std::nth_element(planes_.begin(), end - 1, planes_.end());
  is_near_.assign(neighbours_.size(), 0);
  coverers_.clear();
  for (auto p = planes_.begin(); p != end; ++p) {
    coverers_.push_back(FacetDisc<double>::coverer(doubles_[p->second]));
    is_near_[p->second] = 1;
  }
}

void BallSimplices::keep(std::size_t from, std::size_t to) {
  neighbours_.move(from, to);
  dead_[to] = dead_[from];
  is_near_[to] = is_near_[from];
  doubles_.set(to, doubles_[from]);
}

// Removes the neighbours whose discs are covered or empty (facet_disc.hpp). If p_i may be outside
// its power cell, these neighbours still cut dual edges. They stay then and are only marked dead.
void BallSimplices::cull() {
  find_nearest();
  std::size_t kept = 0;
  for (std::size_t j = 0; j < neighbours_.size(); ++j) {
    const FacetDisc<double> disc(doubles_[j], radius_square_);
    const auto covers = [&](const auto& m) { return disc.covered_by(m); };
    dead_[j] = disc.certainly_empty() || std::any_of(coverers_.begin(), coverers_.end(), covers);
    if (dead_[j] != 0 && !attached_) continue;
    keep(j, kept++);
  }
  neighbours_.resize(kept);
  doubles_.resize(kept);
  near_.assign((kept + 31) / 32, 0);
  for (std::size_t k = 0; k < kept; ++k) near_[k / 32] |= std::uint32_t{is_near_[k] != 0} << k % 32;
}

// Row j of bits: the neighbours that meet j as well as i. Only these can cut the facet of i and j
// where pi <= alpha.
void BallSimplices::fill_row(int j) {
  const auto a = static_cast<std::size_t>(j);
  std::uint32_t* bits = row(j);
  const Neighbours& n = neighbours_;
  mark_meeting(n.columns(), n.size(), {n.x[a], n.y[a], n.z[a], n.reach[a]}, bits);
  bits[a / 32] &= ~(std::uint32_t{1} << a % 32);
}

void BallSimplices::note_coface(int j, float value, SimplexClass coface, BlockOutput& out) {
  const std::uint32_t e = edge_[static_cast<std::size_t>(j - first_)];
  out.edges.values[e] = std::min(out.edges.values[e], value);
  out.edges.states[e] = static_cast<std::uint8_t>(out.edges.states[e] | coface_flags(coface));
}

void BallSimplices::tetrahedra(const NearFirstRows& t, BlockOutput& out) {
  TriangleEnds ends{-1, -1, false};
  if (filter_) {
    ends = filtered<NoSink>(t, [&](const auto& rows, const auto& vectors) {
      return filtered_ends<double>(rows, words_, radius_square_, vectors);
    });
  }
  if (!ends.known) ends = later_ends(exactly(t), t.k);
  for (const int l : {std::min(ends.low, ends.high), std::max(ends.low, ends.high)}) {
    if (l < 0) continue;
    out.tetrahedra.simplices.push_back(
        {i_, neighbours_.ball(t.j), neighbours_.ball(t.k), neighbours_.ball(l)});
  }
}

VertexState BallSimplices::vertex_state() const {
  if (alpha_.plus(weight_) < 0) return VertexState::absent;
  // If a neighbour has c = 0, p_i is on the boundary of its power cell, or the cell is empty after
  // the perturbation. On the boundary, the nearest edge has the same alpha value. An empty cell has
  // no edge.
  return attached_ ? VertexState::attached : VertexState::unattached;
}

// Only then can a tetrahedron have this ball as its first one.
bool BallSimplices::has_three_later(std::uint32_t slot, std::span<const std::uint32_t> list) const {
  return list.size() >= 3 && grid_.ball[list[list.size() - 3]] > grid_.ball[slot];
}

VertexState BallSimplices::process(std::uint32_t slot, std::span<const std::uint32_t> list,
                                   BlockOutput& out) {
  if (!whole_ && !has_three_later(slot, list)) return VertexState::absent;
  return process_with(slot, list, out, NoSink());
}

}  // namespace alphascope
