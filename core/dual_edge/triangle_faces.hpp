// From a triangle ijk of ball i and two of its neighbours to the simplices that its dual edge
// shows: itself and the tetrahedra at the ends. One template body for the CPU and the CUDA
// executor.
//
// The neighbours of ball i are numbered by ball index. Each later neighbour j has a row of bits, 32
// a word: bit m says that m meets j as well as i. So the balls that can cut the dual edge of ijk
// are row_j & row_k (docs/algorithm.md: what cuts it where pi_i <= alpha meets all three), and
// every tetrahedron is found once, from its three lowest balls.
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

// The same with the bits of those neighbours whose planes are nearest: they cut first, and little
// is left to do for the rest.
struct NearFirstRows : TriangleRows {
  const std::uint32_t* near;
};

// The last vertices of a triangle's tetrahedra in K_alpha, -1 for none; not `known`: undecided.
struct TriangleEnds {
  int high, low;
  bool known;
};

// The same with the triangle itself. Attached: its orthocentre lies beyond that end, and its alpha
// value is that of the tetrahedron there.
struct TriangleFace {
  enum class Attached : signed char { no, high, low };
  Decision in;    // K_alpha; the rest counts if it is
  int high, low;  // slots of any order, unlike those that tetrahedra are listed by
  Attached attached;

  static ALPHASCOPE_INLINE TriangleFace undecided() {
    return {Decision::unknown, -1, -1, Attached::no};
  }
  static ALPHASCOPE_INLINE TriangleFace absent() { return {Decision::out, -1, -1, Attached::no}; }
  ALPHASCOPE_INLINE int cofaces() const { return (high >= 0) + (low >= 0); }
};

// Clips by the neighbours whose bits `cutters(word)` gives; true when nothing is left. `lifted(m)`:
// the vector of neighbour m in the units of Real. `sink` gets the edge after each neighbour, what
// that one takes, and whether nothing is left. (One loop over the bits of all words costs a GPU 2 %
// more.)
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

template <class Real, class Lifted, class Sink = NotRecorded>
ALPHASCOPE_INLINE bool clips_away(DualEdge<Real>& edge, const TriangleRows& t, int words,
                                  const Lifted& lifted, const Sink& sink = {}) {
  return clips_away(
      edge, words, [&](int w) { return t.common(w); }, lifted, sink);
}
template <class Real, class Lifted, class Sink = NotRecorded>
ALPHASCOPE_INLINE bool clips_away(DualEdge<Real>& edge, const NearFirstRows& t, int words,
                                  const Lifted& lifted, const Sink& sink = {}) {
  return clips_away(
             edge, words, [&](int w) { return t.common(w) & t.near[w]; }, lifted, sink) ||
         clips_away(
             edge, words, [&](int w) { return t.common(w) & ~t.near[w]; }, lifted, sink);
}

// The dual edge of a triangle after all its cuts; false when nothing is left. `sink` gets it before
// the first cut, and then as clips_away() says. (In one expression: with two statements nvcc makes
// other code of the empty sink.)
template <class Real, class Rows, class Lifted, class Sink = NotRecorded>
ALPHASCOPE_INLINE bool clipped_edge(DualEdge<Real>& edge, const Rows& t, int words,
                                    Real radius_square, const Lifted& lifted,
                                    const Sink& sink = {}) {
  return edge.start(lifted(t.j), lifted(t.k), radius_square) &&
         (sink(edge), !clips_away(edge, t, words, lifted, sink));
}

// Kernel II of one triangle, tetrahedra only: those whose last vertex comes after k.
template <class Real, class Rows, class Lifted>
ALPHASCOPE_INLINE TriangleEnds filtered_ends(const Rows& t, int words, Real radius_square,
                                             const Lifted& lifted) {
  DualEdge<Real> edge;
  if (!clipped_edge(edge, t, words, radius_square, lifted)) return {-1, -1, true};
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

// A triangle whose dual edge is there: `high` and `low` say whether its ends are in K_alpha (out
// where no ball ends it), and whether they cut off the orthocentre; `own`, whether rho <= alpha.
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

// Kernel II of one triangle. `sink`: see clipped_edge().
template <class Real, class Rows, class Lifted, class Sink = NotRecorded>
ALPHASCOPE_INLINE TriangleFace filtered_face(const Rows& t, int words, Real radius_square,
                                             const Lifted& lifted, const Sink& sink = {}) {
  DualEdge<Real> edge;
  if (!clipped_edge(edge, t, words, radius_square, lifted, sink)) return TriangleFace::absent();
  if (!edge.ends_certain() || !edge.certainly_there()) return TriangleFace::undecided();
  const auto &high = edge.high(), &low = edge.low();
  const bool has_high = high.cutter >= 0, has_low = low.cutter >= 0;
  return decided_face(
      {has_high ? edge.within(high, radius_square) : Decision::out,
       has_low ? edge.within(low, radius_square) : Decision::out,
       has_high ? edge.beyond_foot(high) : Decision::out,
       has_low ? edge.beyond_foot(low) : Decision::out, edge.foot_within(radius_square)},
      high.cutter, low.cutter);
}

// Kernel III of one triangle in integers; Integer as orthocentre_cut() asks. `sink`: see
// exact_ends().
template <class Integer, class Neighbours, class Sink = NotRecorded>
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
// Of a decided triangle.
ALPHASCOPE_INLINE TriangleEnds later_ends(const TriangleFace& face, int k) {
  return {face.high > k ? face.high : -1, face.low > k ? face.low : -1, true};
}

// The alpha value of a triangle in K_alpha, the nearest float.
template <class Decider, class Neighbours>
ALPHASCOPE_INLINE Decision triangle_value(const Neighbourhood<Neighbours>& in, int j, int k,
                                          const TriangleFace& face, float* value) {
  using Attached = TriangleFace::Attached;
  if (face.attached == Attached::no) return decide_simplex<Decider>(in, value, j, k);
  return decide_simplex<Decider>(in, value, j, k,
                                 face.attached == Attached::high ? face.high : face.low);
}

}  // namespace alphascope
