// SPDX-License-Identifier: GPL-3.0-or-later
// Finds outer faces: by the regular triangles of a complex, whose tetrahedra are looked up, or by
// sorting the faces of tetrahedra.
#include "core/triangulation/outer_faces.hpp"

#include <algorithm>
#include <atomic>
#include <stdexcept>

#include "core/complex/count_limits.hpp"
#include "core/complex/face_groups.hpp"
#include "core/run/parallel.hpp"
#include "core/triangulation/indices_where.hpp"

namespace alphascope {
namespace {

constexpr FaceCode kNone = ~FaceCode{0};  // no tetrahedron; there are fewer than 2^30

// The regular triangles of a complex by their first vertex, to find the tetrahedron of each.
class RegularTriangles {
 public:
  RegularTriangles(const SimplexList<3>& triangles, const CancelToken& cancel) : cancel_(cancel) {
    const auto places = indices_where(
        triangles.size(),
        [&](std::size_t i) { return triangles.classes[i] == SimplexClass::regular; }, cancel);
    const auto vertex = [&](std::size_t n) { return triangles.simplices[places[n]][0]; };
    rest_.resize(places.size());
    begun_by_.resize(places.empty() ? 0 : std::size_t{vertex(places.size() - 1)} + 1);
    parallel_many(begun_by_.size(), cancel, [&](std::size_t v) { begun_by_[v] = {}; });
    parallel_many(places.size(), cancel, [&](std::size_t n) {
      const BallIndex first = vertex(n);
      if (n > 0 && vertex(n - 1) == first) return;
      // The triangles are in order, so this loop covers all triangles of this vertex.
      Begun& begun = begun_by_[first];
      begun.from = static_cast<std::uint32_t>(n);
      for (; n < places.size() && vertex(n) == first; ++n) {
        const auto& t = triangles.simplices[places[n]];
        rest_[n] = key(t[1], t[2]);
        begun.marks |= mark(rest_[n]);
      }
      begun.to = static_cast<std::uint32_t>(n);
    });
  }

  // The tetrahedron of each triangle: there is exactly one, since the triangle is regular. Throws
  // std::invalid_argument where there is none.
  ResultArray<FaceCode> owners(const Simplices<4>& tetrahedra) const {
    ResultArray<FaceCode> owner(rest_.size());
    parallel_many(owner.size(), cancel_, [&](std::size_t n) { owner[n] = kNone; });
    parallel_many(tetrahedra.size(), cancel_, [&](std::size_t i) {
      const auto& t = tetrahedra[i];
      if (t[0] >= begun_by_.size()) return;
      const Begun& begun = begun_by_[t[0]];
      look_up(owner, begun, key(t[1], t[2]), face_code(i, 3));
      look_up(owner, begun, key(t[1], t[3]), face_code(i, 2));
      look_up(owner, begun, key(t[2], t[3]), face_code(i, 1));
      if (t[1] >= begun_by_.size()) return;
      look_up(owner, begun_by_[t[1]], key(t[2], t[3]), face_code(i, 0));
    });
    std::atomic<bool> all = true;
    parallel_many(owner.size(), cancel_, [&](std::size_t n) {
      if (owner[n] == kNone) all = false;
    });
    if (all) return owner;
    throw std::invalid_argument("the classes of the triangles are not those of this complex");
  }

 private:
  // The triangles whose first vertex is this one; they are few. Without initial values, which one
  // thread would write before all do.
  struct Begun {
    std::uint64_t marks;     // the union of their marks; most other triangles have another mark
    std::uint32_t from, to;  // in rest_
  };
  static std::uint64_t key(BallIndex second, BallIndex third) {
    return std::uint64_t{second} << 32 | third;
  }
  static std::uint64_t mark(std::uint64_t key) {
    return std::uint64_t{1} << (key * 0x9e3779b97f4a7c15 >> 58);
  }

  void look_up(ResultArray<FaceCode>& owner, const Begun& begun, std::uint64_t wanted,
               FaceCode code) const {
    if ((begun.marks & mark(wanted)) == 0) return;
    for (std::uint32_t n = begun.from; n < begun.to; ++n) {
      if (rest_[n] == wanted) {
        owner[n] = code;
        return;
      }
    }
  }

  const CancelToken& cancel_;
  ResultArray<std::uint64_t> rest_;  // keys: second and third vertex
  ResultArray<Begun> begun_by_;      // by vertex
};

}  // namespace

ResultArray<FaceCode> outer_faces(const AlphaComplex& complex, const CancelToken& cancel) {
  const auto& tetrahedra = complex.tetrahedra.simplices;
  if (complex.outside) return in_place(complex.outside->owner, complex.outside->faces);
  if (complex.tetrahedra_only) return outer_faces(tetrahedra, cancel);
  require_face_records(tetrahedra.size(), 4);
  return RegularTriangles(complex.triangles, cancel).owners(tetrahedra);
}

ResultArray<FaceCode> outer_faces(const Simplices<4>& tetrahedra, const CancelToken& cancel) {
  const FaceGroups<3> groups(tetrahedra, cancel);
  const auto places = indices_where(
      groups.size(), [&](std::size_t f) { return groups.coface_count(f) == 1; }, cancel);
  ResultArray<FaceCode> faces(places.size());
  parallel_many(places.size(), cancel, [&](std::size_t n) {
    groups.for_cofaces(places[n], [&](std::uint32_t t) {
      const BallIndex lacks = apex<3>(tetrahedra[t], groups.faces()[places[n]]);
      const auto at = std::find(tetrahedra[t].begin(), tetrahedra[t].end(), lacks);
      faces[n] = face_code(t, static_cast<std::size_t>(at - tetrahedra[t].begin()));
    });
  });
  return faces;
}

}  // namespace alphascope
