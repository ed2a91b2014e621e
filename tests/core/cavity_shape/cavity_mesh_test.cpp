// SPDX-License-Identifier: GPL-3.0-or-later
// Tests surfaces of cavities: oriented, closed around voids, open at mouths.
#include "core/cavity_shape/cavity_mesh.hpp"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <set>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/predicates/lifted.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/support/molecules.hpp"

namespace alphascope {
namespace {

// Counts how often each side is passed forward, less how often backward.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> open_sides(const CavityMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  std::erase_if(balance, [](const auto& side) { return side.second == 0; });
  return balance;
}

double enclosed_volume(const CavityMesh& mesh) {
  double six = 0;
  for (const auto& t : mesh.triangles) {
    six += dot(mesh.points[t[0]], cross(mesh.points[t[1]], mesh.points[t[2]]));
  }
  return six / 6;
}

TEST(CavityMesh, IsClosedAroundVoidsAndEndsAtTheRimsOfMouths) {
  const auto balls = testing::sample_balls("4hhb.pdb.gz", 1.4);
  const auto ground = std::make_shared<const CavityGround>(make_cavity_ground(
      balls, std::make_shared<const Triangulation>(make_triangulation(*balls, 1))));
  const CavityTable table = make_cavity_table(ground, {0, 1.4});
  ASSERT_GT(table.voids, 20u);
  ASSERT_GT(table.pockets, 20u);
  for (std::size_t row = 0; row < table.size(); ++row) {
    const CavityMesh mesh = cavity_mesh(*ground, table.found, table.order[row]);
    std::set<std::uint32_t> used;
    for (const auto& t : mesh.triangles) used.insert(t.begin(), t.end());
    EXPECT_EQ(used.size(), mesh.points.size());
    if (table.cavity(row).is_void()) {
      EXPECT_TRUE(open_sides(mesh).empty()) << "row " << row;
      // Normals point outwards, so the volume is positive.
      const double volume = table.measure(row).volume_of_tetrahedra_angstrom3;
      EXPECT_NEAR(enclosed_volume(mesh), volume, 1e-9 * volume + 1e-9);
    } else {
      EXPECT_FALSE(open_sides(mesh).empty()) << "row " << row;
    }
  }
}

}  // namespace
}  // namespace alphascope
