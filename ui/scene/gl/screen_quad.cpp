// SPDX-License-Identifier: GPL-3.0-or-later
// DrawnTexture, DrawnDepths, QuadProgram and DrawsQuads.
#include "ui/scene/gl/screen_quad.hpp"

#include <vtkOpenGLShaderCache.h>
#include <vtkShaderProgram.h>

#include <GL/gl.h>
#include <GL/glext.h>

namespace alphascope {

namespace {

// Makes an empty texture of this size. Returns false if it has this size already.
bool make_texture(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, int width, int height,
                  PixelKind kind) {
  const auto w = static_cast<unsigned>(width), h = static_cast<unsigned>(height);
  if (texture->GetHandle() != 0 && texture->GetWidth() == w && texture->GetHeight() == h) {
    return false;
  }
  texture->ReleaseGraphicsResources(window);
  texture->SetContext(window);
  texture->ResetFormatAndType();
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  if (kind == PixelKind::sums) {
    texture->SetInternalFormat(GL_RGBA16F);
    texture->SetFormat(GL_RGBA);
    texture->SetDataType(GL_FLOAT);
    texture->Allocate2D(w, h, 4, VTK_FLOAT);
  } else if (kind == PixelKind::depths) {
    texture->AllocateDepth(w, h, vtkTextureObject::Float32);
  } else {
    texture->Allocate2D(w, h, 4, VTK_UNSIGNED_CHAR);
  }
  return true;
}

}  // namespace

void DrawnTexture::bind(vtkOpenGLRenderWindow* window, int width, int height, PixelKind kind) {
  framebuffer_->SetContext(window);
  const bool made = make_texture(texture_, window, width, height, kind);
  framebuffer_->Bind();
  // VTK compares texture objects, and would keep the attachment of the released texture.
  if (made) framebuffer_->RemoveColorAttachment(0);
  framebuffer_->AddColorAttachment(0, texture_);
  framebuffer_->ActivateBuffer(0);
}

void DrawnTexture::release(vtkWindow* window) {
  framebuffer_->ReleaseGraphicsResources(window);
  texture_->ReleaseGraphicsResources(window);
}

void DrawnDepths::bind(vtkOpenGLRenderWindow* window, int width, int height) {
  framebuffer_->SetContext(window);
  const bool made = make_texture(texture_, window, width, height, PixelKind::depths);
  framebuffer_->Bind();
  if (made) framebuffer_->RemoveDepthAttachment();
  framebuffer_->AddDepthAttachment(texture_);
  framebuffer_->DeactivateDrawBuffers();
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglDepthMask mask(state);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglClearDepth(1);
  state->vtkglClear(GL_DEPTH_BUFFER_BIT);
}

void DrawnDepths::release(vtkWindow* window) {
  framebuffer_->ReleaseGraphicsResources(window);
  texture_->ReleaseGraphicsResources(window);
}

vtkOpenGLQuadHelper* QuadProgram::use(vtkOpenGLRenderWindow* window,
                                      const std::function<std::string()>& shader) {
  if (!quad_) quad_ = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, shader().c_str(), "");
  window->GetShaderCache()->ReadyShaderProgram(quad_->Program);
  return quad_->Program && quad_->Program->GetCompiled() ? quad_.get() : nullptr;
}

DrawsQuads::DrawsQuads(vtkOpenGLState* state, int width, int height)
    : blend_(state, GL_BLEND),
      depth_test_(state, GL_DEPTH_TEST),
      scissor_test_(state, GL_SCISSOR_TEST),
      cull_(state, GL_CULL_FACE),
      viewport_(state),
      depth_mask_(state),
      blend_function_(state) {
  for (const unsigned off : {GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_CULL_FACE}) {
    state->vtkglDisable(off);
  }
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglViewport(0, 0, width, height);
}

}  // namespace alphascope
