// Actors for triangles or lines with colours of their own, and what all of them look like.
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkWindow.h>

#include "ui/scene/gl/cell_mapper.hpp"

namespace alphascope {

// Units of depth by which differences are moved to the front: more than any molecule is deep.
inline constexpr double kToTheFront = -1e6;
// Enough that lines on a face are not broken by rounding.
inline constexpr double kBeforeFaces = -4;

// In caps: the balls' win, then the edges of tetrahedra, then their faces.
inline constexpr double kBehindCapsOfBalls = 4, kBehindEdges = 8;

inline void look_like_a_mesh(vtkActor* actor) {
  actor->VisibilityOff();
  vtkProperty* property = actor->GetProperty();
  property->SetInterpolationToFlat();
  property->SetAmbient(0.18);
  property->SetDiffuse(0.82);
  property->SetSpecular(0.12);
  property->SetSpecularPower(20);
}

// Of simplices with corners at balls.
struct CellActor {
  vtkNew<CellMapper> mapper;
  vtkNew<vtkActor> actor;

  CellActor() {
    actor->SetMapper(mapper);
    look_like_a_mesh(actor);
  }
  void show(const EdgeCells& edges, vtkWindow* window) {
    mapper->show_edges(&edges);
    actor->SetVisibility(!mapper->empty());
    if (mapper->empty()) mapper->free_memory(window);
  }
  // What is not empty, and nothing else; what is shown must outlive it.
  void show(const FaceCells& faces, const TetrahedronCells& tetrahedra, vtkWindow* window) {
    tetrahedra.size() > 0 ? mapper->show_tetrahedra(&tetrahedra) : mapper->show_faces(&faces);
    actor->SetVisibility(!mapper->empty());
    if (mapper->empty()) mapper->free_memory(window);
  }
};

struct MeshActor {
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;

  MeshActor() {
    mapper->SetColorModeToDirectScalars();
    mapper->SetScalarModeToUsePointData();
    actor->SetMapper(mapper);
    look_like_a_mesh(actor);
  }
  void show(vtkPolyData* data, vtkWindow* window) {  // null: nothing
    if (data == nullptr) {
      hide(window);
      return;
    }
    mapper->SetInputData(data);
    actor->VisibilityOn();
  }
  void hide(vtkWindow* window) {
    mapper->SetInputData(nullptr);
    mapper->ReleaseGraphicsResources(window);  // else its buffers stay until it draws again
    actor->VisibilityOff();
  }
  // Of what the picture is about: its colour is to be known by also where it is in shadow.
  void brighter() {
    actor->GetProperty()->SetAmbient(0.32);
    actor->GetProperty()->SetDiffuse(0.78);
  }
  // In its very colours, whatever the light.
  void unlit() {
    actor->GetProperty()->SetAmbient(1);
    actor->GetProperty()->SetDiffuse(0);
    actor->GetProperty()->SetSpecular(0);
  }
  // Lit by the normals of its points.
  void smooth() { actor->GetProperty()->SetInterpolationToPhong(); }
  // Of caps, whose balls' caps are in the same plane.
  void behind_balls(double units) {
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, units);
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, units);
  }
  // Lines on faces of the same place win.
  void before_its_faces() {
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, kBeforeFaces);
    actor->GetProperty()->LightingOff();
  }
  void always_in_front() {
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, kToTheFront);
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, kToTheFront);
    actor->GetProperty()->LightingOff();
  }
};

}  // namespace alphascope
