// SPDX-License-Identifier: GPL-3.0-or-later
// Rows for the later neighbours j of a block's balls: the balls that meet both (a row of bits). It
// also decides whether edge ij can be in K_alpha, attached or not.
#pragma once

#include "core/geometry/ordered_bits.hpp"
#include "gpu/dual_edge/dual_edge_block.cuh"

namespace alphascope::gpu {

// Decides whether ball m cuts off the orthocentre of edge ij, if single precision leaves it open.
// Not inlined, because it is rare and would take registers from the loop.
template <class Decider>
__device__ __noinline__ Decision edge_attached_slowly(const DualEdgeProblem& p,
                                                      const ExactNeighbours& n, int j, int m) {
  return edge_attached_to<Decider>(n.of(p), j, m);
}
template <class Decider>
__device__ __noinline__ Decision edge_within_slowly(const DualEdgeProblem& p,
                                                    const ExactNeighbours& n, int j) {
  return decide_simplex<Decider>(n.of(p), nullptr, j);
}

template <class Kind>
class RowMaker {
 public:
  // Makes the row of neighbour j of ball b.
  __device__ RowMaker(const Block& block, int row, int b)
      : block_(block),
        m_(block.m),
        s_(block.s),
        words_(block.words),
        b_(b),
        row_number_(row),
        j_(s_.list[b] - s_.later[b] + row - s_.row0[b]),
        entry0_(s_.entry0[b]),
        row_(m_.rows + row * words_) {}

  // Fills the row. It stays empty if ij is not in K_alpha. Then j is in no triangle of ball i, but
  // still cuts other dual edges.
  __device__ void make() {
    std::uint32_t* possible = &m_.possible[b_ * words_ + (j_ >> 5)];
    const std::uint32_t bit = 1u << (j_ & 31);
    const bool dead = Kind::kEdges && !(*possible & bit);
    if (!dead) meet();
    const bool absent = Kind::kWhole && !dead && !decide_edge();
    if (absent) atomicAnd(possible, ~bit);
    if (dead || absent) {
      for (int w = 0; w < words_; ++w) row_[w] = 0;
    }
  }

 private:
  using Decider = std::conditional_t<Kind::kExact, ExactDecider, FilteredDecider>;

  // Sets the bits of the neighbours that meet j.
  __device__ void meet() {
    const float4 vj = m_.vectors[entry0_ + j_];
    const float reach = m_.reach[entry0_ + j_];
    const int n = s_.list[b_];
    for (int w = 0; w < words_; ++w) {
      std::uint32_t bits = 0;
      const int end = min(n, w * 32 + 32);
      for (int k = w * 32; k < end; ++k) {
        // Both are whole numbers of lattice units below 2^24, so exact; their difference is rounded
        // once.
        const float4 v = m_.vectors[entry0_ + k];
        if (grown_balls_may_meet(v.x - vj.x, v.y - vj.y, v.z - vj.z, reach, m_.reach[entry0_ + k]))
          bits |= 1u << (k & 31);
      }
      if (j_ >> 5 == w) bits &= ~(1u << (j_ & 31));
      row_[w] = bits;
    }
  }

  // Returns false if the edge is not in K_alpha. For a whole complex it also decides whether the
  // edge is attached.
  __device__ bool decide_edge() {
    const ScaledNeighbours vectors{m_.vectors + entry0_};
    const FacetDisc<float> disc(vectors(j_), s_.radius_square[b_]);
    if (disc.certainly_empty()) return false;
    for (int w = 0; w < words_; ++w) {
      for (std::uint32_t bits = row_[w]; bits != 0; bits &= bits - 1) {
        const int k = w * 32 + lowest_bit(bits);
        if (cuts_centre(disc.centre_cut_by(vectors(k)), k)) return true;
      }
    }
    return within_alone(disc.centre_within());
  }

  __device__ bool cuts_centre(Decision d, int k) {
    if (d == Decision::unknown) {
      d = edge_attached_slowly<Decider>(block_.p, exact_neighbours(block_, b_), j_, k);
      if (d == Decision::unknown) atomicMax(&s_.exact[b_], 1);
    }
    return d == Decision::in;
  }

  // Decides an unattached edge; returns false if it is above alpha.
  __device__ bool within_alone(Decision d) {
    if (d == Decision::unknown) {
      d = edge_within_slowly<Decider>(block_.p, exact_neighbours(block_, b_), j_);
      if (d == Decision::unknown) atomicMax(&s_.exact[b_], 1);
    }
    if (d == Decision::in)
      m_.row_ball[row_number_] = static_cast<std::uint8_t>(b_ | kUnattachedRow);
    return d != Decision::out;
  }

  const Block& block_;
  const DualEdgeMemory& m_;
  BlockBalls& s_;
  const int words_, b_, row_number_, j_, entry0_;
  std::uint32_t* row_;
};

// Makes the rows of all the block's balls. Every thread must call it.
template <class Kind>
__device__ inline void make_rows(const Block& block) {
  for (int row = threadIdx.x; row < block.s.rows; row += kBlockThreads) {
    const int b = block.m.row_ball[row];
    if (b < kMaxBallsPerBlock) RowMaker<Kind>(block, row, b).make();
  }
  __syncthreads();
}

}  // namespace alphascope::gpu
