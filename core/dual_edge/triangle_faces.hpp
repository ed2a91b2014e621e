// SPDX-License-Identifier: GPL-3.0-or-later
// Decides a triangle ijk of ball i and two neighbours, and the tetrahedra at the ends of its dual
// edge. One template body serves the CPU and the CUDA executor.
//
// The neighbours of ball i are numbered by ball index. Each later neighbour j has a row of bits in
// words of 32: bit m is set if m meets j as well as i. Every ball that cuts the dual edge where
// pi_i <= alpha meets i, j and k (docs/algorithm.md). So row_j & row_k holds all that can cut it,
// and every tetrahedron is found once, from its three lowest balls.
#pragma once

#include "core/dual_edge/dual_edge.hpp"
#include "core/dual_edge/exact_dual_edge.hpp"
#include "core/predicates/recording.hpp"

namespace alphascope {

ALPHASCOPE_INLINE int lowest_bit(std::uint32_t bits) {
#ifdef __CUDA_ARCH__
  return __ffs(static_cast<int>(bits)) - 1;
#else
  return __builtin_ctz(bits);
#endif
}

// The bits of word `word` for neighbours with a number above k.
ALPHASCOPE_INLINE std::uint32_t bits_after(int k, int word) {
  const int first = k + 1 - word * 32;
  return first <= 0 ? ~0u : first >= 32 ? 0u : ~0u << first;
}

struct TriangleRows {
  int j, k;
  const std::uint32_t *row_j, *row_k;

  ALPHASCOPE_INLINE std::uint32_t common(int word) const { return row_j[word] & row_k[word]; }
  // Is there a neighbour with a higher number than k that meets i, j and k?
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

// TriangleRows with a row of bits for the neighbours whose radical planes are nearest. These cut
// first, and leave little work for the others.
struct NearFirstRows : TriangleRows {
  const std::uint32_t* near;
};

// The last vertices of the tetrahedra of a triangle that are in K_alpha; -1: none. Undecided if not
// `known`.
struct TriangleEnds {
  int high, low;
  bool known;
};

// The ends, and the triangle itself. `attached` is the end whose ball cuts off the orthocentre; the
// alpha value is then that of the tetrahedron at that end.
struct TriangleFace {
  enum class Attached : signed char { no, high, low };
  Decision in;    // is the triangle in K_alpha? The other members are valid only if it is
  int high, low;  // slots, also lower than k; -1: that tetrahedron is not in K_alpha
  Attached attached;

