// SPDX-License-Identifier: GPL-3.0-or-later
// Tests files of alphascope-cli export with VTK's readers, against the complex.
#include <vtkAbstractArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkDataArray.h>
#include <vtkFeatureEdges.h>
#include <vtkFieldData.h>
#include <vtkGLTFReader.h>
#include <vtkIdList.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <set>

#include "tests/app/cli/cli_fixture.hpp"
#include "tests/app/cli/exported_complex.hpp"

namespace alphascope::testing {
namespace {

const char* const kCrambin = ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb";

class ExportVtk : public Cli {
 protected:
  std::string exported(const char* name, const char* alpha) {
    const std::string path = (folder_ / name).string();
    const Outcome made =
        run("export -q " + std::string(kCrambin) + " --alpha " + alpha + " -o '" + path + "'");
    EXPECT_EQ(made.code, 0) << made.err;
    return path;
  }
  TextComplex complex(const char* alpha) {
    const Outcome made = run("compute -q " + std::string(kCrambin) + " --alpha " + alpha +
                             " --out '" + (folder_ / "c.alpha").string() + "'");
    EXPECT_EQ(made.code, 0) << made.err;
    return TextComplex(contents(folder_ / "c.alpha"));
  }
  template <class Reader>
  vtkSmartPointer<vtkPolyData> read(const char* name, const char* alpha) {
    vtkNew<Reader> reader;
    reader->SetFileName(exported(name, alpha).c_str());
    reader->Update();
    return reader->GetOutput();
  }
};

// Positive when triangles are counterclockwise seen from outside.
double volume(vtkPolyData& mesh) {
  double six = 0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType n = 0; n < mesh.GetNumberOfCells(); ++n) {
    mesh.GetCellPoints(n, corners);
    EXPECT_EQ(corners->GetNumberOfIds(), 3);
    double p[3][3];
    for (int k = 0; k < 3; ++k) mesh.GetPoint(corners->GetId(k), p[k]);
    six += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) -
           p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
           p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
  }
  return six / 6;
}

// Counts sides of only one triangle, or also those of more than two.
vtkIdType bad_sides(vtkPolyData& mesh, bool also_of_many) {
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(&mesh);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->SetNonManifoldEdges(also_of_many);
  edges->BoundaryEdgesOn();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}

TEST_F(ExportVtk, PlyIsTheClosedBoundary) {
  const TextComplex whole = complex("3");
  const auto mesh = read<vtkPLYReader>("s.ply", "3");
  EXPECT_EQ(mesh->GetNumberOfPolys(), static_cast<vtkIdType>(whole.regular_triangles()));
  EXPECT_EQ(bad_sides(*mesh, true), 0);
  EXPECT_NEAR(volume(*mesh), whole.volume(), 1e-5 * whole.volume());
  ASSERT_NE(mesh->GetPointData()->GetArray("RGB"), nullptr);
}

TEST_F(ExportVtk, ObjIsTheClosedBoundary) {
  const TextComplex whole = complex("3");
  const auto mesh = read<vtkOBJReader>("s.obj", "3");
  EXPECT_EQ(mesh->GetNumberOfPolys(), static_cast<vtkIdType>(whole.regular_triangles()));
  EXPECT_EQ(bad_sides(*mesh, true), 0);
  EXPECT_NEAR(volume(*mesh), whole.volume(), 1e-5 * whole.volume());
}

// VTK merges vertices at the same position. So a side at which solids touch has more than two
// triangles.
TEST_F(ExportVtk, StlHasASolidForEachComponent) {
  const TextComplex whole = complex("3");
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(exported("s.stl", "3").c_str());
  reader->ScalarTagsOn();
  reader->Update();
  vtkPolyData& mesh = *reader->GetOutput();
  EXPECT_EQ(mesh.GetNumberOfPolys(), static_cast<vtkIdType>(whole.regular_triangles()));
  EXPECT_EQ(bad_sides(mesh, false), 0);
  EXPECT_NEAR(volume(mesh), whole.volume(), 1e-5 * whole.volume());
  std::set<double> solids;
  vtkDataArray* const tags = mesh.GetCellData()->GetScalars();
  ASSERT_NE(tags, nullptr);
  for (vtkIdType n = 0; n < tags->GetNumberOfTuples(); ++n) solids.insert(tags->GetTuple1(n));
  EXPECT_EQ(solids.size(), 3u);
}

