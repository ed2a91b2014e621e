// SPDX-License-Identifier: GPL-3.0-or-later
// Queues events of mouse and keyboard in their order, because frames can be slow. ImGui 1.86 looks
// at the state of both once a frame. So a press and release between two frames would be lost. Here
// events wait, and each frame gets as many as it can tell apart.
#pragma once

#include <bitset>
#include <deque>

struct ImGuiIO;

namespace alphascope {

struct InputEvent {
  enum class Kind { move, leave, button, wheel, key, text, focus };
  Kind kind = Kind::move;
  float x = 0, y = 0;      // move: pixels; wheel: steps
  int code = 0;            // button: 0 left, 1 right, 2 middle; key: as in keys.hpp
  bool down = false;       // button, key; focus: gained
  unsigned character = 0;  // text: Unicode
  double seconds = 0;      // time of the event, on the clock of feed()
};

class InputQueue {
 public:
  void push(const InputEvent& event);
  // Whether events are left that the last feed() could not give to its frame. If so, another frame
  // must be drawn.
  bool waiting() const { return !events_.empty(); }

  // Gives the next frame of the current ImGui context its events and its DeltaTime. `now` is in
  // seconds, on any steady clock. While events wait, frames get the events' own times.
  void feed(double now);

 private:
  // Events that a frame has been given so far.
  struct Frame {
    bool moved = false, button = false, wheel = false, text = false;
    bool press = false;      // of a button, or of a key that is not a modifier
    bool printing = false;   // the key pressed writes a character
    std::bitset<512> keys;   // keys that changed
    std::bitset<3> buttons;  // buttons that changed
    bool takes(const InputEvent& event) const;
    void note(const InputEvent& event);
  };

  void apply(const InputEvent& event, ImGuiIO& io);

  std::deque<InputEvent> events_;
  double time_ = -1;  // of the last frame, seconds
};

}  // namespace alphascope
