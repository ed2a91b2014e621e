// SPDX-License-Identifier: GPL-3.0-or-later
// The interface of a host, which shows the program's pictures and collects its input. A host is a
// window (GLFW) or a framebuffer without a display (EGL). It knows nothing of the pictures'
// content.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ui/window/input_queue.hpp"

namespace alphascope {

struct HostOptions {
  int width = 1440, height = 900;  // at scale 1
  double scale = 0;                // 0: scale of the display
  std::string title = "Alphascope";
  // Called with the factor on fonts and controls, before the window is made, which takes long.
  std::function<void(float scale)> scale_is_known = {};
};

struct HostSize {
  int width = 0, height = 0;  // pixels; 0 while minimised
  float scale = 1;            // factor on fonts and controls
};

// An OpenGL context beside the host's, so that another thread can draw. It is made and destroyed on
// the main thread. It is current on at most one thread, and on none at first.
class BackgroundContext {
 public:
  virtual ~BackgroundContext() = default;
  virtual void make_current() = 0;
  virtual void release() = 0;  // on the thread where the context is current
};

class Host {
 public:
  virtual ~Host() = default;

  virtual HostSize size() const = 0;
  // Requests another size (pixels).
  virtual void resize(int width, int height) = 0;
  // Sets the scale of fonts and controls to `scale` (0: that of the display) times `times`, from
  // the next frame on. The window keeps its size.
  virtual void set_scale(double scale, double times) = 0;
  virtual bool close_requested() const = 0;
  // Hides the window at the end of the program. The program may still have to wait for a job that
  // cannot be interrupted.
  virtual void hide() = 0;
  virtual void set_title(const std::string& title) = 0;
  // Waits for input, for wake() or for the timeout, then collects the input. A timeout of 0 does
  // not wait. Returns whether there may be something to do.
  virtual bool wait_events(double timeout_seconds) = 0;
  // Ends wait_events(). Other threads may call this function and no other.
  virtual void wake() = 0;
  virtual std::vector<std::filesystem::path> take_dropped_files() = 0;
  // Events of mouse and keyboard that no frame has got yet.
  InputQueue& input() { return input_; }

  // Makes the host's own context current; for the main thread.
  virtual void make_current() = 0;
  // Throws std::runtime_error if the driver has no further context.
  virtual std::unique_ptr<BackgroundContext> make_background_context() = 0;

  // ImGui's backend: connects to its current context, and hands over size, time and input before
  // each frame.
  virtual void start_imgui() = 0;
  virtual void stop_imgui() = 0;
  virtual void feed_imgui() = 0;

  // Binds the framebuffer of the frame and returns its OpenGL name.
  virtual unsigned bind_framebuffer() = 0;
  virtual void swap() = 0;

 protected:
  InputQueue input_;
};

// Throws std::runtime_error with a sentence for users if there is no display.
std::unique_ptr<Host> make_glfw_host(const HostOptions& options);

// Throws std::runtime_error if there is no OpenGL, not even in software.
std::unique_ptr<Host> make_egl_host(const HostOptions& options);

}  // namespace alphascope
