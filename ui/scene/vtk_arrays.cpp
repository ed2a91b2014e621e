// See the header. 32-bit cell arrays halve what is uploaded; a soup of 2^31 points does not fit
// any memory this meets.
#include "ui/scene/vtk_arrays.hpp"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace alphascope {
namespace {

// Cells of `corners` consecutive points each.
vtkSmartPointer<vtkCellArray> consecutive_cells(vtkIdType points, int corners) {
  const vtkIdType cells = points / corners;
  vtkNew<vtkTypeInt32Array> offsets, connectivity;
  offsets->SetNumberOfValues(cells + 1);
  connectivity->SetNumberOfValues(points);
  vtkTypeInt32* starts = offsets->GetPointer(0);
  for (vtkIdType i = 0; i <= cells; ++i) starts[i] = static_cast<vtkTypeInt32>(i * corners);
  std::iota(connectivity->GetPointer(0), connectivity->GetPointer(0) + points, 0);
  auto result = vtkSmartPointer<vtkCellArray>::New();
  result->SetData(offsets, connectivity);
  return result;
}

}  // namespace

vtkSmartPointer<vtkPolyData> balls_to_vtk(const BallGeometry& balls) {
  const auto count = static_cast<vtkIdType>(balls.centres.size());
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i) coordinates->SetTypedTuple(i, balls.centres[i].data());
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(consecutive_cells(count, 1));
  return data;
}

void set_colours(vtkPolyData* data, const std::vector<Rgb8>& colours) {
  vtkNew<vtkUnsignedCharArray> array;
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(colours.size()));
  unsigned char* target = array->GetPointer(0);
  for (const Rgb8& c : colours) {
    *target++ = c.r;
    *target++ = c.g;
    *target++ = c.b;
  }
  data->GetPointData()->SetScalars(array);
  data->Modified();
}

void set_radii(vtkPolyData* data, const std::vector<float>& radii) {
  vtkNew<vtkFloatArray> array;
  array->SetName(kRadiusArray);
  array->SetNumberOfValues(static_cast<vtkIdType>(radii.size()));
  std::copy(radii.begin(), radii.end(), array->GetPointer(0));
  data->GetPointData()->AddArray(array);
  data->Modified();
}

vtkSmartPointer<vtkPolyData> soup_to_vtk(const CellSoup& soup, int corners) {
  if (soup.points() == 0) return nullptr;
  // VTK's setter takes a mutable pointer, but a mapper only reads; 1 = the memory is not VTK's.
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetArray(const_cast<float*>(soup.xyz.data()),
                        static_cast<vtkIdType>(soup.xyz.size()), 1);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  colours->SetArray(const_cast<unsigned char*>(soup.rgb.data()),
                    static_cast<vtkIdType>(soup.rgb.size()), 1);
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  const auto cells = consecutive_cells(static_cast<vtkIdType>(soup.points()), corners);
  if (corners == 2) {
    data->SetLines(cells);
  } else {
    data->SetPolys(cells);
  }
  data->GetPointData()->SetScalars(colours);
  data->ComputeCellsBounds();  // kept by VTK; else the thread that draws does it
  return data;
}

std::shared_ptr<BallData> make_ball_data(std::shared_ptr<const BallGeometry> balls,
                                         const std::vector<Rgb8>& colours,
                                         const std::vector<float>& radii) {
  if (!balls || balls->centres.size() != colours.size() || balls->centres.size() != radii.size()) {
    throw std::invalid_argument("every ball needs one colour and one radius");
  }
  auto data = std::make_shared<BallData>();
  data->points = balls_to_vtk(*balls);
  set_colours(data->points, colours);
  set_radii(data->points, radii);
  data->points->ComputeCellsBounds();
  data->balls = std::move(balls);
  return data;
}

std::shared_ptr<MeshData> make_mesh_data(std::shared_ptr<const ComplexMesh> mesh) {
  if (!mesh) return nullptr;
  auto data = std::make_shared<MeshData>();
  data->tetrahedra = soup_to_vtk(mesh->tetrahedra, 3);
  data->boundary = soup_to_vtk(mesh->boundary, 3);
  data->triangles = soup_to_vtk(mesh->triangles, 3);
  data->edges = soup_to_vtk(mesh->edges, 2);
  data->mesh = std::move(mesh);
  return data;
}

std::shared_ptr<DifferenceData> make_difference_data(std::shared_ptr<const DifferenceMesh> mesh) {
  if (!mesh) return nullptr;
  auto data = std::make_shared<DifferenceData>();
  data->faces = soup_to_vtk(mesh->faces, 3);
  data->edges = soup_to_vtk(mesh->edges, 2);
  data->bodies = soup_to_vtk(mesh->bodies, 3);
  data->mesh = std::move(mesh);
  return data;
}

}  // namespace alphascope
