// See the header.
#include "core/run/background.hpp"

#ifdef __linux__
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace alphascope {

void give_way_to_others([[maybe_unused]] Share share) {
#ifdef __linux__
  const auto thread = static_cast<id_t>(syscall(SYS_gettid));  // Linux: nice is a thread's own
  setpriority(PRIO_PROCESS, thread, static_cast<int>(share));  // refused: as before
#endif
}

}  // namespace alphascope
