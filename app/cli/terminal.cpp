#include "app/cli/terminal.hpp"

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <mutex>

namespace alphascope::cli {
namespace {

// A pointer, since a signal handler may touch no object under construction.
const CancelToken* interrupted = nullptr;

extern "C" void on_interrupt(int) {
  interrupted->cancel();  // a lock-free atomic store
}

class ProgressLine {
 public:
  void show(std::string_view stage, double share) {
    const std::lock_guard lock(mutex_);
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    std::fprintf(stderr, "\r\x1b[K%.*s %3.0f %%", static_cast<int>(stage.size()), stage.data(),
                 share * 100);
    shown_ = true;
  }
  void clear() {
    const std::lock_guard lock(mutex_);
    if (shown_) std::fputs("\r\x1b[K", stderr);
    shown_ = false;
  }

 private:
  std::mutex mutex_;
  // Nothing for quick work: a line that flashes up tells nobody anything.
  std::chrono::steady_clock::time_point next_ =
      std::chrono::steady_clock::now() + std::chrono::milliseconds(300);
  bool shown_ = false;
};

ProgressLine& progress_line() {
  static ProgressLine line;
  return line;
}

RunContext make_context() {
  RunContext context;
  if (::isatty(STDERR_FILENO) == 1) {
    context.progress = [](std::string_view stage, double share) {
      progress_line().show(stage, share);
    };
  }
  return context;
}

}  // namespace

const RunContext& run_context() {
  static const RunContext context = [] {
    static RunContext made = make_context();
    interrupted = &made.cancel;
    struct sigaction action {};
    action.sa_handler = on_interrupt;
    action.sa_flags = static_cast<int>(SA_RESETHAND);  // the second signal has its default effect
    ::sigaction(SIGINT, &action, nullptr);
    ::sigaction(SIGTERM, &action, nullptr);
    return made;
  }();
  return context;
}

void clear_progress() {
  progress_line().clear();
}

}  // namespace alphascope::cli
