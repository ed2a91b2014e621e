// SPDX-License-Identifier: GPL-3.0-or-later
// Actors for cells (CellActor) and for triangles or lines with colours of their own (MeshActor),
// and the look of both.
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkWindow.h>

#include "ui/scene/gl/cell_mapper.hpp"

namespace alphascope {

// Depth offset that draws differences in front, in OpenGL's units. It exceeds the depth of any
// molecule.
inline constexpr double kToTheFront = -1e6;
// Depth offset of lines on a face, large enough that rounding does not break them.
inline constexpr double kBeforeFaces = -4;

// Depth offsets in a cap: the balls' caps win, then edges of tetrahedra, then their faces.
inline constexpr double kBehindCapsOfBalls = 4, kBehindEdges = 8;

inline void set_mesh_look(vtkActor* actor) {
  actor->VisibilityOff();
  vtkProperty* property = actor->GetProperty();
  property->SetInterpolationToFlat();
  property->SetAmbient(0.18);
  property->SetDiffuse(0.82);
  property->SetSpecular(0.12);
  property->SetSpecularPower(20);
}

// Shows simplices whose corners are balls.
struct CellActor {
  vtkNew<CellMapper> mapper;
  vtkNew<vtkActor> actor;

  CellActor() {
    actor->SetMapper(mapper);
    set_mesh_look(actor);
  }
  void show(const EdgeCells& edges, vtkWindow* window) {
    mapper->show_edges(&edges);
    actor->SetVisibility(!mapper->empty());
    if (mapper->empty()) mapper->free_memory(window);
  }
  // Shows the tetrahedra, or the faces if there are no tetrahedra. The argument must outlive this
  // actor.
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
    set_mesh_look(actor);
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
    mapper->ReleaseGraphicsResources(window);  // frees its buffers, which would stay until it draws
                                               // again
    actor->VisibilityOff();
  }
  // For the main subject of a picture: its colour stays recognisable in shadow.
  void brighter() {
    actor->GetProperty()->SetAmbient(0.32);
    actor->GetProperty()->SetDiffuse(0.78);
  }
  // Draws exact colours, whatever the light.
  void unlit() {
    actor->GetProperty()->SetAmbient(1);
    actor->GetProperty()->SetDiffuse(0);
    actor->GetProperty()->SetSpecular(0);
  }
  // Computes light from the normals of the points.
  void smooth() { actor->GetProperty()->SetInterpolationToPhong(); }
  // For caps of tetrahedra: caps of balls are in the same plane and win.
  void behind_balls(double units) {
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, units);
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, units);
  }
  // Shows these lines before faces of the same depth.
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
