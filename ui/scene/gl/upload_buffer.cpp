// SPDX-License-Identifier: GPL-3.0-or-later
// Copies with all threads into a mapped buffer, from which the GPU copies to the final one.
#include "ui/scene/gl/upload_buffer.hpp"

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "core/run/parallel.hpp"
#include "ui/scene/gl/opengl_feature.hpp"

namespace alphascope {

void copy_by_all_threads(const unsigned char* from, unsigned char* to, std::size_t bytes) {
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  parallel_each(0, (bytes + kPiece - 1) / kPiece, [&](std::size_t piece) {
    const std::size_t at = piece * kPiece;
    std::memcpy(to + at, from + at, std::min(kPiece, bytes - at));
  });
}

bool UploadBuffer::fill(unsigned target, const unsigned char* content, std::size_t bytes) {
  if (copies_pending_ != nullptr && used_ + bytes > room_) {
    constexpr GLuint64 kForever = std::numeric_limits<GLuint64>::max();
    glClientWaitSync(copies_pending_, GL_SYNC_FLUSH_COMMANDS_BIT, kForever);
    used_ = 0;
  }
  if (bytes > room_ && !reserve(bytes)) return false;
  copy_by_all_threads(content, memory_ + used_, bytes);
  glBindBuffer(GL_COPY_READ_BUFFER, buffer_);
  glCopyBufferSubData(GL_COPY_READ_BUFFER, target, static_cast<GLintptr>(used_), 0,
                      static_cast<GLsizeiptr>(bytes));
  glBindBuffer(GL_COPY_READ_BUFFER, 0);
  used_ += bytes;
  if (copies_pending_ != nullptr) glDeleteSync(copies_pending_);
  copies_pending_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  return true;
}

// Reserves a quarter more than requested, because the drawing grows and shrinks with alpha.
bool UploadBuffer::reserve(std::size_t bytes) {
  release();
  if (!has_opengl(4, 4, "GL_ARB_buffer_storage"))
    return false;  // provides memory that stays
                   // mapped
  const std::size_t room = bytes + bytes / 4;
  constexpr GLbitfield kHow = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  const auto size = static_cast<GLsizeiptr>(room);
  glGenBuffers(1, &buffer_);
  glBindBuffer(GL_COPY_READ_BUFFER, buffer_);
  glBufferStorage(GL_COPY_READ_BUFFER, size, nullptr, kHow | GL_CLIENT_STORAGE_BIT);
  void* const memory = glMapBufferRange(GL_COPY_READ_BUFFER, 0, size, kHow);
  glBindBuffer(GL_COPY_READ_BUFFER, 0);
  memory_ = static_cast<unsigned char*>(memory);
  if (memory_ == nullptr) {
    for (int n = 0; n < 8 && glGetError() != GL_NO_ERROR; ++n) {  // clears the error
    }
    release();
    return false;
  }
  room_ = room;
  return true;
}

// The driver keeps the buffer until the copies that use it are done.
void UploadBuffer::release() {
  if (copies_pending_ != nullptr) glDeleteSync(copies_pending_);
  if (buffer_ != 0) glDeleteBuffers(1, &buffer_);
  copies_pending_ = nullptr;
  buffer_ = 0;
  memory_ = nullptr;
  room_ = used_ = 0;
}

}  // namespace alphascope
