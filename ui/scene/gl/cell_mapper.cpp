// SPDX-License-Identifier: GPL-3.0-or-later
// ShaderBuffer, BallPlaces and CellMapper: uploads of cells, changes of VTK's shaders, and the draw
// call.
#include "ui/scene/gl/cell_mapper.hpp"

#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLCamera.h>
#include <vtkOpenGLHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLVertexArrayObject.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShader.h>
#include <vtkShaderProgram.h>

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string>
#include <utility>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "ui/scene/gl/ball_shader.hpp"
#include "ui/scene/gl/cell_shader.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {
namespace {

constexpr const char* kCorner = "in vec4 vertexMC;";  // as VTK's template declares it
constexpr const char* kBegin = "//VTK::CustomBegin::Impl";
constexpr const char* kPlaced = "//VTK::PositionVC::Impl";
constexpr const char* kColourDeclared = "//VTK::Color::Dec";
constexpr const char* kColour = "//VTK::Color::Impl";
constexpr const char* kUniformFlow = "//VTK::UniformFlow::Impl";
constexpr const char* kNormal = "//VTK::Normal::Impl";
constexpr const char* kLight = "//VTK::Light::Impl";
constexpr const char* kDepth = "//VTK::Depth::Impl";

// Most faces that are lit face by face. With more, most faces are smaller than a pixel. Light for
// each of them then takes longer than light for each pixel.
constexpr std::size_t kMostFacesLit = 2'000'000;
constexpr std::size_t kLargeUpload = std::size_t{4} << 20;  // bytes

constexpr const char* kCellsName = "cells";
constexpr const char* kColoursName = "cellColours";
constexpr const char* kPlacesName = "places";
constexpr const char* kNormalsName = "normals";

using Sources = std::map<vtkShader::Type, vtkShader*>;

// Edits the source of one shader, and writes it back in the destructor.
class Edited {
 public:
  Edited(const Sources& sources, vtkShader::Type type)
      : shader_(sources.at(type)), source_(shader_->GetSource()) {}
  ~Edited() { shader_->SetSource(source_); }
  Edited(const Edited&) = delete;
  Edited& operator=(const Edited&) = delete;

  void instead(const char* mark, const std::string& text) {
    vtkShaderProgram::Substitute(source_, mark, text, false);
  }
  void before(const char* mark, const std::string& more) { instead(mark, more + mark); }
  void after(const char* mark, const std::string& more) { instead(mark, mark + more); }

 private:
  vtkShader* shader_;
  std::string source_;
};

}  // namespace

void ShaderBuffer::set(const void* content, std::size_t count, std::size_t bytes, unsigned format) {
  content_ = content;
  count_ = content == nullptr ? 0 : count;
  bytes_ = bytes;
  format_ = format;
  uploaded_ = false;
}

void ShaderBuffer::upload(vtkOpenGLRenderWindow* window, UploadBuffer& room) {
  if (uploaded_ || count_ == 0) return;
  buffer_->SetType(vtkOpenGLBufferObject::TextureBuffer);
  const auto* const content = static_cast<const unsigned char*>(content_);
  if (count_ * bytes_ < kLargeUpload || !upload_large(content, count_ * bytes_, room)) {
    buffer_->Upload(content, count_ * bytes_, vtkOpenGLBufferObject::TextureBuffer);
  }
  if (texture_->GetHandle() == 0) {
    texture_->SetContext(window);
    texture_->SetInternalFormat(format_);
    texture_->CreateTextureBuffer(static_cast<unsigned>(count_), 4, VTK_FLOAT, buffer_);
  }
  uploaded_ = true;
}

// Returns false if the upload failed. Several threads copy, because the driver's own copy uses one
// thread. Software OpenGL reads the driver's memory itself, so UploadBuffer would only add a copy.
bool ShaderBuffer::upload_large(const unsigned char* content, std::size_t bytes,
                                UploadBuffer& room) {
  if (!buffer_->GenerateBuffer(vtkOpenGLBufferObject::TextureBuffer) || !buffer_->Bind()) {
    return false;
  }
  const auto size = static_cast<GLsizeiptr>(bytes);
  glBufferData(GL_TEXTURE_BUFFER, size, nullptr, GL_STATIC_DRAW);
  const bool by_room = !draws_in_software() && room.fill(GL_TEXTURE_BUFFER, content, bytes);
  const bool there = by_room || map_and_copy(content, bytes);
  buffer_->Release();
  return there;
}

