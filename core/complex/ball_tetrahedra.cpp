// Tetrahedra alone, on the CPU: the dual edges of one ball's triangles (triangle_tetrahedra.hpp).
#include <algorithm>
#include <chrono>

#include "core/complex/ball_facets.hpp"
#include "core/complex/facet_disc.hpp"
#include "core/complex/triangle_tetrahedra.hpp"

namespace alphascope {
namespace {

// From so many neighbours on it pays to look for discs that a single ball covers. Only the time
// depends on it.
constexpr int kLongList = 20;

}  // namespace

// Which neighbours meet j as well as i; none when edge ij is certainly not in K_alpha.
void BallFacets::fill_row(int j, int words, double radius_square, std::uint32_t* row) {
  collect_common(j);
  std::fill_n(row, words, 0u);
  for (const int k : common_) row[k >> 5] |= 1u << (k & 31);
  if (static_cast<int>(doubles_.size()) < kLongList) return;
  const auto at = [&](int k) -> const LiftedVector<double>& {
    return doubles_[static_cast<std::size_t>(k)];
  };
  const FacetDisc<double> disc(at(j), radius_square);
  if (disc.certainly_empty() || std::any_of(common_.begin(), common_.end(), [&](int k) {
        return disc.certainly_covered_by(at(k));
      })) {
    std::fill_n(row, words, 0u);
  }
}

TriangleEnds BallFacets::exact_triangle(const TriangleRows& triangle, int words) {
  const auto start = std::chrono::steady_clock::now();
  ++exact_facets_;
  const FacetInput<Neighbours> input{neighbours_, triangle.j,   weight_,
                                     alpha_,      ghost_reach_, largest_offset_ < kBracketLimit};
  const bool small = largest_offset_ < kSmallOffset && largest_power_ < kSmallPower;
  const TriangleEnds ends = small ? exact_ends<Int128>(input, triangle, words)
                                  : exact_ends<WideInt<4>>(input, triangle, words);
  exact_milliseconds_ +=
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return ends;
}

void BallFacets::tetrahedra(BlockOutput& out) {
  const int n = static_cast<int>(neighbours_.balls.size()), words = (n + 31) / 32;
  const int first =
      static_cast<int>(std::upper_bound(neighbours_.balls.begin(), neighbours_.balls.end(), i_) -
                       neighbours_.balls.begin());
  if (n - first < 3) return;
  const double radius_square = static_cast<double>(weight_) + alpha_;
  const bool filter = largest_offset_ < kBracketLimit;
  doubles_.clear();
  for (const LiftedInt& v : neighbours_.vectors) doubles_.push_back(lifted_as<double>(v));
  rows_.resize(static_cast<std::size_t>(n - first) * static_cast<std::size_t>(words));
  const auto row = [&](int j) {
    return rows_.data() + static_cast<std::ptrdiff_t>(j - first) * words;
  };
  for (int j = first; j < n; ++j) fill_row(j, words, radius_square, row(j));

  const auto vector = [&](int k) -> const LiftedVector<double>& {
    return doubles_[static_cast<std::size_t>(k)];
  };
  for (int j = first; j < n - 2; ++j) {
    const TriangleRows facet{j, j, row(j), row(j)};
    for (int k = facet.next_common(j, words); k >= 0; k = facet.next_common(k, words)) {
      const TriangleRows triangle{j, k, row(j), row(k)};
      if (!triangle.has_fourth(words)) continue;
      ++facets_;
      TriangleEnds ends{-1, -1, false};
      if (filter) ends = filtered_ends<double>(triangle, words, radius_square, vector);
      if (!ends.known) ends = exact_triangle(triangle, words);
      const int low = std::min(ends.low, ends.high), high = std::max(ends.low, ends.high);
      for (const int l : {low, high}) {
        if (l < 0) continue;
        out.tetrahedra.simplices.push_back(
            {i_, neighbours_.ball(j), neighbours_.ball(k), neighbours_.ball(l)});
      }
    }
  }
}

}  // namespace alphascope
