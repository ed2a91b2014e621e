// SPDX-License-Identifier: GPL-3.0-or-later
// A queue of calls that panels and scripts make. They are carried out after the panels of a frame.
#pragma once

#include <functional>
#include <string_view>
#include <utility>
#include <vector>

namespace alphascope {

class CallQueue {
 public:
  // Adds a call. It replaces a waiting call of the same name and takes its place in the order.
  void put(std::string_view name, std::function<void()> call);
  // Makes the waiting calls, in order. Calls added meanwhile wait for the next run. An exception
  // ends the run, and the remaining calls are dropped.
  void run();
  bool empty() const { return waiting_.empty(); }

 private:
  std::vector<std::pair<std::string_view, std::function<void()>>> waiting_;
};

}  // namespace alphascope
