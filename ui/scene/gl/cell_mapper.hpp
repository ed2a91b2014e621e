// A mapper for edges, triangles and tetrahedra whose corners are balls: the vertex shader fetches
// corners and colour of a cell from buffers that hold nothing twice. VTK's mapper would copy every
// corner with its colour, list the indices one by one and go through all of it for the bounds.
// Shaders are made from VTK's templates, so that its passes (peeling, occlusion) and whoever
// replaces parts of shaders work as with any other mapper.
#pragma once

#include <vtkNew.h>
#include <vtkOpenGLBufferObject.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkTextureObject.h>

#include <map>
#include <memory>
#include <utility>

#include "ui/scene/gl/upload_room.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"

namespace alphascope {

// A buffer that shaders index. It goes to the GPU when it is drawn first.
class ShaderBuffer {
 public:
  // `count` texels of `format`, an OpenGL name, `bytes` each; null: nothing. The content must stay
  // until upload().
  void set(const void* content, std::size_t count, std::size_t bytes, unsigned format);
  // What is new. No more than Scene::most_cells(). Through the room, if it is large.
  void upload(vtkOpenGLRenderWindow* window, UploadRoom& room);
  void release(vtkWindow* window);
  bool is_uploaded() const { return uploaded_ || count_ == 0; }
  std::size_t count() const { return count_; }
  int activate();  // its texture unit
  void deactivate();

 private:
  bool upload_large(const unsigned char* content, std::size_t bytes, UploadRoom& room);
  static bool map_and_copy(const unsigned char* content, std::size_t bytes);

  const void* content_ = nullptr;
  std::size_t count_ = 0, bytes_ = 0;
  unsigned format_ = 0;
  bool uploaded_ = false;
  vtkNew<vtkOpenGLBufferObject> buffer_;
  vtkNew<vtkTextureObject> texture_;
};

// For all mappers of a scene: where the balls are, and the way to the GPU.
struct BallPlaces {
  void set(std::shared_ptr<const BallGeometry> new_balls);
  std::shared_ptr<const BallGeometry> balls;
  ShaderBuffer buffer;
  UploadRoom room;
};

// Of lines, which need no other cells.
struct CellLines {
  float side_width = 0;  // of the darker lines around faces, pixels; 0: none
  float rod_radius = 0;  // of edges, Å
  // The least that is drawn: Å at the depth of one Å, or anywhere where nothing gets smaller with
  // it.
  float rod_radius_per_depth = 0;
};

class CellMapper : public vtkOpenGLPolyDataMapper {
 public:
  static CellMapper* New();
  vtkTypeMacro(CellMapper, vtkOpenGLPolyDataMapper);

  void set_places(std::shared_ptr<BallPlaces> places) { places_ = std::move(places); }
  // What is given must stay as long as it is drawn.
  void show_faces(const FaceCells* faces);  // null: nothing
  void show_tetrahedra(const TetrahedronCells* tetrahedra);
  // As rods with round ends. A mapper that shows edges shows nothing else, ever.
  void show_edges(const EdgeCells* edges);  // null: nothing
  void set_lines(const CellLines& lines) { lines_ = lines; }
  // Light for each face instead of each pixel, where faces have no normals between them and are not
  // too many: highlights are coarser.
  void light_faces(bool by_face) { lit_by_face_ = by_face; }
  void free_memory(vtkWindow* window);  // of what is shown, until that is drawn
  bool empty() const { return cells_.count() == 0; }
  // Spent on handing content over to OpenGL, since this was last asked.
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

  void give_camera(vtkShaderProgram* program, vtkRenderer* renderer);

  std::shared_ptr<BallPlaces> places_;  // VTK may keep a mapper longer than a scene lasts
  ShaderBuffer cells_, colours_;        // colours_: of tetrahedra; others bring theirs
  ShaderBuffer normals_;                // of balls
  Kind kind_ = Kind::faces;
  CellLines lines_;
  bool lit_by_face_ = false, built_lit_by_face_ = false;  // asked for, and in the shaders
  float shrink_ = 0;
  double upload_milliseconds_ = 0;
};

}  // namespace alphascope
