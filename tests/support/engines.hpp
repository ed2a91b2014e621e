// SPDX-License-Identifier: GPL-3.0-or-later
// Engines for suites that every engine must pass.
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
  // Limit for engines that are too slow on larger sets, or where balls have more neighbours.
  int most_balls = 1000;
  double most_tuples = std::numeric_limits<double>::infinity();
  // The reason why this machine has no such engine. Empty when it has.
  std::string why_not = {};

  // Balls in the large hard sets.
  int balls_of_large_sets() const { return std::min(most_balls, unless_sanitized(1000, 100)); }
  // Whether this engine computes the complex within seconds.
  bool affords(const BallSet& balls, double alpha_angstrom2) const;
  friend void PrintTo(const EngineFactory& factory, std::ostream* out) { *out << factory.name; }
};

// The suites are compiled once, and linked into one program for each kind of engine. Each program
// defines this function. host_engines.cpp has the host's engines, tests/gpu those of a device and
// of the emulated device.
std::vector<EngineFactory> engines();

// The base of suites for every engine. Skipped where there is no such engine.
class EngineSuite : public ::testing::TestWithParam<EngineFactory> {
 protected:
  void SetUp() override {
    if (!GetParam().why_not.empty()) GTEST_SKIP() << GetParam().why_not;
  }
};

// The suffix that GoogleTest appends to names of parametrised tests.
inline std::string engine_name(const ::testing::TestParamInfo<EngineFactory>& info) {
  return info.param.name;
}

}  // namespace alphascope::testing
