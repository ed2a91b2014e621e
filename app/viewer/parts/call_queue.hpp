// Calls that wait for the end of a frame.
#pragma once

#include <functional>
#include <string_view>
#include <utility>
#include <vector>

namespace alphascope {

class CallQueue {
 public:
  // Replaces a waiting call of the same name, in its place.
  void put(std::string_view name, std::function<void()> call);
  // Carries out what waits, in order. What these calls put waits for the next run. What one throws
  // ends the run; the rest is dropped.
  void run();
  bool empty() const { return waiting_.empty(); }

 private:
  std::vector<std::pair<std::string_view, std::function<void()>>> waiting_;
};

}  // namespace alphascope
