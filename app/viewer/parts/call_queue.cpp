// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces equal calls in place, and makes the calls of one run.
#include "app/viewer/parts/call_queue.hpp"

#include <algorithm>

namespace alphascope {

void CallQueue::put(std::string_view name, std::function<void()> call) {
  const auto same = std::find_if(waiting_.begin(), waiting_.end(),
                                 [&](const auto& waiting) { return waiting.first == name; });
  if (same != waiting_.end()) {
    same->second = std::move(call);
  } else {
    waiting_.emplace_back(name, std::move(call));
  }
}

void CallQueue::run() {
  const auto calls = std::exchange(waiting_, {});
  for (const auto& [name, call] : calls) call();
}

}  // namespace alphascope
