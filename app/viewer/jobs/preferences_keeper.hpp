// The preferences of this window: read at its start, and saved on a thread of their own soon after
// they change.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>

#include "core/document/session/preferences.hpp"
#include "core/run/worker.hpp"

namespace alphascope {

class PreferencesKeeper {
 public:
  // An empty folder: they are neither read nor written, as tests and scripts want it.
  PreferencesKeeper(std::function<void()> wake, const std::filesystem::path& folder);
  ~PreferencesKeeper();  // saves what is not saved yet

  const Preferences& now() const { return now_; }
  void set(const Preferences& preferences);

  // Once a frame, on the main thread: starts saving when it is due. Returns what is to be told,
  // once for all the time of the window; else nothing.
  std::string poll();
  bool unsaved() const { return !folder_.empty() && now_ != saved_; }

 private:
  using Clock = std::chrono::steady_clock;
  void give_up(const std::string& why);

  std::filesystem::path folder_;  // empty: not to be written (any more)
  Preferences saved_, now_;
  std::string problem_;
  Clock::time_point changed_{};
  Worker worker_;  // last: joined first
};

}  // namespace alphascope
