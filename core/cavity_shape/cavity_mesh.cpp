// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the mesh of a cavity from its outer faces without mouths and passages.
#include "core/cavity_shape/cavity_mesh.hpp"

#include <algorithm>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity_shape/cavity_shape.hpp"
#include "core/complex/outward_face.hpp"
#include "core/complex/triangulation.hpp"

namespace alphascope {
namespace {

std::vector<std::uint32_t> open_triangles(const Cavity& cavity) {
  std::vector<std::uint32_t> all;
  for (const auto* openings : {&cavity.mouths, &cavity.passages}) {
    for (const Mouth& opening : *openings) {
      all.insert(all.end(), opening.triangles.begin(), opening.triangles.end());
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

CavityMesh cavity_mesh(const CavityGround& ground, const Cavities& found, std::uint32_t index) {
  const std::vector<std::uint32_t> open = open_triangles(found.cavities[index]);
  CavityMesh mesh;
  std::vector<BallIndex> used;
  for (const auto& [t, k] : outer_faces(ground, found, index)) {
    const std::uint32_t triangle = ground.incidence.triangles_of_tetrahedron[t][k];
    if (std::binary_search(open.begin(), open.end(), triangle)) continue;
    mesh.triangles.push_back(outward_face(*ground.balls, ground.triangulation->tetrahedra[t], k));
    used.insert(used.end(), mesh.triangles.back().begin(), mesh.triangles.back().end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (const BallIndex i : used) {
    mesh.points.push_back(ground.balls->lattice.unit_angstrom() *
                          real_point(ground.balls->centres[i]));
  }
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& v : triangle) {
      v = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
    }
  }
  return mesh;
}

}  // namespace alphascope
