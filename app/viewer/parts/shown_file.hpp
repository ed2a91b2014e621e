// SPDX-License-Identifier: GPL-3.0-or-later
// The file that the window shows, and the opening of others. Sets the state that begins with each
// new molecule.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "app/session/session.hpp"
#include "app/viewer/frames/due_frames.hpp"
#include "app/viewer/frames/settings_sender.hpp"
#include "app/viewer/parts/history.hpp"
#include "app/viewer/parts/opening.hpp"
#include "app/viewer/parts/window_preferences.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/window/host.hpp"

namespace alphascope {

class ShownFile {
 public:
  struct Parts {  // of the window; they must outlive this
    Host& host;
    ViewState& state;
    Session& session;
    SceneController& scene;
    WindowPreferences& preferences;
    History& history;
    SettingsSender& sender;
    DueFrames& due;
  };
  // `benchmark_busy` as in Opening.
  ShownFile(const Parts& parts, std::function<bool()> benchmark_busy);

  Opening& opening() { return opening_; }
  const Opening& opening() const { return opening_; }

  // Call when the session has new balls. `line_scale` as in SceneStyle. Returns whether they are of
  // another molecule, so that the memory of the last one is free.
  bool take_molecule(float line_scale);
  // Closes the file: the start page is shown, and settings that belong to one file are gone.
  void close();
  bool any() const { return file_ != nullptr; }
  // Objects of molecules that are opened; none: usual_objects().
  void set_first_objects(std::optional<DrawnObjects> objects) {
    first_objects_ = std::move(objects);
  }

 private:
  void take_file();
  void reset_settings();
  void close_dialogs(const char* why);
  void start_preset();
  void open_picture_dialog();
  void colour_by_what_differs(const MoleculeContents& contents);

  Parts p_;
  Opening opening_;
  std::shared_ptr<const Molecule> file_;  // the molecule as deposited; null: none
  std::optional<DrawnObjects> first_objects_;
  ColourBy automatic_colour_ = ColourBy::chain;
};

}  // namespace alphascope
