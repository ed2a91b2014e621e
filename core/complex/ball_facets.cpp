#include "core/complex/ball_facets.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>

#include "core/geometry/perturbation.hpp"

namespace alphascope {
namespace {

// The predicate value of a clip is below 48 d⁵c (see clip_error_bound): within these limits, 2^127.
constexpr std::int64_t kInt128OffsetLimit = std::int64_t{1} << 17;
constexpr std::int64_t kInt128PowerLimit = std::int64_t{1} << 36;

// Collects what report_facet tells about one edge ij, then hands it on in lexicographic order.
template <class Neighbours>
struct Collector {
  const Neighbours& neighbours;
  BallIndex i, j;
  BlockOutput& out;
  std::size_t first_triangle, first_tetrahedron;

  void edge(float value, int simplex_class) {
    out.edges.simplices.push_back({i, j});
    out.edges.values.push_back(value);
    out.edges.classes.push_back(static_cast<std::uint8_t>(simplex_class));
  }
  // Insertion keeps the few simplices of one facet sorted.
  void triangle(int k, float value, int simplex_class) {
    insert(out.triangles, first_triangle, {i, j, neighbours.ball(k)}, &value, &simplex_class);
  }
  void tetrahedron(int k, int l) { tetrahedron(k, l, nullptr); }
  void tetrahedron(int k, int l, float value) { tetrahedron(k, l, &value); }

 private:
  void tetrahedron(int k, int l, const float* value) {
    const BallIndex a = neighbours.ball(k), b = neighbours.ball(l);
    insert(out.tetrahedra, first_tetrahedron, {i, j, std::min(a, b), std::max(a, b)}, value,
           nullptr);
  }
  template <int N>
  static void insert(SimplexBuffer<N>& buffer, std::size_t first, std::array<BallIndex, N> simplex,
                     const float* value, const int* simplex_class) {
    std::size_t at = buffer.simplices.size();
    while (at > first && simplex < buffer.simplices[at - 1]) --at;
    const auto offset = static_cast<std::ptrdiff_t>(at);
    buffer.simplices.insert(buffer.simplices.begin() + offset, simplex);
    if (value != nullptr) buffer.values.insert(buffer.values.begin() + offset, *value);
    if (simplex_class != nullptr) {
      buffer.classes.insert(buffer.classes.begin() + offset,
                            static_cast<std::uint8_t>(*simplex_class));
    }
  }
};

}  // namespace

void BallFacets::load(std::uint32_t slot, std::span<const std::uint32_t> list) {
  i_ = grid_.ball[slot];
  weight_ = balls_.weight(i_);
  // A whole number above the radius of the disc, whatever the rounding of sqrt.
  ghost_reach_ =
      static_cast<std::int64_t>(std::sqrt(static_cast<double>(weight_) + alpha_) * (1 + 1e-12)) + 2;
  const std::size_t n = list.size();
  neighbours_.vectors.resize(n);
  neighbours_.balls.resize(n);
  dx_.resize(n);
  dy_.resize(n);
  dz_.resize(n);
  reach_.resize(n);
  common_.resize(n);
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
    dx_[k] = static_cast<float>(x);
    dy_[k] = static_cast<float>(y);
    dz_[k] = static_cast<float>(z);
    reach_[k] = grid_.reach[s];
    largest_offset_ = std::max({largest_offset_, std::abs(x), std::abs(y), std::abs(z)});
    largest_power_ = std::max(largest_power_, std::abs(c));
  }
  clip_bound_ = clip_error_bound(static_cast<double>(largest_offset_),
                                 static_cast<double>(largest_power_), kUnitRoundoff);
}

