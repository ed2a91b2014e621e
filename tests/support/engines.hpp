// The engines that suites which must hold of every one of them run with.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "core/engine/engine.hpp"
#include "tests/support/sanitizer.hpp"

namespace alphascope::testing {

struct EngineFactory {
  std::string name;  // letters, digits and _ only
  std::function<std::unique_ptr<Engine>(std::shared_ptr<const BallSet>)> make;
  // What is slow beyond use on larger sets, or where balls have more neighbours, says so here.
  int most_balls = 1000;
  double most_tuples = std::numeric_limits<double>::infinity();
  // Why there can be no such engine on this machine; empty when there can.
  std::string why_not = {};

  // Of the large hard sets.
  int balls_of_large_sets() const { return std::min(most_balls, unless_sanitized(1000, 100)); }
  // Would this engine take no more than seconds?
  bool affords(const BallSet& balls, double alpha_angstrom2) const;
  friend void PrintTo(const EngineFactory& factory, std::ostream* out) { *out << factory.name; }
};

// The suites are compiled once and linked into one program for each kind of engine. Each program
// defines this: the host's engines (host_engines.cpp), a device's or an emulated device's
// (tests/gpu).
std::vector<EngineFactory> engines();

// What a suite of every engine derives from: skipped where there is no such engine.
class EngineSuite : public ::testing::TestWithParam<EngineFactory> {
 protected:
  void SetUp() override {
    if (!GetParam().why_not.empty()) GTEST_SKIP() << GetParam().why_not;
  }
};

// What GoogleTest appends to the names of parametrised tests.
inline std::string engine_name(const ::testing::TestParamInfo<EngineFactory>& info) {
  return info.param.name;
}

}  // namespace alphascope::testing
