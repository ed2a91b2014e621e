// SPDX-License-Identifier: GPL-3.0-or-later
// State of the keyboard focus, in the window and in each of its dialogs. Plain data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace alphascope {

// The effect of Space and Enter on a widget that has the keyboard focus.
enum class KeyStop : std::uint8_t {
  press,            // like a click
  type,             // typing begins as soon as Tab arrives, or when a dialog opens
  path,             // like type; a dialog that opens selects the file's name, without folder and
                    // ending
  type_when_asked,  // like type, but a dialog that opens does not begin with it
  number,           // the slider becomes a field
  slide             // like number; Left and Right move the slider
};

struct KeyState {
  struct Stop {
    std::string name;
    unsigned id = 0;        // ImGui's
    std::size_t level = 0;  // 0: the window; n: the nth dialog
    KeyStop kind = KeyStop::press;
    bool visible = true;  // not scrolled out of sight
  };
  // The widget from which Tab goes on, and whether a frame marks it. The window and each dialog
  // have one.
  struct Place {
    std::string name;  // empty: none
    bool shown = false;
  };

  std::vector<Stop> stops, drawn;  // stops of the last frame, and of this one so far; in the order
                                   // of drawing
  std::vector<Place> at{{}};
  bool fresh = false;        // the topmost dialog has just opened and takes the keyboard
  bool list_open = false;    // a menu or list is open and takes the keys
  bool list_at_end = false;  // at the end of the last frame; a key may have closed it since
  bool untouched = false;    // the field with which the dialog began is unchanged
  bool enter_used = false;   // in this frame, by the widget in focus
  std::string entered;       // field for a number or a colour in which Enter ended typing now
  std::string typed;         // a slider that is to become a field
  std::string slid;          // a slider that an arrow key moves by `steps`
  int steps = 0;
  // A text in front of the picture takes the keys that scroll it, and Escape.
  bool reading = false;
  // A field whose selection must be set: to the name of a file (caret_selects), or to nothing, with
  // the caret at the end.
  std::string caret;
  bool caret_selects = false;
  std::string field, field_text;  // the field that is typed into, and its text in the last frame
  bool begins = false;            // type_into(): a field begins in the next frame
  // Characters typed in the frame in which a field begins, which ImGui would drop.
  std::vector<unsigned> held;
  bool alt_alone = false;  // Alt is down, and nothing else was pressed since
  bool open_menu = false;  // the first menu of the bar has to open
  // Index of the open menu in the bar, in the last frame; -1: none. in_submenu: the entry chosen or
  // open in it has a menu of its own.
  int bar_menu = -1;
  bool in_submenu = false;
  bool mark_list = false;  // the chosen entry of the next list must be marked at once
};

}  // namespace alphascope
