// SPDX-License-Identifier: GPL-3.0-or-later
// A library that tests load before the C library (LD_PRELOAD). It makes the N-th call of one kind
// fail, or sends a signal at that call. ALPHASCOPE_FAULT is "KIND N ACTION". KIND is open (for
// writing), write, rename, fsync or malloc. ACTION is an errno below 1000, or 1000 + a signal,
// which is sent after the call. "0" makes this and all later calls fail (malloc). Memory is counted
// once the program handles signals, since calls before main() are not its own.
// ALPHASCOPE_FAULT_MARK is a file that is made when the fault happens. With ALPHASCOPE_NO_EXCHANGE,
// names cannot be exchanged, as on NFS.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {
void* __libc_malloc(std::size_t size);                     // NOLINT
void* __libc_calloc(std::size_t count, std::size_t size);  // NOLINT
void* __libc_realloc(void* old, std::size_t size);         // NOLINT
}

namespace {

enum class Kind { none, open, write, rename, fsync, malloc };

struct Fault {
  Kind kind = Kind::none;
  long at = 0;
  int action = 0;
  const char* mark = nullptr;
};
Fault fault;
std::atomic<long> calls{0};
std::atomic<bool> handles_signals{false};

__attribute__((constructor)) void read_fault() {
  const char* const text = std::getenv("ALPHASCOPE_FAULT");
  char kind[16] = {};
  Fault wanted;
  if (text == nullptr || std::sscanf(text, "%15s %ld %d", kind, &wanted.at, &wanted.action) != 3) {
    return;
  }
  const char* const names[] = {"", "open", "write", "rename", "fsync", "malloc"};
  for (int k = 1; k <= 5; ++k) {
    if (std::strcmp(kind, names[k]) == 0) wanted.kind = static_cast<Kind>(k);
  }
  wanted.mark = std::getenv("ALPHASCOPE_FAULT_MARK");
  fault = wanted;
}

void mark() {
  if (fault.mark == nullptr) return;
  const long file = ::syscall(SYS_openat, AT_FDCWD, fault.mark, O_WRONLY | O_CREAT, 0666);
  if (file >= 0) ::syscall(SYS_close, file);
}

// True when this call is to fail.
bool reached(Kind kind) {
  if (kind != fault.kind) return false;
  const long call = ++calls;
  if (call != fault.at && !(fault.action == 0 && call > fault.at)) return false;
  if (call == fault.at) mark();
  return true;
}

bool by_signal() {
  return fault.action >= 1000;
}

template <class Result>
Result failed() {
  errno = fault.action;
  return static_cast<Result>(-1);
}

void send() {
  const int before = errno;
  ::raise(fault.action - 1000);
  errno = before;
}

int open_at(int folder, const char* name, int flags, mode_t mode) {
  const bool hit = (flags & O_ACCMODE) != O_RDONLY && reached(Kind::open);
  if (hit && !by_signal()) return failed<int>();
  const long opened = ::syscall(SYS_openat, folder, name, flags, mode);
  if (hit) send();
  return static_cast<int>(opened);
}

mode_t mode_of(int flags, va_list rest) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
}

template <class Call>
void* allocated(const Call& call) {
  const bool hit = handles_signals && reached(Kind::malloc);
  if (hit && !by_signal()) {
    errno = ENOMEM;
    return nullptr;
  }
  void* const memory = call();
  if (hit) send();
  return memory;
}

}  // namespace

extern "C" {

int open(const char* name, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = mode_of(flags, rest);
  va_end(rest);
  return open_at(AT_FDCWD, name, flags, mode);
}

int open64(const char* name, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = mode_of(flags, rest);
  va_end(rest);
  return open_at(AT_FDCWD, name, flags, mode);
}

ssize_t write(int descriptor, const void* bytes, std::size_t size) {
  const bool hit = reached(Kind::write);
  if (hit && !by_signal()) return failed<ssize_t>();
  const long written = ::syscall(SYS_write, descriptor, bytes, size);
  if (hit) send();
  return written;
}

int rename(const char* from, const char* to) noexcept {
  const bool hit = reached(Kind::rename);
  if (hit && !by_signal()) return failed<int>();
  const long result = ::syscall(SYS_rename, from, to);
  if (hit) send();
  return static_cast<int>(result);
}

// An injected failure is one of this name. EINVAL means a system without exchange, on which the
// program uses rename() instead.
int renameat2(int a, const char* from, int b, const char* to, unsigned flags) noexcept {
  if (std::getenv("ALPHASCOPE_NO_EXCHANGE") != nullptr) {
    errno = EINVAL;
    return -1;
  }
  const bool hit = reached(Kind::rename);
  if (hit && !by_signal()) return failed<int>();
  const long result = ::syscall(SYS_renameat2, a, from, b, to, flags);
  if (hit) send();
  return static_cast<int>(result);
}

int sigaction(int signal, const struct sigaction* action, struct sigaction* old) noexcept {
  using Call = int (*)(int, const struct sigaction*, struct sigaction*);
  static const Call next = reinterpret_cast<Call>(::dlsym(RTLD_NEXT, "sigaction"));
  if (action != nullptr) handles_signals = true;
  return next(signal, action, old);
}

int fsync(int descriptor) {
  const bool hit = reached(Kind::fsync);
  if (hit && !by_signal()) return failed<int>();
  const long result = ::syscall(SYS_fsync, descriptor);
  if (hit) send();
  return static_cast<int>(result);
}

void* malloc(std::size_t size) noexcept {
  return allocated([&] { return __libc_malloc(size); });
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  return allocated([&] { return __libc_calloc(count, size); });
}

void* realloc(void* old, std::size_t size) noexcept {
  return allocated([&] { return __libc_realloc(old, size); });
}

}  // extern "C"
