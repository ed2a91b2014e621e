// SPDX-License-Identifier: GPL-3.0-or-later
// The checks of verify.hpp, each in its own function. Conflicts are searched among all near balls,
// in integers. The complex itself is never trusted to name the near balls. verify_missing.cpp finds
// missing simplices.
#include "core/verify/verify.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/complex/face_groups.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/verify/findings.hpp"
#include "core/verify/verify_missing.hpp"
#include "core/verify/verify_proven.hpp"
#include "core/verify/verify_run.hpp"
#include "core/verify/verify_surroundings.hpp"

namespace alphascope {
namespace {

// False if the other checks cannot safely index the list.
template <int N>
bool check_list(const BallSet& balls, const SimplexList<N>& list, bool with_values,
                const char* name, Findings& findings) {
  if (with_values &&
      (list.alpha_values.size() != list.size() || list.classes.size() != list.size())) {
    findings.fail(std::string(name) + ": alpha values or classes are not one per simplex");
    return false;
  }
  return check_order<N>(balls, list.simplices, findings);
}

// Checks a simplex against every near ball. A ball in conflict has less power than rho <= alpha at
// the orthocentre, so it may touch all balls of the simplex.
class NearBalls {
 public:
  explicit NearBalls(const VerifyBalls& balls) : balls_(balls) {}

  template <int N>
  bool conflict(const Orthosphere<N>& sphere, const std::array<BallIndex, N>& s) const {
    around().find_near_balls<N>(balls_, s);
    return around().conflict<N>(sphere, s);
  }
  // Is the simplex in the triangulation? Call it right after conflict() was false.
  template <int N>
  bool there(const std::array<BallIndex, N>& s) const {
    return in_triangulation<N>(balls_.balls(), s, around().ties());
  }

 private:
  static Surroundings& around() {
    thread_local Surroundings around;
    return around;
  }
  const VerifyBalls& balls_;
};

// Looks a simplex up in a proven triangulation. A simplex that is not in it counts as in conflict.
class ProvenPlaces {
 public:
  explicit ProvenPlaces(const ProvenTriangulation& proven) : proven_(proven) {}

  template <int N>
  bool conflict(const Orthosphere<N>&, const std::array<BallIndex, N>& s) const {
    const std::size_t at = proven_.find<N>(s);
    const auto& attached = proven_.simplices<N>().attached;
    return at == attached.size() || attached[at];
  }
  template <int N>
  bool there(const std::array<BallIndex, N>& s) const {
    return proven_.find<N>(s) < proven_.simplices<N>().simplices.size();
  }

