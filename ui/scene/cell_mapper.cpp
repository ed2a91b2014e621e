// See the header.
#include "ui/scene/cell_mapper.hpp"

#include <vtkObjectFactory.h>
#include <vtkOpenGLHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLVertexArrayObject.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkShader.h>
#include <vtkShaderProgram.h>

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <utility>

namespace alphascope {
namespace {

constexpr const char* kCorner = "in vec4 vertexMC;";  // as VTK's template declares it
constexpr const char* kBegin = "//VTK::CustomBegin::Impl";
constexpr const char* kColourDeclared = "//VTK::Color::Dec";
constexpr const char* kColour = "//VTK::Color::Impl";

// Faces: three balls and the colour. Tetrahedra: four balls; face f lacks corner f.
constexpr const char* kDeclared = R"(
uniform usamplerBuffer cells;
uniform usamplerBuffer cellColours;
uniform samplerBuffer places;
uniform float shrink;
uniform int whole;
flat out vec3 cellColourVSOutput;
vec4 vertexMC;
vec3 placeOf(uint ball) { return texelFetch(places, int(ball)).xyz; }
)";
constexpr const char* kFetched = R"(
  {
    uint colour;
    vec3 place;
    if (whole != 0) {
      int cell = gl_VertexID / 12;
      int face = gl_VertexID % 12 / 3, corner = gl_VertexID % 3;
      uvec4 balls = texelFetch(cells, cell);
      place = placeOf(balls[corner < face ? corner : corner + 1]);
      if (shrink > 0.0) {
        vec3 centre = 0.25 * placeOf(balls.x) + 0.25 * placeOf(balls.y);
        centre += 0.25 * placeOf(balls.z);
        centre += 0.25 * placeOf(balls.w);
        place += shrink * (centre - place);
      }
      colour = texelFetch(cellColours, cell).x;
    } else {
      uvec4 face = texelFetch(cells, gl_VertexID / 3);
      place = placeOf(face[gl_VertexID % 3]);
      colour = face.w;
    }
    vertexMC = vec4(place, 1.0);
    cellColourVSOutput =
        vec3(float(colour & 255u), float(colour >> 8 & 255u), float(colour >> 16 & 255u)) / 255.0;
  }
)";
constexpr const char* kColoured = R"(
  ambientColor = ambientIntensity * cellColourVSOutput;
  diffuseColor = diffuseIntensity * cellColourVSOutput;
)";

constexpr std::size_t kLargeUpload = std::size_t{4} << 20;  // bytes

constexpr const char* kCellsName = "cells";
constexpr const char* kColoursName = "cellColours";
constexpr const char* kPlacesName = "places";

}  // namespace

void ShaderBuffer::set(const void* content, std::size_t count, std::size_t bytes, unsigned format) {
  content_ = content;
  count_ = content == nullptr ? 0 : count;
  bytes_ = bytes;
  format_ = format;
  uploaded_ = false;
}

void ShaderBuffer::upload(vtkOpenGLRenderWindow* window) {
  if (uploaded_ || count_ == 0) return;
  buffer_->SetType(vtkOpenGLBufferObject::TextureBuffer);
  const auto* const content = static_cast<const unsigned char*>(content_);
  if (count_ * bytes_ < kLargeUpload || !copy_by_all_threads(content, count_ * bytes_)) {
    buffer_->Upload(content, count_ * bytes_, vtkOpenGLBufferObject::TextureBuffer);
  }
  if (texture_->GetHandle() == 0) {
    texture_->SetContext(window);
    texture_->SetInternalFormat(format_);
    texture_->CreateTextureBuffer(static_cast<unsigned>(count_), 4, VTK_FLOAT, buffer_);
  }
  uploaded_ = true;
}

