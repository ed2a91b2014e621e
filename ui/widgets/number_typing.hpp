// SPDX-License-Identifier: GPL-3.0-or-later
// The number that the user is typing, and texts that number fields refused. Plain data.
#pragma once

#include <map>
#include <string>

namespace alphascope {

// Text that was typed into a field and that the field refused.
struct RefusedNumber {
  std::string text, error;
  std::string value;  // value of the field before
  int frame = 0;      // the last frame in which the field was drawn
  bool told = true;   // shown below the field, until a click elsewhere
};

struct NumberTyping {
  std::string name;  // name of the field; empty: none
  std::string text;
  bool focus = false;                            // the field is to get the keyboard focus
  std::map<std::string, RefusedNumber> refused;  // by name of the field
  // The frame that last showed why a number was refused, and the field's left upper corner.
  int reason_frame = 0;
  float reason_x = 0, reason_y = 0;
};

}  // namespace alphascope
