// SPDX-License-Identifier: GPL-3.0-or-later
// Explains one simplex from the regular triangulation of a few balls around it.
#include "core/explain/explanation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/complex/own_dimension.hpp"
#include "core/dual_edge/exact_dual_edge.hpp"
#include "core/explain/local_star.hpp"
#include "core/explain/nearest_by_power.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/verify/verify_orthosphere.hpp"

namespace alphascope {
namespace {

using Balls = std::vector<BallIndex>;

constexpr std::size_t kNearest = 6;  // number of balls listed
constexpr std::size_t kFirst = 24;   // number of balls chosen at each point to begin with

template <int N>
std::array<BallIndex, N> as_array(std::span<const BallIndex> simplex) {
  std::array<BallIndex, N> s{};
  std::copy(simplex.begin(), simplex.end(), s.begin());
  return s;
}

// Calls body with the Orthosphere<N> of a simplex of N balls.
template <class Body>
auto with_sphere(const BallSet& balls, std::span<const BallIndex> s, const Body& body) {
  switch (s.size()) {
    case 1:
      return body(Orthosphere<1>(balls, as_array<1>(s)));
    case 2:
      return body(Orthosphere<2>(balls, as_array<2>(s)));
    case 3:
      return body(Orthosphere<3>(balls, as_array<3>(s)));
    default:
      return body(Orthosphere<4>(balls, as_array<4>(s)));
  }
}
ExactRho rho_of(const BallSet& balls, std::span<const BallIndex> s) {
  return with_sphere(balls, s, [](const auto& sphere) { return sphere.rho(); });
}
double quotient(const ExactRho& rho) {
  return rho.numerator.near_double() / rho.denominator.near_double();
}

// Sorted by margin; margins that are equal in double precision, by index.
std::vector<BallMargin> margins(const BallSet& balls, std::span<const BallIndex> simplex,
                                const Balls& near) {
  const double rho = quotient(rho_of(balls, simplex));
  std::vector<BallMargin> result = with_sphere(balls, simplex, [&](const auto& sphere) {
    std::vector<BallMargin> found;
    for (const BallIndex m : near) {
      const double excess = sphere.excess(m);
      found.push_back({m,
                       balls.lattice.square_angstrom(excess + rho),
                       balls.lattice.square_angstrom(excess),
                       sphere.side(m),
                       {}});
    }
    return found;
  });
  std::sort(result.begin(), result.end(), [](const BallMargin& a, const BallMargin& b) {
    return std::pair(a.margin_angstrom2, a.ball) < std::pair(b.margin_angstrom2, b.ball);
  });
  if (result.size() > kNearest) result.resize(kNearest);
  for (BallMargin& one : result) one.steps = steps_of_margin(balls, simplex, one.ball);
  return result;
}

// The list of a complex for simplices of N balls, and a simplex' place in it.
template <int N>
const SimplexList<N>& list_of(const AlphaComplex& complex) {
  if constexpr (N == 1) return complex.vertices;
  if constexpr (N == 2) return complex.edges;
  if constexpr (N == 3) return complex.triangles;
  if constexpr (N == 4) return complex.tetrahedra;
}
template <int N>
std::optional<std::size_t> find(const SimplexList<N>& list, const std::array<BallIndex, N>& s) {
  const auto at = std::lower_bound(list.simplices.begin(), list.simplices.end(), s);
  if (at == list.simplices.end() || *at != s) return {};
  return static_cast<std::size_t>(at - list.simplices.begin());
}

// Calls body(Size<N>) for a simplex of N balls.
template <int N>
struct Size {
  static constexpr int value = N;
};
template <class Body>
auto at_size(std::size_t size, const Body& body) {
  return size == 1   ? body(Size<1>{})
         : size == 2 ? body(Size<2>{})
         : size == 3 ? body(Size<3>{})
                     : body(Size<4>{});
}

// A simplex and its surroundings in the filtration of a few balls.
class Surrounded {
 public:
  Surrounded(const BallSet& balls, const LocalStar& star, const RunContext& context)
      : balls_(balls), star_(star), filtration_(star.balls, star.triangulation, context) {}

