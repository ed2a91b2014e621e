// From a triangle ijk of ball i and two of its neighbours to the tetrahedra at the ends of its dual
// edge: one template body for the CPU and the CUDA executor.
//
// The neighbours of ball i are numbered by ball index. Each later neighbour j has a row of bits, 32
// a word: bit m says that m meets j as well as i. So the balls that can cut the dual edge of ijk
// are row_j & row_k (docs/algorithm.md: what cuts it where pi_i <= alpha meets all three), and
// every tetrahedron is found once, from its three lowest balls.
#pragma once

#include "core/complex/dual_edge.hpp"
#include "core/complex/exact_dual_edge.hpp"

namespace alphascope {

ALPHASCOPE_INLINE int lowest_bit(std::uint32_t bits) {
#ifdef __CUDA_ARCH__
  return __ffs(static_cast<int>(bits)) - 1;
#else
  return __builtin_ctz(bits);
#endif
}

// The bits of a word that stand for numbers above k.
ALPHASCOPE_INLINE std::uint32_t bits_after(int k, int word) {
  const int first = k + 1 - word * 32;
  return first <= 0 ? ~0u : first >= 32 ? 0u : ~0u << first;
}

struct TriangleRows {
  int j, k;
  const std::uint32_t *row_j, *row_k;

  ALPHASCOPE_INLINE std::uint32_t common(int word) const { return row_j[word] & row_k[word]; }
  // Is there a neighbour of higher index than k that meets all three?
  ALPHASCOPE_INLINE bool has_fourth(int words) const {
    for (int w = k >> 5; w < words; ++w) {
      if ((common(w) & bits_after(k, w)) != 0) return true;
    }
    return false;
  }
  // The first common neighbour after m, or -1.
  ALPHASCOPE_HOST_DEVICE int next_common(int m, int words) const {
    for (int w = (m + 1) >> 5; w < words; ++w) {
      const std::uint32_t bits = common(w) & bits_after(m, w);
      if (bits != 0) return w * 32 + lowest_bit(bits);
    }
    return -1;
  }
};

// The last vertices of a triangle's tetrahedra in K_alpha, -1 for none; not `known`: undecided.
struct TriangleEnds {
  int high, low;
  bool known;
};

// Clips by the neighbours of one word of bits, of which bit 0 is number `base`; true when nothing
// is left.
template <class Real, class Lifted>
ALPHASCOPE_INLINE bool clip_by(DualEdge<Real>& edge, std::uint32_t bits, int base,
                               const Lifted& lifted) {
  using Takes = typename DualEdge<Real>::Takes;
  for (; bits != 0; bits &= bits - 1) {
    const int m = base + lowest_bit(bits);
    const auto cut = edge.cut_by(lifted(m));
    const Takes takes = edge.takes(cut);
    if (takes == Takes::all || (takes == Takes::some && edge.clip(cut, m))) return true;
  }
  return false;
}

// Kernel II of one triangle. `lifted(m)`: the vector of neighbour m in the units of Real.
template <class Real, class Lifted>
ALPHASCOPE_INLINE TriangleEnds filtered_ends(const TriangleRows& t, int words, Real radius_square,
                                             const Lifted& lifted) {
  DualEdge<Real> edge;
  if (!edge.start(lifted(t.j), lifted(t.k), radius_square)) return {-1, -1, true};
  for (int w = 0; w < words; ++w) {
    if (clip_by(edge, t.common(w), w * 32, lifted)) return {-1, -1, true};
  }
  if (!edge.ends_certain()) return {-1, -1, false};
  TriangleEnds ends{-1, -1, true};
  const bool high = edge.high().cutter > t.k, low = edge.low().cutter > t.k;
  if (!high && !low) return ends;
  ends.known = edge.certainly_there();
  if (high) {
    const Decision d = edge.within(edge.high(), radius_square);
    if (d == Decision::in) ends.high = edge.high().cutter;
    ends.known = ends.known && d != Decision::unknown;
  }
  if (low) {
    const Decision d = edge.within(edge.low(), radius_square);
    if (d == Decision::in) ends.low = edge.low().cutter;
    ends.known = ends.known && d != Decision::unknown;
  }
  return ends;
}

// Kernel III of one triangle in integers; Integer as orthocentre_cut() asks.
template <class Integer, class Neighbours>
ALPHASCOPE_HOST_DEVICE TriangleEnds exact_ends(const FacetInput<Neighbours>& in,
                                               const TriangleRows& t, int words) {
  const auto next = [&](int m) { return t.next_common(m, words); };
  const int high = exact_end<Integer>(in, t.k, 1, next),
            low = exact_end<Integer>(in, t.k, -1, next);
  return {high > t.k ? high : -1, low > t.k ? low : -1, true};
}

}  // namespace alphascope
