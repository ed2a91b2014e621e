// The checks of verify.hpp, each in its own function. Conflicts are looked for among every near
// ball, in integers; neighbourhood in the complex is never trusted for them. What is missing is
// verify_missing.cpp's.
#include "core/verify/verify.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/complex/face_groups.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/verify/findings.hpp"
#include "core/verify/verify_missing.hpp"
#include "core/verify/verify_run.hpp"
#include "core/verify/verify_surroundings.hpp"

namespace alphascope {
namespace {

// False when the list cannot be indexed safely by the other checks.
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

// The least alpha value of the cofaces that a simplex has in the complex, if any.
using LeastOfCofaces = std::optional<float>;

// A simplex by itself: what its alpha value must be, and that it is in the triangulation. A ball in
// conflict has, at the orthocentre, less power than rho <= alpha: it may touch all balls of the
// simplex.
template <int N>
void check_simplex(const VerifyBalls& balls, const std::array<BallIndex, N>& s, const float* value,
                   const LeastOfCofaces& least, Findings& findings) {
  const bool hidden = std::any_of(s.begin(), s.end(), [&](BallIndex v) { return balls.hidden(v); });
  findings.check<N>(!hidden, s, "a ball is hidden by another one with the same centre");
  const Orthosphere<N> sphere(balls.balls(), s);
  findings.check<N>(!sphere.flat(), s, "its balls are affinely dependent");
  if (hidden || sphere.flat()) return;
  const ExactRho rho = sphere.rho();
  const bool within = compare_exact(rho, balls.alpha()) <= 0;
  findings.check<N>(within, s, "ortho-radius above alpha");
  if (!within) return;  // and then far balls might be in conflict, too
  thread_local Surroundings around;
  around.look_around<N>(balls, s);
  if (around.conflict<N>(sphere, s)) {
    findings.check<N>(least.has_value(), s, "a ball is in conflict with its orthosphere");
    if (!least) return;
    findings.check<N>(value == nullptr || *value == *least, s,
                      "attached, but its alpha value is not the least of its cofaces'");
    return;
  }
  findings.check<N>(value == nullptr || *value == round_exact(rho), s,
                    "unattached, but its alpha value is not the ortho-radius");
  if (least) return;  // which shows that it is there
  findings.check<N>(in_triangulation<N>(balls.balls(), s, around.ties()), s,
                    "a tie with another ball is broken wrongly");
}

// Simplices that need not be faces of larger ones.
template <int N>
void check_top(const VerifyBalls& balls, const SimplexList<N>& list, const RunContext& context,
               Findings& findings) {
  verify_all(list.size(), context, [&](std::size_t n) {
    check_simplex<N>(balls, list.simplices[n],
                     list.alpha_values.empty() ? nullptr : &list.alpha_values[n], std::nullopt,
                     findings);
  });
}

template <int N>
void check_faces(const VerifyBalls& balls, const SimplexList<N>& list,
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
    check_simplex<N>(balls, s, &list.alpha_values[n], least[n], findings);
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
    findings.check<N>(false, s, "missing: its orthosphere is empty and not above alpha");
  }
}

// The tetrahedra, with their faces and classes.
AlphaComplex closure(const AlphaComplex& tetrahedra_only) {
  AlphaComplex whole;
  whole.tetrahedra.simplices = tetrahedra_only.tetrahedra.simplices;
  whole.triangles.simplices = FaceGroups<3>(whole.tetrahedra.simplices).faces();
  whole.edges.simplices = FaceGroups<2>(whole.triangles.simplices).faces();
  whole.vertices.simplices = FaceGroups<1>(whole.edges.simplices).faces();
  classify(whole);
  return whole;
}

// Of a complex that is sound but perhaps not all.
void check_complete(const VerifyBalls& balls, const AlphaComplex& complex,
                    const RunContext& context, Findings& findings) {
  AlphaComplex expected = complex.tetrahedra_only ? closure(complex) : complex;
  if (!complex.tetrahedra_only) {
    classify(expected);
    check_classes(complex.tetrahedra, expected.tetrahedra, findings);
    check_classes(complex.triangles, expected.triangles, findings);
    check_classes(complex.edges, expected.edges, findings);
    check_classes(complex.vertices, expected.vertices, findings);
  }
  const MissingSimplices missing = find_missing(balls, expected, complex.tetrahedra_only, context);
  report_missing<1>(missing.vertices, findings);
  report_missing<2>(missing.edges, findings);
  report_missing<3>(missing.triangles, findings);
  report_missing<4>(missing.tetrahedra, findings);
}

template <int N>
bool is_sublist(const SimplexList<N>& smaller, const SimplexList<N>& larger) {
  return std::includes(larger.simplices.begin(), larger.simplices.end(), smaller.simplices.begin(),
                       smaller.simplices.end());
}

}  // namespace

Verification verify(const BallSet& given, const AlphaComplex& complex, const RunContext& context) {
  Findings findings;
  const bool whole = !complex.tetrahedra_only;
  bool sound = check_list(given, complex.tetrahedra, whole, "tetrahedra", findings);
  sound = check_list(given, complex.triangles, whole, "triangles", findings) && sound;
  sound = check_list(given, complex.edges, whole, "edges", findings) && sound;
  sound = check_list(given, complex.vertices, whole, "vertices", findings) && sound;
  if (std::isnan(complex.alpha_on_lattice.below)) findings.fail("alpha is not a number");
  if (!findings.good()) return findings.take();

  const VerifyBalls balls(given, complex.alpha_on_lattice);
  check_top<4>(balls, complex.tetrahedra, context, findings);
  if (whole) {
    check_faces<3>(balls, complex.triangles, complex.tetrahedra, context, findings);
    check_faces<2>(balls, complex.edges, complex.triangles, context, findings);
    check_faces<1>(balls, complex.vertices, complex.edges, context, findings);
  }
  // What may be skipped in the search for missing simplices is known of a sound complex only.
  if (findings.good()) check_complete(balls, complex, context, findings);
  return findings.take();
}

bool is_subcomplex(const AlphaComplex& smaller, const AlphaComplex& larger) {
  return is_sublist(smaller.vertices, larger.vertices) && is_sublist(smaller.edges, larger.edges) &&
         is_sublist(smaller.triangles, larger.triangles) &&
         is_sublist(smaller.tetrahedra, larger.tetrahedra);
}

}  // namespace alphascope
