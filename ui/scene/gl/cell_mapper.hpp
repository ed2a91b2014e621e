// SPDX-License-Identifier: GPL-3.0-or-later
// A mapper for edges, triangles and tetrahedra whose corners are balls. The vertex shader fetches
// corners and colour of a cell from buffers without duplicates. VTK's mapper would copy each corner
// with its colour, list all indices and compute the bounds from all points. The shaders are made
// from VTK's templates. So VTK's passes (peeling, occlusion) and replacements of shader parts work
// as with other mappers.
#pragma once

#include <vtkNew.h>
#include <vtkOpenGLBufferObject.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkTextureObject.h>

#include <map>
#include <memory>
#include <utility>

#include "ui/scene/gl/upload_buffer.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"

namespace alphascope {

// A buffer that shaders index. It is uploaded to the GPU when it is first drawn.
class ShaderBuffer {
 public:
  // Sets `count` texels of `format` (an OpenGL constant), each of `bytes` bytes; null: no content.
  // The content must stay in place until upload().
  void set(const void* content, std::size_t count, std::size_t bytes, unsigned format);
  // Uploads new content, at most Scene::most_cells() texels. Large content goes through `room`.
  void upload(vtkOpenGLRenderWindow* window, UploadBuffer& room);
  void release(vtkWindow* window);
  bool is_uploaded() const { return uploaded_ || count_ == 0; }
  std::size_t count() const { return count_; }
  int activate();  // returns the texture unit
  void deactivate();

 private:
  bool upload_large(const unsigned char* content, std::size_t bytes, UploadBuffer& room);
  static bool map_and_copy(const unsigned char* content, std::size_t bytes);

  const void* content_ = nullptr;
  std::size_t count_ = 0, bytes_ = 0;
  unsigned format_ = 0;
  bool uploaded_ = false;
  vtkNew<vtkOpenGLBufferObject> buffer_;
  vtkNew<vtkTextureObject> texture_;
};

// Centres of the balls and the memory for uploads, shared by all mappers of a scene.
struct BallPlaces {
  void set(std::shared_ptr<const BallGeometry> new_balls);
  std::shared_ptr<const BallGeometry> balls;
  ShaderBuffer buffer;
  UploadBuffer room;
};

// Widths of lines; changing them needs no new cells.
struct CellLines {
  float face_lines = 0;  // of the darker lines around faces, pixels; 0: none
  float rod_radius = 0;  // of edges, Å
  // The least radius that is drawn: Å for each Å of depth. Without perspective it is in Å at any
  // depth.
  float rod_radius_per_depth = 0;
};

class CellMapper : public vtkOpenGLPolyDataMapper {
 public:
  static CellMapper* New();
  vtkTypeMacro(CellMapper, vtkOpenGLPolyDataMapper);

  void set_places(std::shared_ptr<BallPlaces> places) { places_ = std::move(places); }
  // The argument must stay in place as long as it is drawn.
  void show_faces(const FaceCells* faces);  // null: nothing
  void show_tetrahedra(const TetrahedronCells* tetrahedra);
  // Draws edges as rods with round ends. Such a mapper can show nothing but edges afterwards.
  void show_edges(const EdgeCells* edges);  // null: nothing
  void set_lines(const CellLines& lines) { lines_ = lines; }
  // Draws edges in front of everything else, as BallRendering::in_front does balls.
  void bring_to_front(bool front) { in_front_ = front; }
  // Computes light once for each face instead of each pixel, which makes highlights coarser. It has
  // no effect on faces with normals at corners, nor above 2 million faces (kMostFacesLit).
  void light_faces(bool by_face) { lit_by_face_ = by_face; }
  void free_memory(vtkWindow* window);  // frees the buffers of cells and colours until they are
                                        // drawn again
  bool empty() const { return cells_.count() == 0; }
  // Milliseconds spent on handing content over to OpenGL since the last call.
  double take_upload_milliseconds();

  double* GetBounds() override;
  using vtkOpenGLPolyDataMapper::GetBounds;
  void ReleaseGraphicsResources(vtkWindow* window) override;

 protected:
  CellMapper();
  ~CellMapper() override;
  void ComputeBounds() override;
  bool GetNeedToRebuildBufferObjects(vtkRenderer*, vtkActor*) override;
  void BuildBufferObjects(vtkRenderer* renderer, vtkActor*) override;
  bool GetNeedToRebuildShaders(vtkOpenGLHelper& helper, vtkRenderer* renderer,
                               vtkActor* actor) override;
  void ReplaceShaderValues(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer,
                           vtkActor* actor) override;
  void SetMapperShaderParameters(vtkOpenGLHelper& helper, vtkRenderer* renderer,
                                 vtkActor* actor) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;

 private:
  CellMapper(const CellMapper&) = delete;
  void operator=(const CellMapper&) = delete;

  enum class Kind : std::uint8_t { faces, tetrahedra, edges };

  void set_camera_uniforms(vtkShaderProgram* program, vtkRenderer* renderer);

  std::shared_ptr<BallPlaces> places_;  // shared, because VTK may keep a mapper longer than the
                                        // scene lives
  ShaderBuffer cells_, colours_;        // colours_: of tetrahedra; faces and edges contain theirs
  ShaderBuffer normals_;                // of balls
  Kind kind_ = Kind::faces;
  CellLines lines_;
  bool in_front_ = false;
  bool lit_by_face_ = false, built_lit_by_face_ = false;  // requested; used by the present shaders
  float shrink_ = 0;
  double upload_milliseconds_ = 0;
};

}  // namespace alphascope
