// SPDX-License-Identifier: GPL-3.0-or-later
// Plain arrays as VTK data. They are not copied if VTK can use the memory in place.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <span>

#include "ui/scene/mesh/ball_geometry.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"
#include "ui/scene/mesh/difference_mesh.hpp"
#include "ui/scene/mesh/layer_mesh.hpp"
#include "ui/scene/objects/object_mesh.hpp"
#include "ui/scene/scene_data.hpp"

namespace alphascope {

struct BallData {
  std::shared_ptr<const BallGeometry> balls;
  vtkSmartPointer<vtkPolyData> points;
};

// Shaders read the arrays of the mesh in place.
struct MeshData {
  std::shared_ptr<const ComplexMesh> mesh;
};

struct CapData {
  std::shared_ptr<const CapMesh> mesh;
  vtkSmartPointer<vtkPolyData> faces, edges;
};

struct DifferenceData {
  std::shared_ptr<const DifferenceMesh> mesh;
  vtkSmartPointer<vtkPolyData> faces, edges;
};

struct BodyData {
  vtkSmartPointer<vtkPolyData> faces, edges;
  std::shared_ptr<BallData> spheres;  // null: none
};

struct LayerData {
  std::shared_ptr<const LayerMesh> mesh;
  vtkSmartPointer<vtkPolyData> faces, edges, body_lines, tubes;
  BodyData opaque, translucent;
  std::shared_ptr<BallData> atoms;  // null: none
};

struct ObjectData {
  std::shared_ptr<const ObjectMesh> mesh;  // shaders read its sticks in place
  vtkSmartPointer<vtkPolyData> surface, dots;
  std::shared_ptr<BallData> spheres;  // null: none
};

// Each ball is a vertex cell: vtkOpenGLSphereMapper gets its bounds from cells and draws nothing
// without them. Point arrays: colours (scalars) and "radius".
vtkSmartPointer<vtkPolyData> balls_to_vtk(const BallGeometry& balls);
void set_colours(vtkPolyData* data, const std::vector<Rgb8>& colours);
void set_radii(vtkPolyData* data, const std::vector<float>& radii);
std::span<const float> radii_of(const BallData& balls);  // Å, as drawn

// The result uses the points and colours of `soup`, which must outlive it. A cell has `corners`
// points, 1 to 3. Null if `soup` has no points.
vtkSmartPointer<vtkPolyData> soup_to_vtk(const CellSoup& soup, int corners);

// The same for triangles with normals.
vtkSmartPointer<vtkPolyData> smooth_to_vtk(const SmoothMesh& mesh);

inline constexpr const char* kRadiusArray = "radius";

}  // namespace alphascope
