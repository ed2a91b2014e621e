// SPDX-License-Identifier: GPL-3.0-or-later
// Reads preferences, and delays their saving.
#include "app/viewer/jobs/preferences_keeper.hpp"

#include <exception>
#include <utility>

namespace alphascope {
namespace {

// Preferences are saved this long after a change. While the window is resized, its size changes all
// the time.
constexpr std::chrono::milliseconds kSaveAfter{1000};

}  // namespace

PreferencesKeeper::PreferencesKeeper(std::function<void()> wake,
                                     const std::filesystem::path& folder)
    : folder_(folder), worker_(std::move(wake)) {
  if (folder_.empty()) return;
  ReadPreferences read = read_preferences(folder_);
  saved_ = now_ = std::move(read.preferences);
  problem_ = std::move(read.problem);
  if (read.keep_file) folder_.clear();
}

PreferencesKeeper::~PreferencesKeeper() {
  if (!unsaved()) return;
  try {
    save_preferences(folder_, saved_, now_);
  } catch (const std::exception&) {
    // The window is gone, so no message can be shown.
  }
}

void PreferencesKeeper::set(const Preferences& preferences) {
  if (preferences == now_) return;
  now_ = preferences;
  changed_ = Clock::now();
}

void PreferencesKeeper::give_up(const std::string& why) {
  folder_.clear();
  problem_ = "Preferences and the list of recent files are not saved: " + why;
}

std::string PreferencesKeeper::poll() {
  worker_.poll();
  const bool due = unsaved() && Clock::now() - changed_ >= kSaveAfter;
  if (due && !worker_.activity().busy) {
    worker_.submit(
        [this, folder = folder_, before = saved_,
         now = now_](const RunContext&) -> Worker::Delivery {
          save_preferences(folder, before, now);
          return [this, now] { saved_ = now; };
        },
        [this](const Worker::Failure& failure) { give_up(failure.message); });
  }
  return std::exchange(problem_, {});
}

}  // namespace alphascope
