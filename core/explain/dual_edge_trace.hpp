// SPDX-License-Identifier: GPL-3.0-or-later
// Collects reports of BallSimplices about the simplices of one ball. Inner header of core/explain.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "core/dual_edge/ball_simplices_sink.hpp"
#include "core/explain/step_tallies.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// Numbers and lists for all simplices with the ball, at whichever of their balls the engine finds
// them.
struct DualEdgeTrace {
  // About the ball's own list of neighbours:
  std::uint64_t coverers = 0;     // number of coverers that were tried
  std::vector<BallIndex> listed;  // neighbours that may cut
  std::vector<BallIndex> facing;  // those of them that may have a facet

  TestTallies edges;  // conflict: attached; band: integers were needed
  OptimisationTallies triples;
  TestTallies filter, exact;  // of dual edges; valid: a rest is left
  Tally outside, held, far, moved;
  std::vector<StepSegment> filter_segments, exact_segments;
  std::vector<StepDualEdge> samples;
  Tally left, above_alpha, attached, triangles;
  MarkedSimplices beyond{.mark = StepMark::dropped}, in{.mark = StepMark::kept};
  std::set<std::array<BallIndex, 4>> tetrahedra;
};

// Thrown through the engine's code if a ball has more than kMostDualEdgesOfBall.
struct TooManyDualEdges {};

class DualEdgeTraceSink final : public BallSimplicesSink {
 public:
  // Writes the reports about `ball` to `trace`.
  DualEdgeTraceSink(const BallSet& balls, BallIndex ball, const RunContext& context,
                    DualEdgeTrace& trace)
      : balls_(balls), about_(ball), context_(context), trace_(trace) {}
  // Must be called before BallSimplices runs for the ball `from`.
  void start(BallIndex from) { from_ = from; }

  bool wants(int j, int k) const override;
  void operator()(const ListNote& note) const override;
  void operator()(const CentreNote& note) const override;
  void operator()(const EdgeNote& note) const override;
  void operator()(const TripleNote& note) const override;
  void operator()(const DualEdge<double>& edge) const override;
  void operator()(const DualEdge<double>& edge, int m, DualEdge<double>::Takes takes,
                  bool gone) const override;
  void operator()(int high, int low) const override;
  void operator()(int taken_by) const override;
  void operator()(const FaceNote& note) const override;

 private:
  // The current dual edge, as far as it is known.
  struct Current {
    std::array<BallIndex, 3> triangle{};
    int j = 0, k = 0;
    // The dual edge as kernel II has clipped it so far; empty if no point of the line is within
    // alpha.
    std::optional<DualEdge<double>> edge;
    StepDualEdge steps;
    bool unsure = false;
    // `ends` is set if kernel III found both ends. `taken_by` is the ball that took the rest, in
    // either kernel; -1: none.
    std::optional<std::array<int, 2>> ends;
    int taken_by = -1;
  };
  // The current edge.
  struct CurrentEdge {
    bool integers = false;
    int cut_by = -1;
  };

  BallIndex ball(int slot) const { return list_[static_cast<std::size_t>(slot)]; }
  bool here() const { return from_ == about_; }
  LiftedVector<double> lifted(int slot) const;
  RealPoint place(const DualEdge<double>& edge, double s) const;
  StepSegment segment(const DualEdge<double>& edge, double high, double low) const;
  void filtered(bool open) const;
  void exactly() const;
  void decided(const TriangleFace& face) const;
  void keep_sample(StepMark mark) const;

  const BallSet& balls_;
  const BallIndex about_;
  const RunContext& context_;
  DualEdgeTrace& trace_;
  BallIndex from_ = 0;
  // Mutable because sinks are called as constants.
  mutable std::vector<BallIndex> list_;
  mutable CurrentEdge edge_;
  mutable Current current_;
};

}  // namespace alphascope
