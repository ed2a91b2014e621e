// What mouse and keyboard did, in order, for a window whose frames can be slow. ImGui 1.86 looks at
// the state of both once a frame: what goes down and up between two frames would be lost. Here it
// waits, and each frame is given as much as it can tell apart.
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
  double seconds = 0;      // when it came, on the clock of feed()
};

class InputQueue {
 public:
  void push(const InputEvent& event);
  // Some events came too late for the frame that feed() was last called for: another frame is due.
  bool waiting() const { return !events_.empty(); }

  // Hands the next frame of the current ImGui context its events and its DeltaTime. `now` in
  // seconds, of any steady clock. While events wait, time goes by as they came.
  void feed(double now);

 private:
  // What a frame has been given so far.
  struct Frame {
    bool moved = false, button = false, wheel = false, text = false;
    bool press = false;      // of a key that is no modifier, or a button
    bool printing = false;   // the key pressed writes a character
    std::bitset<512> keys;   // changed
    std::bitset<3> buttons;  // changed
    bool takes(const InputEvent& event) const;
    void note(const InputEvent& event);
  };

  void apply(const InputEvent& event, ImGuiIO& io);

  std::deque<InputEvent> events_;
  double time_ = -1;  // of the last frame
};

}  // namespace alphascope
