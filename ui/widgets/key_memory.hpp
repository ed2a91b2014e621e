// Where the keyboard is, among the fields and buttons of the window and of its dialogs. Plain data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace alphascope {

// What Space and Enter do with a widget that the keyboard has come to.
enum class KeyStop : std::uint8_t {
  press,            // as a click
  type,             // what is typed goes there as soon as Tab comes there, or a dialog opens
  path,             // the same; a dialog that opens selects the name without folder and ending
  type_when_asked,  // as type, but a dialog that opens does not begin with it
  number,           // a slider becomes a field
  slide             // the same, and Left and Right move it
};

struct KeyMemory {
  struct Stop {
    std::string name;
    unsigned id = 0;        // ImGui's
    std::size_t level = 0;  // 0: the window; n: the nth dialog
    KeyStop kind = KeyStop::press;
    bool visible = true;  // not scrolled out of sight
  };
  // Of each level: the widget that Tab goes on from, and whether it is marked.
  struct Place {
    std::string name;  // empty: none
    bool shown = false;
  };

  std::vector<Stop> stops, drawn;  // of the last frame and of this one, in the order of drawing
  std::vector<Place> at{{}};
  bool fresh = false;        // the dialog on top has just come, and takes the keyboard
  bool list_open = false;    // a menu or list, whose keys are its own
  bool list_at_end = false;  // of the last frame: a key may have closed it since
  bool untouched = false;    // nobody has done anything with the field that the dialog began with
  bool enter_used = false;   // in this frame, by the widget that the keyboard is at
  std::string typed;         // a slider that is to become a field
  std::string slid;          // a slider that an arrow key moves, by so many steps
  int steps = 0;
  // A field in which something else than all is to be selected: the name of a file, or nothing,
  // with the caret at the end.
  std::string caret;
  bool caret_selects = false;
  std::string field, field_text;  // that is typed into, and its text in the last frame
  bool begins = false;            // a field begins in the next frame, by type_into()
  // Typed in the frame in which a field begins: ImGui would drop it.
  std::vector<unsigned> held;
  bool alt_alone = false;  // went down, and nothing else since
  bool open_menu = false;  // the first menu of the bar is to open
  // Of the bar, in the last frame: the menu that is open, by its place, -1: none; and whether an
  // entry with a menu of its own is chosen or open in it.
  int bar_menu = -1;
  bool in_submenu = false;
  bool mark_list = false;  // what is chosen in the list that opens is to be seen at once
};

}  // namespace alphascope
