// SPDX-License-Identifier: GPL-3.0-or-later
// Tests buffers that carry arrays to the GPU.
#include "ui/scene/gl/upload_buffer.hpp"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <gtest/gtest.h>

#include <vector>

#include "ui/window/egl_context.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kMegabyte = std::size_t{1} << 20;

// Fills a buffer and reads it back.
std::vector<unsigned char> uploaded(UploadBuffer& room, const std::vector<unsigned char>& content) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_TEXTURE_BUFFER, buffer);
  const auto size = static_cast<GLsizeiptr>(content.size());
  glBufferData(GL_TEXTURE_BUFFER, size, nullptr, GL_STATIC_DRAW);
  EXPECT_TRUE(room.fill(GL_TEXTURE_BUFFER, content.data(), content.size()));
  std::vector<unsigned char> read(content.size(), 1);
  glGetBufferSubData(GL_TEXTURE_BUFFER, 0, size, read.data());
  glDeleteBuffers(1, &buffer);
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
  return read;
}

// The buffer grows. The next content is written behind content that is still being copied, or at
// the start when the buffer is full.
TEST(UploadBuffer, BringsEverythingToItsBuffer) {
  const EglContext context;
  UploadBuffer room;
  unsigned seed = 7;
  for (int time = 0; time < 2; ++time) {
    for (const std::size_t bytes : {5 * kMegabyte, kMegabyte + 3, 5 * kMegabyte, std::size_t{1},
                                    12 * kMegabyte + 17, 2 * kMegabyte, 2 * kMegabyte}) {
      std::vector<unsigned char> content(bytes);
      for (unsigned char& byte : content) {
        byte = static_cast<unsigned char>((seed = seed * 1664525 + 1013904223) >> 24);
      }
      EXPECT_TRUE(uploaded(room, content) == content) << bytes;
    }
    room.release();
  }
}

}  // namespace
}  // namespace alphascope
