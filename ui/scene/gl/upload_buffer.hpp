// SPDX-License-Identifier: GPL-3.0-or-later
// Memory for uploads of large content to the GPU. No VTK.
#pragma once

#include <cstddef>

struct __GLsync;

namespace alphascope {

// Memory that the processor writes and the GPU reads. It is kept from one upload to the next. On
// its own, the driver (NVIDIA's 580) allocates memory of twice the content for each upload. That
// takes longer than the copy. An UploadBuffer belongs to an OpenGL context, which must be current
// in each call.
class UploadBuffer {
 public:
  UploadBuffer() = default;
  UploadBuffer(const UploadBuffer&) = delete;
  UploadBuffer& operator=(const UploadBuffer&) = delete;

  // Fills the buffer bound to `target` (an OpenGL constant), which must have at least `bytes`
  // bytes. All threads of the caller's task arena copy. Returns false, and leaves the buffer as it
  // was, if OpenGL has no such memory or none left.
  bool fill(unsigned target, const unsigned char* content, std::size_t bytes);
  void release();

 private:
  bool reserve(std::size_t bytes);

  unsigned buffer_ = 0;  // an OpenGL name
  unsigned char* memory_ = nullptr;
  std::size_t room_ = 0, used_ = 0;     // bytes; used_ includes copies that are not finished
  __GLsync* copies_pending_ = nullptr;  // signalled when all copies are finished
};

// Copies in pieces of 1 MiB by all threads of the caller's task arena.
void copy_by_all_threads(const unsigned char* from, unsigned char* to, std::size_t bytes);

}  // namespace alphascope