 private:
  const ProvenTriangulation& proven_;
};

// The least alpha value of the cofaces of a simplex in the complex; empty without cofaces.
using LeastOfCofaces = std::optional<float>;

// Checks one simplex: its alpha value, and that it is in the triangulation.
template <int N, class Places>
void check_simplex(const VerifyBalls& balls, const Places& places,
                   const std::array<BallIndex, N>& s, const float* value,
                   const LeastOfCofaces& least, Findings& findings) {
  const bool hidden = std::any_of(s.begin(), s.end(), [&](BallIndex v) { return balls.hidden(v); });
  findings.check<N>(!hidden, s, "a ball is hidden by another one with the same centre");
  const Orthosphere<N> sphere(balls.balls(), s);
  findings.check<N>(!sphere.flat(), s, "its balls are affinely dependent");
  if (hidden || sphere.flat()) return;
  const ExactRho rho = sphere.rho();
  const bool within = compare_exact(rho, balls.alpha()) <= 0;
  findings.check<N>(within, s, "ortho-radius above alpha");
  if (!within) return;  // far balls could be in conflict too, and are not searched
  if (places.template conflict<N>(sphere, s)) {
    findings.check<N>(least.has_value(), s, "a ball is in conflict with its orthosphere");
    if (!least) return;
    findings.check<N>(value == nullptr || *value == *least, s,
                      "attached, but its alpha value is not the least of its cofaces'");
    return;
  }
  findings.check<N>(value == nullptr || *value == round_exact(rho), s,
                    "unattached, but its alpha value is not the ortho-radius");
  if (least) return;  // the coface proves that it is in the triangulation
  findings.check<N>(places.template there<N>(s), s, "a tie with another ball is broken wrongly");
}

// Checks simplices that need not be faces of larger ones.
template <int N, class Places>
void check_top(const VerifyBalls& balls, const Places& places, const SimplexList<N>& list,
               const RunContext& context, Findings& findings) {
  verify_all(list.size(), context, [&](std::size_t n) {
    check_simplex<N>(balls, places, list.simplices[n],
                     list.alpha_values.empty() ? nullptr : &list.alpha_values[n], std::nullopt,
                     findings);
  });
}

template <int N, class Places>
void check_faces(const VerifyBalls& balls, const Places& places, const SimplexList<N>& list,
                 const SimplexList<N + 1>& cofaces, const RunContext& context, Findings& findings) {
  std::vector<LeastOfCofaces> least(list.size());
  const FaceGroups<N> groups(cofaces.simplices);
  context.cancel.throw_if_cancelled();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const auto& face = groups.faces()[g];
    const auto at = std::lower_bound(list.simplices.begin(), list.simplices.end(), face);
    const bool there = at != list.simplices.end() && *at == face;
    findings.check<N>(there, face, "face of a simplex of the complex, but not in it");
    if (!there) continue;
    LeastOfCofaces& value = least[static_cast<std::size_t>(at - list.simplices.begin())];
    groups.for_cofaces(g, [&](auto coface) {
      const float of_coface = cofaces.alpha_values[coface];
      value = std::min(value.value_or(of_coface), of_coface);
    });
  }
  verify_all(list.size(), context, [&](std::size_t n) {
    const auto& s = list.simplices[n];
    findings.check<N>(!least[n] || list.alpha_values[n] <= *least[n], s,
                      "alpha value above that of a coface");
    check_simplex<N>(balls, places, s, &list.alpha_values[n], least[n], findings);
  });
}

template <int N>
void check_classes(const SimplexList<N>& list, const SimplexList<N>& expected, Findings& findings) {
  for (std::size_t n = 0; n < list.size(); ++n) {
    findings.check<N>(list.classes[n] == expected.classes[n], list.simplices[n], "wrong class");
  }
}

template <int N>
void report_missing(const Simplices<N>& missing, Findings& findings) {
  for (const auto& s : missing) {
    findings.check<N>(
        false, s, "missing: no ball is in conflict with its orthosphere, and ρ is not above alpha");
  }
}

// The complex of the tetrahedra and their faces, with classes.
AlphaComplex closure(const AlphaComplex& tetrahedra_only) {
  AlphaComplex whole;
  whole.tetrahedra.simplices = tetrahedra_only.tetrahedra.simplices;
  whole.triangles.simplices = FaceGroups<3>(whole.tetrahedra.simplices).faces();
  whole.edges.simplices = FaceGroups<2>(whole.triangles.simplices).faces();
  whole.vertices.simplices = FaceGroups<1>(whole.edges.simplices).faces();
  classify(whole);
  return whole;
}

void check_classes(const AlphaComplex& complex, Findings& findings) {
  AlphaComplex expected = complex;
  classify(expected);
  check_classes(complex.tetrahedra, expected.tetrahedra, findings);
  check_classes(complex.triangles, expected.triangles, findings);
  check_classes(complex.edges, expected.edges, findings);
  check_classes(complex.vertices, expected.vertices, findings);
}

template <int N>
Simplices<N> missing_in(const SimplexList<N>& list, const ProvenTriangulation& proven) {
  const ProvenSimplices<N>& all = proven.simplices<N>();
  Simplices<N> missing;
  for (std::size_t n = 0; n < all.simplices.size(); ++n) {
    const auto& s = all.simplices[n];
    if (all.in[n] && !std::binary_search(list.simplices.begin(), list.simplices.end(), s)) {
      missing.push_back(s);
    }
  }
  return missing;
}

// The missing simplices of a complex that is sound, but may be incomplete.
MissingSimplices missing_of(const VerifyBalls& balls, const AlphaComplex& complex,
                            const ProvenTriangulation* proven, const RunContext& context) {
  if (proven == nullptr) {
    return find_missing(balls, complex.tetrahedra_only ? closure(complex) : complex,
                        complex.tetrahedra_only, context);
  }
  MissingSimplices missing;
  missing.tetrahedra = missing_in<4>(complex.tetrahedra, *proven);
  if (complex.tetrahedra_only) return missing;
  missing.triangles = missing_in<3>(complex.triangles, *proven);
  missing.edges = missing_in<2>(complex.edges, *proven);
  missing.vertices = missing_in<1>(complex.vertices, *proven);
  return missing;
}

template <class Places>
void check_simplices(const VerifyBalls& balls, const Places& places, const AlphaComplex& complex,
                     const RunContext& context, Findings& findings) {
  check_top<4>(balls, places, complex.tetrahedra, context, findings);
  if (complex.tetrahedra_only) return;
  check_faces<3>(balls, places, complex.triangles, complex.tetrahedra, context, findings);
  check_faces<2>(balls, places, complex.edges, complex.triangles, context, findings);
  check_faces<1>(balls, places, complex.vertices, complex.edges, context, findings);
}

// Are there so many near balls that making and proving a triangulation is faster than the search?
// This is estimated from a sample. It affects the method only, not the findings.
bool has_crowds(const VerifyBalls& balls) {
  constexpr std::size_t kAsked = 50, kFew = 60;
  const std::size_t count = balls.balls().size();
  std::size_t asked = 0, near = 0;
  std::vector<BallIndex> found;
  for (std::size_t i = 0; i < count; i += count / kAsked + 1, ++asked) {
    balls.around(static_cast<BallIndex>(i), found);
    near += found.size();
  }
  return near > kFew * asked;
}

template <int N>
bool is_sublist(const SimplexList<N>& smaller, const SimplexList<N>& larger) {
  return std::includes(larger.simplices.begin(), larger.simplices.end(), smaller.simplices.begin(),
                       smaller.simplices.end());
}

}  // namespace

