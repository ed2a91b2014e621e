// What passes over the whole picture share: textures to draw into, programs, and OpenGL's state for
// it. For sources of the scene only.
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

// Four channels of 8 bits, or of floating-point numbers of 16 bits, in which samples add up; or
// depths.
enum class PixelKind : std::uint8_t { bytes, sums, depths };

// A texture of the size that is wanted, in a framebuffer.
class DrawnTexture {
 public:
  // Binds the framebuffer and makes the texture anew where it has another size.
  void bind(vtkOpenGLRenderWindow* window, int width, int height, PixelKind kind);
  vtkOpenGLFramebufferObject* framebuffer() { return framebuffer_; }
  vtkTextureObject* texture() { return texture_; }
  void release(vtkWindow* window);

 private:
  vtkNew<vtkOpenGLFramebufferObject> framebuffer_;
  vtkNew<vtkTextureObject> texture_;
};

// Depths of the size that is wanted, and nothing else.
class DrawnDepths {
 public:
  // Binds the framebuffer and clears it: nothing is nearer than the farthest.
  void bind(vtkOpenGLRenderWindow* window, int width, int height);
  vtkTextureObject* texture() { return texture_; }
  void release(vtkWindow* window);

 private:
  vtkNew<vtkOpenGLFramebufferObject> framebuffer_;
  vtkNew<vtkTextureObject> texture_;
};

// A fragment shader for the whole of a picture.
class QuadProgram {
 public:
  // In use, to be given its values and rendered. It is compiled on first use, from what `shader`
  // returns; null where it does not compile.
  vtkOpenGLQuadHelper* use(vtkOpenGLRenderWindow* window,
                           const std::function<std::string()>& shader);
  void release() { quad_.reset(); }

 private:
  std::unique_ptr<vtkOpenGLQuadHelper> quad_;
};

// While it is there: no depth, no blending, no scissors, and all of a target of this size.
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