  bool has(std::span<const BallIndex> simplex) const {
    return at_size(simplex.size(), [&](auto n) {
      return find<n.value>(list_of<n.value>(filtration_.top()), local<n.value>(simplex))
          .has_value();
    });
  }
  AlphaLevel appears(std::span<const BallIndex> simplex) const {
    return at_size(simplex.size(),
                   [&](auto n) { return value_of<n.value>(local<n.value>(simplex)); });
  }
  void levels(Explanation& e) const {
    at_size(e.simplex.size(), [&](auto n) {
      e.attached = attached<n.value>(local<n.value>(e.simplex));
      fill_regular<n.value>(local<n.value>(e.simplex), e);
      return 0;
    });
    Balls local;
    for (const BallIndex v : e.simplex) local.push_back(star_.local(v));
    at_size(largest_size(), [&](auto n) {
      fill_interior<n.value>(local, e);
      return 0;
    });
  }
  AtAlpha at(std::span<const BallIndex> simplex, const AlphaLevel& appears,
             const LatticeAlpha& alpha) const {
    AlphaComplex complex = threshold(filtration_, alpha, false);
    set_classes_in(star_.triangulation.dimension, complex);
    AtAlpha result{alpha, false, SimplexClass::singular, steps_of_rho(balls_, appears.from, alpha)};
    at_size(simplex.size(), [&](auto n) {
      const auto& list = list_of<n.value>(complex);
      const auto found = find<n.value>(list, local<n.value>(simplex));
      result.in_complex = found.has_value();
      if (found) result.simplex_class = list.classes[*found];
      return 0;
    });
    return result;
  }

 private:
  template <int N>
  std::array<BallIndex, N> local(std::span<const BallIndex> simplex) const {
    std::array<BallIndex, N> s{};
    std::transform(simplex.begin(), simplex.end(), s.begin(),
                   [&](BallIndex v) { return star_.local(v); });
    return s;
  }
  template <int N>
  float float_of(const std::array<BallIndex, N>& s) const {
    const auto& list = list_of<N>(filtration_.top());
    return list.alpha_values[*find<N>(list, s)];
  }
  // Calls visit(coface) for each coface with one more ball.
  template <int N, class Visit>
  void for_cofaces(const std::array<BallIndex, N>& s, const Visit& visit) const {
    for (const auto& coface : list_of<N + 1>(filtration_.top()).simplices) {
      if (std::includes(coface.begin(), coface.end(), s.begin(), s.end())) visit(coface);
    }
  }
  template <int N>
  bool attached(const std::array<BallIndex, N>& s) const {
    bool is = false;
    if constexpr (N < 4) {
      for_cofaces<N>(s, [&](const auto& coface) {
        for (const BallIndex m : coface) {
          is = is || (std::find(s.begin(), s.end(), m) == s.end() &&
                      conflict_with_smallest_orthosphere(*star_.balls, s, m) < 0);
        }
      });
    }
    return is;
  }
  AlphaLevel level(float on_lattice, Balls from) const {
    const double rho = quotient(rho_of(balls_, from));
    return {balls_.lattice.square_angstrom(rho), on_lattice, std::move(from)};
  }
  // The level of a simplex. An attached simplex has the level of a coface with the same float. If
  // several cofaces have that float, the one with the least exact value counts.
  template <int N>
  AlphaLevel value_of(const std::array<BallIndex, N>& s) const {
    const float value = float_of<N>(s);
    if (!attached<N>(s)) return level(value, star_.all(s));
    AlphaLevel least;
    if constexpr (N < 4) {
      for_cofaces<N>(s, [&](const auto& coface) {
        if (float_of<N + 1>(coface) != value) return;
        AlphaLevel one = value_of<N + 1>(coface);
        if (least.from.empty() ||
            compare_exact(rho_of(balls_, one.from), rho_of(balls_, least.from)) < 0) {
          least = std::move(one);
        }
      });
    }
    return least;
  }
  // The number of vertices of the largest simplices.
  std::size_t largest_size() const {
    return static_cast<std::size_t>(star_.triangulation.dimension) + 1;
  }
  template <int N>
  void fill_regular(const std::array<BallIndex, N>& s, Explanation& e) const {
    e.largest = N == largest_size();
    if constexpr (N < 4) {
      float least = HUGE_VALF;
      for_cofaces<N>(s, [&](const auto& c) { least = std::min(least, float_of<N + 1>(c)); });
      for_cofaces<N>(s, [&](const auto& c) {
        if (float_of<N + 1>(c) == least) lower(e.regular, value_of<N + 1>(c), -1);
      });
    }
  }
  template <int N>
  RealPoint orthocentre(const std::array<BallIndex, N>& s) const {
    const Orthosphere<N> sphere(*star_.balls, s);
    return balls_.lattice.unit_angstrom() *
           (real_point(star_.balls->centres[s[0]]) + sphere.from_first_ball());
  }
  // Sets dual edges, hull and interior level. They follow from the largest simplices around the
  // simplex (N balls) and from their faces there.
  template <int N>
  void fill_interior(const Balls& local, Explanation& e) const {
    const auto around = [&local](const auto& larger) {
      return std::includes(larger.begin(), larger.end(), local.begin(), local.end());
    };
    if constexpr (N > 1) {
      for (const auto& face : list_of<N - 1>(filtration_.top()).simplices) {
        if (!around(face)) continue;
        std::vector<RealPoint> ends;
        for_cofaces<N - 1>(face, [&](const auto& s) { ends.push_back(orthocentre<N>(s)); });
        if (ends.size() == 2) e.dual_edges_angstrom.push_back({ends[0], ends[1]});
        e.on_hull = e.on_hull || ends.size() < 2;
      }
    }
    if (e.on_hull) return;
    for (const auto& s : list_of<N>(filtration_.top()).simplices) {
      if (around(s)) lower(e.interior, value_of<N>(s), 1);
    }
  }
  // Keeps the lower (sign -1) or the higher (sign 1) of two levels.
  void lower(std::optional<AlphaLevel>& kept, AlphaLevel one, int sign) const {
    if (!kept || compare_exact(rho_of(balls_, one.from), rho_of(balls_, kept->from)) * sign > 0)
      kept = std::move(one);
  }