// Only balls that meet the grown ball j as well as ball i can cut their facet where pi <= alpha.
void BallFacets::collect_common(int j) {
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

template <class T>
void BallFacets::report(const FacetInput<Neighbours>& input, const Polygon<T>& polygon, int axis,
                        float edge_value, BlockOutput& out) {
  Collector<Neighbours> sink{
      neighbours_, i_, neighbours_.ball(input.j), out, out.triangles.size(), out.tetrahedra.size()};
  const auto sides = static_cast<std::size_t>(polygon.size);
  if (corner_in_.size() < sides) {
    corner_in_.resize(2 * sides);
    corner_value_.resize(2 * sides);
  }
  report_facet<ExactDecider>(input, polygon, axis, edge_value,
                             {corner_in_.data(), corner_value_.data()}, sink);
}

bool BallFacets::filtered_facet(const FacetInput<Neighbours>& input, int axis, bool negative,
                                float edge_value, BlockOutput& out) {
  filtered_.reserve(common_.size() + 3);
  Polygon<double>& polygon = filtered_;
  const auto frame =
      make_facet_frame(lifted_as<double>(neighbours_.lifted(input.j)), axis, negative);
  start_polygon(polygon, frame, ghost_reach_);
  const double bound = clip_bound_;
  for (const int k : common_) {
    const auto line = frame.line(lifted_as<double>(neighbours_.lifted(k)));
    const auto side = [&](int s) {
      const double value = polygon.corner(s).beyond(line);
      return (value > bound) - (value < -bound);
    };
    const ClipOutcome outcome = clip(polygon, line, k, side);
    if (outcome == ClipOutcome::empty) return true;
    if (outcome == ClipOutcome::uncertain) return false;
  }
  report(input, polygon, axis, edge_value, out);
  return true;
}

template <class Integer>
void BallFacets::exact_facet(Polygon<Integer>& scratch, const FacetInput<Neighbours>& input,
                             int axis, bool negative, float edge_value, BlockOutput& out) {
  scratch.reserve(common_.size() + 3);
  Polygon<Integer>& polygon = scratch;
  const LiftedInt j = neighbours_.lifted(input.j);
  const auto frame = make_facet_frame(lifted_as<Integer>(j), axis, negative);
  start_polygon(polygon, frame, ghost_reach_);
  for (const int m : common_) {
    const LiftedInt vm = neighbours_.lifted(m);
    const auto line = frame.line(lifted_as<Integer>(vm));
    const auto side = [&](int s) {
      const int sign = sign_of(polygon.corner(s).beyond(line));
      if (sign != 0) return sign;
      const int k = polygon.id(s), l = polygon.id(s + 1 == polygon.size ? 0 : s + 1);
      return perturbed_cut(j, input.side_vector(k, axis), k < 0, input.side_vector(l, axis), l < 0,
                           vm);
    };
    if (clip(polygon, line, m, side) == ClipOutcome::empty) return;
  }
  report(input, polygon, axis, edge_value, out);
}

void BallFacets::facet(int j, BlockOutput& out) {
  const LiftedInt& vj = neighbours_.lifted(j);
  const FacetInput<Neighbours> input{
      neighbours_, j, weight_, alpha_, ghost_reach_, largest_offset_ < kBracketLimit};
  float edge_value = 0;
  if (decide_edge<ExactDecider>(input, &edge_value) == Decision::out) return;
  const FacetAxis axis = facet_axis(vj.x, vj.y, vj.z);
  if (filtered_facet(input, axis.axis, axis.negative, edge_value, out)) return;

  const auto start = std::chrono::steady_clock::now();
  ++exact_facets_;
  if (largest_offset_ < kInt128OffsetLimit && largest_power_ < kInt128PowerLimit) {
    exact_facet(exact128_, input, axis.axis, axis.negative, edge_value, out);
  } else {
    exact_facet(exact256_, input, axis.axis, axis.negative, edge_value, out);
  }
  exact_milliseconds_ +=
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

VertexState BallFacets::process(std::uint32_t slot, std::span<const std::uint32_t> list,
                                BlockOutput& out) {
  load(slot, list);
  if (!whole_) {
    tetrahedra(out);
    return VertexState::absent;  // not asked for
  }
  const int n = static_cast<int>(list.size());
  for (int j = 0; j < n; ++j) {
    if (neighbours_.ball(j) < i_) continue;
    collect_common(j);
    ++facets_;
    facet(j, out);
  }
  if (-static_cast<double>(weight_) > alpha_) return VertexState::absent;
  for (const LiftedInt& v : neighbours_.vectors) {
    // With equality the centre lies on the boundary of its power cell, or the cell is empty after
    // perturbation: then the nearest edge has the same value, or there is none.
    if (v.c <= 0) return VertexState::attached;
  }
  return VertexState::unattached;
}

}  // namespace alphascope
