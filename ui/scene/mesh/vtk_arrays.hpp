// Plain arrays as VTK data, without copying where VTK can use the memory as it is.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <span>

#include "ui/scene/mesh/ball_geometry.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"
#include "ui/scene/mesh/difference_mesh.hpp"
#include "ui/scene/mesh/layer_mesh.hpp"
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

// One vertex cell a ball: vtkOpenGLSphereMapper takes its bounds from cells and shows nothing
// without. Point arrays: colours (scalars) and "radius".
vtkSmartPointer<vtkPolyData> balls_to_vtk(const BallGeometry& balls);
void set_colours(vtkPolyData* data, const std::vector<Rgb8>& colours);
void set_radii(vtkPolyData* data, const std::vector<float>& radii);
std::span<const float> radii_of(const BallData& balls);  // as they are drawn

// Points and colours stay those of `soup`, which must outlive the result; `corners` points a cell.
// Null for a soup without points.
vtkSmartPointer<vtkPolyData> soup_to_vtk(const CellSoup& soup, int corners);

// The same of points with normals.
vtkSmartPointer<vtkPolyData> smooth_to_vtk(const SmoothMesh& mesh);

inline constexpr const char* kRadiusArray = "radius";

}  // namespace alphascope
