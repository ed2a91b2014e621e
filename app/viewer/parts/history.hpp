// The history of the open file in the window: the panels' settings as entries, and the view where
// the program has moved it, which undo brings back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "app/session/session.hpp"
#include "app/viewer/parts/gestures.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "core/document/session/editor.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

class History {
 public:
  History(ViewState& state, const Session& session, SceneController& scene)
      : state_(state), session_(session), scene_(scene) {}

  // As the panels have them, but for the molecule's options, which are as it was opened.
  Settings settings() const;
  void begin_frame() { gesture_ = gestures_.in_this_frame(); }
  // Once a frame. `by_itself`: the program changes settings, which makes no entry.
  void note_changes(bool by_itself);
  void undo();
  void redo();
  void restart();  // another file: from here on there is nothing to go back to
  void restart(const Settings& settings);
  void amend();  // the panels' settings are no entry: what was asked for could not be done

  // A change of the view that somebody asked for. Undo of the change that comes with it brings the
  // view back.
  void move_view(const std::function<void()>& how);
  void note_view_moved() { ++view_moves_; }
  void begin_calls() { view_before_calls_.reset(); }

  // The history of a session that is kept, and put in place again when it comes back.
  const Editor& editor() const { return editor_; }
  void put(const Editor& editor);
  void set_to_come_back(std::optional<Editor> editor) { to_come_back_ = std::move(editor); }
  void take_back();  // it has come

 private:
  void show_settings();
  void note_view();
  void bring_view_back(const CameraPlace& view, bool other_atoms);

  ViewState& state_;
  const Session& session_;
  SceneController& scene_;
  Editor editor_;
  // A view that the program moved for an entry: where it was before and, once the entry is undone,
  // after it.
  struct MovedView {
    CameraPlace before;
    std::optional<CameraPlace> after;
    std::uint64_t moves = 0;  // view_moves_ then
  };
  std::map<std::size_t, MovedView> moved_views_;  // by the number of the entry, from 1
  std::optional<CameraPlace> view_before_calls_;
  Gesture entry_gesture_ = 0;     // of the last entry
  std::uint64_t view_moves_ = 0;  // that somebody asked for, by hand or in words
  Gestures gestures_;
  Gesture gesture_ = 0;                 // of this frame
  std::optional<Editor> to_come_back_;  // of the session that is on its way
};

}  // namespace alphascope
