// SPDX-License-Identifier: GPL-3.0-or-later
// Measures with OpenGL's timestamp queries.
#include "ui/scene/gl/picture_timer.hpp"

#include <GL/gl.h>
#include <GL/glext.h>

#include "ui/scene/gl/opengl_feature.hpp"

namespace alphascope {
namespace {

bool has_a_clock() {
  if (!has_opengl(3, 3, "GL_ARB_timer_query")) return false;
  GLint bits = 0;
  glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
  return bits > 0;
}

}  // namespace

bool PictureTimer::start() {
  if (query_ == 0 && !has_a_clock()) return false;
  if (query_ == 0) glGenQueries(1, &query_);
  GLint64 now = 0;
  glGetInteger64v(GL_TIMESTAMP, &now);
  begun_ = now;
  return true;
}

void PictureTimer::stop() {
  glQueryCounter(query_, GL_TIMESTAMP);
  running_ = true;
}

std::optional<double> PictureTimer::take_milliseconds(bool wait) {
  if (!running_) return std::nullopt;
  if (!wait) {
    GLint there = 0;
    glGetQueryObjectiv(query_, GL_QUERY_RESULT_AVAILABLE, &there);
    if (there == 0) return std::nullopt;
  }
  GLuint64 ended = 0;
  glGetQueryObjectui64v(query_, GL_QUERY_RESULT, &ended);
  running_ = false;
  return static_cast<double>(static_cast<std::int64_t>(ended) - begun_) / 1e6;
}

}  // namespace alphascope
