// The way of large content to the GPU. No VTK.
#pragma once

#include <cstddef>

struct __GLsync;

namespace alphascope {

// Memory that the processor writes and the GPU reads. Through it the driver takes none: its own way
// takes as much as the content twice, anew each time, and that takes longer than the copy. What is
// here belongs to an OpenGL context, which must be current whenever this is used.
class UploadRoom {
 public:
  UploadRoom() = default;
  UploadRoom(const UploadRoom&) = delete;
  UploadRoom& operator=(const UploadRoom&) = delete;

  // Fills the buffer that is bound to `target`, an OpenGL name, and as large as this; by all
  // threads of the caller's task arena. False: this OpenGL cannot, or has no memory left, and
  // nothing was done.
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
