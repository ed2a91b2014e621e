// SPDX-License-Identifier: GPL-3.0-or-later
// A window through GLFW, with its OpenGL context. VTK's GLEW needs GLX, which is GLFW's default on
// X11.
#define GLFW_INCLUDE_GLCOREARB
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "ui/widgets/keys.hpp"
#include "ui/window/egl_context.hpp"
#include "ui/window/host.hpp"
#include "ui/window/software_context.hpp"
#include "ui/window/window_icon.hpp"

namespace alphascope {
namespace {

static_assert(key::kA == GLFW_KEY_A && key::kT == GLFW_KEY_T && key::kF1 == GLFW_KEY_F1 &&
              key::kEscape == GLFW_KEY_ESCAPE && key::kEnter == GLFW_KEY_ENTER &&
              key::kTab == GLFW_KEY_TAB && key::kBackspace == GLFW_KEY_BACKSPACE &&
              key::kDelete == GLFW_KEY_DELETE && key::kRight == GLFW_KEY_RIGHT &&
              key::kLeft == GLFW_KEY_LEFT && key::kUp == GLFW_KEY_UP &&
              key::kDown == GLFW_KEY_DOWN && key::kHome == GLFW_KEY_HOME &&
              key::kEnd == GLFW_KEY_END && key::kKeypadEnter == GLFW_KEY_KP_ENTER &&
              key::kInsert == GLFW_KEY_INSERT && key::kPageUp == GLFW_KEY_PAGE_UP &&
              key::kPageDown == GLFW_KEY_PAGE_DOWN && key::kSpace == GLFW_KEY_SPACE &&
              key::kMenu == GLFW_KEY_MENU && key::kV == GLFW_KEY_V && key::kZ == GLFW_KEY_Z &&
              key::kFirstKeypad == GLFW_KEY_KP_0);
static_assert(key::kLeftShift == GLFW_KEY_LEFT_SHIFT &&
              key::kLeftControl == GLFW_KEY_LEFT_CONTROL && key::kLeftAlt == GLFW_KEY_LEFT_ALT &&
              key::kLeftSuper == GLFW_KEY_LEFT_SUPER && key::kRightShift == GLFW_KEY_RIGHT_SHIFT &&
              key::kRightAlt == GLFW_KEY_RIGHT_ALT &&
              key::kRightControl == GLFW_KEY_RIGHT_CONTROL &&
              key::kRightSuper == GLFW_KEY_RIGHT_SUPER);

constexpr int kLeastWidth = 900, kLeastHeight = 600;  // at scale 1

std::string last_glfw_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "no reason given";
}

[[noreturn]] void fail(const std::string& what, const std::string& remedy) {
  throw std::runtime_error(what + " (" + last_glfw_error() + "). " + remedy +
                           ", or use --shot OUT.png to draw into a file without a display.");
}

// ImGui's cursors in its order; GLFW 3.3 has no diagonal ones.
constexpr std::array kCursors{GLFW_ARROW_CURSOR,   GLFW_IBEAM_CURSOR,   GLFW_ARROW_CURSOR,
                              GLFW_VRESIZE_CURSOR, GLFW_HRESIZE_CURSOR, GLFW_ARROW_CURSOR,
                              GLFW_ARROW_CURSOR,   GLFW_HAND_CURSOR,    GLFW_ARROW_CURSOR};
static_assert(kCursors.size() == ImGuiMouseCursor_COUNT);

float monitor_scale() {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  float x = 1, y = 1;
  if (monitor != nullptr) glfwGetMonitorContentScale(monitor, &x, &y);
  return std::max({1.0f, x, y});
}

class GlfwBackgroundContext final : public BackgroundContext {
 public:
  GlfwBackgroundContext() {
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);  // the other hints are still those of the window
    window_ = glfwCreateWindow(16, 16, "Alphascope", nullptr, nullptr);
    glfwWindowHint(GLFW_VISIBLE, GLFW_TRUE);
    if (window_ == nullptr) {
      throw std::runtime_error("OpenGL gave no second context to draw the picture in (" +
                               last_glfw_error() + "). Close other programs and try again.");
    }
  }
  ~GlfwBackgroundContext() override { glfwDestroyWindow(window_); }
  void make_current() override { glfwMakeContextCurrent(window_); }
  void release() override { glfwMakeContextCurrent(nullptr); }

 private:
  GLFWwindow* window_ = nullptr;
};

