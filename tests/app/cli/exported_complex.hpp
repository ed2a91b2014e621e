// SPDX-License-Identifier: GPL-3.0-or-later
// The complex as `compute --out` writes it, for comparison with exported files.
#pragma once

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace alphascope::testing {

struct TextSimplex {
  std::vector<int> balls;
  double alpha = 0;
  char letter = '?';  // of its class
};

struct TextComplex {
  std::vector<std::array<double, 4>> balls;  // x y z r, Å
  std::array<std::vector<TextSimplex>, 4> simplices;

  explicit TextComplex(const std::string& text) {
    std::istringstream lines(text);
    std::string word;
    std::size_t count = 0;
    lines.seekg(static_cast<std::streamoff>(text.find("\nballs ") + 1));
    lines >> word >> count;
    balls.resize(count);
    for (auto& ball : balls) {
      for (double& x : ball) lines >> x;
    }
    for (std::size_t dimension = 0; dimension < 4; ++dimension) {
      lines >> word >> count;
      simplices[dimension].resize(count);
      for (TextSimplex& s : simplices[dimension]) {
        s.balls.resize(dimension + 1);
        for (int& ball : s.balls) lines >> ball;
        lines >> s.alpha >> s.letter;
      }
    }
  }

  std::size_t regular_triangles() const {
    std::size_t count = 0;
    for (const TextSimplex& s : simplices[2]) count += s.letter == 'r';
    return count;
  }

  double volume() const {  // of the tetrahedra, Å³
    double six = 0;
    for (const TextSimplex& s : simplices[3]) {
      double d[3][3];
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          d[k][axis] = balls[static_cast<std::size_t>(s.balls[k + 1])][axis] -
                       balls[static_cast<std::size_t>(s.balls[0])][axis];
        }
      }
      six += std::fabs(d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
                       d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
                       d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]));
    }
    return six / 6;
  }
};

}  // namespace alphascope::testing