  const BallSet& balls_;
  const LocalStar& star_;
  Filtration filtration_;
};

// The culprits that leave three balls no dual edge: one ball that cuts off their whole line of
// equal power, or two balls that do so together.
Balls cutters_of_line(const BallSet& balls, const Balls& ijk, const Balls& chosen) {
  const LiftedInt j = lifted_vector(balls, ijk[0], ijk[1]),
                  k = lifted_vector(balls, ijk[0], ijk[2]);
  std::optional<std::pair<BallIndex, EndBall>> ends[2];
  for (const BallIndex m : chosen) {
    if (std::binary_search(ijk.begin(), ijk.end(), m)) continue;
    const LiftedInt v = lifted_vector(balls, ijk[0], m);
    const int side = sign_of(determinant(j, k, v));
    if (side == 0) {  // The ball cuts off all of the line or nothing.
      if (triangle_foot_cut(j, k, v) > 0) return {m};
      continue;
    }
    auto& end = ends[side > 0];
    if (!end || orthocentre_cut<WideInt<4>>(j, k, end->second, v) > 0) end = {m, {0, v}};
  }
  Balls found;
  for (const auto& end : ends) {
    if (end) found.push_back(end->first);
  }
  return found;
}

// A ball of the same centre that hides ball i, by the rule of core/neighbours/coincident.hpp.
std::optional<BallIndex> twin_that_hides(const BallSet& balls, BallIndex i) {
  std::optional<BallIndex> best;
  for (BallIndex m = 0; m < balls.size(); ++m) {
    if (m == i || balls.centres[m] != balls.centres[i]) continue;
    const BallIndex before = best ? *best : i;
    if (balls.radii[m] > balls.radii[before] ||
        (balls.radii[m] == balls.radii[before] && m < before))
      best = m;
  }
  return best;
}

// All proper faces of a simplex, the smaller ones first.
std::vector<Balls> proper_faces(const Balls& simplex) {
  std::vector<Balls> faces;
  for (unsigned bits = 1; bits + 1 < 1u << simplex.size(); ++bits) {
    Balls face;
    for (std::size_t n = 0; n < simplex.size(); ++n) {
      if (bits >> n & 1) face.push_back(simplex[n]);
    }
    faces.push_back(face);
  }
  std::stable_sort(faces.begin(), faces.end(),
                   [](const Balls& a, const Balls& b) { return a.size() < b.size(); });
  return faces;
}

bool independent(const BallSet& balls, std::span<const BallIndex> simplex) {
  return with_sphere(balls, simplex, [](const auto& sphere) { return !sphere.flat(); });
}

LocalStar star_of(const BallSet& balls, const Balls& simplex, const Explanation& e,
                  const RunContext& context) {
  Balls first = simplex;
  std::vector<PointAtBall> points;
  for (const BallIndex v : simplex) points.push_back({v, {}});
  for (const Balls& near : nearest_by_power(balls, points, simplex, kFirst)) {
    first.insert(first.end(), near.begin(), near.end());
  }
  for (const BallMargin& one : e.nearest) first.push_back(one.ball);
  return local_star(balls, simplex, std::move(first), context);
}

// Notes why `simplex` is absent if the reason is not the absence of a face.
void own_absence(const BallSet& balls, const Balls& simplex, const Explanation& e,
                 const Balls& chosen, Explanation& to) {
  to.absence = AbsenceReason::cut_away;
  if (simplex.size() == 1) {
    to.absence = AbsenceReason::hidden;
    to.absent_face = simplex;
    if (const auto twin = twin_that_hides(balls, simplex[0])) {
      to.culprits = {*twin};
      return;
    }
  }
  if (simplex.size() == 3) {
    to.culprits = cutters_of_line(balls, simplex, chosen);
    return;
  }
  for (const BallMargin& one : e.nearest) {
    if (to.culprits.empty() && one.sign <= 0 && (one.sign < 0 || one.steps.back().sign < 0))
      to.culprits = {one.ball};
  }
}

void explain_absence(const BallSet& balls, const RunContext& context, const LocalStar& star,
                     Explanation& e) {
  for (const BallIndex v : e.simplex) {
    Explanation alone;
    alone.nearest = e.simplex.size() == 1 ? e.nearest : std::vector<BallMargin>{};
    const Balls one{v};
    if (e.simplex.size() > 1) {
      const PointAtBall at{v, {}};
      alone.nearest =
          margins(balls, one, nearest_by_power(balls, {&at, 1}, one, 2 * kNearest).front());
    }
    const LocalStar around = star_of(balls, one, alone, context);
    const auto& vertices = around.triangulation.vertices;
    if (std::binary_search(vertices.begin(), vertices.end(), around.local(v))) continue;
    return own_absence(balls, one, alone, around.chosen, e);
  }
  if (!e.orthosphere) {
    e.absence = AbsenceReason::dependent;
    return;
  }
  for (const Balls& face : proper_faces(e.simplex)) {
    if (face.size() < 2 || !independent(balls, face)) continue;
    const LocalStar around = star_of(balls, face, e, context);
    if (Surrounded(balls, around, context).has(face)) continue;
    e.absence = AbsenceReason::face;
    e.absent_face = face;
    return;
  }
  own_absence(balls, e.simplex, e, star.chosen, e);
}

}  // namespace

Explanation explain(const BallSet& balls, std::span<const BallIndex> simplex,
                    std::optional<LatticeAlpha> alpha_on_lattice, const RunContext& context) {
  Explanation e;
  e.lattice = balls.lattice;
  e.simplex.assign(simplex.begin(), simplex.end());
  std::sort(e.simplex.begin(), e.simplex.end());
  if (e.simplex.empty() || e.simplex.size() > 4 || e.simplex.back() >= balls.size() ||
      std::adjacent_find(e.simplex.begin(), e.simplex.end()) != e.simplex.end()) {
    throw std::invalid_argument("a simplex is 1 to 4 different balls of the set");
  }
  if (alpha_on_lattice && std::isnan(alpha_on_lattice->below)) {
    throw std::invalid_argument("alpha is not a number");
  }
  if (independent(balls, e.simplex)) {
    const PointAtBall centre{e.simplex[0], with_sphere(balls, e.simplex, [](const auto& s) {
                               return s.from_first_ball();
                             })};
    const RealPoint at = real_point(balls.centres[e.simplex[0]]) + centre.offset;
    const ExactRho rho = rho_of(balls, e.simplex);
    e.orthosphere = {balls.lattice.unit_angstrom() * at,
                     balls.lattice.square_angstrom(quotient(rho)), rho.numerator.sign()};
    e.nearest = margins(balls, e.simplex,
                        nearest_by_power(balls, {&centre, 1}, e.simplex, 2 * kNearest).front());
  }
  const LocalStar star = star_of(balls, e.simplex, e, context);
  e.dimension = star.triangulation.dimension;
  const Surrounded around(balls, star, context);
  if (!around.has(e.simplex)) {
    explain_absence(balls, context, star, e);
    return e;
  }
  e.appears = around.appears(e.simplex);
  around.levels(e);
  if (alpha_on_lattice) e.at_alpha = around.at(e.simplex, e.appears, *alpha_on_lattice);
  return e;
}

}  // namespace alphascope
