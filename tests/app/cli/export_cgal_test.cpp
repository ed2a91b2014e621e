// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that CGAL reads boundaries of alphascope-cli export as solids.
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include "tests/app/cli/cli_fixture.hpp"
#include "tests/app/cli/exported_complex.hpp"

namespace alphascope::testing {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

class ExportCgal : public Cli, public ::testing::WithParamInterface<const char*> {};

// CGAL refuses a mesh that is not an orientable manifold.
TEST_P(ExportCgal, ReadsTheBoundaryAsAClosedSolid) {
  const std::string molecule = ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz";
  const std::string name = (folder_ / "s.").string() + GetParam(),
                    text = (folder_ / "c.alpha").string();
  for (const char* alpha : {"1.4", "3"}) {
    for (const std::string command : {"export", "compute"}) {
      const Outcome made = run(command + " -q " + molecule + " --alpha " + alpha +
                               (command == "export" ? " -o '" + name : " --out '" + text) + "'");
      ASSERT_EQ(made.code, 0) << made.err;
    }
    const TextComplex whole(contents(text));
    SurfaceMesh mesh;
    if (std::string(GetParam()) == "off") {
      ASSERT_TRUE(CGAL::IO::read_OFF(name, mesh));
    } else {
      std::ifstream file(name, std::ios::binary);
      ASSERT_TRUE(CGAL::IO::read_PLY(file, mesh));
    }
    EXPECT_GE(mesh.number_of_faces(), whole.regular_triangles());
    EXPECT_TRUE(CGAL::is_closed(mesh));
    EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
    EXPECT_NEAR(pmp::volume(mesh), whole.volume(), 1e-5 * whole.volume());
  }
}
INSTANTIATE_TEST_SUITE_P(Formats, ExportCgal, ::testing::Values("off", "ply"));

}  // namespace
}  // namespace alphascope::testing
