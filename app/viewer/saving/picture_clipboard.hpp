// SPDX-License-Identifier: GPL-3.0-or-later
// Puts pictures on the clipboard, by the usual program of the desktop. That program goes on
// offering the picture after the window is closed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace alphascope {

class CancelToken;

struct ClipboardProgram {
  std::filesystem::path program;
  std::vector<std::string> arguments;  // it reads a PNG picture from its standard input
};

// wl-copy under Wayland, otherwise xclip. Throws std::runtime_error with a sentence that names the
// missing package, or says that there is no display.
ClipboardProgram picture_clipboard();

// Throws std::runtime_error with the program's message if it refuses the picture, and Cancelled.
void copy_picture(const ClipboardProgram& clipboard, std::string_view png,
                  const CancelToken& cancel);

}  // namespace alphascope
