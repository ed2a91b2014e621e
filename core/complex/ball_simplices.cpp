#include "core/complex/ball_simplices.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>

namespace alphascope {
namespace {

// From so many neighbours on it pays to look for discs that a single ball covers. Only the time
// depends on it.
constexpr std::size_t kLongList = 20;

}  // namespace

void BallSimplices::load(std::uint32_t slot, std::span<const std::uint32_t> list) {
  i_ = grid_.ball[slot];
  weight_ = balls_.weight(i_);
  radius_square_ = static_cast<double>(weight_) + alpha_;
  // A whole number above the radius of the disc, whatever the rounding of sqrt.
  ghost_reach_ = static_cast<std::int64_t>(std::sqrt(radius_square_) * (1 + 1e-12)) + 2;
  const std::size_t n = list.size();
  neighbours_.vectors.resize(n);
  neighbours_.balls.resize(n);
  doubles_.resize(n);
  dx_.resize(n);
  dy_.resize(n);
  dz_.resize(n);
  reach_.resize(n);
  largest_power_ = 4 * ghost_reach_;
  largest_offset_ = 1;
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint32_t s = list[k];
    const std::int64_t x = std::int64_t{grid_.x[s]} - grid_.x[slot],
                       y = std::int64_t{grid_.y[s]} - grid_.y[slot],
                       z = std::int64_t{grid_.z[s]} - grid_.z[slot];
    const std::int64_t c = x * x + y * y + z * z + weight_ - balls_.weight(grid_.ball[s]);
    neighbours_.vectors[k] = {x, y, z, c};
    neighbours_.balls[k] = grid_.ball[s];
    doubles_[k] = lifted_as<double>(neighbours_.vectors[k]);
    dx_[k] = static_cast<float>(x);
    dy_[k] = static_cast<float>(y);
    dz_[k] = static_cast<float>(z);
    reach_[k] = grid_.reach[s];
    largest_offset_ = std::max({largest_offset_, std::abs(x), std::abs(y), std::abs(z)});
    largest_power_ = std::max(largest_power_, std::abs(c));
  }
  filter_ = largest_offset_ < kBracketLimit;
  words_ = static_cast<int>((n + 31) / 32);
  first_ =
      static_cast<int>(std::upper_bound(neighbours_.balls.begin(), neighbours_.balls.end(), i_) -
                       neighbours_.balls.begin());
}

// Only balls that meet the grown ball j as well as ball i can cut their facet where pi <= alpha.
void BallSimplices::collect_common(int j) {
  constexpr float kMargin = 1.0f + 1.0f / (1 << 18);
  const auto a = static_cast<std::size_t>(j);
  const float x = dx_[a], y = dy_[a], z = dz_[a], reach = reach_[a];
  const std::size_t n = neighbours_.balls.size();
  common_.resize(n);
  std::size_t count = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const float ex = dx_[k] - x, ey = dy_[k] - y, ez = dz_[k] - z, sum = reach_[k] + reach;
    common_[count] = static_cast<int>(k);
    count += (ex * ex + ey * ey + ez * ez <= sum * sum * kMargin) & (k != a);
  }
  common_.resize(count);
}

// Which neighbours meet j as well as i (they stay in common_); none, and j marked, when edge ij is
// certainly not in K_alpha.
void BallSimplices::fill_row(int j) {
  collect_common(j);
  std::uint32_t* bits = row(j);
  std::fill_n(bits, words_, 0u);
  for (const int k : common_) bits[k >> 5] |= 1u << (k & 31);
  if (!filter_ || doubles_.size() < kLongList) return;
  const FacetDisc<double> disc(vector(j), radius_square_);
  if (disc.certainly_empty() || std::any_of(common_.begin(), common_.end(),
                                            [&](int k) { return disc.cut_by(vector(k)).covers; })) {
    std::fill_n(bits, words_, 0u);
    dead_[static_cast<std::size_t>(j - first_)] = 1;
  }
}

bool BallSimplices::edge_is_attached(int j, const FacetDisc<double>& disc) {
  return std::any_of(common_.begin(), common_.end(), [&](int m) {
    Decision d = filter_ ? disc.cut_by(vector(m)).centre : Decision::unknown;
    if (d == Decision::unknown) d = edge_attached_to<ExactDecider>(surroundings(), j, m);
    return d == Decision::in;
  });
}

void BallSimplices::add_edge(int j, BlockOutput& out) {
  float value = HUGE_VALF;
  if (!edge_is_attached(j, FacetDisc<double>(vector(j), radius_square_)) &&
      decide_edge<ExactDecider>(surroundings(), j, &value) == Decision::out) {
    dead_[static_cast<std::size_t>(j - first_)] = 1;
    return;
  }
  edge_[static_cast<std::size_t>(j - first_)] = out.edges.size();
  out.edges.simplices.push_back({i_, neighbours_.ball(j)});
  out.edges.values.push_back(value);
  out.edges.states.push_back(0);
}

