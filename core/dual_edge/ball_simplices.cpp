// SPDX-License-Identifier: GPL-3.0-or-later
// The list of neighbours of one ball: loaded, culled and turned into rows of bits. The templates
// that find its simplices are in ball_simplices_body.hpp.
#include "core/dual_edge/ball_simplices.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/dual_edge/ball_simplices_body.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/predicates/grown_balls.hpp"

namespace alphascope {

void BallSimplices::load(std::uint32_t slot, std::span<const std::uint32_t> list) {
  i_ = grid_.ball[slot];
  weight_ = balls_.weight(i_);
  radius_square_ = alpha_.plus(weight_);
  // An integer above the radius of the grown ball, whatever the rounding of sqrt.
  ghost_reach_ = static_cast<std::int64_t>(std::sqrt(radius_square_) * (1 + 1e-12)) + 2;
  slots_.assign(list.begin(), list.end());
  dead_.assign(list.size(), 0);
  lift(slot);
  filter_ = largest_offset_ < kBracketLimit;
  culled_ = filter_ && list.size() >= kLongList;
  if (culled_) cull();
  const std::size_t n = slots_.size();
  x_.resize(n);
  y_.resize(n);
  z_.resize(n);
  reach_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint32_t s = slots_[k];
    x_[k] = grid_.x[s];
    y_[k] = grid_.y[s];
    z_[k] = grid_.z[s];
    reach_[k] = grid_.reach[s];
  }
  words_ = static_cast<int>((n + 31) / 32);
  meets_.assign(static_cast<std::size_t>(words_) * 32, 0);
  first_ =
      static_cast<int>(std::upper_bound(neighbours_.balls.begin(), neighbours_.balls.end(), i_) -
                       neighbours_.balls.begin());
}

void BallSimplices::lift(std::uint32_t slot) {
  const std::size_t n = slots_.size();
  const LatticePoint centre{grid_.x[slot], grid_.y[slot], grid_.z[slot]};
  const std::int32_t radius = balls_.radii[i_];
  neighbours_.vectors.resize(n);
  neighbours_.balls.resize(n);
  doubles_.resize(n);
  largest_power_ = 4 * ghost_reach_;
  largest_offset_ = 1;
  attached_ = false;
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint32_t s = slots_[k];
    const LiftedInt v =
        lifted_vector(centre, radius, LatticePoint{grid_.x[s], grid_.y[s], grid_.z[s]},
                      balls_.radii[grid_.ball[s]]);
    neighbours_.vectors[k] = v;
    neighbours_.balls[k] = grid_.ball[s];
    doubles_[k] = lifted_as<double>(v);
    largest_offset_ = std::max({largest_offset_, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    largest_power_ = std::max(largest_power_, std::abs(v.c));
    attached_ = attached_ || v.c <= 0;
  }
}

// Finds the kCoverers neighbours whose radical planes are nearest to p_i, and prepares them as
// coverers.
void BallSimplices::find_nearest() {
  planes_.clear();
  for (std::size_t k = 0; k < doubles_.size(); ++k) {
    const LiftedVector<double>& v = doubles_[k];
    planes_.emplace_back(v.c / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z), k);
  }
  const auto end = planes_.begin() + static_cast<std::ptrdiff_t>(kCoverers);
  std::nth_element(planes_.begin(), end - 1, planes_.end());
  std::sort(planes_.begin(), end);
  coverers_.clear();
  is_near_.assign(doubles_.size(), 0);
  for (auto p = planes_.begin(); p != end; ++p) {
    coverers_.push_back(FacetDisc<double>::coverer(doubles_[p->second]));
    is_near_[p->second] = 1;
  }
}

void BallSimplices::keep(std::size_t from, std::size_t to) {
  slots_[to] = slots_[from];
  dead_[to] = dead_[from];
  is_near_[to] = is_near_[from];
  neighbours_.vectors[to] = neighbours_.vectors[from];
  neighbours_.balls[to] = neighbours_.balls[from];
  doubles_[to] = doubles_[from];
}

// Removes the neighbours whose discs are covered or empty (facet_disc.hpp). If p_i may be outside
// its power cell, these neighbours still cut dual edges. They stay then and are only marked dead.
void BallSimplices::cull() {
  find_nearest();
  std::size_t kept = 0;
  for (std::size_t j = 0; j < slots_.size(); ++j) {
    const FacetDisc<double> disc(doubles_[j], radius_square_);
    const auto covers = [&](const auto& m) { return disc.covered_by(m); };
    dead_[j] = disc.certainly_empty() || std::any_of(coverers_.begin(), coverers_.end(), covers);
    if (dead_[j] != 0 && !attached_) continue;
    keep(j, kept++);
  }
  slots_.resize(kept);
  neighbours_.vectors.resize(kept);
  neighbours_.balls.resize(kept);
  doubles_.resize(kept);
  near_.assign((kept + 31) / 32, 0);
  for (std::size_t k = 0; k < kept; ++k) near_[k / 32] |= std::uint32_t{is_near_[k] != 0} << k % 32;
}

// Row j of bits: the neighbours that meet j as well as i. Only these can cut the facet of i and j
// where pi <= alpha.
void BallSimplices::fill_row(int j) {
  const auto a = static_cast<std::size_t>(j);
  const std::size_t n = neighbours_.balls.size();
  const std::int32_t x = x_[a], y = y_[a], z = z_[a];
  const float reach = reach_[a];
  // Compilers vectorise these two loops, but not a single loop that writes bits.
  for (std::size_t k = 0; k < n; ++k)
    meets_[k] = grown_balls_may_meet(x_[k] - x, y_[k] - y, z_[k] - z, reach, reach_[k]);
  meets_[a] = 0;
  std::uint32_t* bits = row(j);
  for (int w = 0; w < words_; ++w) {
    const std::uint8_t* meets = meets_.data() + 32 * static_cast<std::ptrdiff_t>(w);
    std::uint32_t word = 0;
    for (int b = 0; b < 32; ++b) word |= std::uint32_t{meets[b]} << b;
    bits[w] = word;
  }
}

void BallSimplices::note_coface(int j, float value, SimplexClass coface, BlockOutput& out) {
  const std::uint32_t e = edge_[static_cast<std::size_t>(j - first_)];
  out.edges.values[e] = std::min(out.edges.values[e], value);
  out.edges.states[e] = static_cast<std::uint8_t>(out.edges.states[e] | coface_flags(coface));
}

void BallSimplices::tetrahedra(const NearFirstRows& t, BlockOutput& out) {
  TriangleEnds ends{-1, -1, false};
  if (filter_) {
    ends = filtered(t, [&](const auto& rows, const auto& vectors) {
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

VertexState BallSimplices::process(std::uint32_t slot, std::span<const std::uint32_t> list,
                                   BlockOutput& out) {
  return process_with(slot, list, out, NoSink());
}

}  // namespace alphascope
