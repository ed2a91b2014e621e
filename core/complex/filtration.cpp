// Thresholding a filtration. The float of an alpha value decides except where alpha itself rounds
// to it: those simplices, the ties, are decided exactly.
#include "core/complex/filtration.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/complex/face_groups.hpp"
#include "core/geometry/exact_alpha.hpp"

namespace alphascope {
namespace {

// The simplices of one dimension whose alpha value rounds to the same float as alpha.
template <int N>
struct Ties {
  Simplices<N> simplices;  // in lexicographic order
  std::vector<char> in_complex;

  bool any(bool in) const { return std::count(in_complex.begin(), in_complex.end(), in) > 0; }
};

struct AllTies {
  Ties<1> vertices;
  Ties<2> edges;
  Ties<3> triangles;
  Ties<4> tetrahedra;

  bool any(bool in) const {
    return vertices.any(in) || edges.any(in) || triangles.any(in) || tetrahedra.any(in);
  }
};

template <int N>
void collect_ties(const SimplexList<N>& list, float limit, Ties<N>& ties) {
  const auto count = std::count(list.alpha_values.begin(), list.alpha_values.end(), limit);
  if (count == 0) return;
  ties.simplices.reserve(static_cast<std::size_t>(count));
  for (std::size_t n = 0; n < list.size(); ++n) {
    if (list.alpha_values[n] == limit) ties.simplices.push_back(list.simplices[n]);
  }
}

void decide_tetrahedra(const BallSet& balls, double alpha, Ties<4>& ties) {
  for (const auto& s : ties.simplices) {
    ties.in_complex.push_back(compare_ortho_radius(balls, s, alpha) <= 0);
  }
}

// A tied face has only cofaces of the same float or a larger one, and if it is attached, the coface
// from which it has its value, whose apex is in conflict with it, is a tie itself. So the ties of
// the next dimension are all that needs to be looked at.
template <int N>
void decide_faces(const BallSet& balls, double alpha, const Ties<N + 1>& cofaces, Ties<N>& ties) {
  const FaceGroups<N> groups(cofaces.simplices);
  std::size_t g = 0;
  for (const auto& face : ties.simplices) {
    bool attached = false, coface_in = false;
    while (g < groups.size() && groups.faces()[g] < face) ++g;
    if (g < groups.size() && groups.faces()[g] == face) {
      groups.for_cofaces(g, [&](std::uint32_t c) {
        const auto& coface = cofaces.simplices[c];
        coface_in = coface_in || cofaces.in_complex[c];
        int n = 0;
        while (n < N && coface[n] == face[n]) ++n;
        attached = attached || conflict_with_smallest_orthosphere(balls, face, coface[n]) < 0;
      });
    }
    ties.in_complex.push_back(coface_in ||
                              (!attached && compare_ortho_radius(balls, face, alpha) <= 0));
  }
}

AllTies decide_ties(const Filtration& filtration, double alpha, float limit, bool tetrahedra_only) {
  const AlphaComplex& top = filtration.top();
  const BallSet& balls = filtration.balls();
  AllTies ties;
  collect_ties(top.tetrahedra, limit, ties.tetrahedra);
  decide_tetrahedra(balls, alpha, ties.tetrahedra);
  if (tetrahedra_only) return ties;
  collect_ties(top.triangles, limit, ties.triangles);
  decide_faces<3>(balls, alpha, ties.tetrahedra, ties.triangles);
  collect_ties(top.edges, limit, ties.edges);
  decide_faces<2>(balls, alpha, ties.triangles, ties.edges);
  collect_ties(top.vertices, limit, ties.vertices);
  decide_faces<1>(balls, alpha, ties.edges, ties.vertices);
  return ties;
}

template <int N>
void select(const SimplexList<N>& from, float limit, const Ties<N>& ties, SimplexList<N>& to) {
  const std::size_t below = static_cast<std::size_t>(std::count_if(
      from.alpha_values.begin(), from.alpha_values.end(), [&](float v) { return v < limit; }));
  to.simplices.reserve(below + ties.simplices.size());
  to.alpha_values.reserve(below + ties.simplices.size());
  std::size_t tie = 0;
  for (std::size_t n = 0; n < from.size(); ++n) {
    const float value = from.alpha_values[n];
    if (value < limit || (value == limit && ties.in_complex[tie++])) {
      to.simplices.push_back(from.simplices[n]);
      to.alpha_values.push_back(value);
    }
  }
}

// Classes from the levels, where all ties are decided alike: a level equal to the limit is passed
// iff the ties are in. Visits the simplices as select() did.
template <int N>
void select_classes(const SimplexList<N>& from, const ClassLevels& levels, float limit,
                    bool ties_in, SimplexList<N>& to) {
  to.classes.reserve(to.size());
  const auto passed = [&](float level) { return level < limit || (ties_in && level == limit); };
  for (std::size_t n = 0; n < from.size(); ++n) {
    if (!passed(from.alpha_values[n])) continue;
    to.classes.push_back(passed(levels.interior_from[n])  ? SimplexClass::interior
                         : passed(levels.regular_from[n]) ? SimplexClass::regular
                                                          : SimplexClass::singular);
  }
}

}  // namespace

AlphaComplex threshold(const Filtration& filtration, double alpha, bool tetrahedra_only) {
  const AlphaComplex& top = filtration.top();
  if (!(alpha <= filtration.alpha_max_on_lattice())) {
    throw std::invalid_argument("alpha is larger than the filtration's alpha_max");
  }
  AlphaComplex complex;
  complex.lattice = top.lattice;
  complex.alpha_on_lattice = alpha;
  complex.tetrahedra_only = tetrahedra_only;
  if (alpha == filtration.alpha_max_on_lattice()) {
    complex.tetrahedra = top.tetrahedra;
    if (!tetrahedra_only) {
      complex.triangles = top.triangles;
      complex.edges = top.edges;
      complex.vertices = top.vertices;
    }
  } else {
    const float limit = static_cast<float>(alpha);
    const AllTies ties = decide_ties(filtration, alpha, limit, tetrahedra_only);
    select(top.tetrahedra, limit, ties.tetrahedra, complex.tetrahedra);
    if (!tetrahedra_only) {
      select(top.triangles, limit, ties.triangles, complex.triangles);
      select(top.edges, limit, ties.edges, complex.edges);
      select(top.vertices, limit, ties.vertices, complex.vertices);
      if (ties.any(true) && ties.any(false)) {
        classify(complex);
      } else {
        const bool in = ties.any(true);
        const ClassLevelsByDimension& levels = filtration.levels();
        complex.tetrahedra.classes.assign(complex.tetrahedra.size(), SimplexClass::interior);
        select_classes(top.triangles, levels.triangles, limit, in, complex.triangles);
        select_classes(top.edges, levels.edges, limit, in, complex.edges);
        select_classes(top.vertices, levels.vertices, limit, in, complex.vertices);
      }
    }
  }
  if (tetrahedra_only) {
    complex.tetrahedra.alpha_values.clear();
    complex.tetrahedra.classes.clear();
  }
  complex.hash = complex_hash(complex);
  return complex;
}

}  // namespace alphascope
