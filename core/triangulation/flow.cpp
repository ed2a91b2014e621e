// SPDX-License-Identifier: GPL-3.0-or-later
// The flow of a triangulation: alpha value and outflow of each tetrahedron, and whether a flow path
// reaches a sink or infinity.
#include "core/triangulation/flow.hpp"

#include <atomic>
#include <vector>

#include "core/predicates/simplex_corners.hpp"
#include "core/run/parallel.hpp"
#include "core/triangulation/tetrahedron_flow.hpp"

namespace alphascope {
namespace {

// Marks the tetrahedra from which a flow path leads to a start. It goes against the flow, face by
// face.
class Reach {
 public:
  Reach(const Triangulation& triangulation, Flow& flow, std::uint8_t mark)
      : triangulation_(triangulation), flow_(flow), mark_(mark) {}

  // Marks the starts, for which `starts` is true, and all tetrahedra that flow to them.
  template <class Starts>
  void from(const Starts& starts, const CancelToken& cancel) {
    constexpr std::size_t kGrain = 1024;
    parallel_ranges(0, static_cast<std::uint32_t>(flow_.marks.size()), kGrain,
                    [&](std::uint32_t first, std::uint32_t end) {
                      std::vector<std::uint32_t> open;
                      for (std::uint32_t t = first; t != end; ++t) {
                        if (starts(t)) visit(t, open);
                        while (!open.empty()) {
                          const std::uint32_t last = open.back();
                          open.pop_back();
                          go_on(last, open);
                        }
                        if (t % 256 == 0 && cancel.cancelled()) return;
                      }
                    });
    cancel.throw_if_cancelled();
  }

 private:
  void visit(std::uint32_t t, std::vector<std::uint32_t>& open) {
    std::atomic_ref<std::uint8_t> marks(flow_.marks[t]);
    if (marks.load(std::memory_order_relaxed) & mark_) return;
    if (!(marks.fetch_or(mark_, std::memory_order_relaxed) & mark_)) open.push_back(t);
  }
  void go_on(std::uint32_t t, std::vector<std::uint32_t>& open) {
    for (const Neighbour across : triangulation_.neighbours[t]) {
      if (across.is_hull()) continue;
      const auto& back = triangulation_.neighbours[across.index()];
      unsigned k = 0;
      while (back[k] != Neighbour::tetrahedron(t)) ++k;
      const std::uint8_t marks =
          std::atomic_ref(flow_.marks[across.index()]).load(std::memory_order_relaxed);
      if (marks >> k & 1) visit(across.index(), open);
    }
  }

  const Triangulation& triangulation_;
  Flow& flow_;
  const std::uint8_t mark_;
};

}  // namespace

Flow make_flow(const BallSet& balls, const Triangulation& triangulation, FlowTies ties,
               const CancelToken& cancel) {
  Flow flow;
  const std::size_t count = triangulation.tetrahedra.size();
  flow.marks.resize(count);
  flow.alpha_values.resize(count);
  std::atomic<std::size_t> tied = 0;
  parallel_many(count, cancel, [&](std::size_t t) {
    const SimplexCorners<4> corners{balls, triangulation.tetrahedra[t]};
    const TetrahedronFlow tetrahedron(corners);
    flow.alpha_values[t] = tetrahedron.alpha_value();
    std::uint32_t tied_here = 0;
    flow.marks[t] = tetrahedron.flow(ties, tied_here);
    if (tied_here > 0) tied += tied_here;
  });
  flow.ties = tied;
  const auto faces = [&](std::uint32_t t) {
    return std::atomic_ref(flow.marks[t]).load(std::memory_order_relaxed) & Flow::kFaces;
  };
  Reach(triangulation, flow, Flow::kReachesSink)
      .from([&](std::uint32_t t) { return faces(t) == 0; }, cancel);
  Reach(triangulation, flow, Flow::kReachesInfinity)
      .from(
          [&](std::uint32_t t) {
            const unsigned out = faces(t);
            for (unsigned k = 0; k < 4; ++k) {
              if ((out >> k & 1) && triangulation.neighbours[t][k].is_hull()) return true;
            }
            return false;
          },
          cancel);
  return flow;
}

}  // namespace alphascope
