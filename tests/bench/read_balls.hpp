// SPDX-License-Identifier: GPL-3.0-or-later
// Reads balls for programs that measure, without the readers' libraries: .balls files
// (make_balls.py) and plain .xyzr tables.
#pragma once

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/geometry/ball_set.hpp"

namespace alphascope::bench {

// Reads the digits and the numbers of balls and operations, then x y z r of each ball. 3 x 4
// matrices (Å) follow, if any, by which the balls are repeated.
inline BallSet read_ball_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::int32_t head[3];
  in.read(reinterpret_cast<char*>(head), sizeof head);
  if (!in) throw std::runtime_error(path + ": cannot be read");
  std::vector<std::int32_t> base(4 * static_cast<std::size_t>(head[1]));
  std::vector<double> matrices(12 * static_cast<std::size_t>(head[2]));
  in.read(reinterpret_cast<char*>(base.data()), static_cast<std::streamsize>(base.size() * 4));
  in.read(reinterpret_cast<char*>(matrices.data()),
          static_cast<std::streamsize>(matrices.size() * 8));
  if (!in) throw std::runtime_error(path + ": ends early");
  if (matrices.empty()) matrices = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  BallSet balls;
  balls.lattice.digits = head[0];
  const double unit = std::pow(10.0, head[0]);
  for (std::size_t m = 0; m < matrices.size(); m += 12) {
    for (std::size_t b = 0; b < base.size(); b += 4) {
      std::int32_t p[3];
      for (std::size_t row = 0; row < 3; ++row) {
        const double* a = matrices.data() + m + 4 * row;
        p[row] = static_cast<std::int32_t>(
            std::lround(a[0] * base[b] + a[1] * base[b + 1] + a[2] * base[b + 2] + a[3] * unit));
      }
      balls.centres.push_back({p[0], p[1], p[2]});
      balls.radii.push_back(base[b + 3]);
    }
  }
  return balls;
}

// Reads lines of x y z r in Å. The lattice has four digits.
inline BallSet read_xyzr(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path + ": cannot be read");
  BallSet balls;
  balls.lattice.digits = 4;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    double v[4];
    if (!(words >> v[0] >> v[1] >> v[2] >> v[3])) continue;
    const auto at = [&](int n) { return static_cast<std::int32_t>(std::lround(v[n] * 1e4)); };
    balls.centres.push_back({at(0), at(1), at(2)});
    balls.radii.push_back(at(3));
  }
  return balls;
}

inline BallSet read_balls(const std::string& path) {
  return path.ends_with(".xyzr") ? read_xyzr(path) : read_ball_file(path);
}

// Reads FILE[:SOLVENT], and grows the balls by the solvent radius in Å.
inline BallSet read_grown_balls(const std::string& word) {
  const std::size_t colon = word.rfind(':');
  const double solvent = colon == std::string::npos ? 0 : std::atof(word.c_str() + colon + 1);
  return with_solvent(read_balls(word.substr(0, colon)), solvent);
}

}  // namespace alphascope::bench
