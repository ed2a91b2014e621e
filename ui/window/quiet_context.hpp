// An OpenGL context in software for work in the background of a window: with threads of its own,
// which give way to the window's.
#pragma once

#include <memory>

#include "ui/window/host.hpp"

namespace alphascope {

// Mesa's software driver has one pool of threads for each display, and one context's picture waits
// until the other's is done. This context is of a display of its own, and so is its pool. Another
// context that is current on this thread stays current. Throws std::runtime_error when there is no
// EGL.
std::unique_ptr<BackgroundContext> make_quiet_context();

}  // namespace alphascope
