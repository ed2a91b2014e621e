// Where the program's pictures go and its input comes from: a real window (GLFW) or a framebuffer
// without any display (EGL). Knows nothing of what is drawn.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ui/window/input_queue.hpp"

namespace alphascope {

struct HostOptions {
  int width = 1440, height = 900;  // at scale 1
  double scale = 0;                // 0: as the display says
  std::string title = "Alphascope";
};

struct HostSize {
  int width = 0, height = 0;  // pixels; 0 while minimised
  float scale = 1;            // of fonts and controls
};

// An OpenGL context beside the host's, for another thread to draw in. Made and destroyed on the
// main thread; current on one thread at a time, on none at first.
class BackgroundContext {
 public:
  virtual ~BackgroundContext() = default;
  virtual void make_current() = 0;
  virtual void release() = 0;  // by the thread that it is current on
};

class Host {
 public:
  virtual ~Host() = default;

  virtual HostSize size() const = 0;
  // Asks for another size, in pixels.
  virtual void resize(int width, int height) = 0;
  // Of fonts and controls, from the next frame on; 0: as the display says. `times` as large as
  // that. The window stays as large as it is.
  virtual void set_scale(double scale, double times) = 0;
  virtual bool close_requested() const = 0;
  // For the end of the program, which may wait for work that cannot be interrupted.
  virtual void hide() = 0;
  virtual void set_title(const std::string& title) = 0;
  // Waits for input, wake() or the timeout, then takes in what arrived; 0 only takes in. Returns
  // whether there may have been something.
  virtual bool wait_events(double timeout_seconds) = 0;
  // Ends a wait_events(). The only function that other threads may call.
  virtual void wake() = 0;
  virtual std::vector<std::filesystem::path> take_dropped_files() = 0;
  // What the mouse and the keyboard did and no frame has been told yet.
  InputQueue& input() { return input_; }

  // The context that the host's pictures are drawn in, on the main thread.
  virtual void make_current() = 0;
  // Throws std::runtime_error when the driver has no more.
  virtual std::unique_ptr<BackgroundContext> make_background_context() = 0;

  // ImGui's side: connect to the current context, feed size, time and input before each frame.
  virtual void start_imgui() = 0;
  virtual void stop_imgui() = 0;
  virtual void feed_imgui() = 0;

  // Binds the framebuffer that the frame is drawn into; its OpenGL name.
  virtual unsigned bind_framebuffer() = 0;
  virtual void swap() = 0;

 protected:
  InputQueue input_;
};

// Throws std::runtime_error with a sentence for people when there is no display.
std::unique_ptr<Host> make_glfw_host(const HostOptions& options);

// Throws std::runtime_error when not even software OpenGL is there.
std::unique_ptr<Host> make_egl_host(const HostOptions& options);

}  // namespace alphascope
