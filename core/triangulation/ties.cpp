// SPDX-License-Identifier: GPL-3.0-or-later
// Collects the ties of a filtration and decides them by exact predicates, from tetrahedra down to
// vertices.
#include "core/triangulation/ties.hpp"

#include "core/complex/alpha_complex.hpp"
#include "core/complex/face_groups.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

template <int N>
void collect_ties(const SimplexList<N>& list, float limit, Ties<N>& ties) {
  const float* values = list.alpha_values.data();
  const std::size_t count =
      parallel_sum(0, list.size(), 1 << 15, [&](std::size_t first, std::size_t end) {
        unsigned equal = 0;
        for (std::size_t n = first; n != end; ++n) equal += values[n] == limit;
        return equal;
      });
  if (count == 0) return;
  ties.simplices.reserve(count);
  for (std::size_t n = 0; n < list.size(); ++n) {
    if (values[n] == limit) ties.simplices.push_back(list.simplices[n]);
  }
}

void decide_tetrahedra(const BallSet& balls, const LatticeAlpha& alpha, Ties<4>& ties) {
  for (const auto& s : ties.simplices) {
    ties.in_complex.push_back(compare_ortho_radius(balls, s, alpha) <= 0);
  }
}

// A tied face has only cofaces with the same float or a larger one. If it is attached, it has its
// value from a coface whose apex is in conflict with it. That coface is a tie as well. So only the
// ties of the next dimension need a look.
template <int N>
void decide_faces(const BallSet& balls, const LatticeAlpha& alpha, const Ties<N + 1>& cofaces,
                  Ties<N>& ties) {
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

}  // namespace

AllTies decide_ties(const Filtration& filtration, const LatticeAlpha& alpha, bool tetrahedra_only) {
  const float limit = alpha.nearest_float();
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

}  // namespace alphascope
