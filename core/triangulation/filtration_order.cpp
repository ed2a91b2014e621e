// SPDX-License-Identifier: GPL-3.0-or-later
// Sorts simplices by the floats of their alpha values, and then those of one float by integers.
#include "core/triangulation/filtration_order.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <utility>

#include "core/complex/alpha_complex.hpp"
#include "core/complex/count_limits.hpp"
#include "core/geometry/ordered_bits.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

struct Entry {
  std::uint32_t value;  // ordered bits
  SimplexPlace place;
  bool is_before(const Entry& other) const {
    if (value != other.value) return value < other.value;
    if (place.dimension != other.place.dimension) return place.dimension < other.place.dimension;
    return place.index < other.place.index;
  }
};

using Members = std::span<const Entry>;

// The simplices whose alpha values round to one float, sorted by dimension and index.
class OneFloat {
 public:
  OneFloat(const BallSet& balls, const AlphaComplex& complex, Members members)
      : balls_(balls), complex_(complex), members_(members), source_(members.size()) {}

  // Writes them in the order of their exact values.
  void sort_into(std::span<SimplexPlace> sorted) {
    find_sources();
    std::vector<std::uint32_t> order(members_.size());
    for (std::uint32_t n = 0; n < order.size(); ++n) order[n] = n;
    std::size_t equal = 1;
    while (equal < members_.size() && compare(equal - 1, equal) == 0) ++equal;
    if (equal < members_.size()) {
      std::stable_sort(order.begin(), order.end(),
                       [&](std::uint32_t a, std::uint32_t b) { return compare(a, b) < 0; });
    }
    for (std::size_t n = 0; n < order.size(); ++n) sorted[n] = members_[order[n]].place;
  }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  std::span<const BallIndex> balls_of(std::size_t member) const {
    const auto [dimension, index] = members_[member].place;
    switch (dimension) {
      case 0:
        return complex_.vertices.simplices[index];
      case 1:
        return complex_.edges.simplices[index];
      case 2:
        return complex_.triangles.simplices[index];
      default:
        return complex_.tetrahedra.simplices[index];
    }
  }

  // Compares the exact values of two members.
  int compare(std::size_t a, std::size_t b) const {
    if (source_[a] == source_[b]) return 0;
    return compare_ortho_radii_of(balls_, balls_of(source_[a]), balls_of(source_[b]));
  }

  // Finds for each member the one whose ortho-radius is its alpha value: itself, or for an attached
  // face the least of its cofaces. An attached face has its value from a coface whose ball attaches
  // it. That coface has the same float, so all that is needed is here.
  void find_sources() {
    for (std::uint32_t n = 0; n < members_.size(); ++n) source_[n] = n;
    std::vector<std::uint32_t> least(members_.size(), kNone);  // a coface
    std::vector<char> attached(members_.size(), 0);
    std::size_t end = members_.size();
    for (std::uint32_t dimension = 3; dimension > 0; --dimension) {
      const std::size_t begin = first_of(dimension), faces = first_of(dimension - 1);
      for (std::size_t coface = begin; coface < end && faces < begin; ++coface) {
        const std::span<const BallIndex> balls = balls_of(coface);
        for (std::size_t apex = 0; apex < balls.size(); ++apex) {
          const std::size_t face = face_without(balls, apex, faces, begin);
          if (face == begin) continue;
          if (conflict_with_smallest_orthosphere(balls_, balls_of(face), balls[apex]) < 0)
            attached[face] = 1;
          if (least[face] == kNone || compare(coface, least[face]) < 0)
            least[face] = static_cast<std::uint32_t>(coface);
        }
      }
      for (std::size_t face = faces; face < begin; ++face) {
        if (attached[face]) source_[face] = source_[least[face]];
      }
      end = begin;
    }
  }

  std::size_t first_of(std::uint32_t dimension) const {
    return static_cast<std::size_t>(std::lower_bound(members_.begin(), members_.end(), dimension,
                                                     [](const Entry& e, std::uint32_t limit) {
                                                       return e.place.dimension < limit;
                                                     }) -
                                    members_.begin());
  }

  // The member in [begin, end) with these balls but one; `end` if there is none.
  std::size_t face_without(std::span<const BallIndex> balls, std::size_t apex, std::size_t begin,
                           std::size_t end) const {
    std::array<BallIndex, 3> face{};
    std::size_t count = 0;
    for (std::size_t n = 0; n < balls.size(); ++n) {
      if (n != apex) face[count++] = balls[n];
    }
    const std::span<const BallIndex> wanted(face.data(), count);
    std::size_t low = begin, high = end;
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (std::ranges::lexicographical_compare(balls_of(middle), wanted)) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low < end && std::ranges::equal(balls_of(low), wanted) ? low : end;
  }

  const BallSet& balls_;
  const AlphaComplex& complex_;
  const Members members_;
  std::vector<std::uint32_t> source_;
};

template <int N>
void append(const SimplexList<N>& list, std::vector<Entry>& entries) {
  require_at_most(list.size(), kMostIndices, "simplices");
  for (std::uint32_t n = 0; n < list.size(); ++n)
    entries.push_back({ordered_bits(list.alpha_values[n] + 0.0f), {N - 1, n}});  // -0 becomes 0
}

}  // namespace

std::vector<SimplexPlace> filtration_order(const BallSet& balls, const AlphaComplex& complex,
                                           const CancelToken& cancel) {
  if (complex.tetrahedra_only)
    throw std::invalid_argument("an order needs a whole complex, not only its tetrahedra");
  std::vector<Entry> entries;
  entries.reserve(complex.vertices.size() + complex.edges.size() + complex.triangles.size() +
                  complex.tetrahedra.size());
  append(complex.vertices, entries);
  append(complex.edges, entries);
  append(complex.triangles, entries);
  append(complex.tetrahedra, entries);
  cancel.throw_if_cancelled();
  tbb::parallel_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return a.is_before(b); });
  std::vector<SimplexPlace> order(entries.size());
  // Each range sorts the floats that begin in it.
  parallel_ranges(0, entries.size(), 1024, [&](std::size_t first, std::size_t last) {
    std::size_t begin = first;
    while (begin > 0 && begin < last && entries[begin].value == entries[begin - 1].value) ++begin;
    for (std::size_t end = begin; begin < last; begin = end) {
      if (cancel.cancelled()) return;
      while (end < entries.size() && entries[end].value == entries[begin].value) ++end;
      const std::size_t count = end - begin;
      if (count == 1) {
        order[begin] = entries[begin].place;
      } else {
        OneFloat(balls, complex, Members(entries).subspan(begin, count))
            .sort_into(std::span(order).subspan(begin, count));
      }
    }
  });
  cancel.throw_if_cancelled();
  return order;
}

}  // namespace alphascope