// At this alpha some solids touch themselves along edges.
TEST_F(ExportVtk, GlbHasAClosedMeshForEachSolid) {
  const TextComplex whole = complex("1.4");
  vtkNew<vtkGLTFReader> reader;
  const std::string path = exported("s.glb", "1.4");
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkSmartPointer<vtkCompositeDataIterator> it;
  it.TakeReference(reader->GetOutput()->NewIterator());
  double sum = 0;
  int meshes = 0;
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem()) {
    auto* const mesh = vtkPolyData::SafeDownCast(it->GetCurrentDataObject());
    ASSERT_NE(mesh, nullptr);
    EXPECT_EQ(bad_sides(*mesh, true), 0);
    EXPECT_GT(volume(*mesh), 0);
    sum += volume(*mesh);
    ++meshes;
  }
  EXPECT_EQ(meshes, 41);
  EXPECT_NEAR(sum, whole.volume(), 1e-5 * whole.volume());
}

// --- VTU, VTP

std::string text_of(vtkFieldData& fields, const char* name) {
  auto* const array = vtkStringArray::SafeDownCast(fields.GetAbstractArray(name));
  EXPECT_NE(array, nullptr) << name;
  return array == nullptr ? "" : std::string(array->GetValue(0));
}

void expect_points(vtkPointSet& set, const TextComplex& whole) {
  ASSERT_EQ(set.GetNumberOfPoints(), static_cast<vtkIdType>(whole.balls.size()));
  vtkDataArray* const radii = set.GetPointData()->GetArray("radius_angstrom");
  ASSERT_NE(radii, nullptr);
  for (std::size_t n = 0; n < whole.balls.size(); ++n) {
    const auto id = static_cast<vtkIdType>(n);
    double p[3];
    set.GetPoint(id, p);
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(p[axis], whole.balls[n][axis]);
    EXPECT_EQ(radii->GetTuple1(id), whole.balls[n][3]);
    EXPECT_EQ(set.GetPointData()->GetArray("ball")->GetTuple1(id), static_cast<double>(n));
  }
  EXPECT_EQ(set.GetPointData()->GetArray("element")->GetTuple1(0), 7);
  EXPECT_EQ(set.GetPointData()->GetArray("serial")->GetTuple1(326), 327);
  EXPECT_EQ(text_of(*set.GetPointData(), "atom_name"), "N");
  EXPECT_EQ(text_of(*set.GetPointData(), "residue_name"), "THR");
  EXPECT_EQ(text_of(*set.GetPointData(), "chain"), "A");
  EXPECT_EQ(text_of(*set.GetFieldData(), "sha256").size(), 64u);
  EXPECT_EQ(text_of(*set.GetFieldData(), "alpha_angstrom2"), "1.4");
}

void expect_cells(vtkDataSet& set, const TextComplex& whole, std::size_t dimensions) {
  vtkCellData& data = *set.GetCellData();
  vtkDataArray *const dimension = data.GetArray("dimension"),
                      *const alpha = data.GetArray("alpha_angstrom2"),
                      *const letter = data.GetArray("class");
  ASSERT_TRUE(dimension != nullptr && alpha != nullptr && letter != nullptr);
  vtkIdType cell = 0;
  vtkNew<vtkIdList> corners;
  for (std::size_t d = 0; d < dimensions; ++d) {
    for (const TextSimplex& s : whole.simplices[d]) {
      ASSERT_LT(cell, set.GetNumberOfCells());
      set.GetCellPoints(cell, corners);
      ASSERT_EQ(corners->GetNumberOfIds(), static_cast<vtkIdType>(d + 1));
      for (std::size_t k = 0; k <= d; ++k) {
        ASSERT_EQ(corners->GetId(static_cast<vtkIdType>(k)), s.balls[k]);
      }
      ASSERT_EQ(dimension->GetTuple1(cell), static_cast<double>(d));
      ASSERT_NEAR(alpha->GetTuple1(cell), s.alpha, 1e-8 * std::fabs(s.alpha));
      ASSERT_EQ("sri"[static_cast<int>(letter->GetTuple1(cell))], s.letter);
      ++cell;
    }
  }
  EXPECT_EQ(cell, set.GetNumberOfCells());
}

TEST_F(ExportVtk, VtuHasEverySimplex) {
  const TextComplex whole = complex("1.4");
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(exported("c.vtu", "1.4").c_str());
  reader->Update();
  vtkUnstructuredGrid& grid = *reader->GetOutput();
  expect_points(grid, whole);
  expect_cells(grid, whole, 4);
  EXPECT_EQ(grid.GetCellType(grid.GetNumberOfCells() - 1), VTK_TETRA);
}

TEST_F(ExportVtk, VtpHasVerticesEdgesAndTriangles) {
  const TextComplex whole = complex("1.4");
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(exported("c.vtp", "1.4").c_str());
  reader->Update();
  vtkPolyData& data = *reader->GetOutput();
  expect_points(data, whole);
  expect_cells(data, whole, 3);
  EXPECT_EQ(data.GetNumberOfLines(), static_cast<vtkIdType>(whole.simplices[1].size()));
}

}  // namespace
}  // namespace alphascope::testing
