// SPDX-License-Identifier: GPL-3.0-or-later
// Sums weighted colours of translucent layers, and blends their mean over the picture.
#include "ui/scene/gl/translucent_sum.hpp"

#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderer.h>
#include <vtkProp.h>
#include <vtkRenderState.h>
#include <vtkShaderProgram.h>

#include <GL/gl.h>
#include <GL/glext.h>

namespace alphascope {
namespace {

constexpr const char* kOutput = "//VTK::DepthPeeling::Impl";
// The limit 0.999 avoids the infinite weight of an opaque layer.
constexpr const char* kWeighted = R"(
  float layerWeight = -log(1.0 - min(gl_FragData[0].a, 0.999));
  gl_FragData[0] = layerWeight * vec4(gl_FragData[0].rgb, 1.0);
)";
constexpr const char* kMean = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 texCoord;
uniform sampler2D sums;
void main() {
  vec4 sum = texelFetch(sums, ivec2(gl_FragCoord.xy), 0);
  if (sum.a <= 0.0) discard;
  gl_FragData[0] = vec4(sum.rgb / sum.a, 1.0 - exp(-sum.a));
}
)";

}  // namespace

vtkStandardNewMacro(TranslucentSum);

bool TranslucentSum::PostReplaceShaderValues(std::string&, std::string&,
                                             std::string& fragment_shader, vtkAbstractMapper*,
                                             vtkProp*) {
  vtkShaderProgram::Substitute(fragment_shader, kOutput, kWeighted);
  return true;
}

void TranslucentSum::Render(const vtkRenderState* state) {
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetRenderWindow());
  vtkOpenGLFramebufferObject* drawn = window->GetRenderFramebuffer();
  vtkTextureObject* depths = drawn->GetDepthAttachmentAsTextureObject();
  if (depths == nullptr) return;
  const int width = static_cast<int>(depths->GetWidth());
  const int height = static_cast<int>(depths->GetHeight());
  sum(state, depths, width, height);
  show(window, width, height);
}

void TranslucentSum::sum(const vtkRenderState* state, vtkTextureObject* depths, int width,
                         int height) {
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLState* gl = window->GetState();
  const DrawsQuads whole(gl, width, height);
  const vtkOpenGLState::ScopedglClearColor clear(gl);
  gl->PushFramebufferBindings();
  sums_.bind(window, width, height, PixelKind::sums);
  sums_.framebuffer()->RemoveDepthAttachment();  // the attachment may be from a framebuffer that
                                                 // was made anew
  sums_.framebuffer()->AddDepthAttachment(depths);
  gl->vtkglClearColor(0, 0, 0, 0);
  gl->vtkglClear(GL_COLOR_BUFFER_BIT);
  gl->vtkglEnable(GL_DEPTH_TEST);
  gl->vtkglEnable(GL_BLEND);
  gl->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  this->PreRender(state);
  for (int i = 0; i < state->GetPropArrayCount(); ++i) {
    vtkProp* prop = state->GetPropArray()[i];
    if (prop->HasTranslucentPolygonalGeometry()) prop->RenderTranslucentPolygonalGeometry(renderer);
  }
  this->PostRender(state);
  sums_.framebuffer()->RemoveDepthAttachment();
  gl->PopFramebufferBindings();
}

void TranslucentSum::show(vtkOpenGLRenderWindow* window, int width, int height) {
  vtkOpenGLQuadHelper* quad = mean_.use(window, [] { return kMean; });
  if (quad == nullptr) return;
  vtkOpenGLState* gl = window->GetState();
  const DrawsQuads quads(gl, width, height);
  gl->vtkglEnable(GL_BLEND);
  gl->vtkglBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  sums_.texture()->Activate();
  quad->Program->SetUniformi("sums", sums_.texture()->GetTextureUnit());
  quad->Render();
  sums_.texture()->Deactivate();
}

void TranslucentSum::ReleaseGraphicsResources(vtkWindow* window) {
  mean_.release();
  sums_.release(window);
  Superclass::ReleaseGraphicsResources(window);
}

}  // namespace alphascope
