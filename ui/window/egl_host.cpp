// SPDX-License-Identifier: GPL-3.0-or-later
// A window without a display: a framebuffer in an EGL context. Its input comes from scripts, or
// from code that fills its queue.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <imgui.h>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>

#include "ui/window/egl_context.hpp"
#include "ui/window/host.hpp"

namespace alphascope {
namespace {

class EglBackgroundContext final : public BackgroundContext {
 public:
  EglBackgroundContext() { context_.release(); }
  void make_current() override { context_.make_current(); }
  void release() override { context_.release(); }

 private:
  EglContext context_;
};

class EglHost final : public Host {
 public:
  explicit EglHost(const HostOptions& options)
      : scale_(options.scale > 0 ? static_cast<float>(options.scale) : 1.0f) {
    glGenFramebuffers(1, &framebuffer_);
    glGenTextures(1, &colour_);
    resize(static_cast<int>(std::lround(static_cast<float>(options.width) * scale_)),
           static_cast<int>(std::lround(static_cast<float>(options.height) * scale_)));
  }

  ~EglHost() override {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteTextures(1, &colour_);
  }

  HostSize size() const override { return {width_, height_, scale_}; }

  void resize(int width, int height) override {
    width_ = width;
    height_ = height;
    glBindTexture(GL_TEXTURE_2D, colour_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
  }

  void set_scale(double scale, double times) override {
    scale_ = static_cast<float>((scale > 0 ? scale : 1) * times);
  }
  bool close_requested() const override { return false; }
  void hide() override {}
  void set_title(const std::string&) override {}

  bool wait_events(double timeout_seconds) override {
    std::unique_lock lock(mutex_);
    const bool woken = wake_.wait_for(lock, std::chrono::duration<double>(timeout_seconds),
                                      [this] { return woken_; });
    woken_ = false;
    return woken;
  }

  void wake() override {
    {
      const std::lock_guard lock(mutex_);
      woken_ = true;
    }
    wake_.notify_one();
  }

  std::vector<std::filesystem::path> take_dropped_files() override { return {}; }

  void make_current() override { context_.make_current(); }
  std::unique_ptr<BackgroundContext> make_background_context() override {
    auto context = std::make_unique<EglBackgroundContext>();
    make_current();  // the new context has made itself current
    return context;
  }

  void start_imgui() override {}
  void stop_imgui() override {}
  void feed_imgui() override {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width_), static_cast<float>(height_)};
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    input_.feed(std::chrono::duration<double>(now).count());
  }

  unsigned bind_framebuffer() override {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    return framebuffer_;
  }
  void swap() override { glFinish(); }

 private:
  EglContext context_;
  float scale_;
  int width_ = 0, height_ = 0;
  unsigned framebuffer_ = 0, colour_ = 0;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool woken_ = false;
};

}  // namespace

std::unique_ptr<Host> make_egl_host(const HostOptions& options) {
  return std::make_unique<EglHost>(options);
}

}  // namespace alphascope
