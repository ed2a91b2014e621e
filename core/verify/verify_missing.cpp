// SPDX-License-Identifier: GPL-3.0-or-later
// Finds missing simplices. This is why it is enough to test one more ball with each known simplex.
//
// T is the regular triangulation with ties broken: that of the weights w - e for all small enough e
// (verify_orthosphere.hpp). A simplex s of T is in K_alpha iff its alpha value, the least power
// over its dual face V_s, is at most alpha.
//
//   Claim. Let L be a part of K_alpha, closed under faces, so that
//    (0) every vertex of K_alpha without a ball in conflict is in L;
//    (1) for every simplex t of L with 1 to 3 balls, and every ball m, the simplex s of t and m is
//        in L if it is in T, no ball is in conflict with it, and its rho is at most alpha.
//   Then L = K_alpha.
//
//   Proof. Suppose that some simplex is missing. Let s be one of the least perturbed alpha value,
//   and with the most balls among these. If s had its value from a coface, that coface would be in
//   K_alpha. It has the same value and more balls, so it would be in L, and so would its face s.
//   Hence the orthocentre x of s is inside V_s. So no ball is in conflict there, with or without
//   the perturbation, and rho <= alpha. If s is a vertex, it is in L by (0). Else some barycentric
//   coordinate of x in s is positive, for their sum is 1. Let it be that of ball l, and let t be s
//   without l. Go from x towards the orthocentre of t, along the flat where the balls of t have
//   equal power. Since x is on l's side of t, this power falls strictly, and l's power falls less.
//   No other ball bounds V_t near x. So V_t has points of less power than x. Hence t, which is in
//   T, is in K_alpha and has a smaller perturbed value than s. Then t is in L, and by (1) so is s:
//   a contradiction. ∎
//
// A ball in conflict with s, or tied, contains the orthocentre when grown by alpha, as do all balls
// of s. So it may touch all of them, and only near balls have to be searched. This holds only for
// rho <= alpha. A simplex with rho > alpha that is discarded for a near conflict is discarded
// rightly.
//
// An interior simplex t needs no search, since all simplices of T around it are in L:
//  - A triangle with two tetrahedra has no third.
//  - The tetrahedra of T at an edge form a cycle or a fan, where neighbours share a triangle. Let
//    all triangles in L at the edge have both their tetrahedra in L. Then each of these tetrahedra
//    has its neighbours in L, so L has the whole cycle if it has any of it.
//  - The same holds at a vertex, whose edges, triangles and tetrahedra form a connected surface.
//
// If only tetrahedra are given, L begins with them and their faces. Simplices of fewer balls that
// (0) and (1) find are added to it until there are no more.
#include "core/verify/verify_missing.hpp"

#include <algorithm>
#include <iterator>
#include <mutex>
#include <utility>

#include "core/verify/verify_run.hpp"
#include "core/verify/verify_surroundings.hpp"

