// SPDX-License-Identifier: GPL-3.0-or-later
// Reads amounts of memory from the system, and returns freed memory to it.
#include "app/viewer/parts/memory_watch.hpp"

#include "app/session/system_memory.hpp"
#include "app/viewer/mouse/gestures.hpp"
#include "core/run/freed_memory.hpp"
#include "core/run/freed_on_other_thread.hpp"

namespace alphascope {

void MemoryWatch::read() {
  state_.memory_bytes = resident_bytes();
  state_.free_bytes = available_bytes().value_or(0);
}

void MemoryWatch::give_back_when_due(bool busy) {
  if (!to_give_back_ || busy || interacting(state_)) return;
  to_give_back_ = false;
  wait_until_freed();
  return_freed_memory();
  read();
  due_.ask();
}

}  // namespace alphascope
