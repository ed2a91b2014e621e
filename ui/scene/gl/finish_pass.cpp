// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the fronts of translucent actors, and runs the shader of finish_shader.hpp over the
// picture.
#include "ui/scene/gl/finish_pass.hpp"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkShaderProgram.h>

#include <GL/gl.h>
#include <GL/glext.h>

#include <utility>
#include <vector>

#include "ui/scene/gl/finish_shader.hpp"

namespace alphascope {
namespace {

// Depth at which fading begins, as a share of the way from the nearest to the farthest point.
constexpr double kCueFrom = 0.25;

}  // namespace

void FinishPass::give(vtkOpenGLRenderer* renderer, const FinishSettings& f,
                      vtkShaderProgram* program) {
  vtkCamera* camera = renderer->GetActiveCamera();
  const vtkMatrix4x4* p =
      camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1);
  const auto element = [&](int row, int column) {
    return static_cast<float>(p->GetElement(row, column));
  };
  const float depth[] = {element(2, 2), element(2, 3), element(3, 2), element(3, 3)};
  const float scale[] = {element(0, 0), element(1, 1)};
  const float shift[] = {element(0, 2), element(0, 3), element(1, 2), element(1, 3)};
  const int size[] = {static_cast<int>(result_.texture()->GetWidth()),
                      static_cast<int>(result_.texture()->GetHeight())};
  const float radii[] = {f.near_radius, f.far_radius};
  const double* range = camera->GetClippingRange();
  const float cue[] = {f.depth_cue, static_cast<float>(range[0] + kCueFrom * (range[1] - range[0])),
                       static_cast<float>(range[1])};
  const float outline[] = {f.outline_width, f.outline_jump};
  const float background[] = {f.background.r, f.background.g, f.background.b,
                              f.transparent ? 0.0f : 1.0f};
  const float line[] = {f.line.r, f.line.g, f.line.b};
  program->SetUniform4f("depthOfNdc", depth);
  program->SetUniform2f("scaleOfNdc", scale);
  program->SetUniform4f("shiftOfNdc", shift);
  program->SetUniform2i("size", size);
  program->SetUniformi("tapCount", f.occlusion_taps);
  program->SetUniformi("turn", f.turn);
  program->SetUniform2f("radii", radii);
  program->SetUniformf("strength", f.occlusion_strength);
  program->SetUniform3f("light", f.light.data());
  program->SetUniformf("shadowReach", f.shadow_reach);
  program->SetUniform3f("cue", cue);
  program->SetUniform2f("outline", outline);
  program->SetUniform4f("background", background);
  program->SetUniform3f("lineColour", line);
}

void FinishPass::apply(vtkOpenGLRenderer* renderer, const FinishSettings& finish) {
  pass(renderer, finish, false);
}

void FinishPass::apply_to_translucent(vtkOpenGLRenderer* renderer, const FinishSettings& finish) {
  pass(renderer, finish, true);
}

void FinishPass::draw_fronts(vtkOpenGLRenderer* renderer, const FinishSettings& finish, int width,
                             int height) {
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  const DrawsQuads whole(state, width, height);
  state->PushFramebufferBindings();
  fronts_.bind(window, width, height);
  state->vtkglEnable(GL_DEPTH_TEST);
  vtkPropCollection* props = renderer->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i) {
    auto* actor = vtkActor::SafeDownCast(props->GetItemAsObject(i));
    if (actor == nullptr || !actor->GetVisibility()) continue;
    if (!actor->HasTranslucentPolygonalGeometry()) continue;
    if (static_cast<float>(actor->GetProperty()->GetOpacity()) < finish.translucent_opacity) {
      continue;
    }
    actor->GetProperty()->Render(actor, renderer);
    actor->Render(renderer, actor->GetMapper());
    actor->GetProperty()->PostRender(actor, renderer);
  }
  state->PopFramebufferBindings();
}

void FinishPass::pass(vtkOpenGLRenderer* renderer, const FinishSettings& finish, bool translucent) {
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLFramebufferObject* drawn = window->GetRenderFramebuffer();
  vtkTextureObject* colours = drawn->GetColorAttachmentAsTextureObject(0);
  vtkTextureObject* depths = drawn->GetDepthAttachmentAsTextureObject();
  if (colours == nullptr || depths == nullptr) return;
  const int width = static_cast<int>(colours->GetWidth());
  const int height = static_cast<int>(colours->GetHeight());
  if (translucent) draw_fronts(renderer, finish, width, height);
  const bool occlusion = finish.occlusion_taps > 0;
  vtkOpenGLQuadHelper* quad = programs_[(occlusion ? 1 : 0) + (translucent ? 2 : 0)].use(
      window, [&] { return finish_shader(occlusion, translucent); });
  if (quad == nullptr) return;
  vtkOpenGLState* state = window->GetState();
  const DrawsQuads quads(state, width, height);
  state->PushFramebufferBindings();
  result_.bind(window, width, height, PixelKind::bytes);
  std::vector<std::pair<const char*, vtkTextureObject*>> textures{{"colours", colours},
                                                                  {"depths", depths}};
  if (translucent) textures.emplace_back("fronts", fronts_.texture());
  for (const auto& [name, texture] : textures) {
    texture->Activate();
    quad->Program->SetUniformi(name, texture->GetTextureUnit());
  }
  give(renderer, finish, quad->Program);
  if (translucent) quad->Program->SetUniformf("opacity", finish.translucent_opacity);
  quad->Render();
  for (const auto& texture : textures) texture.second->Deactivate();
  result_.framebuffer()->Bind(GL_READ_FRAMEBUFFER);
  result_.framebuffer()->ActivateReadBuffer(0);
  drawn->Bind(GL_DRAW_FRAMEBUFFER);
  state->vtkglBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                              GL_NEAREST);
  state->PopFramebufferBindings();
}

void FinishPass::release(vtkWindow* window) {
  for (QuadProgram& program : programs_) program.release();
  result_.release(window);
  fronts_.release(window);
}

}  // namespace alphascope