// Copies into the bound buffer.
bool ShaderBuffer::map_and_copy(const unsigned char* content, std::size_t bytes) {
  constexpr GLbitfield kHow = GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT;
  void* const to = glMapBufferRange(GL_TEXTURE_BUFFER, 0, static_cast<GLsizeiptr>(bytes), kHow);
  if (to == nullptr) return false;
  copy_by_all_threads(content, static_cast<unsigned char*>(to), bytes);
  return glUnmapBuffer(GL_TEXTURE_BUFFER) == GL_TRUE;  // false: the driver lost it
}

void ShaderBuffer::release(vtkWindow* window) {
  texture_->ReleaseGraphicsResources(window);
  buffer_->ReleaseGraphicsResources();
  uploaded_ = false;
}

int ShaderBuffer::activate() {
  if (count_ == 0) return 0;
  texture_->Activate();
  return texture_->GetTextureUnit();
}

void ShaderBuffer::deactivate() {
  if (count_ > 0) texture_->Deactivate();
}

void BallPlaces::set(std::shared_ptr<const BallGeometry> new_balls) {
  balls = std::move(new_balls);
  const bool any = balls && !balls->centres.empty();
  buffer.set(any ? balls->centres.data() : nullptr, any ? balls->centres.size() : 0,
             sizeof(balls->centres[0]), GL_RGB32F);
}

vtkStandardNewMacro(CellMapper);

// VTK draws nothing without a point, and checks its input for changes. So the input is one point
// that never changes.
CellMapper::CellMapper() {
  vtkNew<vtkPoints> one;
  one->InsertNextPoint(0, 0, 0);
  vtkNew<vtkPolyData> nothing;
  nothing->SetPoints(one);
  this->SetInputData(nothing);
  this->ScalarVisibilityOff();
}

CellMapper::~CellMapper() = default;

void CellMapper::show_faces(const FaceCells* faces) {
  kind_ = Kind::faces;
  cells_.set(faces ? faces->faces.data() : nullptr, faces ? faces->size() : 0, sizeof(DrawnFace),
             GL_RGBA32UI);
  colours_.set(nullptr, 0, 0, GL_R32UI);
  const bool any = faces != nullptr && !faces->normals.empty();
  normals_.set(any ? faces->normals.data() : nullptr, any ? faces->normals.size() : 0,
               sizeof(faces->normals[0]), GL_RGB32F);
}

void CellMapper::show_edges(const EdgeCells* edges) {
  kind_ = Kind::edges;
  cells_.set(edges ? edges->edges.data() : nullptr, edges ? edges->size() : 0, sizeof(DrawnEdge),
             GL_RGBA32UI);
}

void CellMapper::show_tetrahedra(const TetrahedronCells* tetrahedra) {
  kind_ = Kind::tetrahedra;
  shrink_ = tetrahedra->shrink;
  cells_.set(tetrahedra->balls.data(), tetrahedra->size(), sizeof(tetrahedra->balls[0]),
             GL_RGBA32UI);
  colours_.set(tetrahedra->colours.data(), tetrahedra->size(), sizeof(PackedColour), GL_R32UI);
}

void CellMapper::free_memory(vtkWindow* window) {
  cells_.release(window);
  colours_.release(window);
}

double CellMapper::take_upload_milliseconds() {
  return std::exchange(upload_milliseconds_, 0.0);
}

double* CellMapper::GetBounds() {
  this->ComputeBounds();
  return this->Bounds;
}

// The bounds of all balls contain every cell. A tighter box would need a pass over the cells.
void CellMapper::ComputeBounds() {
  const std::array<double, 6> none{1, -1, 1, -1, 1, -1};
  const auto& bounds = places_ != nullptr && !empty() ? places_->balls->bounds : none;
  std::copy(bounds.begin(), bounds.end(), this->Bounds);
}

