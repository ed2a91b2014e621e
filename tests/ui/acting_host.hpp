// SPDX-License-Identifier: GPL-3.0-or-later
// A window without a display in which a user acts in real time. Events come while the program waits
// or draws, waits take real time, and frames are drawn only when the program wants them.
#pragma once

#include <imgui.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "ui/window/host.hpp"

namespace alphascope::testing {

class ActingHost final : public Host {
 public:
  using Clock = std::chrono::steady_clock;
  struct Act {
    double at = 0;                // seconds since the first frame
    std::function<void()> event;  // on the main thread, as GLFW's callbacks
  };

  explicit ActingHost(const HostOptions& options) : inner_(make_egl_host(options)) {}

  // Acts for the next run(), which ends `seconds` after it began.
  void play(std::vector<Act> acts, double seconds) {
    acts_ = std::move(acts);
    next_ = 0;
    seconds_ = seconds;
    frames = 0;
    start_ = Clock::now();
  }
  void push(InputEvent event) {
    event.seconds = now();
    input_.push(event);
  }
  void tap(int code) {
    push({.kind = InputEvent::Kind::key, .code = code, .down = true});
    push({.kind = InputEvent::Kind::key, .code = code, .down = false});
  }
  void press(bool down) { push({.kind = InputEvent::Kind::button, .code = 0, .down = down}); }
  void move(float x, float y) { push({.x = x, .y = y}); }
  double played() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  int frames = 0;
  std::chrono::milliseconds frame_time{0};  // time to show a picture, as on a slow machine
  std::function<void()> after_frame;

  HostSize size() const override { return inner_->size(); }
  void resize(int width, int height) override { inner_->resize(width, height); }
  void set_scale(double scale, double times) override { inner_->set_scale(scale, times); }
  void hide() override {}
  bool close_requested() const override {
    return played() > seconds_ && next_ == acts_.size() && !input_.waiting();
  }
  void set_title(const std::string&) override {}
  bool wait_events(double timeout_seconds) override {
    const double end = played() + timeout_seconds;
    for (bool something = false;;) {
      for (; next_ < acts_.size() && acts_[next_].at <= played(); ++next_) {
        acts_[next_].event();
        something = true;
      }
      if (something || inner_->wait_events(0.002)) return true;
      if (played() >= end || played() > seconds_) return false;
    }
  }
  void wake() override { inner_->wake(); }
  std::vector<std::filesystem::path> take_dropped_files() override {
    return std::exchange(dropped, {});
  }
  std::vector<std::filesystem::path> dropped;
  void make_current() override { inner_->make_current(); }
  std::unique_ptr<BackgroundContext> make_background_context() override {
    return inner_->make_background_context();
  }
  void start_imgui() override {}
  void stop_imgui() override {}
  void feed_imgui() override {
    const HostSize s = size();
    ImGui::GetIO().DisplaySize = {static_cast<float>(s.width), static_cast<float>(s.height)};
    input_.feed(now());
  }
  unsigned bind_framebuffer() override { return inner_->bind_framebuffer(); }
  void swap() override {
    inner_->swap();
    ++frames;
    std::this_thread::sleep_for(frame_time);
    if (after_frame) after_frame();
  }

 private:
  static double now() {
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
  }

  std::unique_ptr<Host> inner_;
  std::vector<Act> acts_;
  std::size_t next_ = 0;
  double seconds_ = 0;
  Clock::time_point start_ = Clock::now();
};

}  // namespace alphascope::testing
