// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the current gesture from ImGui's state of mouse buttons and keys.
#include "app/viewer/mouse/gestures.hpp"

#include <imgui.h>

#include <algorithm>
#include <functional>
#include <iterator>

#include "ui/panels/playback.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

bool interacting(const ViewState& state) {
  const ImGuiIO& io = ImGui::GetIO();
  return state.playback.alpha || state.playback.models || io.MouseDown[0] || io.MouseDown[1] ||
         io.MouseDown[2];
}

bool anything_pressed() {
  bool pressed = false;
  for (int button = 0; button < ImGuiMouseButton_COUNT; ++button) {
    pressed |= ImGui::IsMouseClicked(button);
  }
  for (int key = 0; key < IM_ARRAYSIZE(ImGui::GetIO().KeysDown); ++key) {
    pressed |= ImGui::IsKeyPressed(key, false);
  }
  return pressed;
}

Gesture Gestures::in_this_frame() {
  const ImGuiIO& io = ImGui::GetIO();
  const bool pressed = anything_pressed();
  const bool held =
      std::any_of(std::begin(io.MouseDown), std::end(io.MouseDown), std::identity()) ||
      std::any_of(std::begin(io.KeysDown), std::end(io.KeysDown), std::identity());
  if (pressed) ++count_;
  constexpr int kFramesAfterRelease = 2;
  frames_left_ = pressed || held ? kFramesAfterRelease : std::max(0, frames_left_ - 1);
  return frames_left_ > 0 ? count_ : 0;
}

}  // namespace alphascope
