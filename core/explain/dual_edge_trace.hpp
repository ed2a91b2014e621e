// What BallSimplices tells of the simplices of one ball, counted and listed. Inner header of
// core/steps.
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

// Of all simplices with the ball, at whichever of their balls the engine finds them.
struct DualEdgeTrace {
  // The ball's own list of neighbours.
  std::uint64_t coverers = 0;     // that were tried
  std::vector<BallIndex> listed;  // that may cut
  std::vector<BallIndex> facing;  // of them: that may have a facet

  Fates edges;  // conflict: attached; band: integers were needed
  Choice triples;
  Fates filter, exact;  // dual edges; valid: something is left
  Tally outside, held, far, moved;
  std::vector<StepSegment> filter_segments, exact_segments;
  std::vector<StepDualEdge> samples;
  Tally left, above_alpha, attached, triangles;
  MarkedSimplices beyond{.mark = StepMark::dropped}, in{.mark = StepMark::kept};
  std::set<std::array<BallIndex, 4>> tetrahedra;
};

// Thrown through the engine's code.
struct TooManyDualEdges {};

class DualEdgeTraceSink final : public BallSimplicesSink {
 public:
  // What is about `ball` goes to `trace`.
  DualEdgeTraceSink(const BallSet& balls, BallIndex ball, const RunContext& context,
                    DualEdgeTrace& trace)
      : balls_(balls), about_(ball), context_(context), trace_(trace) {}
  // The next run of BallSimplices is with the ball `from`.
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
  // The dual edge at hand, as far as it is known.
  struct Current {
    std::array<BallIndex, 3> triangle{};
    int j = 0, k = 0;
    // Kernel II: none when no point of the line is within alpha.
    std::optional<DualEdge<double>> edge;
    StepDualEdge steps;
    bool unsure = false;
    // Kernel III: it found both ends; and in either, who took the rest.
    std::optional<std::array<int, 2>> ends;
    int taken_by = -1;
  };
  // An edge at hand.
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
  // Sinks are called as constants.
  mutable std::vector<BallIndex> list_;
  mutable CurrentEdge edge_;
  mutable Current current_;
};

}  // namespace alphascope
