// SPDX-License-Identifier: GPL-3.0-or-later
// Low priority for threads whose work can wait.
#pragma once

namespace alphascope {

// A thread's share of a core that other threads also want; the values are the kernel's "nice"
// values. An idle core is used fully.
enum class CpuShare {
  third = 5,       // of the time of a normal thread
  seventieth = 19  // the work ends even on a machine that is always busy
};

// Applies to the calling thread and to the threads that it starts later, permanently. Does nothing
// where the system has no such priorities.
void lower_thread_priority(CpuShare share);

}  // namespace alphascope