Verification verify(const BallSet& given, const AlphaComplex& complex, const RunContext& context,
                    VerifyBy by) {
  Findings findings;
  const bool whole = !complex.tetrahedra_only;
  bool sound = check_list(given, complex.tetrahedra, whole, "tetrahedra", findings);
  sound = check_list(given, complex.triangles, whole, "triangles", findings) && sound;
  sound = check_list(given, complex.edges, whole, "edges", findings) && sound;
  sound = check_list(given, complex.vertices, whole, "vertices", findings) && sound;
  if (std::isnan(complex.alpha_on_lattice.below)) findings.fail("alpha is not a number");
  if (!findings.good()) return findings.take();

  const VerifyBalls balls(given, complex.alpha_on_lattice);
  std::optional<ProvenTriangulation> proven;
  if (by == VerifyBy::triangulation || (by == VerifyBy::whatever_is_faster && has_crowds(balls))) {
    proven.emplace(balls, context);
    if (!proven->proof().ok()) proven.reset();
  }
  if (proven) {
    check_simplices(balls, ProvenPlaces(*proven), complex, context, findings);
  } else {
    check_simplices(balls, NearBalls(balls), complex, context, findings);
  }
  // The search for missing simplices skips some, which is right only for a sound complex.
  if (findings.good()) {
    if (whole) check_classes(complex, findings);
    const MissingSimplices missing =
        missing_of(balls, complex, proven ? &*proven : nullptr, context);
    report_missing<1>(missing.vertices, findings);
    report_missing<2>(missing.edges, findings);
    report_missing<3>(missing.triangles, findings);
    report_missing<4>(missing.tetrahedra, findings);
  }
  Verification found = findings.take();
  if (proven) found.checks += proven->proof().checks;
  return found;
}

bool is_subcomplex(const AlphaComplex& smaller, const AlphaComplex& larger) {
  return is_sublist(smaller.vertices, larger.vertices) && is_sublist(smaller.edges, larger.edges) &&
         is_sublist(smaller.triangles, larger.triangles) &&
         is_sublist(smaller.tetrahedra, larger.tetrahedra);
}

}  // namespace alphascope
