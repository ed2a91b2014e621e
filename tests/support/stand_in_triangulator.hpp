// SPDX-License-Identifier: GPL-3.0-or-later
// A device for tests: its triangulations are CGAL's, or it makes none and says why.
#pragma once

#include <string>
#include <utility>

#include "core/geometry/ball_set.hpp"
#include "core/triangulation/cgal_triangulation.hpp"
#include "core/triangulation/device_triangulator.hpp"

namespace alphascope::testing {

struct TriangulatorCalls {
  int made = 0, asked = 0, released = 0;
  int filtrations = 0, grounds = 0, memberships = 0;
  bool takes_much_room = false;
};

class StandInTriangulator : public DeviceTriangulator {
 public:
  StandInTriangulator(TriangulatorCalls& calls, std::string why_not)
      : calls_(calls), why_not_(std::move(why_not)) {
    ++calls_.made;
  }
  DeviceTriangulation make(const BallSet& balls, const RunContext& context) override {
    ++calls_.asked;
    context.cancel.throw_if_cancelled();
    DeviceTriangulation made;
    made.report.maker = "a device";
    made.report.waves = 3;
    made.report.why_not = why_not_;
    if (why_not_.empty()) made.triangulation = make_cgal_triangulation(balls, 1);
    return made;
  }
  // It makes no filtrations, the CPU's grounds, and knows no ground.
  std::optional<FiltrationParts> filtration_parts(const BallSet&, const Triangulation&,
                                                  const RunContext& context,
                                                  std::string& why_not) override {
    ++calls_.filtrations;
    context.cancel.throw_if_cancelled();
    why_not = "it makes none";
    return std::nullopt;
  }
  std::optional<TriangulationGround> ground(const BallSet& balls,
                                            const Triangulation& triangulation, FlowTies ties,
                                            const RunContext& context, std::string&) override {
    ++calls_.grounds;
    return TriangulationGround{make_incidence(triangulation, context.cancel),
                               make_flow(balls, triangulation, ties, context.cancel)};
  }
  std::optional<Membership> membership(const Incidence&, const LatticeAlpha&,
                                       const CancelToken&) override {
    ++calls_.memberships;
    return std::nullopt;
  }
  std::optional<ResultArray<OutsidePart>> outside_parts(const Membership&,
                                                        std::span<const std::uint32_t>, double,
                                                        const CancelToken&) override {
    return std::nullopt;
  }
  bool takes_much_room() override { return calls_.takes_much_room; }
  void release_memory() override { ++calls_.released; }

 private:
  TriangulatorCalls& calls_;
  std::string why_not_;
};

}  // namespace alphascope::testing
