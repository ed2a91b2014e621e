// SPDX-License-Identifier: GPL-3.0-or-later
// Common parts of passes over the whole picture: textures to draw into, programs, and OpenGL's
// state. For sources of the scene only.
#pragma once

#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkTextureObject.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace alphascope {

// bytes: four channels of 8 bits. sums: four channels of 16-bit floats, in which samples add up.
// depths: 32-bit floats.
enum class PixelKind : std::uint8_t { bytes, sums, depths };

// A texture with a framebuffer that draws into it.
class DrawnTexture {
 public:
  // Binds the framebuffer. Makes the texture anew if its size differs.
  void bind(vtkOpenGLRenderWindow* window, int width, int height, PixelKind kind);
  vtkOpenGLFramebufferObject* framebuffer() { return framebuffer_; }
  vtkTextureObject* texture() { return texture_; }
  void release(vtkWindow* window);

 private:
  vtkNew<vtkOpenGLFramebufferObject> framebuffer_;
  vtkNew<vtkTextureObject> texture_;
};

// A depth texture with a framebuffer that draws into it.
class DrawnDepths {
 public:
  // Binds the framebuffer and clears it to the farthest depth.
  void bind(vtkOpenGLRenderWindow* window, int width, int height);
  vtkTextureObject* texture() { return texture_; }
  void release(vtkWindow* window);

 private:
  vtkNew<vtkOpenGLFramebufferObject> framebuffer_;
  vtkNew<vtkTextureObject> texture_;
};

// A fragment shader that runs over the whole picture.
class QuadProgram {
 public:
  // Returns the program, bound and ready for uniforms and Render(). The first call compiles the
  // source that `shader` returns. Null if it does not compile.
  vtkOpenGLQuadHelper* use(vtkOpenGLRenderWindow* window,
                           const std::function<std::string()>& shader);
  void release() { quad_.reset(); }

 private:
  std::unique_ptr<vtkOpenGLQuadHelper> quad_;
};

// While this object exists: no depth test, no blending, no scissors, and a viewport of this size
// (pixels).
class DrawsQuads {
 public:
  DrawsQuads(vtkOpenGLState* state, int width, int height);
  DrawsQuads(const DrawsQuads&) = delete;
  DrawsQuads& operator=(const DrawsQuads&) = delete;

 private:
  vtkOpenGLState::ScopedglEnableDisable blend_, depth_test_, scissor_test_, cull_;
  vtkOpenGLState::ScopedglViewport viewport_;
  vtkOpenGLState::ScopedglDepthMask depth_mask_;
  vtkOpenGLState::ScopedglBlendFuncSeparate blend_function_;
};

}  // namespace alphascope
