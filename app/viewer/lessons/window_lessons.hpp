// SPDX-License-Identifier: GPL-3.0-or-later
// Lessons in the window: their files, and the player whose stage the window is.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/session/session.hpp"
#include "app/viewer/frames/due_frames.hpp"
#include "app/viewer/frames/settings_sender.hpp"
#include "app/viewer/lessons/lesson_files.hpp"
#include "app/viewer/lessons/lesson_player.hpp"
#include "app/viewer/parts/history.hpp"
#include "app/viewer/parts/opening.hpp"
#include "app/viewer/parts/window_preferences.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "core/document/commands/commands.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

class WindowLessons {
 public:
  struct Parts {  // of the window; they must outlive this
    ViewState& state;
    const Commands& commands;
    Session& session;
    SceneController& scene;
    Opening& opening;
    WindowPreferences& preferences;
    History& history;
    const SettingsSender& sender;
    DueFrames& due;
    std::function<void()> close_file;  // shows the start page
  };
  // `wake` as in Worker. `folders` as in LessonFiles.
  WindowLessons(const Parts& parts, std::function<void()> wake,
                std::vector<std::filesystem::path> folders);
  ~WindowLessons();

  // The folders of the program's and the user's lessons. Empty `of_user`: the user has none.
  static std::vector<std::filesystem::path> folders(const std::filesystem::path& of_user);

  void open(const std::string& name_or_path) { files_.open(name_or_path); }
  void poll();  // takes in what was read
  LessonPlayer& player() { return player_; }
  bool busy() const { return files_.busy() || player_.busy(); }
  bool plays() const { return player_.busy(); }  // a step changes the settings

 private:
  class Stage;  // the window as the player sees it

  Parts p_;
  LessonFiles files_;
  std::unique_ptr<LessonStage> stage_;
  LessonPlayer player_;
};

}  // namespace alphascope
