// SPDX-License-Identifier: GPL-3.0-or-later
// Hands queued events to ImGui's frames.
#include "ui/window/input_queue.hpp"

#include <imgui.h>

#include <algorithm>
#include <cfloat>

#include "ui/widgets/keys.hpp"

namespace alphascope {
namespace {

using Kind = InputEvent::Kind;
constexpr double kLeastStep = 1e-4;  // seconds; ImGui requires that each frame takes some time

bool is_modifier(int code) {
  return code >= key::kFirstModifier && code <= key::kLastModifier;
}

// Whether a key writes a character on any keyboard layout.
bool is_printing(int code) {
  return code < key::kEscape || (code >= key::kFirstKeypad && code < key::kKeypadEnter);
}

bool same_place(const InputEvent& event) {
  return event.kind == Kind::move;
}

}  // namespace

void InputQueue::push(const InputEvent& event) {
  const bool known = event.kind != Kind::key || (event.code >= 0 && event.code < 512);
  const bool three_buttons = event.kind != Kind::button || (event.code >= 0 && event.code < 3);
  if (!known || !three_buttons) return;
  // Among successive moves only the last counts.
  if (same_place(event) && !events_.empty() && same_place(events_.back())) {
    events_.back() = event;
  } else {
    events_.push_back(event);
  }
}

bool InputQueue::Frame::takes(const InputEvent& e) const {
  const auto code = static_cast<std::size_t>(e.code);
  switch (e.kind) {
    case Kind::move:
    case Kind::leave:
      return !button && !wheel && !press;
    case Kind::button:
      // A frame never has both a move and a press or release. ImGui must first see the widget under
      // the mouse, and before a release the slider's last move.
      return !moved && !press && !wheel && !text && !buttons[code];
    case Kind::wheel:
      return !button && !press;
    case Kind::key:
      if (is_modifier(e.code)) return !press && !button && !wheel && !text && !keys[code];
      return e.down ? !press && !button && !wheel && !text && !keys[code] : !keys[code];
    case Kind::text:
      return !button && !wheel && (!press || printing);
    case Kind::focus:
      return !press && !button && !text;
  }
  return true;
}

void InputQueue::Frame::note(const InputEvent& e) {
  const auto code = static_cast<std::size_t>(e.code);
  moved |= e.kind == Kind::move || e.kind == Kind::leave;
  wheel |= e.kind == Kind::wheel;
  text |= e.kind == Kind::text;
  if (e.kind == Kind::button) {
    button = buttons[code] = true;
    press |= e.down;
  }
  if (e.kind == Kind::key) {
    keys[code] = true;
    press |= e.down && !is_modifier(e.code);
    printing |= e.down && is_printing(e.code);
  }
}

void InputQueue::apply(const InputEvent& e, ImGuiIO& io) {
  switch (e.kind) {
    case Kind::move:
      io.MousePos = {e.x, e.y};
      break;
    case Kind::leave:
      // While a button is down, a dragged object stays at its last position.
      if (!std::any_of(io.MouseDown, io.MouseDown + 3, [](bool down) { return down; })) {
        io.MousePos = {-FLT_MAX, -FLT_MAX};
      }
      break;
    case Kind::button:
      io.MouseDown[e.code] = e.down;
      break;
    case Kind::wheel:
      io.MouseWheelH += e.x;
      io.MouseWheel += e.y;
      break;
    case Kind::key:
      io.KeysDown[e.code] = e.down;
      break;
    case Kind::text:
      io.AddInputCharacter(e.character);
      break;
    case Kind::focus:
      io.AddFocusEvent(e.down);
      break;
  }
  io.KeyCtrl = io.KeysDown[key::kLeftControl] || io.KeysDown[key::kRightControl];
  io.KeyShift = io.KeysDown[key::kLeftShift] || io.KeysDown[key::kRightShift];
  io.KeyAlt = io.KeysDown[key::kLeftAlt] || io.KeysDown[key::kRightAlt];
  io.KeySuper = io.KeysDown[key::kLeftSuper] || io.KeysDown[key::kRightSuper];
}

void InputQueue::feed(double now) {
  ImGuiIO& io = ImGui::GetIO();
  Frame frame;
  double until = now;
  while (!events_.empty() && frame.takes(events_.front())) {
    const InputEvent event = events_.front();
    events_.pop_front();
    apply(event, io);
    frame.note(event);
    if (waiting()) until = std::min(now, event.seconds);
  }
  if (!waiting()) until = now;
  if (time_ < 0) time_ = until - 1.0 / 60;
  const double step = std::max(until - time_, kLeastStep);
  time_ += step;
  io.DeltaTime = static_cast<float>(step);
}

}  // namespace alphascope
