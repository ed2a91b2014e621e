// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the engine panel: the choice of engines, the thesis' switches, and texts on the device.
#include <gtest/gtest.h>

#include "app/viewer/session_text.hpp"
#include "tests/ui/panels/panels_fixture.hpp"
#include "ui/panels/panel_list.hpp"

namespace alphascope::testing {
namespace {

constexpr Size kLarge{1280, 2200, 1};

GpuDevice a_gpu() {
  return {true, "NVIDIA H200", "", "CUDA driver 13.0", 90, std::size_t{139} << 30};
}

TEST(EnginePanel, WithoutAGpuItsEnginesCannotBeChosen) {
  Panels panels(kLarge);
  panels.state = loaded_state();
  panels.state.gpu = GpuDevice{.why_not = "There is no NVIDIA driver."};
  panels.frame(2);
  for (const char* entry : {"engine.gpu", "engine.tuples-gpu"}) {
    panels.click("engine.choice");
    panels.click(entry);
    EXPECT_EQ(panels.state.settings.request.engine, EngineChoice::automatic) << entry;
    panels.tap(key::kEscape);
  }
  panels.click("engine.choice");
  panels.click("engine.tuples-cpu");
  EXPECT_EQ(panels.state.settings.request.engine, EngineChoice::tuples_cpu);
}

TEST(EnginePanel, WithAGpuTheyCan) {
  Panels panels(kLarge);
  panels.state = loaded_state();
  panels.state.gpu = a_gpu();
  panels.frame(2);
  panels.click("engine.choice");
  panels.click("engine.tuples-gpu");
  EXPECT_EQ(panels.state.settings.request.engine, EngineChoice::tuples_gpu);
}

TEST(EnginePanel, TheSwitchesBelongToTheTupleEngines) {
  Panels panels(kLarge);
  panels.state = loaded_state();
  panels.frame(2);
  EXPECT_FALSE(panels.rects.contains("tuples.edge"));
  panels.state.settings.request.engine = EngineChoice::tuples_cpu;
  panels.frame(2);
  panels.click("tuples.edge", 0.05f);
  EXPECT_FALSE(panels.state.settings.request.tuples.edge_optimisation);
  panels.click("tuples.texture", 0.05f);
  EXPECT_TRUE(panels.state.settings.request.tuples.texture) << "says nothing on the CPU";
  panels.state.settings.request.engine = EngineChoice::tuples_gpu;
  panels.frame(2);
  panels.click("tuples.texture", 0.05f);
  EXPECT_FALSE(panels.state.settings.request.tuples.texture);
}

TEST(EnginePanel, EachSwitchArrivesInTheRequest) {
  Request c;
  c.engine = EngineChoice::tuples_gpu;
  EXPECT_EQ(canonical(c).tuples, TupleOptions{});
  EXPECT_EQ(canonical(c).engine, EngineChoice::tuples_gpu);
  c.tuples = {TupleGridKind::thesis, false, false, false, 1, false, 0};
  const TupleOptions all_off{TupleGridKind::thesis, false, false, false, 1, false, 0};
  EXPECT_EQ(canonical(c).tuples, all_off);
  c.engine = EngineChoice::cpu;
  EXPECT_EQ(canonical(c).tuples, TupleOptions{}) << "another engine has no such switches";
  c.engine = EngineChoice::tuples_cpu;
  EXPECT_FALSE(canonical(c).tuples.edge_optimisation);
  EXPECT_TRUE(canonical(c).tuples.pinned) << "of the GPU only";
}

TEST(EnginePanel, TheDeviceTellsItsCapability) {
  GpuDevice gpu;
  EXPECT_EQ(gpu.capability_text(), "");
  gpu.compute_capability = 90;
  EXPECT_EQ(gpu.capability_text(), "9.0");
  gpu.compute_capability = 121;
  EXPECT_EQ(gpu.capability_text(), "12.1");
}

TEST(EnginePanel, ComparingEveryTimeIsOffForLargeMolecules) {
  Panels p({1280, 1900, 1});
  p.state = loaded_state();
  p.state.window.auto_compare = true;
  p.state.molecule.balls = kMostBallsToCompareUnasked + 1;
  p.frame(3);
  p.click("engine.auto_compare");
  EXPECT_TRUE(p.state.window.auto_compare) << "a disabled box; the choice is for smaller molecules";
  p.state.molecule.balls = kMostBallsToCompareUnasked;
  p.frame(2);
  p.click("engine.auto_compare");
  EXPECT_FALSE(p.state.window.auto_compare);
}

}  // namespace
}  // namespace alphascope::testing