  static ALPHASCOPE_INLINE TriangleFace undecided() {
    return {Decision::unknown, -1, -1, Attached::no};
  }
  static ALPHASCOPE_INLINE TriangleFace absent() { return {Decision::out, -1, -1, Attached::no}; }
  ALPHASCOPE_INLINE int cofaces() const { return (high >= 0) + (low >= 0); }
};

// Clips by the neighbours whose bits are set in `cutters(word)`; true when nothing is left.
// `lifted(m)` is the vector of neighbour m in the units of Real. After each neighbour, `sink` gets
// the edge, the part that this neighbour removed, and whether nothing is left. A single loop over
// the bits of all words is 2 % slower on a GPU.
template <class Real, class Cutters, class Lifted, class Sink>
ALPHASCOPE_INLINE bool clips_away(DualEdge<Real>& edge, int words, const Cutters& cutters,
                                  const Lifted& lifted, const Sink& sink) {
  using Takes = typename DualEdge<Real>::Takes;
  for (int w = 0; w < words; ++w) {
    for (std::uint32_t bits = cutters(w); bits != 0; bits &= bits - 1) {
      const int m = w * 32 + lowest_bit(bits);
      const auto cut = edge.cut_by(lifted(m));
      const Takes takes = edge.takes(cut);
      if (takes == Takes::all || (takes == Takes::some && edge.clip(cut, m))) {
        sink(edge, m, takes, true);
        return true;
      }
      sink(edge, m, takes, false);
    }
  }
  return false;
}

template <class Real, class Lifted, class Sink = NoSink>
ALPHASCOPE_INLINE bool clips_away(DualEdge<Real>& edge, const TriangleRows& t, int words,
                                  const Lifted& lifted, const Sink& sink = {}) {
  return clips_away(
      edge, words, [&](int w) { return t.common(w); }, lifted, sink);
}
template <class Real, class Lifted, class Sink = NoSink>
ALPHASCOPE_INLINE bool clips_away(DualEdge<Real>& edge, const NearFirstRows& t, int words,
                                  const Lifted& lifted, const Sink& sink = {}) {
  return clips_away(
             edge, words, [&](int w) { return t.common(w) & t.near[w]; }, lifted, sink) ||
         clips_away(
             edge, words, [&](int w) { return t.common(w) & ~t.near[w]; }, lifted, sink);
}

// The dual edge of a triangle after all cuts; false when nothing is left. `sink` gets the edge
// before the first cut, and then the calls of clips_away(). This is one expression because two
// statements make nvcc emit other code for the empty sink.
template <class Real, class Rows, class Lifted, class Sink = NoSink>
ALPHASCOPE_INLINE bool clipped_edge(DualEdge<Real>& edge, const Rows& t, int words,
                                    Real radius_square, const Lifted& lifted,
                                    const Sink& sink = {}) {
  return edge.start(lifted(t.j), lifted(t.k), radius_square) &&
         (sink(edge), !clips_away(edge, t, words, lifted, sink));
}

// Kernel II for one triangle when only tetrahedra are requested: those whose last vertex comes
// after k.
template <class Real, class Rows, class Lifted>
ALPHASCOPE_INLINE TriangleEnds filtered_ends(const Rows& t, int words, Real radius_square,
                                             const Lifted& lifted) {
  DualEdge<Real> edge;
  if (!clipped_edge(edge, t, words, radius_square, lifted)) return {-1, -1, true};
  if (!edge.ends_certain()) return {-1, -1, false};
  TriangleEnds ends{-1, -1, true};
  const bool high = edge.high().cutter > t.k, low = edge.low().cutter > t.k;
  if (!high && !low) return ends;
  ends.known = edge.certainly_not_empty();
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

// Decisions about a triangle whose dual edge is not empty. `high`, `low`: is the tetrahedron at
// that end in K_alpha (`out` where no ball ends the edge)? `high_cuts`, `low_cuts`: does that end
// cut off the orthocentre? `own`: is rho <= alpha?
struct FaceDecisions {
  Decision high, low, high_cuts, low_cuts, own;
};
ALPHASCOPE_INLINE TriangleFace decided_face(const FaceDecisions& d, int high, int low) {
  using Attached = TriangleFace::Attached;
  if (d.high == Decision::unknown || d.low == Decision::unknown ||
      d.high_cuts == Decision::unknown || d.low_cuts == Decision::unknown)
    return TriangleFace::undecided();
  const Attached attached = d.high_cuts == Decision::in  ? Attached::high
                            : d.low_cuts == Decision::in ? Attached::low
                                                         : Attached::no;
  const Decision in = attached == Attached::high  ? d.high
                      : attached == Attached::low ? d.low
                                                  : d.own;
  return {in, d.high == Decision::in ? high : -1, d.low == Decision::in ? low : -1, attached};
}

// Kernel II for one triangle. `sink`: see clipped_edge().
template <class Real, class Rows, class Lifted, class Sink = NoSink>
ALPHASCOPE_INLINE TriangleFace filtered_face(const Rows& t, int words, Real radius_square,
                                             const Lifted& lifted, const Sink& sink = {}) {
  DualEdge<Real> edge;
  if (!clipped_edge(edge, t, words, radius_square, lifted, sink)) return TriangleFace::absent();
  if (!edge.ends_certain() || !edge.certainly_not_empty()) return TriangleFace::undecided();
  const auto &high = edge.high(), &low = edge.low();
  const bool has_high = high.cutter >= 0, has_low = low.cutter >= 0;
  return decided_face(
      {has_high ? edge.within(high, radius_square) : Decision::out,
       has_low ? edge.within(low, radius_square) : Decision::out,
       has_high ? edge.cuts_off_foot(high) : Decision::out,
       has_low ? edge.cuts_off_foot(low) : Decision::out, edge.foot_within(radius_square)},
      high.cutter, low.cutter);
}

// Kernel III for one triangle, in integers; for Integer see kSmallOffset. `sink`: see exact_ends().
template <class Integer, class Neighbours, class Sink = NoSink>
ALPHASCOPE_HOST_DEVICE TriangleFace exact_face(const Neighbourhood<Neighbours>& in,
                                               const TriangleRows& t, int words,
                                               const Sink& sink = {}) {
  EndBall high, low;
  if (!exact_ends<Integer>(
          in, t.j, t.k, [&](int m) { return t.next_common(m, words); }, high, low, sink))
    return TriangleFace::absent();
  const auto within = [&](const EndBall& e) {
    return e.slot < 0 ? Decision::out : decide_simplex<ExactDecider>(in, nullptr, t.j, t.k, e.slot);
  };
  const auto cuts = [&](const EndBall& e) {
    return e.slot < 0 ? Decision::out : triangle_cut_by<ExactDecider>(in, t.j, t.k, e.lifted);
  };
  return decided_face({within(high), within(low), cuts(high), cuts(low),
                       decide_simplex<ExactDecider>(in, nullptr, t.j, t.k)},
                      high.slot, low.slot);
}
// The ends of a decided triangle that come after k.
ALPHASCOPE_INLINE TriangleEnds later_ends(const TriangleFace& face, int k) {
  return {face.high > k ? face.high : -1, face.low > k ? face.low : -1, true};
}

// The alpha value of a triangle in K_alpha, rounded to the nearest float.
template <class Decider, class Neighbours>
ALPHASCOPE_INLINE Decision triangle_value(const Neighbourhood<Neighbours>& in, int j, int k,
                                          const TriangleFace& face, float* value) {
  using Attached = TriangleFace::Attached;
  if (face.attached == Attached::no) return decide_simplex<Decider>(in, value, j, k);
  return decide_simplex<Decider>(in, value, j, k,
                                 face.attached == Attached::high ? face.high : face.low);
}

}  // namespace alphascope
