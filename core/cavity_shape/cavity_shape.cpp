// SPDX-License-Identifier: GPL-3.0-or-later
// Lists the faces, rims and a place of a cavity for drawing.
#include "core/cavity_shape/cavity_shape.hpp"

#include <algorithm>
#include <vector>

#include "core/cavity/cavity_ground.hpp"
#include "core/complex/triangulation.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice.hpp"
#include "core/triangulation/incidence.hpp"

namespace alphascope {

std::vector<OuterFace> outer_faces(const CavityGround& ground, const Cavities& found,
                                   std::uint32_t index) {
  std::vector<OuterFace> outer;
  for (const std::uint32_t t : found.cavities[index].tetrahedra) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      const Neighbour across = ground.triangulation->neighbours[t][k];
      if (across.is_hull() || found.cavity_of_tetrahedron[across.index()] != index) {
        outer.push_back({t, k});
      }
    }
  }
  return outer;
}

Simplices<3> cavity_surface(const CavityGround& ground, const Cavities& found,
                            std::uint32_t index) {
  const Incidence& incidence = ground.incidence;
  Simplices<3> surface;
  for (const auto& [t, k] : outer_faces(ground, found, index)) {
    surface.push_back(incidence.triangles[incidence.triangles_of_tetrahedron[t][k]]);
  }
  return surface;
}

Simplices<2> mouth_rims(const CavityGround& ground, const Cavity& cavity) {
  const Incidence& incidence = ground.incidence;
  Simplices<2> rims;
  for (const Mouth& mouth : cavity.mouths) {
    std::vector<std::uint32_t> edges;
    for (const std::uint32_t f : mouth.triangles) {
      edges.insert(edges.end(), incidence.edges_of_triangle[f].begin(),
                   incidence.edges_of_triangle[f].end());
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const bool again =
          (k > 0 && edges[k] == edges[k - 1]) || (k + 1 < edges.size() && edges[k] == edges[k + 1]);
      if (!again) rims.push_back(incidence.edges[edges[k]]);
    }
  }
  return rims;
}

RealPoint deepest_place_angstrom(const CavityGround& ground, const Cavity& cavity) {
  const Lattice& lattice = ground.balls->lattice;
  RealPoint sum;
  for (const BallIndex ball : ground.triangulation->tetrahedra[cavity.deepest_sink]) {
    sum = sum + real_point(ground.balls->centres[ball]);
  }
  return lattice.unit_angstrom() / 4 * sum;
}

}  // namespace alphascope
