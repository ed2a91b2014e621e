// SPDX-License-Identifier: GPL-3.0-or-later
// Copies the visible simplices into a complex of their own, so functions that build meshes need not
// know of hidden balls. The copy takes time only while something is hidden.
#include "ui/scene/mesh/visible_mesh.hpp"

#include <algorithm>

#include "core/triangulation/outer_faces.hpp"

namespace alphascope {
namespace {

using Places = std::vector<std::uint32_t>;  // index in the whole list for each simplex of the part

template <int N>
Places keep_visible(const SimplexList<N>& all, const std::vector<bool>& hidden,
                    SimplexList<N>& part) {
  Places places;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& simplex = all.simplices[i];
    const bool hides = std::any_of(simplex.begin(), simplex.end(),
                                   [&](BallIndex ball) { return hidden.at(ball); });
    if (hides) continue;
    places.push_back(static_cast<std::uint32_t>(i));
    part.simplices.push_back(simplex);
    if (i < all.alpha_values.size()) part.alpha_values.push_back(all.alpha_values[i]);
    if (i < all.classes.size()) part.classes.push_back(all.classes[i]);
  }
  return places;
}

// Replaces indices in the part's lists by those in the whole complex. Empty: cell i is i.
template <class Numbers>
void name_in_whole(Numbers& numbers, std::size_t cells, const Places& places) {
  if (numbers.empty()) {
    numbers.assign(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(cells));
  } else {
    for (std::uint32_t& place : numbers) place = places[place];
  }
}

template <class Codes>
void name_faces_in_whole(Codes& codes, const Places& tetrahedra) {
  for (FaceCode& code : codes) code = face_code(tetrahedra[tetrahedron_of(code)], code % 4);
}

// A complex with the lattice and alpha of `complex`, and empty lists.
AlphaComplex part_of(const AlphaComplex& complex) {
  AlphaComplex part;
  part.lattice = complex.lattice;
  part.alpha_on_lattice = complex.alpha_on_lattice;
  part.tetrahedra_only = true;  // classes describe the outside of the whole complex, not of the
                                // part
  return part;
}

}  // namespace

ComplexMesh build_visible_mesh(const AlphaComplex& complex, const std::vector<bool>& hidden,
                               const MeshBuild& build) {
  if (hidden.empty()) return build(complex);
  AlphaComplex part = part_of(complex);
  keep_visible(complex.vertices, hidden, part.vertices);
  const Places edges = keep_visible(complex.edges, hidden, part.edges);
  const Places triangles = keep_visible(complex.triangles, hidden, part.triangles);
  const Places tetrahedra = keep_visible(complex.tetrahedra, hidden, part.tetrahedra);
  ComplexMesh mesh = build(part);
  name_in_whole(mesh.edges.source, mesh.edges.size(), edges);
  name_in_whole(mesh.triangles.source, mesh.triangles.size(), triangles);
  name_in_whole(mesh.tetrahedra.source, mesh.tetrahedra.size(), tetrahedra);
  name_faces_in_whole(mesh.outside.source, tetrahedra);
  name_faces_in_whole(mesh.boundary.source, tetrahedra);
  return mesh;
}

CapMesh build_visible_caps(const AlphaComplex& complex, const std::vector<bool>& hidden,
                           const CapBuild& build) {
  if (hidden.empty()) return build(complex);
  AlphaComplex part = part_of(complex);
  const Places tetrahedra = keep_visible(complex.tetrahedra, hidden, part.tetrahedra);
  CapMesh caps = build(part);
  name_faces_in_whole(caps.faces.source, tetrahedra);
  return caps;
}

}  // namespace alphascope
