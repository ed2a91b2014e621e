// SPDX-License-Identifier: GPL-3.0-or-later
// Computes cavities from their definitions in rationals.
#include "tests/support/reference/rational_cavities.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"

namespace alphascope::testing {
namespace {

struct WeightedPoint {
  Rational p[3], w;
};

// The power of m, less that of the smallest sphere orthogonal to a, b and c.
Rational excess(const WeightedPoint (&abc)[3], const WeightedPoint& m) {
  Rational d[2][3], half[2], gram[2][2];
  for (int k = 0; k < 2; ++k) {
    half[k] = abc[0].w - abc[k + 1].w;
    for (int a = 0; a < 3; ++a) {
      d[k][a] = abc[k + 1].p[a] - abc[0].p[a];
      half[k] += d[k][a] * d[k][a];
    }
    half[k] /= 2;
  }
  for (int k = 0; k < 2; ++k) {
    for (int l = 0; l < 2; ++l) {
      for (int a = 0; a < 3; ++a) gram[k][l] += d[k][a] * d[l][a];
    }
  }
  const Rational det = gram[0][0] * gram[1][1] - gram[0][1] * gram[1][0];
  const Rational s = (half[0] * gram[1][1] - half[1] * gram[0][1]) / det,
                 t = (half[1] * gram[0][0] - half[0] * gram[1][0]) / det;
  Rational rho = -abc[0].w, power = -m.w;
  for (int a = 0; a < 3; ++a) {
    const Rational x = s * d[0][a] + t * d[1][a], from_m = abc[0].p[a] + x - m.p[a];
    rho += x * x;
    power += from_m * from_m;
  }
  return power - rho;
}

int inside(const BallSet& balls, std::span<const BallIndex, 3> triangle, BallIndex m,
           bool perturbed) {
  BallIndex four[4] = {triangle[0], triangle[1], triangle[2], m};
  std::sort(four, four + 4,
            [&](BallIndex a, BallIndex b) { return balls.centres[a] > balls.centres[b]; });
  Rational step(1);
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 2, 300);
  std::map<BallIndex, Rational> less;
  for (const BallIndex i : four) {
    step /= power;
    less[i] = perturbed ? step : Rational(0);
  }
  const auto point = [&](BallIndex i) {
    const LatticePoint& p = balls.centres[i];
    return WeightedPoint{{Rational(p.x), Rational(p.y), Rational(p.z)},
                         Rational(balls.radii[i]) * balls.radii[i] - less[i]};
  };
  const WeightedPoint abc[3] = {point(triangle[0]), point(triangle[1]), point(triangle[2])};
  return -sgn(excess(abc, point(m)));
}

Simplex without(Simplex simplex, std::size_t n) {
  simplex.erase(simplex.begin() + static_cast<std::ptrdiff_t>(n));
  return simplex;
}

// Rank modulo 2 of the boundary map from cofaces to faces.
std::size_t boundary_rank(const std::vector<Simplex>& cofaces, const std::vector<Simplex>& faces) {
  std::vector<std::set<std::size_t>> columns;
  for (const Simplex& coface : cofaces) {
    std::set<std::size_t> column;
    for (std::size_t n = 0; n < coface.size(); ++n) {
      const auto at = std::find(faces.begin(), faces.end(), without(coface, n));
      column.insert(static_cast<std::size_t>(at - faces.begin()));
    }
    columns.push_back(std::move(column));
  }
  std::map<std::size_t, std::set<std::size_t>> by_lowest;
  for (std::set<std::size_t> column : columns) {
    while (!column.empty() && by_lowest.count(*column.rbegin())) {
      for (const std::size_t row : by_lowest[*column.rbegin()]) {
        if (!column.erase(row)) column.insert(row);
      }
    }
    if (!column.empty()) by_lowest[*column.rbegin()] = column;
  }
  return by_lowest.size();
}

// Groups simplices: two are in one group if a chain of pairs accepted by `joined` links them.
std::vector<std::vector<Simplex>> grouped(
    std::vector<Simplex> left, const std::function<bool(const Simplex&, const Simplex&)>& joined) {
  std::vector<std::vector<Simplex>> groups;
  while (!left.empty()) {
    std::vector<Simplex> group{left.back()};
    left.pop_back();
    for (std::size_t n = 0; n < group.size(); ++n) {
      for (std::size_t m = 0; m < left.size();) {
        if (joined(group[n], left[m])) {
          group.push_back(left[m]);
          left.erase(left.begin() + static_cast<std::ptrdiff_t>(m));
        } else {
          ++m;
        }
      }
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

class Search {
 public:
  Search(const BallSet& balls, const RationalOracle& oracle, double alpha, bool strict)
      : balls_(balls), values_(oracle.alpha_values()), alpha_(alpha) {
    for (const auto& [t, value] : values_) {
      if (t.size() != 4) continue;
      for (std::size_t k = 0; k < 4; ++k) {
        const Simplex face = without(t, k);
        tetrahedra_of_[face].push_back(t);
        const std::span<const BallIndex, 3> abc(face.data(), 3);
        int side = inside_smallest_orthosphere(balls, abc, t[k]);
        ties_ += side == 0;
        if (side == 0 && !strict) side = inside_perturbed_orthosphere(balls, abc, t[k]);
        if (side > 0) out_of_[t].push_back(face);
      }
    }
  }

  RationalCavities find(bool castp_rule) {
    RationalCavities result;
    result.flow_ties = ties_;
    std::vector<Simplex> inside;
    for (const auto& [t, value] : values_) {
      if (t.size() == 4 && !is_in(t) && (castp_rule ? reaches(t, true) : !reaches(t, false))) {
        inside.push_back(t);
      }
    }
    for (const auto& group : grouped(inside, [&](const Simplex&a, const Simplex&b) {
           const Simplex face = common(a, b);
           return face.size() == 3 && !is_in(face);
         })) {
      result.cavities.insert(cavity_of(group, inside));
    }
    set_betti(result);
    return result;
  }

 private:
  const BallSet& balls_;
  bool is_in(const Simplex& s) const { return values_.at(s) <= Rational(alpha_); }
  static Simplex common(const Simplex& a, const Simplex& b) {
    Simplex both;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
    return both;
  }
  // True when some path of the flow ends at a sink, or at infinity.
  bool reaches(const Simplex& t, bool sink) const {
    const auto out = out_of_.find(t);
    if (out == out_of_.end()) return sink;
    for (const Simplex& face : out->second) {
      const std::vector<Simplex>& sides = tetrahedra_of_.at(face);
      if (sides.size() == 1) {
        if (!sink) return true;
      } else if (reaches(sides[sides[0] == t ? 1 : 0], sink)) {
        return true;
      }
    }
    return false;
  }

  RationalCavity cavity_of(const std::vector<Simplex>& group, const std::vector<Simplex>& inside) {
    RationalCavity cavity;
    cavity.tetrahedra = {group.begin(), group.end()};
    std::vector<Simplex> opening;
    for (const Simplex& t : cavity.tetrahedra) {
      for (std::size_t k = 0; k < 4; ++k) {
        const Simplex face = without(t, k);
        const std::vector<Simplex>& sides = tetrahedra_of_.at(face);
        const bool outside =
            sides.size() == 1 ||
            std::find(inside.begin(), inside.end(), sides[sides[0] == t ? 1 : 0]) == inside.end();
        if (!is_in(face) && outside) opening.push_back(face);
      }
      if (out_of_.count(t)) continue;
      cavity.sinks.insert(t);
      // Among equal sinks the one with the first centres counts.
      const auto centres = [&](const Simplex& of) {
        std::vector<LatticePoint> places;
        for (const BallIndex v : of) places.push_back(balls_.centres[v]);
        std::sort(places.begin(), places.end());
        return places;
      };
      const Simplex& deepest = cavity.deepest_sink;
      if (deepest.empty() || values_.at(t) > values_.at(deepest) ||
          (values_.at(t) == values_.at(deepest) && centres(t) < centres(deepest))) {
        cavity.deepest_sink = t;
      }
    }
    for (const auto& mouth : grouped(opening, [&](const Simplex&a, const Simplex&b) {
           const Simplex both = common(a, b);
           for (const BallIndex v : both) {
             if (!is_in({v})) return true;
           }
           return both.size() == 2 && !is_in(both);
         })) {
      cavity.mouths.insert({mouth.begin(), mouth.end()});
    }
    return cavity;
  }

  void set_betti(RationalCavities& result) const {
    std::vector<Simplex> of_size[5];
    for (const auto& [s, value] : values_) {
      if (is_in(s)) of_size[s.size()].push_back(s);
    }
    std::size_t rank[5] = {};
    for (std::size_t size = 2; size < 5; ++size) {
      rank[size] = boundary_rank(of_size[size], of_size[size - 1]);
    }
    for (std::size_t d = 0; d < 3; ++d) {
      result.betti[d] = static_cast<long long>(of_size[d + 1].size()) -
                        static_cast<long long>(rank[d + 1] + rank[d + 2]);
    }
  }

  const std::map<Simplex, Rational>& values_;
  const double alpha_;
  std::map<Simplex, std::vector<Simplex>> tetrahedra_of_;  // tetrahedra at each triangle
  std::map<Simplex, std::vector<Simplex>> out_of_;  // triangles by which a tetrahedron flows out
  std::size_t ties_ = 0;
};

}  // namespace

int inside_smallest_orthosphere(const BallSet& balls, std::span<const BallIndex, 3> triangle,
                                BallIndex m) {
  return inside(balls, triangle, m, false);
}
int inside_perturbed_orthosphere(const BallSet& balls, std::span<const BallIndex, 3> triangle,
                                 BallIndex m) {
  return inside(balls, triangle, m, true);
}

RationalCavities rational_cavities(const BallSet& balls, const RationalOracle& oracle, double alpha,
                                   bool strict_ties, bool castp_rule) {
  return Search(balls, oracle, alpha, strict_ties).find(castp_rule);
}

}  // namespace alphascope::testing
