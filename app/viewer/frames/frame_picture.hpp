// SPDX-License-Identifier: GPL-3.0-or-later
// The picture in the frames of the window. It follows the session's results. This class decides
// which frames draw it, and updates the texts about it.
#pragma once

#include "app/session/session.hpp"
#include "app/viewer/frames/due_frames.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/window/host.hpp"
#include "ui/window/imgui_frame.hpp"

namespace alphascope {

class FramePicture {
 public:
  struct Parts {  // of the window; they must outlive this
    Host& host;
    ViewState& state;
    const ImGuiFrame& frame;
    SceneController& scene;
    const Store& store;
    const Session& session;
    DueFrames& due;
  };
  explicit FramePicture(const Parts& parts) : p_(parts) {}

  // Hands new results of the session to the scene.
  void follow(const SessionChanges& changes);
  // Takes in a finished picture, and updates the texts about the picture.
  void poll();

  // `patient`: from now on pictures are drawn at the finest quality, however long they take.
  void set_patient(bool patient) { patient_ = patient; }
  // Call before the panels: a GPU draws a new picture while the panels are drawn.
  void begin();
  void mark_outdated();  // while newer results are on their way
  // Call once a frame, after the panels. If true, neither draw the picture nor show the frame: the
  // tables of a new picture are not ready.
  bool waits_for_tables();
  // Call after the panels, which decide the picture's size, and before ImGui shows it. `yields`:
  // draws nothing if input is waiting, since slow pictures would delay the window.
  void draw(bool yields);

 private:
  Parts p_;
  bool patient_ = false;
  bool must_draw_ = false;  // the picture does not show state.result yet
  bool is_new_ = false;     // since the last waits_for_tables()
};

}  // namespace alphascope