// A software context from EGL, beside GLFW's contexts from GLX. EGL cannot make it current while a
// GLX context is current on the thread, so that one is released first.
class QuietContextBesideGlx final : public BackgroundContext {
 public:
  void make_current() override {
    glfwMakeContextCurrent(nullptr);
    context_->make_current();
  }
  void release() override { context_->release(); }

 private:
  std::unique_ptr<BackgroundContext> context_ = make_software_context();
};

class GlfwHost final : public Host {
 public:
  explicit GlfwHost(const HostOptions& options) : fixed_scale_(static_cast<float>(options.scale)) {
    if (!glfwInit()) {
      fail("There is no display to open a window on", "Start the program in a graphical session");
    }
    const float scale = fixed_scale_ > 0 ? fixed_scale_ : monitor_scale();
    if (options.scale_is_known) options.scale_is_known(scale);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 2);
    // Not forward-compatible: such a context draws every line one pixel wide.
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_SAMPLES, 0);
    // Desktops find the program's entry by this name: StartupWMClass in resources/desktop.
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "alphascope");
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "alphascope");
    window_ = glfwCreateWindow(pixels(options.width, scale), pixels(options.height, scale),
                               options.title.c_str(), nullptr, nullptr);
    if (window_ == nullptr) {
      const std::string reason = "Cannot open a window with OpenGL 3.2";
      try {
        fail(reason,
             "Install a newer driver of the graphics card, set LIBGL_ALWAYS_SOFTWARE=1 to draw on "
             "the CPU");
      } catch (...) {
        glfwTerminate();
        throw;
      }
    }
    glfwSetWindowUserPointer(window_, this);
    set_icon();
    if (const float dense = density(); dense > 1) {  // GLFW measures this window in points, not in
                                                     // pixels
      resize(pixels(options.width, scale), pixels(options.height, scale));
    }
    limit_size();
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
      for (int i = 0; i < count; ++i) of(w).dropped_.emplace_back(paths[i]);
    });
    note_window_events();
    queue_input();
  }

  ~GlfwHost() override {
    for (GLFWcursor* cursor : cursors_) {
      if (cursor != nullptr) glfwDestroyCursor(cursor);
    }
    glfwDestroyWindow(window_);
    glfwTerminate();
  }

  HostSize size() const override {
    HostSize size;
    glfwGetFramebufferSize(window_, &size.width, &size.height);
    size.scale = scale();
    return size;
  }

  void resize(int width, int height) override {
    const float dense = density();
    glfwSetWindowSize(window_, pixels(width, 1 / dense), pixels(height, 1 / dense));
  }
  void set_scale(double scale, double times) override {
    fixed_scale_ = static_cast<float>(scale);
    times_ = static_cast<float>(times);
    limit_size();
  }
  bool close_requested() const override { return glfwWindowShouldClose(window_); }
  void hide() override {
    glfwHideWindow(window_);
    glfwPollEvents();  // sends the request to the display
  }
  void set_title(const std::string& title) override { glfwSetWindowTitle(window_, title.c_str()); }

  bool wait_events(double timeout_seconds) override {
    something_ = false;
    if (timeout_seconds <= 0) {
      glfwPollEvents();
    } else {
      glfwWaitEventsTimeout(timeout_seconds);
    }
    return woken_.exchange(false) || something_ || input_.waiting() || !dropped_.empty();
  }

  void wake() override {
    woken_ = true;
    glfwPostEmptyEvent();
  }

  std::vector<std::filesystem::path> take_dropped_files() override {
    return std::exchange(dropped_, {});
  }

  void make_current() override { glfwMakeContextCurrent(window_); }
  std::unique_ptr<BackgroundContext> make_background_context() override {
    if (draws_in_software()) return std::make_unique<QuietContextBesideGlx>();
    return std::make_unique<GlfwBackgroundContext>();
  }

  void start_imgui() override {
    ImGuiIO& io = ImGui::GetIO();
    io.BackendPlatformName = "alphascope_glfw";
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
    io.ClipboardUserData = window_;
    io.SetClipboardTextFn = [](void* window, const char* text) {
      glfwSetClipboardString(static_cast<GLFWwindow*>(window), text);
    };
    io.GetClipboardTextFn = [](void* window) {
      return glfwGetClipboardString(static_cast<GLFWwindow*>(window));
    };
    for (std::size_t i = 0; i < cursors_.size(); ++i) {
      cursors_[i] = glfwCreateStandardCursor(kCursors[i]);
    }
  }

  void stop_imgui() override {}

  void feed_imgui() override {
    ImGuiIO& io = ImGui::GetIO();
    const HostSize now = size();
    io.DisplaySize = {static_cast<float>(now.width), static_cast<float>(now.height)};
    input_.feed(glfwGetTime());
    const int wanted = std::clamp<int>(ImGui::GetMouseCursor(), 0, ImGuiMouseCursor_COUNT - 1);
    if (wanted == cursor_) return;
    cursor_ = wanted;
    glfwSetCursor(window_, cursors_[static_cast<std::size_t>(wanted)]);
  }

  unsigned bind_framebuffer() override { return 0; }
  void swap() override { glfwSwapBuffers(window_); }

 private:
  void set_icon() {
    std::vector<IconPicture> pictures = window_icon();
    std::vector<GLFWimage> images;
    images.reserve(pictures.size());
    for (IconPicture& picture : pictures) {
      images.push_back({picture.width, picture.height, picture.rgba.data()});
    }
    glfwSetWindowIcon(window_, static_cast<int>(images.size()), images.data());
  }

  static int pixels(int at_scale_1, float scale) {
    return static_cast<int>(std::lround(static_cast<float>(at_scale_1) * scale));
  }

  static GlfwHost& of(GLFWwindow* window) {
    return *static_cast<GlfwHost*>(glfwGetWindowUserPointer(window));
  }
  static void note(GLFWwindow* window) { of(window).something_ = true; }
  static void push(GLFWwindow* window, InputEvent event) {
    event.seconds = glfwGetTime();
    of(window).input_.push(event);
  }

  // Returns the scale of fonts and controls. Without a fixed scale, the monitor's scale counts.
  float scale() const {
    if (fixed_scale_ > 0) return fixed_scale_ * times_;
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::max({1.0f, x, y}) * times_;
  }

  // Returns the number of pixels in a unit of GLFW's sizes and positions; 1 on X11.
  float density() const {
    int points = 0, width = 0;
    glfwGetWindowSize(window_, &points, nullptr);
    glfwGetFramebufferSize(window_, &width, nullptr);
    return points > 0 && width > 0 ? static_cast<float>(width) / static_cast<float>(points) : 1;
  }

  // Sets the least size of the window. A scale that the user has chosen does not raise it, since
  // the window could then exceed the screen.
  void limit_size() {
    density_ = density();
    const float points = std::min(scale(), monitor_scale()) / density_;
    glfwSetWindowSizeLimits(window_, pixels(kLeastWidth, points), pixels(kLeastHeight, points),
                            GLFW_DONT_CARE, GLFW_DONT_CARE);
  }

  void note_window_events() {
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { note(w); });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) {
      of(w).density_ = of(w).density();
      note(w);
    });
    glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* w, float, float) {
      of(w).limit_size();
      note(w);
    });
  }

  void queue_input() {
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int focused) {
      push(w, {.kind = InputEvent::Kind::focus, .down = focused != 0});
    });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int entered) {
      if (entered == 0) push(w, {.kind = InputEvent::Kind::leave});
    });
    glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
      const float dense = of(w).density_;
      push(w, {.x = static_cast<float>(x) * dense, .y = static_cast<float>(y) * dense});
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) {
      push(w, {.kind = InputEvent::Kind::button, .code = button, .down = action == GLFW_PRESS});
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) {
      push(w, {.kind = InputEvent::Kind::wheel,
               .x = static_cast<float>(x),
               .y = static_cast<float>(y)});
    });
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int) {
      if (action == GLFW_REPEAT) return;  // ImGui repeats keys itself
      push(w, {.kind = InputEvent::Kind::key, .code = key, .down = action == GLFW_PRESS});
    });
    glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned character) {
      push(w, {.kind = InputEvent::Kind::text, .character = character});
    });
  }

  GLFWwindow* window_ = nullptr;
  float fixed_scale_;
  float times_ = 1;  // factor on fixed_scale_ or the monitor's scale
  float density_ = 1;
  std::array<GLFWcursor*, ImGuiMouseCursor_COUNT> cursors_{};
  int cursor_ = 0;
  bool something_ = false;
  std::atomic<bool> woken_ = false;
  std::vector<std::filesystem::path> dropped_;
};

}  // namespace

std::unique_ptr<Host> make_glfw_host(const HostOptions& options) {
  return std::make_unique<GlfwHost>(options);
}

}  // namespace alphascope
