// Balls and complexes for the tests of measures.
#pragma once

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "core/engine/engine.hpp"
#include "core/measure/union_measures.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope::testing {

inline std::string measure_data(const std::string& file) {
  return std::string(ALPHASCOPE_SOURCE_DIR) + "/tests/core/measure/data/" + file;
}

// Lines of x y z r in Å, on the lattice of all their digits.
inline BallSet balls_of_file(const std::string& file) {
  BallSet balls;
  balls.lattice.digits = kMinLatticeDigits;
  std::vector<double> values;
  std::ifstream in(measure_data(file));
  for (std::string line; std::getline(in, line);) {
    if (line[0] == '#') continue;
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      const std::size_t point = word.find('.');
      const std::size_t digits = point == std::string::npos ? 0 : word.size() - point - 1;
      balls.lattice.digits = std::max(balls.lattice.digits, static_cast<int>(digits));
      values.push_back(std::stod(word));
    }
  }
  const auto at = [&](std::size_t n) {
    return static_cast<std::int32_t>(balls.lattice.nearest_units(values[n]));
  };
  for (std::size_t n = 0; n + 3 < values.size(); n += 4) {
    balls.centres.push_back({at(n), at(n + 1), at(n + 2)});
    balls.radii.push_back(at(n + 3));
  }
  return balls;
}

inline AlphaComplex complex_of(const BallSet& balls, double alpha_angstrom2 = 0) {
  return make_cpu_engine(std::make_shared<BallSet>(balls), {1})->compute({alpha_angstrom2}, {});
}
inline UnionMeasures measured(const BallSet& balls, double alpha_angstrom2 = 0,
                              const MeasureOptions& options = {1}) {
  return measure_union(balls, complex_of(balls, alpha_angstrom2), options);
}

}  // namespace alphascope::testing
