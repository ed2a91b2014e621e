// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the preferences of this window. They are read at its start, and saved on a thread of their
// own soon after a change.
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
  // An empty folder means that preferences are neither read nor written, as in tests and scripts.
  PreferencesKeeper(std::function<void()> wake, const std::filesystem::path& folder);
  ~PreferencesKeeper();  // saves unsaved changes

  const Preferences& now() const { return now_; }
  void set(const Preferences& preferences);

  // Call once a frame on the main thread: starts saving when it is due. Returns a notice for the
  // user at most once while the window is open; otherwise an empty text.
  std::string poll();
  bool unsaved() const { return !folder_.empty() && now_ != saved_; }

 private:
  using Clock = std::chrono::steady_clock;
  void give_up(const std::string& why);

  std::filesystem::path folder_;  // empty: nothing is written (any more)
  Preferences saved_, now_;
  std::string problem_;
  Clock::time_point changed_{};
  Worker worker_;  // last member, so that its thread is joined first
};

}  // namespace alphascope
