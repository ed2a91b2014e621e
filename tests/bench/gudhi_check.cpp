// SPDX-License-Identifier: GPL-3.0-or-later
// Compares filtrations with those of GUDHI (Debian: libgudhi-dev): simplices, alpha values, order.
//   alphascope_gudhi_check sets|FILE.balls|FILE.xyzr[:SOLVENT]...
// sets: the hard sets of the tests, but for those in one plane, of which GUDHI takes none.
// It is built only on request, since CGAL's alpha shapes take a minute to compile.
#include <gudhi/Alpha_complex_3d.h>
#include <gudhi/Simplex_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/complex/triangulation.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/filtration_order.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/bench/read_balls.hpp"
#include "tests/support/random_balls.hpp"

using namespace alphascope;

namespace {

using Simplex = std::vector<BallIndex>;
using Theirs =
    Gudhi::alpha_complex::Alpha_complex_3d<Gudhi::alpha_complex::complexity::EXACT, true>;
using Tree = Gudhi::Simplex_tree<Gudhi::Simplex_tree_options_full_featured>;

// Their alpha values, square lattice units, as doubles. Of balls with equal centres only one is
// among `vertices`.
std::map<Simplex, double> of_gudhi(const BallSet& balls, const Simplices<1>& vertices) {
  std::vector<Theirs::Bare_point_3> points;
  std::vector<Theirs::FT> weights;
  std::map<std::array<double, 3>, BallIndex> ball_at;
  for (BallIndex i = 0; i < balls.size(); ++i) {
    const LatticePoint& p = balls.centres[i];
    points.emplace_back(p.x, p.y, p.z);
    weights.emplace_back(static_cast<double>(balls.weight(i)));
  }
  for (const auto [i] : vertices) {
    const LatticePoint& p = balls.centres[i];
    ball_at[{double(p.x), double(p.y), double(p.z)}] = i;
  }
  Theirs complex(points, weights);
  Tree tree;
  complex.create_complex(tree);
  std::map<Simplex, double> values;
  for (const auto handle : tree.complex_simplex_range()) {
    Simplex simplex;
    for (const auto vertex : tree.simplex_vertex_range(handle)) {
      const auto& p = complex.get_point(static_cast<std::size_t>(vertex));
      simplex.push_back(
          ball_at.at({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}));
    }
    std::sort(simplex.begin(), simplex.end());
    values[simplex] = tree.filtration(handle);
  }
  return values;
}

template <int N>
void add(const SimplexList<N>& list, std::size_t index,
         std::vector<std::pair<Simplex, float>>& to) {
  to.push_back(
      {{list.simplices[index].begin(), list.simplices[index].end()}, list.alpha_values[index]});
}

bool compare(const std::string& name, const BallSet& balls) {
  const Triangulation triangulation = make_triangulation(balls, 1);
  if (triangulation.dimension < 3) return true;
  const Filtration filtration(std::make_shared<const BallSet>(balls), triangulation);
  const AlphaComplex& top = filtration.top();
  std::vector<std::pair<Simplex, float>> ours;
  for (const SimplexPlace& place : filtration_order(balls, top)) {
    if (place.dimension == 0) add(top.vertices, place.index, ours);
    if (place.dimension == 1) add(top.edges, place.index, ours);
    if (place.dimension == 2) add(top.triangles, place.index, ours);
    if (place.dimension == 3) add(top.tetrahedra, place.index, ours);
  }
  const std::map<Simplex, double> theirs = of_gudhi(balls, top.vertices.simplices);
  std::size_t missing = 0, other_value = 0, other_order = 0;
  double last = -HUGE_VAL;
  for (const auto& [simplex, value] : ours) {
    const auto at = theirs.find(simplex);
    if (at == theirs.end()) {
      ++missing;
      continue;
    }
    // Doubles of exact values: they may be one step beside the nearest.
    const double step = std::fabs(at->second) * 4e-16;
    other_value += static_cast<float>(at->second - step) != value &&
                   static_cast<float>(at->second + step) != value;
    other_order += at->second < last - std::fabs(last) * 4e-16;
    last = at->second;
  }
  const bool equal = missing + other_value + other_order == 0 && ours.size() == theirs.size();
  std::printf(
      "%s %s: simplices %zu, GUDHI's %zu, missing %zu, other values %zu, out of order %zu\n",
      equal ? "ok  " : "DIFF", name.c_str(), ours.size(), theirs.size(), missing, other_value,
      other_order);
  return equal;
}

}  // namespace

int main(int argc, char** argv) {
  bool equal = argc > 1;
  for (int n = 1; n < argc; ++n) {
    const std::string word = argv[n];
    if (word == "sets") {
      testing::Random random(44);
      for (const testing::NamedBalls& set : testing::large_hard_sets(random))
        equal = compare(set.name, set.balls) && equal;
      continue;
    }
    equal = compare(word, bench::read_grown_balls(word)) && equal;
  }
  return equal ? 0 : 1;
}
