// SPDX-License-Identifier: GPL-3.0-or-later
// The user's preferences in the window: theme, scale, engine, size, recent files and last folder.
#pragma once

#include <filesystem>
#include <optional>

#include "app/viewer/jobs/preferences_keeper.hpp"
#include "app/viewer/options.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/window/host.hpp"

namespace alphascope {

class WindowPreferences {
 public:
  WindowPreferences(Host& host, ViewState& state, const std::filesystem::path& folder)
      : host_(host), state_(state), keeper_([&host] { host.wake(); }, folder) {}

  void begin_with(const ViewerOptions& options);  // options of the command line take precedence
  void note();                                    // call once a frame; notes changes by the user
  void ignore_changes_so_far();  // changes by a session or a lesson are not preferences
  void take_gpu();               // call when a GPU is found: the preferred engine may need it
  void note_recent_file(const std::filesystem::path& file);
  void forget_recent();
  bool follow_scale();  // returns whether the scale of the window has changed
  bool poll();          // returns whether a notice was shown
  // Factor of line widths in pictures, for this scale of the letters.
  float line_scale(float scale) const;

 private:
  Preferences preferred() const;

  Host& host_;
  ViewState& state_;
  PreferencesKeeper keeper_;
  Preferences noted_;                     // the window's preferences at the last look
  double set_scale_ = 0, set_times_ = 1;  // arguments of the last Host::set_scale()
  // A preferred engine that waits for the search for a GPU.
  std::optional<EngineChoice> engine_when_found_;
};

}  // namespace alphascope