void BallSimplices::note_coface(int j, float value, bool interior, BlockOutput& out) {
  const std::uint32_t e = edge_[static_cast<std::size_t>(j - first_)];
  out.edges.values[e] = std::min(out.edges.values[e], value);
  out.edges.states[e] = static_cast<std::uint8_t>(out.edges.states[e] | kHasCoface |
                                                  (interior ? 0 : kHasBoundaryCoface));
}

TriangleFace BallSimplices::exactly(const TriangleRows& rows) {
  const auto start = std::chrono::steady_clock::now();
  ++exact_dual_edges_;
  const bool small = largest_offset_ < kSmallOffset && largest_power_ < kSmallPower;
  const TriangleFace face = small ? exact_face<Int128>(surroundings(), rows, words_)
                                  : exact_face<WideInt<4>>(surroundings(), rows, words_);
  exact_milliseconds_ +=
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return face;
}

void BallSimplices::triangle(const TriangleRows& t, BlockOutput& out) {
  TriangleFace face = TriangleFace::undecided();
  if (filter_) {
    face = filtered_face<double>(t, words_, radius_square_,
                                 [&](int k) -> const LiftedVector<double>& { return vector(k); });
  }
  if (face.in == Decision::unknown) face = exactly(t);
  if (face.in == Decision::out) return;
  const std::array<BallIndex, 3> ijk{i_, neighbours_.ball(t.j), neighbours_.ball(t.k)};
  float value = 0;
  triangle_value<ExactDecider>(surroundings(), t.j, t.k, face, &value);
  out.triangles.simplices.push_back(ijk);
  out.triangles.values.push_back(value);
  out.triangles.states.push_back(static_cast<std::uint8_t>(face.cofaces()));
  note_coface(t.j, value, face.cofaces() == 2, out);
  note_coface(t.k, value, face.cofaces() == 2, out);
  for (const int l : {std::min(face.low, face.high), std::max(face.low, face.high)}) {
    if (l <= t.k) continue;
    decide_tetrahedron<ExactDecider>(surroundings(), t.j, t.k, l, &value);
    out.tetrahedra.simplices.push_back({ijk[0], ijk[1], ijk[2], neighbours_.ball(l)});
    out.tetrahedra.values.push_back(value);
  }
}

void BallSimplices::tetrahedra(const TriangleRows& t, BlockOutput& out) {
  TriangleEnds ends{-1, -1, false};
  if (filter_) {
    ends = filtered_ends<double>(t, words_, radius_square_,
                                 [&](int k) -> const LiftedVector<double>& { return vector(k); });
  }
  if (!ends.known) ends = later_ends(exactly(t), t.k);
  for (const int l : {std::min(ends.low, ends.high), std::max(ends.low, ends.high)}) {
    if (l < 0) continue;
    out.tetrahedra.simplices.push_back(
        {i_, neighbours_.ball(t.j), neighbours_.ball(t.k), neighbours_.ball(l)});
  }
}

void BallSimplices::triangles_of(int j, BlockOutput& out) {
  const TriangleRows ij{j, j, row(j), row(j)};
  for (int k = ij.next_common(j, words_); k >= 0; k = ij.next_common(k, words_)) {
    const TriangleRows t{j, k, row(j), row(k)};
    if (whole_ ? dead_[static_cast<std::size_t>(k - first_)] != 0 : !t.has_fourth(words_)) continue;
    ++dual_edges_;
    whole_ ? triangle(t, out) : tetrahedra(t, out);
  }
}

VertexState BallSimplices::vertex_state() const {
  if (-static_cast<double>(weight_) > alpha_) return VertexState::absent;
  // With equality the centre lies on the boundary of its power cell, or the cell is empty after
  // perturbation: then the nearest edge has the same value, or there is none.
  const bool attached = std::any_of(neighbours_.vectors.begin(), neighbours_.vectors.end(),
                                    [](const LiftedInt& v) { return v.c <= 0; });
  return attached ? VertexState::attached : VertexState::unattached;
}

VertexState BallSimplices::process(std::uint32_t slot, std::span<const std::uint32_t> list,
                                   BlockOutput& out) {
  load(slot, list);
  const int n = static_cast<int>(list.size()), later = n - first_;
  if (!whole_ && later < 3) return VertexState::absent;  // not asked for
  rows_.resize(static_cast<std::size_t>(later) * static_cast<std::size_t>(words_));
  dead_.assign(static_cast<std::size_t>(later), 0);
  edge_.resize(static_cast<std::size_t>(later));
  for (int j = first_; j < n; ++j) {
    fill_row(j);
    if (whole_ && dead_[static_cast<std::size_t>(j - first_)] == 0) add_edge(j, out);
  }
  for (int j = first_; j < n; ++j) {
    if (dead_[static_cast<std::size_t>(j - first_)] == 0) triangles_of(j, out);
  }
  return whole_ ? vertex_state() : VertexState::absent;
}

}  // namespace alphascope