void CellMapper::ReleaseGraphicsResources(vtkWindow* window) {
  free_memory(window);
  if (places_ != nullptr) {
    places_->buffer.release(window);
    places_->room.release();
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

bool CellMapper::GetNeedToRebuildBufferObjects(vtkRenderer*, vtkActor*) {
  return !cells_.is_uploaded() || !colours_.is_uploaded() || !normals_.is_uploaded() ||
         !places_->buffer.is_uploaded();
}

void CellMapper::BuildBufferObjects(vtkRenderer* renderer, vtkActor*) {
  const auto start = std::chrono::steady_clock::now();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  cells_.upload(window, places_->room);
  colours_.upload(window, places_->room);
  normals_.upload(window, places_->room);
  places_->buffer.upload(window, places_->room);
  this->VBOBuildTime.Modified();
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  upload_milliseconds_ += taken.count();
}

bool CellMapper::GetNeedToRebuildShaders(vtkOpenGLHelper& helper, vtkRenderer* renderer,
                                         vtkActor* actor) {
  const std::size_t faces = (kind_ == Kind::tetrahedra ? 4 : 1) * cells_.count();
  const bool by_face = lit_by_face_ && normals_.count() == 0 && faces <= kMostFacesLit;
  const bool other = std::exchange(built_lit_by_face_, by_face) != by_face;
  return this->Superclass::GetNeedToRebuildShaders(helper, renderer, actor) || other;
}

void CellMapper::ReplaceShaderValues(Sources shaders, vtkRenderer* renderer, vtkActor* actor) {
  {
    Edited vertex(shaders, vtkShader::Vertex), fragment(shaders, vtkShader::Fragment);
    if (kind_ == Kind::edges) {
      vertex.instead(kCorner, std::string(kColourOf) + kRodsDeclared);
      vertex.instead(kPlaced, kRodsPlaced);
      fragment.before(kColourDeclared, kRodsToFragments);
      fragment.instead(kDepth, kRodsMet);
      fragment.instead(kNormal, "");
      fragment.after(kColour, kRodsColoured);
    } else {
      vertex.instead(kCorner, std::string(kColourOf) + kFacesDeclared);
      vertex.before(kBegin, kFacesFetched);
      fragment.before(kColourDeclared, std::string(kColourOf) + kFacesToFragments);
      fragment.after(kUniformFlow, kFacesUniform);
      fragment.after(kColour, kFacesColoured);
      if (built_lit_by_face_) {
        fragment.instead(kLight, kFacesLit);
      } else {
        fragment.after(kNormal, kFacesNormal);
      }
    }
  }
  this->Superclass::ReplaceShaderValues(shaders, renderer, actor);
}

void CellMapper::set_camera_uniforms(vtkShaderProgram* program, vtkRenderer* renderer) {
  auto* camera = vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera());
  vtkMatrix4x4 *to_camera, *to_picture, *whole_way;
  vtkMatrix3x3* turn;
  camera->GetKeyMatrices(renderer, to_camera, turn, to_picture, whole_way);
  if (kind_ != Kind::edges) {
    program->SetUniformMatrix("cellToCamera", turn);
    return;
  }
  program->SetUniformMatrix("cellToCamera", to_camera);
  program->SetUniformMatrix("cameraToPicture", to_picture);
  program->SetUniformi("parallel", camera->GetParallelProjection());
}

void CellMapper::SetMapperShaderParameters(vtkOpenGLHelper& helper, vtkRenderer* renderer,
                                           vtkActor* actor) {
  this->Superclass::SetMapperShaderParameters(helper, renderer, actor);
  vtkShaderProgram* program = helper.Program;
  const int cells = cells_.activate();
  program->SetUniformi(kCellsName, cells);
  const int places = places_->buffer.activate();
  program->SetUniformi(kPlacesName, places);
  set_camera_uniforms(program, renderer);
  if (kind_ == Kind::edges) {
    program->SetUniformf("radius", lines_.rod_radius);
    program->SetUniformf("depthScale", in_front_ ? kFrontDepth : 1.0F);
    program->SetUniformf("radiusPerDepth", lines_.rod_radius_per_depth);
    return;
  }
  // Samplers of one type may share a unit if one of them is not read.
  const bool whole = kind_ == Kind::tetrahedra, smoothed = normals_.count() > 0;
  program->SetUniformi(kColoursName, whole ? colours_.activate() : cells);
  program->SetUniformi(kNormalsName, smoothed ? normals_.activate() : places);
  program->SetUniformi("whole", whole ? 1 : 0);
  program->SetUniformi("outward", actor->GetProperty()->GetBackfaceCulling() ? 1 : 0);
  program->SetUniformi("smoothed", smoothed ? 1 : 0);
  program->SetUniformi("litByFace", built_lit_by_face_ ? 1 : 0);
  program->SetUniformf("shrink", shrink_);
  // Lines would show the faces that smooth light hides.
  program->SetUniformf("faceLines", smoothed ? 0 : lines_.face_lines);
}

void CellMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) {
  if (empty()) return;
  this->UpdateShaders(this->Primitives[PrimitiveTris], renderer, actor);
  if (this->Primitives[PrimitiveTris].Program == nullptr) return;
  // A new shader program has unbound the vertex array. VTK does not bind it again, since it has no
  // attributes.
  this->Primitives[PrimitiveTris].VAO->Bind();
  const std::size_t corners = kind_ == Kind::tetrahedra ? 12 : kind_ == Kind::edges ? 6 : 3;
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners * cells_.count()));
  cells_.deactivate();
  colours_.deactivate();
  normals_.deactivate();
  places_->buffer.deactivate();
}

}  // namespace alphascope
