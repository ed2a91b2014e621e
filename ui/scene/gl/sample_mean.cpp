// SPDX-License-Identifier: GPL-3.0-or-later
// Positions of samples in a pixel, and their sum and mean in textures.
#include "ui/scene/gl/sample_mean.hpp"

#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstdint>

#include "core/geometry/alpha.hpp"
#include "ui/scene/gl/sample_place.hpp"
#include "ui/scene/scene.hpp"

namespace alphascope {
namespace {

constexpr const char* kScaled = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 texCoord;
uniform sampler2D colours;
uniform float scale;
void main() {
  gl_FragData[0] = scale * texelFetch(colours, ivec2(gl_FragCoord.xy), 0);
}
)";

// The bits of `k` in reverse order, behind the binary point.
double reversed(unsigned k) {
  double value = 0;
  for (double digit = 0.5; k != 0; k >>= 1, digit /= 2) value += digit * (k & 1);
  return value;
}

}  // namespace

// The first two dimensions of Sobol's sequence. I. M. Sobol, USSR Comput. Math. Math. Phys. 7
// (1967) 86-112.
std::array<double, 2> sample_place(int k) {
  double up = 0;
  unsigned direction = 8, bits = 0;
  for (auto rest = static_cast<unsigned>(k); rest != 0; rest >>= 1) {
    if (rest & 1) bits ^= direction;
    direction ^= direction >> 1;
  }
  up = bits / 16.0;
  const double middle = 0.5 - 0.5 / kMostSamples;
  return {reversed(static_cast<unsigned>(k)) - middle, up - middle};
}

void SampleMean::draw(vtkOpenGLRenderWindow* window, vtkTextureObject* from, float scale) {
  vtkOpenGLQuadHelper* quad = program_.use(window, [] { return kScaled; });
  if (quad == nullptr) return;
  from->Activate();
  quad->Program->SetUniformi("colours", from->GetTextureUnit());
  quad->Program->SetUniformf("scale", scale);
  quad->Render();
  from->Deactivate();
}

void SampleMean::add(vtkOpenGLRenderWindow* window, int width, int height) {
  if (!is_of(width, height)) forget();
  width_ = width;
  height_ = height;
  vtkOpenGLState* state = window->GetState();
  const DrawsQuads quads(state, width, height);
  state->PushFramebufferBindings();
  sum_.bind(window, width, height, PixelKind::sums);
  if (count_ > 0) {
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFunc(GL_ONE, GL_ONE);
  }
  draw(window, window->GetDisplayFramebuffer()->GetColorAttachmentAsTextureObject(0), 1);
  state->PopFramebufferBindings();
  ++count_;
}

vtkOpenGLFramebufferObject* SampleMean::resolve(vtkOpenGLRenderWindow* window) {
  vtkOpenGLState* state = window->GetState();
  const DrawsQuads quads(state, width_, height_);
  state->PushFramebufferBindings();
  picture_.bind(window, width_, height_, PixelKind::bytes);
  draw(window, sum_.texture(), 1.0f / static_cast<float>(count_));
  state->PopFramebufferBindings();
  return picture_.framebuffer();
}

void SampleMean::release(vtkWindow* window) {
  forget();
  program_.release();
  sum_.release(window);
  picture_.release(window);
}

}  // namespace alphascope
