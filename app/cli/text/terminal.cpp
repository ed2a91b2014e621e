// SPDX-License-Identifier: GPL-3.0-or-later
// Signals, the progress line, and a buffer of standard output that remembers errors.
#include "app/cli/text/terminal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "app/options/exit_code.hpp"
#include "app/session/clean_exit.hpp"
#include "core/files/atomic_file.hpp"

namespace alphascope::cli {
namespace {

// The buffer between std::cout and a descriptor. It keeps the error of a failed write.
class DescriptorBuffer : public std::streambuf {
 public:
  explicit DescriptorBuffer(int descriptor) : descriptor_(descriptor) { text_.reserve(kBytes); }
  int error() const { return error_; }  // errno of the first failure; 0: none

 protected:
  int_type overflow(int_type c) override {
    const char byte = traits_type::to_char_type(c);
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    return xsputn(&byte, 1) == 1 ? c : traits_type::eof();
  }
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    text_.append(text, static_cast<std::size_t>(size));
    return text_.size() < kBytes || sync() == 0 ? size : 0;
  }
  int sync() override {
    std::string_view rest = text_;
    while (!rest.empty() && error_ == 0) {
      const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
      if (written >= 0) {
        rest.remove_prefix(static_cast<std::size_t>(written));
      } else if (errno != EINTR) {
        error_ = errno;
      }
    }
    text_.clear();
    return error_ == 0 ? 0 : -1;
  }

 private:
  static constexpr std::size_t kBytes = 1 << 16;
  int descriptor_, error_ = 0;
  std::string text_;
};

// Never destroyed, since std::cout is flushed after all static objects are gone.
DescriptorBuffer& standard_output() {
  static auto& buffer = *new DescriptorBuffer(STDOUT_FILENO);
  return buffer;
}
DescriptorBuffer& standard_error() {
  static auto& buffer = *new DescriptorBuffer(STDERR_FILENO);
  return buffer;
}

Verbosity chosen_verbosity = Verbosity::normal;
bool chosen_times = true;

// A pointer, since a signal handler must not touch an object under construction. The token is never
// destroyed.
const CancelToken* interrupted = nullptr;
std::atomic<int> cancelling_signal{0};
constexpr unsigned kMostSeconds = 2;  // seconds from cancelling to the forced end

extern "C" void on_cancel(int signal) {
  int none = 0;
  if (cancelling_signal.compare_exchange_strong(none, signal)) {
    interrupted->cancel();  // a lock-free atomic store
    ::alarm(kMostSeconds);
  } else {
    kill_self_by(signal);
  }
}

// Ends the program if its work did not react to the cancel token. Drawing in OpenGL, or opening a
// pipe that nobody reads, does not.
extern "C" void on_deadline(int signal) {
  if (cancelling_signal.load() == 0) return kill_self_by(signal);
  end_all_writing();
  constexpr std::string_view kMessage = "alphascope-cli: cancelled.\n";
  static_cast<void>(!::write(STDERR_FILENO, kMessage.data(), kMessage.size()));
  ::_exit(cancelled_status());
}

class ProgressLine {
 public:
  void show(std::string_view stage, double share) {
    const std::lock_guard lock(mutex_);
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    const int width = std::fprintf(stderr, "\r%.*s %3.0f %%", static_cast<int>(stage.size()),
                                   stage.data(), share * 100);
    // Blanks cover the rest of a longer previous line.
    if (width < width_) std::fprintf(stderr, "%*s", width_ - width, "");
    width_ = std::max(width, 0);
  }
  void clear() {
    const std::lock_guard lock(mutex_);
    if (width_ > 0) std::fprintf(stderr, "\r%*s\r", width_, "");
    width_ = 0;
  }

 private:
  std::mutex mutex_;
  // The first line appears after 300 ms, since nobody could read a shorter flash.
  std::chrono::steady_clock::time_point next_ =
      std::chrono::steady_clock::now() + std::chrono::milliseconds(300);
  int width_ = 0;  // width of the present line; 0: none
};

ProgressLine& progress_line() {
  static ProgressLine line;
  return line;
}

// Prints a line when another stage begins.
class StageLog {
 public:
  void show(std::string_view stage) {
    const std::lock_guard lock(mutex_);
    if (stage == last_) return;
    last_ = stage;
    std::fprintf(stderr, "alphascope-cli: %s\n", last_.c_str());
  }

 private:
  std::mutex mutex_;
  std::string last_;
};

// Whether standard error is a terminal on which a line can be rewritten.
bool rewrites_lines() {
  const char* const terminal = std::getenv("TERM");
  return ::isatty(STDERR_FILENO) == 1 && terminal != nullptr && *terminal != '\0' &&
         std::string_view(terminal) != "dumb";
}

RunContext make_context() {
  RunContext context;
  if (interrupted != nullptr) context.cancel = *interrupted;
  if (chosen_verbosity == Verbosity::quiet) return context;
  if (chosen_verbosity == Verbosity::verbose) {
    context.progress = [log = std::make_shared<StageLog>()](std::string_view stage, double) {
      log->show(stage);
    };
  } else if (rewrites_lines()) {
    context.progress = [](std::string_view stage, double share) {
      progress_line().show(stage, share);
    };
  }
  return context;
}

}  // namespace

void set_up_standard_streams() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) continue;
    // Opens /dev/null in the wrong direction, so reading or writing still fails. open() takes the
    // lowest free number, which is this descriptor.
    static_cast<void>(::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  }
  std::cout.rdbuf(&standard_output());
}

void summary_to_standard_error() {
  std::cout.flush();
  std::cout.rdbuf(&standard_error());
}

int finish_standard_output(int status) {
  standard_error().pubsync();
  standard_output().pubsync();
  const int error = standard_output().error();
  if (error == 0) return status;
  constexpr int kClosedPipe = 128 + SIGPIPE;
  if (error == EPIPE) return status != 0 ? status : kClosedPipe;
  std::fprintf(stderr, "alphascope-cli: Cannot write standard output: %s.\n",
               error == EBADF ? "it is closed" : std::strerror(error));
  return status != 0 ? status : static_cast<int>(ExitCode::unwritable_output);
}

void set_verbosity(Verbosity verbosity) {
  chosen_verbosity = verbosity;
}

Verbosity verbosity() {
  return chosen_verbosity;
}

void set_times_wanted(bool wanted) {
  chosen_times = wanted;
}

bool times_wanted() {
  return chosen_times;
}

bool times_shown() {
  return chosen_times && chosen_verbosity != Verbosity::quiet;
}

void set_up_signals() {
  prepare_clean_exit("alphascope-cli", static_cast<int>(ExitCode::computing_failed));
  interrupted = new CancelToken;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) handle_signal(signal, on_cancel);
  end_on_signals({SIGPIPE, SIGQUIT, SIGXCPU});
  std::signal(SIGALRM, on_deadline);
}

const RunContext& run_context() {
  static const RunContext context = make_context();
  return context;
}

int cancelled_status() {
  return 128 + cancelling_signal.load();
}

void clear_progress() {
  progress_line().clear();
}

}  // namespace alphascope::cli
