// An OpenGL context that needs no display (EGL on Mesa's surfaceless platform), for screenshots and
// tests. Holds no framebuffer: whoever draws brings one.
#pragma once

#include <memory>

namespace alphascope {

class EglContext {
 public:
  // Makes a core context of OpenGL 3.2 or newer current on this thread. Throws std::runtime_error
  // that says which step failed and which package is missing.
  EglContext();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void make_current();
  void release();  // by the thread that it is current on

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

// The current context, whichever it is, draws in software.
bool draws_in_software();

}  // namespace alphascope
