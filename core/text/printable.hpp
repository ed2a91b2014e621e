// SPDX-License-Identifier: GPL-3.0-or-later
// Makes text from files safe to show on a terminal, in a window or in a table. A title may hold
// escape sequences that change colours, the window's title or earlier output. Names may hold bytes
// that are no UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace alphascope {

// Valid UTF-8 on one line. Each character that is neither visible nor a blank becomes an escape, as
// programming languages write it. "\x1B" stands for ESC. Bytes that are no UTF-8 are written in the
// same form. "\u202E" stands for a change of the writing direction, and so on for other invisible
// characters. So different texts stay different. A tab becomes a blank.
std::string printable(std::string_view text);

// Does the text stay unchanged under printable()?
bool is_printable(std::string_view text);

// JSON in which every character that printable() would change, except line ends, is a JSON escape
// such as "\u009b". A reader gets the original characters.
std::string printable_json(std::string_view json);

// The first 60 bytes of a text, printable, for messages.
std::string shortened(std::string_view text);

}  // namespace alphascope
