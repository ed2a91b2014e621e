// A real window through GLFW, with its OpenGL context. VTK's GLEW wants GLX, GLFW's default on X11.
#define GLFW_INCLUDE_GLCOREARB
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "ui/panels/keys.hpp"
#include "ui/window/host.hpp"

namespace alphascope {
namespace {

static_assert(key::kA == GLFW_KEY_A && key::kT == GLFW_KEY_T && key::kF1 == GLFW_KEY_F1 &&
              key::kEscape == GLFW_KEY_ESCAPE && key::kEnter == GLFW_KEY_ENTER &&
              key::kTab == GLFW_KEY_TAB && key::kBackspace == GLFW_KEY_BACKSPACE &&
              key::kDelete == GLFW_KEY_DELETE && key::kRight == GLFW_KEY_RIGHT &&
              key::kLeft == GLFW_KEY_LEFT && key::kUp == GLFW_KEY_UP &&
              key::kDown == GLFW_KEY_DOWN && key::kHome == GLFW_KEY_HOME &&
              key::kEnd == GLFW_KEY_END && key::kPageUp == GLFW_KEY_PAGE_UP &&
              key::kPageDown == GLFW_KEY_PAGE_DOWN && key::kKeypadEnter == GLFW_KEY_KP_ENTER);

constexpr int kLeastWidth = 900, kLeastHeight = 600;  // at scale 1

std::string last_glfw_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "no reason given";
}

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(what + " (" + last_glfw_error() +
                           "). Start the program in a graphical session, or use --shot OUT.png "
                           "to draw into a file without a display.");
}

float monitor_scale() {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  float x = 1, y = 1;
  if (monitor != nullptr) glfwGetMonitorContentScale(monitor, &x, &y);
  return std::max({1.0f, x, y});
}

class GlfwBackgroundContext final : public BackgroundContext {
 public:
  GlfwBackgroundContext() {
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);  // the other hints stay those of the window
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

class GlfwHost final : public Host {
 public:
  explicit GlfwHost(const HostOptions& options) : fixed_scale_(static_cast<float>(options.scale)) {
    if (!glfwInit()) fail("There is no display to open a window on");
    const float scale = fixed_scale_ > 0 ? fixed_scale_ : monitor_scale();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 2);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SAMPLES, 0);
    window_ = glfwCreateWindow(pixels(options.width, scale), pixels(options.height, scale),
                               options.title.c_str(), nullptr, nullptr);
    if (window_ == nullptr) {
      const std::string reason = "Cannot open a window with OpenGL 3.2";
      try {
        fail(reason);
      } catch (...) {
        glfwTerminate();
        throw;
      }
    }
    glfwSetWindowSizeLimits(window_, pixels(kLeastWidth, scale), pixels(kLeastHeight, scale),
                            GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(window_, this);
    glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
      auto* self = static_cast<GlfwHost*>(glfwGetWindowUserPointer(w));
      for (int i = 0; i < count; ++i) self->dropped_.emplace_back(paths[i]);
    });
    note_events();
  }

  ~GlfwHost() override {
    glfwDestroyWindow(window_);
    glfwTerminate();
  }

  HostSize size() const override {
    HostSize size;
    glfwGetFramebufferSize(window_, &size.width, &size.height);
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    size.scale = fixed_scale_ > 0 ? fixed_scale_ : std::max({1.0f, x, y});
    return size;
  }

  void resize(int width, int height) override { glfwSetWindowSize(window_, width, height); }
  bool close_requested() const override { return glfwWindowShouldClose(window_); }
  void set_title(const std::string& title) override { glfwSetWindowTitle(window_, title.c_str()); }

  bool wait_events(double timeout_seconds) override {
    something_ = false;
    if (timeout_seconds <= 0) {
      glfwPollEvents();
    } else {
      glfwWaitEventsTimeout(timeout_seconds);
    }
    return woken_.exchange(false) || something_ || !dropped_.empty();
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
    return std::make_unique<GlfwBackgroundContext>();
  }

  void start_imgui() override { ImGui_ImplGlfw_InitForOpenGL(window_, true); }
  void stop_imgui() override { ImGui_ImplGlfw_Shutdown(); }
  void feed_imgui() override { ImGui_ImplGlfw_NewFrame(); }

  unsigned bind_framebuffer() override { return 0; }
  void swap() override { glfwSwapBuffers(window_); }

 private:
  static int pixels(int at_scale_1, float scale) {
    return static_cast<int>(std::lround(static_cast<float>(at_scale_1) * scale));
  }

  static void note(GLFWwindow* window) {
    static_cast<GlfwHost*>(glfwGetWindowUserPointer(window))->something_ = true;
  }

  // Before ImGui installs its callbacks: it calls these first.
  void note_events() {
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { note(w); });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { note(w); });
    glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* w, float, float) { note(w); });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int) { note(w); });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int) { note(w); });
    glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double, double) { note(w); });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int, int, int) { note(w); });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double) { note(w); });
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int, int, int, int) { note(w); });
    glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned) { note(w); });
  }

  GLFWwindow* window_ = nullptr;
  float fixed_scale_;
  bool something_ = false;
  std::atomic<bool> woken_ = false;
  std::vector<std::filesystem::path> dropped_;
};

}  // namespace

std::unique_ptr<Host> make_glfw_host(const HostOptions& options) {
  return std::make_unique<GlfwHost>(options);
}

}  // namespace alphascope
