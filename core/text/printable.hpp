// Text that comes from a file, made safe to show: on a terminal, in a window, in a table. A title
// may hold escape sequences that change colours, the window's title or what was printed before, and
// names may hold bytes that are no UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace alphascope {

// Correct UTF-8 on one line, in which everything that is no visible character or blank stands as it
// would in a program: "\x1B" for the byte of ESC and for bytes that are no UTF-8, "\u202E" for what
// turns the direction of writing round, and for other characters that cannot be seen. So texts that
// differ stay different. A tab becomes a blank.
std::string printable(std::string_view text);

// Whether printable() would change nothing.
bool is_printable(std::string_view text);

// JSON as it is written, with every character that printable() would change (but line ends) as JSON
// has it: "\u009b". A reader gets back what was there.
std::string printable_json(std::string_view json);

// The first characters of a text, printable, for messages.
std::string shortened(std::string_view text);

}  // namespace alphascope