namespace alphascope {
namespace {

template <int N>
void sort_unique(Simplices<N>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

// Is the simplex in K_alpha as an unattached one? `around` must include the surroundings of the
// simplex.
template <int N>
bool stands_alone(const VerifyBalls& balls, const std::array<BallIndex, N>& simplex,
                  Surroundings& around, const Simplices<N>& known) {
  const Orthosphere<N> sphere(balls.balls(), simplex);
  if (sphere.flat() || around.conflict<N>(sphere, simplex)) return false;
  if (std::binary_search(known.begin(), known.end(), simplex)) return false;  // known already
  return compare_exact(sphere.rho(), balls.alpha()) <= 0 &&
         in_triangulation<N>(balls.balls(), simplex, around.ties());
}

// (0) of the claim.
Simplices<1> missing_vertices(const VerifyBalls& balls, const Simplices<1>& known,
                              const RunContext& context) {
  Simplices<1> missing;
  std::mutex mutex;
  verify_all(balls.balls().size(), context, [&](std::size_t n) {
    const auto i = static_cast<BallIndex>(n);
    if (balls.hidden(i) || balls.empty(i)) return;
    thread_local Surroundings around;
    around.find_near_balls<1>(balls, {i});
    if (!stands_alone<1>(balls, {i}, around, known)) return;
    const std::lock_guard lock(mutex);
    missing.push_back({i});
  });
  sort_unique<1>(missing);
  return missing;
}

// (1) of the claim: the cofaces of `faces` that are missing in `known`.
template <int N>
Simplices<N + 1> missing_cofaces(const VerifyBalls& balls, const Simplices<N>& faces,
                                 const Simplices<N + 1>& known, const RunContext& context) {
  Simplices<N + 1> missing;
  std::mutex mutex;
  verify_all(faces.size(), context, [&](std::size_t n) {
    thread_local Surroundings around;
    around.find_near_balls<N>(balls, faces[n]);
    for (const BallIndex m : around.near()) {
      const std::array<BallIndex, N + 1> coface = joined<N>(faces[n], m);
      if (!stands_alone<N + 1>(balls, coface, around, known)) continue;
      const std::lock_guard lock(mutex);
      missing.push_back(coface);
    }
  });
  sort_unique<N + 1>(missing);
  return missing;
}

// One dimension of L, and the part of it that is still to be searched.
template <int N>
struct Part {
  Simplices<N> known, open;

  explicit Part(const SimplexList<N>& list) : known(list.simplices) {
    for (std::size_t n = 0; n < list.size(); ++n) {
      if (list.classes[n] != SimplexClass::interior) open.push_back(list.simplices[n]);
    }
  }
  // Adds simplices and returns those that were not known.
  Simplices<N> add(Simplices<N> found) {
    sort_unique<N>(found);
    Simplices<N> added, all;
    std::set_difference(found.begin(), found.end(), known.begin(), known.end(),
                        std::back_inserter(added));
    std::merge(known.begin(), known.end(), added.begin(), added.end(), std::back_inserter(all));
    known.swap(all);
    open.insert(open.end(), added.begin(), added.end());
    return added;
  }
};

template <int N>
Simplices<N - 1> faces_of(const Simplices<N>& list) {
  Simplices<N - 1> faces;
  for (const auto& simplex : list) {
    for (int dropped = 0; dropped < N; ++dropped) {
      std::array<BallIndex, N - 1> face;
      std::copy(simplex.begin(), simplex.begin() + dropped, face.begin());
      std::copy(simplex.begin() + dropped + 1, simplex.end(), face.begin() + dropped);
      faces.push_back(face);
    }
  }
  return faces;
}

}  // namespace

MissingSimplices find_missing(const VerifyBalls& balls, const AlphaComplex& complex,
                              bool tetrahedra_given, const RunContext& context) {
  MissingSimplices missing;
  Part<1> vertices(complex.vertices);
  Part<2> edges(complex.edges);
  Part<3> triangles(complex.triangles);
  missing.vertices = missing_vertices(balls, vertices.known, context);
  if (tetrahedra_given) vertices.add(std::exchange(missing.vertices, {}));
  for (;;) {
    missing.edges = missing_cofaces<1>(balls, vertices.open, edges.known, context);
    vertices.open.clear();
    if (tetrahedra_given) vertices.add(faces_of<2>(edges.add(std::exchange(missing.edges, {}))));
    missing.triangles = missing_cofaces<2>(balls, edges.open, triangles.known, context);
    edges.open.clear();
    if (tetrahedra_given) {
      const Simplices<3> added = triangles.add(std::exchange(missing.triangles, {}));
      vertices.add(faces_of<2>(edges.add(faces_of<3>(added))));
    }
    const Simplices<4> found =
        missing_cofaces<3>(balls, triangles.open, complex.tetrahedra.simplices, context);
    triangles.open.clear();
    missing.tetrahedra.insert(missing.tetrahedra.end(), found.begin(), found.end());
    if (vertices.open.empty() && edges.open.empty()) break;
    if (!tetrahedra_given) break;
  }
  sort_unique<4>(missing.tetrahedra);
  return missing;
}

}  // namespace alphascope
