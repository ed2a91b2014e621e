// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of balls and complexes for tests of measures.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/engine/engine.hpp"
#include "core/measure/union_measures.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope::testing {

// A file in the source tree, or in the folder that the environment variable ALPHASCOPE_MEASURE_DATA
// names.
inline std::string measure_data(const std::string& file) {
  const char* folder = std::getenv("ALPHASCOPE_MEASURE_DATA");
  const std::string in_source = std::string(ALPHASCOPE_SOURCE_DIR) + "/tests/core/measure/data";
  std::string path = (folder != nullptr ? folder : in_source) + "/" + file;
  if (!std::ifstream(path)) throw std::runtime_error(path + ": cannot be read");
  return path;
}

// Reads lines of x y z r in Å, on the lattice of all their digits.
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

// Spheres through the origin, or off it by a unit of `factor`. Many touch each other there.
inline BallSet balls_through_a_point(Random& random, int count, int factor) {
  static constexpr int kVectors[8][4] = {{1, 2, 2, 3},  {2, 3, 6, 7},  {1, 4, 8, 9}, {4, 4, 7, 9},
                                         {2, 6, 9, 11}, {6, 6, 7, 11}, {0, 3, 4, 5}, {0, 0, 1, 1}};
  BallSet balls;
  balls.lattice.digits = 3;
  const int* v = kVectors[0];
  for (int n = 0; n < count; ++n) {
    // Every other ball lies in the direction of the previous one.
    if (n % 2 == 0) v = kVectors[random_int(random, 0, 7)];
    const int by = factor * random_int(random, 1, 6) * (random_int(random, 0, 2) == 0 ? -1 : 1);
    const int turn = n / 2 % 3;
    const int off = factor > 1 ? random_int(random, -1, 1) : 0;
    add_ball(balls, by * v[turn], by * v[(turn + 1) % 3], by * v[(turn + 2) % 3],
             std::abs(by) * v[3] + off);
  }
  return balls;
}

}  // namespace alphascope::testing
