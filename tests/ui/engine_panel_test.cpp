// The engine panel: which engines can be chosen, the thesis' switches, and what the device is.
#include <gtest/gtest.h>

#include "app/viewer/state_bridge.hpp"
#include "tests/ui/panels_fixture.hpp"

namespace alphascope::testing {
namespace {

constexpr Size kLarge{1280, 1400, 1};

GpuInfo a_gpu() {
  return {true, true, "NVIDIA H200", "CUDA driver 13.0", "9.0", std::size_t{139} << 30, ""};
}

TEST(EnginePanel, WithoutAGpuItsEnginesCannotBeChosen) {
  Panels panels(kLarge);
  panels.state = loaded_state();
  panels.state.gpu = {true, false, "", "", "", 0, "There is no NVIDIA driver."};
  panels.frame(2);
  for (const char* entry : {"engine.gpu", "engine.tuples-gpu"}) {
    panels.click("engine.choice");
    panels.click(entry);
    EXPECT_EQ(panels.state.compute.engine, EngineChoice::automatic) << entry;
    panels.tap(key::kEscape);
  }
  panels.click("engine.choice");
  panels.click("engine.tuples-cpu");
  EXPECT_EQ(panels.state.compute.engine, EngineChoice::tuples_cpu);
}

TEST(EnginePanel, WithAGpuTheyCan) {
  Panels panels(kLarge);
  panels.state = loaded_state();
  panels.state.gpu = a_gpu();
  panels.frame(2);
  panels.click("engine.choice");
  panels.click("engine.tuples-gpu");
  EXPECT_EQ(panels.state.compute.engine, EngineChoice::tuples_gpu);
}

TEST(EnginePanel, TheSwitchesBelongToTheTupleEngines) {
  Panels panels(kLarge);
  panels.state = loaded_state();
  panels.frame(2);
  EXPECT_FALSE(panels.rects.contains("tuples.edge"));
  panels.state.compute.engine = EngineChoice::tuples_cpu;
  panels.frame(2);
  panels.click("tuples.edge", 0.05f);
  EXPECT_FALSE(panels.state.compute.tuples.edge_optimisation);
  panels.click("tuples.texture", 0.05f);
  EXPECT_TRUE(panels.state.compute.tuples.texture) << "says nothing on the CPU";
  panels.state.compute.engine = EngineChoice::tuples_gpu;
  panels.frame(2);
  panels.click("tuples.texture", 0.05f);
  EXPECT_FALSE(panels.state.compute.tuples.texture);
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

TEST(EnginePanel, TheMachineBecomesPlainData) {
  MachineInfo machine;
  machine.gpu_usable = true;
  machine.gpu = "NVIDIA H200";
  machine.driver = "CUDA driver 13.0";
  machine.gpu_capability = "9.0";
  machine.gpu_memory_bytes = 7;
  const GpuInfo gpu = describe_gpu(machine);
  EXPECT_TRUE(gpu.known && gpu.usable);
  EXPECT_EQ(gpu.name + gpu.driver + gpu.capability, "NVIDIA H200CUDA driver 13.09.0");
  EXPECT_EQ(gpu.memory_bytes, 7u);
}

TEST(EnginePanel, ComparingEveryTimeIsOffForLargeMolecules) {
  Panels p({1280, 1400, 1});
  p.state = loaded_state();
  p.state.auto_compare = true;
  p.state.molecule.balls = kMostBallsToCompareUnasked + 1;
  p.frame(3);
  p.click("engine.auto_compare");
  EXPECT_TRUE(p.state.auto_compare) << "a disabled box; the choice is for smaller molecules";
  p.state.molecule.balls = kMostBallsToCompareUnasked;
  p.frame(2);
  p.click("engine.auto_compare");
  EXPECT_FALSE(p.state.auto_compare);
}

}  // namespace
}  // namespace alphascope::testing
