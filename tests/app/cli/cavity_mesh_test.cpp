// SPDX-License-Identifier: GPL-3.0-or-later
// Tests surfaces that alphascope-cli cavities writes, with VTK's readers.
#include <vtkCompositeDataIterator.h>
#include <vtkFeatureEdges.h>
#include <vtkGLTFReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "tests/app/cli/cli_fixture.hpp"

namespace alphascope::testing {
namespace {

const char* const kHaemoglobin = ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz";

struct Sizes {
  vtkIdType points = 0, triangles = 0;
  double low = 1e300, high = -1e300;  // along x
  void add(vtkPolyData& mesh) {
    points += mesh.GetNumberOfPoints();
    triangles += mesh.GetNumberOfPolys();
    double bounds[6];
    mesh.GetBounds(bounds);
    low = std::min(low, bounds[0]);
    high = std::max(high, bounds[1]);
  }
};

class CavityMesh : public Cli {
 protected:
  std::string write_mesh(const char* name) {
    const std::string path = (folder_ / name).string();
    const Outcome found = run("cavities -q " + std::string(kHaemoglobin) + " --surface '" + path +
                              "' --json '" + (folder_ / "c.json").string() + "'");
    EXPECT_EQ(found.code, 0) << found.err;
    return path;
  }
};

TEST_F(CavityMesh, IsTheSameAsPlyAndAsGlb) {
  vtkNew<vtkPLYReader> ply;
  ply->SetFileName(write_mesh("s.ply").c_str());
  ply->Update();
  Sizes of_ply, of_glb;
  of_ply.add(*ply->GetOutput());
  ASSERT_NE(ply->GetOutput()->GetPointData()->GetArray("RGB"), nullptr);

  const std::string path = write_mesh("s.glb");
  vtkNew<vtkGLTFReader> glb;
  glb->SetFileName(path.c_str());
  glb->Update();
  vtkSmartPointer<vtkCompositeDataIterator> it;
  it.TakeReference(glb->GetOutput()->NewIterator());
  std::size_t meshes = 0, closed = 0;
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem()) {
    auto* const mesh = vtkPolyData::SafeDownCast(it->GetCurrentDataObject());
    ASSERT_NE(mesh, nullptr);
    of_glb.add(*mesh);
    vtkNew<vtkFeatureEdges> edges;
    edges->SetInputData(mesh);
    edges->FeatureEdgesOff();
    edges->NonManifoldEdgesOff();
    edges->ManifoldEdgesOff();
    edges->BoundaryEdgesOn();
    edges->Update();
    ++meshes;
    closed += edges->GetOutput()->GetNumberOfCells() == 0;
  }
  const json listed = json::parse(contents(folder_ / "c.json"));
  EXPECT_EQ(meshes, listed["cavities"].size());
  EXPECT_EQ(closed, listed["counts"]["voids"]);
  EXPECT_GT(of_glb.triangles, 1000);
  EXPECT_EQ(of_glb.triangles, of_ply.triangles);
  EXPECT_EQ(of_glb.points, of_ply.points);
  EXPECT_EQ(of_glb.low, of_ply.low);
  EXPECT_EQ(of_glb.high, of_ply.high);
}

}  // namespace
}  // namespace alphascope::testing
