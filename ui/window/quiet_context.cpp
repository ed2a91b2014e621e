// See the header.
#include "ui/window/quiet_context.hpp"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <exception>
#include <thread>

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

void give_way_to_others() {
  constexpr int kNice = 5;                                     // a third of a usual thread's share
  const auto thread = static_cast<id_t>(syscall(SYS_gettid));  // Linux: nice is a thread's own
  setpriority(PRIO_PROCESS, thread, kNice);
}

std::unique_ptr<BackgroundContext> make_quiet_context() {
  std::unique_ptr<BackgroundContext> context;
  std::exception_ptr failure;
  // The driver's threads take over what the thread that starts them has.
  std::thread([&] {
    try {
      give_way_to_others();
      context = std::make_unique<QuietContext>();
    } catch (...) {
      failure = std::current_exception();
    }
  }).join();
  if (failure) std::rethrow_exception(failure);
  return context;
}

}  // namespace alphascope