// False: nothing came of it. The driver's own copy is made by one thread.
bool ShaderBuffer::copy_by_all_threads(const unsigned char* content, std::size_t bytes) {
  if (!buffer_->GenerateBuffer(vtkOpenGLBufferObject::TextureBuffer) || !buffer_->Bind()) {
    return false;
  }
  const auto size = static_cast<GLsizeiptr>(bytes);
  glBufferData(GL_TEXTURE_BUFFER, size, nullptr, GL_STATIC_DRAW);
  constexpr GLbitfield kHow = GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT;
  auto* const to = static_cast<unsigned char*>(glMapBufferRange(GL_TEXTURE_BUFFER, 0, size, kHow));
  if (to == nullptr) {
    buffer_->Release();
    return false;
  }
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  tbb::parallel_for(std::size_t{0}, (bytes + kPiece - 1) / kPiece, [&](std::size_t piece) {
    const std::size_t from = piece * kPiece;
    std::memcpy(to + from, content + from, std::min(kPiece, bytes - from));
  });
  const bool kept = glUnmapBuffer(GL_TEXTURE_BUFFER) == GL_TRUE;  // false: the driver lost it
  buffer_->Release();
  return kept;
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

// VTK draws nothing without a point, and looks for changes in what it is given; this never changes.
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
  whole_ = false;
  cells_.set(faces ? faces->faces.data() : nullptr, faces ? faces->size() : 0, sizeof(DrawnFace),
             GL_RGBA32UI);
  colours_.set(nullptr, 0, 0, GL_R32UI);
}

void CellMapper::show_tetrahedra(const TetrahedronCells* tetrahedra) {
  whole_ = true;
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

// Those of all balls: what is drawn lies within, and a tighter box would take a pass over it.
void CellMapper::ComputeBounds() {
  const std::array<double, 6> none{1, -1, 1, -1, 1, -1};
  const auto& bounds = places_ != nullptr && !empty() ? places_->balls->bounds : none;
  std::copy(bounds.begin(), bounds.end(), this->Bounds);
}

void CellMapper::ReleaseGraphicsResources(vtkWindow* window) {
  free_memory(window);
  if (places_ != nullptr) places_->buffer.release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

bool CellMapper::GetNeedToRebuildBufferObjects(vtkRenderer*, vtkActor*) {
  return !cells_.is_uploaded() || !colours_.is_uploaded() || !places_->buffer.is_uploaded();
}

void CellMapper::BuildBufferObjects(vtkRenderer* renderer, vtkActor*) {
  const auto start = std::chrono::steady_clock::now();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  cells_.upload(window);
  colours_.upload(window);
  places_->buffer.upload(window);
  this->VBOBuildTime.Modified();
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  upload_milliseconds_ += taken.count();
}

void CellMapper::ReplaceShaderValues(std::map<vtkShader::Type, vtkShader*> shaders,
                                     vtkRenderer* renderer, vtkActor* actor) {
  std::string vertex = shaders[vtkShader::Vertex]->GetSource();
  std::string fragment = shaders[vtkShader::Fragment]->GetSource();
  const auto before = [](std::string& source, const char* mark, const std::string& more) {
    vtkShaderProgram::Substitute(source, mark, more + mark, false);
  };
  const auto after = [](std::string& source, const char* mark, const std::string& more) {
    vtkShaderProgram::Substitute(source, mark, mark + more, false);
  };
  vtkShaderProgram::Substitute(vertex, kCorner, kDeclared, false);
  before(vertex, kBegin, kFetched);
  before(fragment, kColourDeclared, "flat in vec3 cellColourVSOutput;\n");
  after(fragment, kColour, kColoured);
  shaders[vtkShader::Vertex]->SetSource(vertex);
  shaders[vtkShader::Fragment]->SetSource(fragment);
  this->Superclass::ReplaceShaderValues(shaders, renderer, actor);
}

void CellMapper::SetMapperShaderParameters(vtkOpenGLHelper& helper, vtkRenderer* renderer,
                                           vtkActor* actor) {
  this->Superclass::SetMapperShaderParameters(helper, renderer, actor);
  vtkShaderProgram* program = helper.Program;
  const auto give = [program](const char* name, int value) {
    if (program->IsUniformUsed(name)) program->SetUniformi(name, value);
  };
  const int cells = cells_.activate();
  give(kCellsName, cells);
  // Samplers of one kind may share a unit where one of them is not read.
  give(kColoursName, whole_ ? colours_.activate() : cells);
  give(kPlacesName, places_->buffer.activate());
  give("whole", whole_ ? 1 : 0);
  if (program->IsUniformUsed("shrink")) program->SetUniformf("shrink", shrink_);
}

void CellMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) {
  if (empty()) return;
  this->UpdateShaders(this->Primitives[PrimitiveTris], renderer, actor);
  if (this->Primitives[PrimitiveTris].Program == nullptr) return;
  // A new program has let go of it, and without attributes VTK does not bind it again.
  this->Primitives[PrimitiveTris].VAO->Bind();
  const std::size_t corners = (whole_ ? 12 : 3) * cells_.count();
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners));
  cells_.deactivate();
  colours_.deactivate();
  places_->buffer.deactivate();
}

}  // namespace alphascope
