// SPDX-License-Identifier: GPL-3.0-or-later
// The flow of a triangulation: alpha value and outflow of each tetrahedron, and whether a flow path
// reaches a sink or infinity.
#include "core/triangulation/flow.hpp"

#include <atomic>
#include <vector>

#include "core/predicates/exact_alpha.hpp"
#include "core/predicates/flow_predicate.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

// One tetrahedron, with its balls lifted from the first one.
class Tetrahedron {
 public:
  Tetrahedron(const BallSet& balls, const std::array<BallIndex, 4>& simplex)
      : balls_(balls), simplex_(simplex), weight_(balls.weight(simplex[0])) {
    for (std::size_t n = 0; n < 3; ++n) v_[n] = lifted_vector(balls, simplex[0], simplex[n + 1]);
    if (!within_bracket_limit(v_[0]) || !within_bracket_limit(v_[1]) ||
        !within_bracket_limit(v_[2])) {
      return;
    }
    const TetrahedronCentre centre = tetrahedron_centre(
        lifted_as<double>(v_[0]), lifted_as<double>(v_[1]), lifted_as<double>(v_[2]));
    rho_ = tetrahedron_rho(centre, static_cast<double>(weight_));
    flow_sides_filtered(centre, beyond_);
  }

  float alpha_value() const {
    float rounded = 0;
    if (round_bracket(rho_, &rounded)) return rounded;
    return round_exact(exact_tetrahedron_rho(v_[0], v_[1], v_[2], weight_));
  }

  // The faces through which it flows out, as bits of Flow::marks. Counts exact ties in `tied`.
  std::uint8_t flow(FlowTies ties, std::atomic<std::size_t>& tied) const {
    unsigned faces = 0;
    for (unsigned k = 0; k < 4; ++k) {
      if (beyond_[k] > 0 || (beyond_[k] == 0 && flows_exactly(k, ties, tied))) faces |= 1u << k;
    }
    return static_cast<std::uint8_t>(faces);
  }

 private:
  bool flows_exactly(unsigned k, FlowTies ties, std::atomic<std::size_t>& tied) const {
    const BallIndex i = simplex_[k == 0 ? 1 : 0];
    const LiftedInt a = lifted_vector(balls_, i, simplex_[k < 2 ? 2 : 1]),
                    b = lifted_vector(balls_, i, simplex_[k < 3 ? 3 : 2]),
                    m = lifted_vector(balls_, i, simplex_[k]);
    const int side = flow_side_exact(a, b, m);
    if (side != 0) return side > 0;
    ++tied;
    return tied_flow(a, b, m, ties);
  }

  const BallSet& balls_;
  const std::array<BallIndex, 4>& simplex_;
  const std::int64_t weight_;
  LiftedInt v_[3];
  Bracket rho_{0, HUGE_VAL};
  signed char beyond_[4] = {0, 0, 0, 0};
};

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
    const Tetrahedron tetrahedron(balls, triangulation.tetrahedra[t]);
    flow.alpha_values[t] = tetrahedron.alpha_value();
    flow.marks[t] = tetrahedron.flow(ties, tied);
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
