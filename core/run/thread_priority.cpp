// SPDX-License-Identifier: GPL-3.0-or-later
// Sets the priority of a thread on Linux.
#include "core/run/thread_priority.hpp"

#ifdef __linux__
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace alphascope {

void lower_thread_priority([[maybe_unused]] CpuShare share) {
#ifdef __linux__
  // On Linux each thread has its own nice value.
  const auto thread = static_cast<id_t>(syscall(SYS_gettid));
  // If refused, the priority stays as it is.
  setpriority(PRIO_PROCESS, thread, static_cast<int>(share));
#endif
}

}  // namespace alphascope
