// The user's preferences in the window: theme, scale, engine, size, recent files, last folder.
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

  void begin_with(const ViewerOptions& options);  // options of the command line go before
  void note();                                    // once a frame: changes that the user has made
  void take_as_seen();  // changes by a session or a lesson are not the user's
  void take_gpu();      // one was found: the preferred engine may need it
  void note_recent_file(const std::filesystem::path& file);
  void forget_recent();
  bool follow_scale();  // whether the scale of the window has changed
  bool poll();          // whether there is something to tell, which is told
  // Of lines in pictures, for letters of this scale.
  float line_scale(float scale) const;

 private:
  Preferences preferred() const;

  Host& host_;
  ViewState& state_;
  PreferencesKeeper keeper_;
  Preferences noted_;                     // as the window had them when they were looked at last
  double set_scale_ = 0, set_times_ = 1;  // of the host
  std::optional<EngineChoice> engine_when_found_;  // preferred, and in need of a GPU
};

}  // namespace alphascope
