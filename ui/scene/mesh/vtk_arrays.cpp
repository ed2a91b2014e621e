// SPDX-License-Identifier: GPL-3.0-or-later
// Makes VTK's arrays. Cells use 32-bit indices, which halves the upload. 2^31 points would not fit
// into memory anyway.
#include "ui/scene/mesh/vtk_arrays.hpp"

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

#include "core/document/store/answer.hpp"
#include "core/molecule/rgb8.hpp"

namespace alphascope {
namespace {

// VTK's setter takes a mutable pointer, but the mapper only reads. The argument 1 tells VTK not to
// free the memory.
template <class Array, class Value>
vtkSmartPointer<Array> in_place(const std::vector<Value>& values, int components) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(components);
  array->SetArray(const_cast<Value*>(values.data()), static_cast<vtkIdType>(values.size()), 1);
  return array;
}

vtkSmartPointer<vtkPolyData> points_in_place(const std::vector<float>& xyz,
                                             const std::vector<std::uint8_t>& rgb) {
  vtkNew<vtkPoints> points;
  points->SetData(in_place<vtkFloatArray>(xyz, 3));
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->SetScalars(in_place<vtkUnsignedCharArray>(rgb, 3));
  return data;
}

vtkSmartPointer<vtkTypeInt32Array> starts_of_cells(vtkIdType cells, int corners) {
  auto offsets = vtkSmartPointer<vtkTypeInt32Array>::New();
  offsets->SetNumberOfValues(cells + 1);
  vtkTypeInt32* starts = offsets->GetPointer(0);
  for (vtkIdType i = 0; i <= cells; ++i) starts[i] = static_cast<vtkTypeInt32>(i * corners);
  return offsets;
}

// Cells that each have `corners` consecutive points.
vtkSmartPointer<vtkCellArray> consecutive_cells(vtkIdType points, int corners) {
  const vtkIdType cells = points / corners;
  vtkNew<vtkTypeInt32Array> connectivity;
  connectivity->SetNumberOfValues(points);
  std::iota(connectivity->GetPointer(0), connectivity->GetPointer(0) + points, 0);
  auto result = vtkSmartPointer<vtkCellArray>::New();
  result->SetData(starts_of_cells(cells, corners), connectivity);
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

std::span<const float> radii_of(const BallData& balls) {
  auto* array = vtkFloatArray::SafeDownCast(balls.points->GetPointData()->GetArray(kRadiusArray));
  return {array->GetPointer(0), static_cast<std::size_t>(array->GetNumberOfValues())};
}

vtkSmartPointer<vtkPolyData> soup_to_vtk(const CellSoup& soup, int corners) {
  if (soup.points() == 0) return nullptr;
  auto data = points_in_place(soup.xyz, soup.rgb);
  const auto cells = consecutive_cells(static_cast<vtkIdType>(soup.points()), corners);
  if (corners == 1) {
    data->SetVerts(cells);
  } else if (corners == 2) {
    data->SetLines(cells);
  } else {
    data->SetPolys(cells);
  }
  data->ComputeCellsBounds();  // VTK keeps the bounds; otherwise the drawing thread would compute
                               // them
  return data;
}

vtkSmartPointer<vtkPolyData> smooth_to_vtk(const SmoothMesh& mesh) {
  if (mesh.points() == 0) return nullptr;
  auto data = points_in_place(mesh.xyz, mesh.rgb);
  data->GetPointData()->SetNormals(in_place<vtkFloatArray>(mesh.normals, 3));
  vtkNew<vtkCellArray> cells;
  cells->SetData(starts_of_cells(static_cast<vtkIdType>(mesh.corners.size() / 3), 3),
                 in_place<vtkTypeInt32Array>(mesh.corners, 1));
  data->SetPolys(cells);
  data->ComputeCellsBounds();
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
  data->mesh = std::move(mesh);
  return data;
}

std::shared_ptr<CapData> make_cap_data(std::shared_ptr<const CapMesh> mesh) {
  if (!mesh) return nullptr;
  auto data = std::make_shared<CapData>();
  data->faces = soup_to_vtk(mesh->faces, 3);
  data->edges = soup_to_vtk(mesh->edges, 2);
  data->mesh = std::move(mesh);
  return data;
}

std::shared_ptr<DifferenceData> make_difference_data(std::shared_ptr<const DifferenceMesh> mesh) {
  if (!mesh) return nullptr;
  auto data = std::make_shared<DifferenceData>();
  data->faces = soup_to_vtk(mesh->faces, 3);
  data->edges = soup_to_vtk(mesh->edges, 2);
  data->mesh = std::move(mesh);
  return data;
}

namespace {

BodyData body_data(const LayerBodies& bodies) {
  BodyData data{soup_to_vtk(bodies.faces, 3), soup_to_vtk(bodies.edges, 2), nullptr};
  if (bodies.spheres) {
    data.spheres = make_ball_data(bodies.spheres, bodies.sphere_colours, bodies.spheres->radii);
  }
  return data;
}

}  // namespace

std::shared_ptr<LayerData> make_layer_data(std::shared_ptr<const LayerMesh> mesh) {
  if (!mesh) return nullptr;
  auto data = std::make_shared<LayerData>();
  data->faces = soup_to_vtk(mesh->marks.faces, 3);
  data->edges = soup_to_vtk(mesh->marks.edges, 2);
  data->body_lines = soup_to_vtk(mesh->body_lines, 2);
  data->tubes = smooth_to_vtk(mesh->tubes);
  data->opaque = body_data(mesh->opaque);
  data->translucent = body_data(mesh->translucent);
  if (mesh->atoms) {
    data->atoms = make_ball_data(mesh->atoms, mesh->atom_colours, mesh->atoms->radii);
  }
  data->mesh = std::move(mesh);
  return data;
}

std::shared_ptr<ObjectData> make_object_data(std::shared_ptr<const ObjectMesh> mesh) {
  if (!mesh) return nullptr;
  auto data = std::make_shared<ObjectData>();
  data->surface = smooth_to_vtk(mesh->cartoon.surface);
  data->dots = soup_to_vtk(mesh->dots, 1);
  if (mesh->spheres) {
    data->spheres = make_ball_data(mesh->spheres, mesh->sphere_colours, mesh->spheres->radii);
  }
  data->mesh = std::move(mesh);
  return data;
}

}  // namespace alphascope
