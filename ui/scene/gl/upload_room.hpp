// The way of large content to the GPU. No VTK.
#pragma once

#include <cstddef>

struct __GLsync;

namespace alphascope {

// Memory that the processor writes and the GPU reads, kept from one upload to the next. Left to
// itself the driver takes new memory for each upload, twice as much as the content (NVIDIA's 580),
// and that takes longer than the copy. This belongs to an OpenGL context, which must be current
// whenever it is used.
class UploadRoom {
 public:
  UploadRoom() = default;
  UploadRoom(const UploadRoom&) = delete;
  UploadRoom& operator=(const UploadRoom&) = delete;

  // Fills the buffer that is bound to `target`, an OpenGL name; it must have so many bytes. All
  // threads of the caller's task arena copy. False: this OpenGL has no such memory, or none left,
  // and the buffer is as it was.
  bool fill(unsigned target, const unsigned char* content, std::size_t bytes);
  void release();

 private:
  bool reserve(std::size_t bytes);

  unsigned buffer_ = 0;  // an OpenGL name
  unsigned char* memory_ = nullptr;
  std::size_t room_ = 0, used_ = 0;  // bytes; what is used may be on its way
  __GLsync* on_its_way_ = nullptr;   // passed when all of that has arrived
};

// By all threads of the caller's task arena, in pieces.
void copy_by_all_threads(const unsigned char* from, unsigned char* to, std::size_t bytes);

}  // namespace alphascope
