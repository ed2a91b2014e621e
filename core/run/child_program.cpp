// SPDX-License-Identifier: GPL-3.0-or-later
// Starts, feeds and ends a child program. Input goes through a socket: writing to a socket whose
// other end is closed returns an error, while a pipe raises a signal.
#include "core/run/child_program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <utility>

#include "core/run/cancel_token.hpp"
#include "core/run/uninterrupted_step.hpp"

extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace alphascope {
namespace {

namespace fs = std::filesystem;

constexpr int kLookMilliseconds = 50;  // interval at which the token is read

// Running child programs, in a form that a signal handler can read. If all places are in use, a
// further one is ended by its object only.
constexpr int kPlaces = 16;
std::atomic<int> children[kPlaces];
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler reads them");

void remember(int process) {
  for (std::atomic<int>& place : children) {
    int empty = 0;
    if (place.compare_exchange_strong(empty, process)) return;
  }
}

void forget(int process) {
  for (std::atomic<int>& place : children) {
    int found = process;
    if (place.compare_exchange_strong(found, 0)) return;
  }
}

int status_of(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

// The settings of a new child: its streams, default signals, a process group of its own.
class SpawnSettings {
 public:
  SpawnSettings(int input, int errors, int file) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, errors, STDERR_FILENO);
    // This is last, since an earlier descriptor may have this number.
    if (file >= 0) posix_spawn_file_actions_adddup2(&actions_, file, kChildFile);
    posix_spawnattr_init(&attributes_);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(
        &attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  int start(pid_t& process, const char* program, char* const* arguments) const {
    return ::posix_spawn(&process, program, &actions_, &attributes_, arguments, environ);
  }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

}  // namespace

std::optional<fs::path> find_program(std::string_view name) {
  const char* const path = std::getenv("PATH");
  std::string_view folders = path == nullptr ? "/usr/local/bin:/usr/bin:/bin" : path;
  while (!folders.empty()) {
    const std::size_t end = folders.find(':');
    const fs::path program = fs::path(folders.substr(0, end)) / name;
    std::error_code ignored;
    if (fs::is_regular_file(program, ignored) && ::access(program.c_str(), X_OK) == 0) {
      return program;
    }
    folders.remove_prefix(end == std::string_view::npos ? folders.size() : end + 1);
  }
  return std::nullopt;
}

ChildProgram::ChildProgram(const fs::path& program, const std::vector<std::string>& arguments,
                           int file) {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw std::runtime_error("Cannot start " + program.string() + ": " + std::strerror(errno) +
                             ".");
  }
  input_ = ends[0];
  errors_ = ::memfd_create("errors", MFD_CLOEXEC);
  // execv() takes pointers to characters that are not constant, but does not change them.
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (const std::string& a : arguments) words.push_back(const_cast<char*>(a.c_str()));
  words.push_back(nullptr);
  pid_t process = -1;
  int error = errno;
  if (errors_ >= 0) {
    const SpawnSettings settings(ends[1], errors_, file);
    const UninterruptedStep step;
    error = settings.start(process, program.c_str(), words.data());
    if (error == 0) remember(process);
  }
  ::close(ends[1]);
  if (error != 0) {
    close_input();
    if (errors_ >= 0) ::close(errors_);
    throw std::runtime_error("Cannot start " + program.string() + ": " + std::strerror(error) +
                             ".");
  }
  process_ = process;
}

ChildProgram::~ChildProgram() {
  close_input();
  ::close(errors_);
  if (process_ < 0) return;
  ::kill(-process_, SIGKILL);
  while (reap(0) < 0 && errno == EINTR) {
  }
}

// Returns the exit status if the child has ended, else a negative number. Afterwards its process
// number may be reused.
int ChildProgram::reap(int options) {
  const UninterruptedStep step;
  int status = 0;
  const pid_t ended = ::waitpid(process_, &status, options);
  if (ended != process_) return ended < 0 ? -1 : -2;
  forget(std::exchange(process_, -1));
  return status_of(status);
}

void kill_child_programs() noexcept {
  for (std::atomic<int>& place : children) {
    const int process = place.load();
    if (process <= 0) continue;
    ::kill(-process, SIGKILL);
    constexpr int kMostMilliseconds = 1000;
    for (int k = 0; k < kMostMilliseconds && ::waitpid(process, nullptr, WNOHANG) == 0; ++k) {
      ::poll(nullptr, 0, 1);
    }
  }
}

void ChildProgram::close_input() {
  if (input_ >= 0) ::close(std::exchange(input_, -1));
}

bool ChildProgram::write(std::span<const std::uint8_t> bytes, const CancelToken& cancel) {
  while (!bytes.empty()) {
    cancel.throw_if_cancelled();
    pollfd ready{input_, POLLOUT, 0};
    // Interrupted by a signal, or not ready yet.
    if (::poll(&ready, 1, kLookMilliseconds) <= 0) continue;
    const ssize_t sent = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (sent < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
  return true;
}

int ChildProgram::finish(const CancelToken& cancel) {
  close_input();
  for (;;) {
    if (const int status = reap(WNOHANG); status >= 0) return status;
    cancel.throw_if_cancelled();
    std::this_thread::sleep_for(std::chrono::milliseconds(kLookMilliseconds / 5));
  }
}

std::string ChildProgram::error_output(std::size_t most) const {
  struct stat status {};
  if (::fstat(errors_, &status) != 0) return {};
  const std::size_t length = std::min(most, static_cast<std::size_t>(status.st_size));
  std::string text(length, '\0');
  const ssize_t got =
      ::pread(errors_, text.data(), length, status.st_size - static_cast<off_t>(length));
  text.resize(got < 0 ? 0 : static_cast<std::size_t>(got));
  return text;
}

}  // namespace alphascope
