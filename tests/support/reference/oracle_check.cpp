// SPDX-License-Identifier: GPL-3.0-or-later
// Compares complexes with the oracle at interesting alphas.
#include "tests/support/reference/oracle_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "core/complex/compare.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/verify/verify.hpp"

namespace alphascope::testing {
namespace {

std::string text_of(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

template <class Difference>
std::string text_of(const char* name, const Difference& d) {
  return std::string(name) + std::to_string(d.missing.size()) + " missing " +
         std::to_string(d.extra.size()) + " extra; ";
}

std::string in_context(const std::string& what, const NamedBalls& set, double alpha) {
  return set.name + ", alpha " + text_of(alpha) + " Å², " +
         std::to_string(set.balls.lattice.digits) + " digits: " + what + list_balls(set.balls);
}

}  // namespace

std::vector<double> interesting_alphas(const RationalOracle& oracle, const Lattice& lattice) {
  constexpr double kStep = 1.0 / 1048576;
  std::set<double> alphas = {-1e6, -1, 0, 1, 1e6, 1e300};
  for (const auto& [simplex, value] : oracle.alpha_values()) {
    const double near = std::round(value.get_d() / kStep) * kStep;
    const double step = std::fabs(near) < 4e9 ? kStep : 1;
    for (const double alpha : {near - step, near, near + step})
      alphas.insert(lattice.square_angstrom(alpha));
  }
  return {alphas.begin(), alphas.end()};
}

std::vector<double> some_of(Random& random, std::vector<double> alphas, std::size_t most) {
  while (alphas.size() > most) {
    alphas.erase(alphas.begin() + random_int(random, 1, int(alphas.size()) - 2));
  }
  std::shuffle(alphas.begin(), alphas.end(), random);
  return alphas;
}

std::string list_balls(const BallSet& balls) {
  std::string text;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const LatticePoint& p = balls.centres[i];
    text += "\n  " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) +
            " " + std::to_string(balls.radii[i]);
  }
  return text;
}

std::string difference(const AlphaComplex& found, const AlphaComplex& expected) {
  const Comparison c = compare(found, expected);
  if (!c.identical()) {
    return text_of("V ", c.vertices) + text_of("E ", c.edges) + text_of("F ", c.triangles) +
           text_of("T ", c.tetrahedra) + std::to_string(c.alpha_values_differing) + " values, " +
           std::to_string(c.classes_differing) + " classes differ";
  }
  const std::uint64_t hash =
      found.tetrahedra_only ? tetrahedra_hash(expected) : complex_hash(expected);
  return found.hash == hash ? "" : "only the hash differs";
}

namespace {

// Returns the difference between both complexes or, if there is none, an error that the verifier
// finds.
std::string difference_or_doubt(const BallSet& balls, const AlphaComplex& found,
                                const AlphaComplex& expected) {
  const std::string what = difference(found, expected);
  if (!what.empty()) return what;
  for (const VerifyBy by : {VerifyBy::search, VerifyBy::triangulation}) {
    const Verification verification = verify(balls, found, {}, by);
    if (!verification.ok()) return "the verifier says " + verification.messages.at(0);
  }
  return "";
}

}  // namespace

std::string difference_from_oracle(Engine& engine, const NamedBalls& set,
                                   const RationalOracle& oracle, std::span<const double> alphas,
                                   OracleCounts& counts) {
  for (const double alpha : alphas) {
    const AlphaComplex expected = oracle.complex(set.balls.lattice.alpha_on_lattice(alpha));
    const AlphaComplex found = engine.compute({alpha}, {});
    std::string what = difference_or_doubt(set.balls, found, expected);
    if (what.empty()) {
      what = difference_or_doubt(set.balls, engine.compute({alpha, true}, {}), expected);
      if (!what.empty()) what = "tetrahedra alone: " + what;
    }
    if (!what.empty()) return in_context(what, set, alpha);
    ++counts.complexes;
    counts.simplices += found.vertices.size() + found.edges.size() + found.triangles.size() +
                        found.tetrahedra.size();
  }
  return "";
}

}  // namespace alphascope::testing
