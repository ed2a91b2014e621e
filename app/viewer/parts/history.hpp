// SPDX-License-Identifier: GPL-3.0-or-later
// The undo history of the open file. Each entry holds the settings of the panels, and the view if
// the program moved it for that change. Undo brings both back.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "app/session/session.hpp"
#include "app/viewer/mouse/gestures.hpp"
#include "app/viewer/parts/camera_history.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "core/document/session/editor.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

class History {
 public:
  History(ViewState& state, const Session& session, SceneController& scene)
      : state_(state), session_(session), scene_(scene) {}

  // The settings of the panels, with the options with which the molecule was opened.
  Settings settings() const;
  void begin_frame() { gesture_ = gestures_.in_this_frame(); }
  // Call once a frame. `by_itself`: the program changes settings (playback, lessons), which makes
  // no entry.
  void note_changes(bool by_itself);
  void undo();
  void redo();
  void restart();  // for another file: the history is empty from here on
  void restart(const Settings& settings);
  void amend();  // to be called if the last request failed or was cancelled; the settings that are
                 // back then make no entry

  // Moves the view on request. A change of settings may come with the move; its undo brings the
  // view back.
  void move_view(const std::function<void()>& how);
  // Call when a user has moved the view from `before`, by a drag or the wheel.
  void note_view_moved(const std::optional<CameraPlace>& before);
  // Goes to the view before the last move, or to the one after it.
  void earlier_view();
  void later_view();
  void begin_calls() { view_before_calls_.reset(); }

  // The undo history of a molecule that is kept during a lesson, and its return.
  const Editor& editor() const { return editor_; }
  void put(const Editor& editor);
  void set_to_restore(std::optional<Editor> editor) { to_restore_ = std::move(editor); }
  void restore();  // the session has come back

 private:
  void show_settings();
  void note_view();
  void go_to_view(std::optional<CameraPlace> found);
  void bring_view_back(const CameraPlace& view, bool other_atoms);

  ViewState& state_;
  const Session& session_;
  SceneController& scene_;
  Editor editor_;
  // A view that the program moved for an entry: before the move and, once the entry is undone,
  // after it.
  struct MovedView {
    CameraPlace before;
    std::optional<CameraPlace> after;
    std::uint64_t moves = 0;  // the value of view_moves_ at the move
  };
  std::map<std::size_t, MovedView> moved_views_;  // key: number of the entry, from 1
  std::optional<CameraPlace> view_before_calls_;
  Gesture entry_gesture_ = 0;     // the gesture that made the last entry
  std::uint64_t view_moves_ = 0;  // moves of the view on request, by hand or by a command
  CameraHistory views_;
  Gesture view_gesture_ = 0;  // that moved the view last; 0: the wheel
  std::chrono::steady_clock::time_point wheel_at_{};
  Gestures gestures_;
  Gesture gesture_ = 0;               // the gesture of this frame
  std::optional<Editor> to_restore_;  // the history of the session that is being opened
};

}  // namespace alphascope
