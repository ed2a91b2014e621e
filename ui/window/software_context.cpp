// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a context whose driver threads have a low priority.
#include "ui/window/software_context.hpp"

#include <exception>
#include <thread>

#include "core/run/thread_priority.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {
namespace {

class QuietContext final : public BackgroundContext {
 public:
  QuietContext() { context_.release(); }
  void make_current() override { context_.make_current(); }
  void release() override { context_.release(); }

 private:
  EglContext context_;
};

}  // namespace

std::unique_ptr<BackgroundContext> make_software_context() {
  std::unique_ptr<BackgroundContext> context;
  std::exception_ptr failure;
  // The driver's threads inherit the priority of the thread that starts them.
  std::thread([&] {
    try {
      lower_thread_priority(CpuShare::third);
      context = std::make_unique<QuietContext>();
    } catch (...) {
      failure = std::current_exception();
    }
  }).join();
  if (failure) std::rethrow_exception(failure);
  return context;
}

}  // namespace alphascope
