// SPDX-License-Identifier: GPL-3.0-or-later
// Compares our CGAL engine with CGAL used directly, on one file. It shows whether our reference is
// as fast as CGAL. Prints medians in ms.
//
//   alphascope_cgal_routes FILE [SOLVENT_Å [REPETITIONS]]      FILE is relative to
//   ALPHASCOPE_TEST_DATA
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/engine/engine.hpp"
#include "tests/bench/cgal_parallel.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/reference/cgal_reference.hpp"

namespace {

using namespace alphascope;

class Medians {
 public:
  void add(const std::string& row, double milliseconds) {
    if (times_[row].empty()) order_.push_back(row);
    times_[row].push_back(milliseconds);
  }
  void print() {
    for (const std::string& row : order_) {
      std::vector<double>& t = times_[row];
      std::sort(t.begin(), t.end());
      std::printf("%-60s %10.2f   (%.2f to %.2f)\n", row.c_str(), t[t.size() / 2], t.front(),
                  t.back());
    }
  }

 private:
  std::vector<std::string> order_;
  std::map<std::string, std::vector<double>> times_;
};

void measure(const std::shared_ptr<const BallSet>& balls, Medians& medians) {
  for (const int threads : {1, 0}) {
    const std::string name = threads == 1 ? "engine, 1 thread: " : "engine, all threads: ";
    const auto engine = make_cgal_engine(balls, {threads});
    for (const bool tetrahedra_only : {true, false}) {
      const std::string what = tetrahedra_only ? "tetrahedra, " : "whole, ";
      for (const double alpha : {1.4, 0.0, 10.0}) {
        for (const StageTime& stage :
             engine->compute({alpha, tetrahedra_only}, {}).timings.stages) {
          const std::string at = stage.setup ? "" : ", alpha " + std::to_string(alpha).substr(0, 4);
          medians.add(name + what + stage.label + at, stage.milliseconds);
        }
      }
    }
  }
  const double alpha = balls->lattice.alpha_on_lattice(1.4).nearest();
  for (const bool parallel : {false, true}) {
    const std::string name = parallel ? "CGAL, parallel: " : "CGAL, sequential: ";
    const auto cells = parallel ? testing::regular_cells_in_parallel(*balls, alpha)
                                : testing::regular_cells(*balls, alpha);
    medians.add(name + "regular triangulation", cells.triangulation_milliseconds);
    medians.add(name + "cells <= alpha, alpha 1.4", cells.filter_milliseconds);
  }
  for (const double a : {1.4, 0.0, 10.0}) {
    const auto shape =
        testing::fixed_alpha_shape(*balls, balls->lattice.alpha_on_lattice(a).nearest());
    medians.add("CGAL: Fixed_alpha_shape_3, alpha " + std::to_string(a).substr(0, 4),
                shape.classification_milliseconds);
  }
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2) {
    std::fprintf(stderr, "usage: %s FILE [SOLVENT_Å [REPETITIONS]]\n", argv[0]);
    return 2;
  }
  const auto balls = testing::molecule_balls(argv[1], argc > 2 ? std::strtod(argv[2], nullptr) : 0);
  if (!balls) throw std::runtime_error("set ALPHASCOPE_TEST_DATA to the folder of molecules");
  std::printf("%s, %zu balls\n", argv[1], balls->size());
  Medians medians;
  const int repetitions = argc > 3 ? static_cast<int>(std::strtol(argv[3], nullptr, 10)) : 5;
  for (int n = 0; n < repetitions; ++n) measure(balls, medians);
  medians.print();
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
