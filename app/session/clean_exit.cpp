// SPDX-License-Identifier: GPL-3.0-or-later
// Handlers of signals, of terminate and of exhausted memory.
#include "app/session/clean_exit.hpp"

#include <cxxabi.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <typeinfo>

#include "core/files/atomic_file.hpp"

namespace alphascope {
namespace {

const char* program_name = "";
int status_without_memory = 1;
std::terminate_handler terminate_before = nullptr;

// Memory in reserve. It is freed when an allocation first fails, because destructors and the
// message may need some.
constexpr std::size_t kReserveBytes = std::size_t{1} << 18;
std::atomic<void*> reserve{nullptr};

void on_no_memory() {
  std::free(reserve.exchange(nullptr));
  throw std::bad_alloc();
}

void say(const char* text) {
  static_cast<void>(!::write(STDERR_FILENO, text, std::strlen(text)));
}

// Called when an exception leaves a noexcept function. Destructors are such functions, and those of
// nlohmann's JSON values allocate memory.
[[noreturn]] void on_terminate() {
  const std::type_info* const type = abi::__cxa_current_exception_type();
  if (type != nullptr && *type == typeid(std::bad_alloc)) {
    end_all_writing();
    say(program_name);
    say(": Not enough memory.\n");
    ::_exit(status_without_memory);
  }
  if (terminate_before != nullptr) terminate_before();
  std::abort();
}

extern "C" void on_last_signal(int signal) {
  kill_self_by(signal);
}

// Makes a fault of the program, such as SIGSEGV, remove the temporary files first. Handlers of
// sanitizers stay.
void end_on_fault(int signal) {
  struct sigaction action {};
  if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) return;
  action = {};
  action.sa_handler = on_last_signal;
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

void prepare_clean_exit(const char* program, int status) {
  program_name = program;
  status_without_memory = status;
  terminate_before = std::set_terminate(on_terminate);
  reserve = std::malloc(kReserveBytes);
  std::set_new_handler(on_no_memory);
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL}) end_on_fault(signal);
  std::signal(SIGXFSZ, SIG_IGN);  // a write beyond the shell's limit fails with a message
}

void handle_signal(int signal, void (*handler)(int)) {
  struct sigaction action {};
  if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) return;
  action = {};
  action.sa_handler = handler;
  action.sa_flags = 0;  // without SA_RESTART, so that a read that waits for input ends, too
  ::sigaction(signal, &action, nullptr);
}

void end_on_signals(std::initializer_list<int> signals) {
  for (const int signal : signals) handle_signal(signal, on_last_signal);
}

void kill_self_by(int signal) {
  end_all_writing();
  std::signal(signal, SIG_DFL);
  std::raise(signal);  // takes effect when the handler returns
}

}  // namespace alphascope
