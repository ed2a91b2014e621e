// SPDX-License-Identifier: GPL-3.0-or-later
// An OpenGL context in software for background work of a window. Its threads give way to the
// window's.
#pragma once

#include <memory>

#include "ui/window/host.hpp"

namespace alphascope {

// Makes a context with a display of its own. Mesa's software driver has a pool of threads for each
// display. In one pool, a context waits until pictures of the other are finished. The thread's
// current context stays current. Throws std::runtime_error if there is no EGL.
std::unique_ptr<BackgroundContext> make_software_context();

}  // namespace alphascope
