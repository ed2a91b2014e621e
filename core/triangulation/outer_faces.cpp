// See the header.
#include "core/triangulation/outer_faces.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/complex/count_limits.hpp"
#include "core/complex/face_groups.hpp"
#include "core/triangulation/chosen_places.hpp"
#include "core/triangulation/parallel_ranges.hpp"

namespace alphascope {
namespace {

constexpr FaceCode kNone = ~FaceCode{0};  // of no tetrahedron: there are fewer than 2^30

// The regular triangles of a complex by their first vertex, to find the tetrahedron of each.
class RegularTriangles {
 public:
  RegularTriangles(const SimplexList<3>& triangles, const CancelToken& cancel) : cancel_(cancel) {
    const auto places = chosen_places(
        triangles.size(),
        [&](std::size_t i) { return triangles.classes[i] == SimplexClass::regular; }, cancel);
    const auto vertex = [&](std::size_t n) { return triangles.simplices[places[n]][0]; };
    const std::size_t end = places.empty() ? 0 : std::size_t{vertex(places.size() - 1)} + 1;
    rest_.resize(places.size());
    first_.resize(end + 1);
    first_.back() = static_cast<std::uint32_t>(places.size());
    parallel_ranges(places.size(), cancel, [&](std::size_t n) {
      const auto& t = triangles.simplices[places[n]];
      rest_[n] = std::uint64_t{t[1]} << 32 | t[2];
      // They are in order: the first of a vertex also begins those without any before it.
      const std::size_t from = n == 0 ? 0 : std::size_t{vertex(n - 1)} + 1;
      for (std::size_t v = from; v <= t[0]; ++v) first_[v] = static_cast<std::uint32_t>(n);
    });
  }

  // One tetrahedron each, since they are regular.
  ResultArray<FaceCode> owners(const Simplices<4>& tetrahedra) const {
    ResultArray<FaceCode> owner(rest_.size());
    parallel_ranges(owner.size(), cancel_, [&](std::size_t n) { owner[n] = kNone; });
    parallel_ranges(tetrahedra.size(), cancel_, [&](std::size_t t) {
      for (std::size_t k = 0; k < 4; ++k) {
        const FaceCode code = face_code(t, k);
        look_up(owner, face_vertices(tetrahedra, code), code);
      }
    });
    return owner;
  }

 private:
  // A vertex is the first one of a few regular triangles only.
  void look_up(ResultArray<FaceCode>& owner, const std::array<BallIndex, 3>& face,
               FaceCode code) const {
    if (std::size_t{face[0]} + 1 >= first_.size()) return;
    const std::uint64_t wanted = std::uint64_t{face[1]} << 32 | face[2];
    for (std::uint32_t n = first_[face[0]]; n < first_[face[0] + 1]; ++n) {
      if (rest_[n] < wanted) continue;
      if (rest_[n] == wanted) owner[n] = code;
      return;
    }
  }

  const CancelToken& cancel_;
  ResultArray<std::uint64_t> rest_;   // second and third vertex
  ResultArray<std::uint32_t> first_;  // of each vertex, in rest_
};

}  // namespace

ResultArray<FaceCode> outer_faces(const AlphaComplex& complex, const CancelToken& cancel) {
  const auto& tetrahedra = complex.tetrahedra.simplices;
  if (complex.tetrahedra_only) return outer_faces(tetrahedra, cancel);
  require_face_records(tetrahedra.size(), 4);
  ResultArray<FaceCode> faces = RegularTriangles(complex.triangles, cancel).owners(tetrahedra);
  if (std::find(faces.begin(), faces.end(), kNone) == faces.end()) return faces;
  throw std::invalid_argument("the classes of the triangles are not those of this complex");
}

ResultArray<FaceCode> outer_faces(const Simplices<4>& tetrahedra, const CancelToken& cancel) {
  const FaceGroups<3> groups(tetrahedra, cancel);
  const auto places = chosen_places(
      groups.size(), [&](std::size_t f) { return groups.coface_count(f) == 1; }, cancel);
  ResultArray<FaceCode> faces(places.size());
  parallel_ranges(places.size(), cancel, [&](std::size_t n) {
    groups.for_cofaces(places[n], [&](std::uint32_t t) {
      const BallIndex lacks = apex<3>(tetrahedra[t], groups.faces()[places[n]]);
      const auto at = std::find(tetrahedra[t].begin(), tetrahedra[t].end(), lacks);
      faces[n] = face_code(t, static_cast<std::size_t>(at - tetrahedra[t].begin()));
    });
  });
  return faces;
}

}  // namespace alphascope
