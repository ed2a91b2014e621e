// SPDX-License-Identifier: GPL-3.0-or-later
// An OpenGL context that needs no display (EGL on Mesa's surfaceless platform), for screenshots and
// tests. It has no framebuffer; the caller must make one.
#pragma once

#include <memory>

namespace alphascope {

class EglContext {
 public:
  // Makes a core context of OpenGL 3.2 or newer current on this thread. Throws std::runtime_error
  // that names the failed step and the missing package.
  EglContext();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void make_current();
  void release();  // on the thread where the context is current

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

// Whether the current context draws in software (llvmpipe or softpipe).
bool draws_in_software();

}  // namespace alphascope
