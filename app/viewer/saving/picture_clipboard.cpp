// SPDX-License-Identifier: GPL-3.0-or-later
// Finds and runs wl-copy or xclip. GLFW offers texts only.
#include "app/viewer/saving/picture_clipboard.hpp"

#include <cstdint>
#include <cstdlib>
#include <span>
#include <stdexcept>

#include "core/run/child_program.hpp"
#include "core/text/printable.hpp"

namespace alphascope {
namespace {

struct Way {
  const char* variable;  // of the environment: the display that the program needs
  const char *program, *package;
  std::vector<std::string> arguments;
};

const std::vector<Way>& ways() {
  static const std::vector<Way> all{
      {"WAYLAND_DISPLAY", "wl-copy", "wl-clipboard", {"--type", "image/png"}},
      {"DISPLAY", "xclip", "xclip", {"-selection", "clipboard", "-t", "image/png", "-i"}}};
  return all;
}

bool is_set(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && value[0] != '\0';
}

}  // namespace

ClipboardProgram picture_clipboard() {
  const Way* missing = nullptr;
  for (const Way& way : ways()) {
    if (!is_set(way.variable)) continue;
    if (const auto program = find_program(way.program)) return {*program, way.arguments};
    if (missing == nullptr) missing = &way;
  }
  if (missing == nullptr) {
    throw std::runtime_error(
        "Cannot copy the picture: there is no display with a clipboard. Save it as a file.");
  }
  throw std::runtime_error("Cannot copy the picture: the program " + std::string(missing->program) +
                           " is missing. Install the package " + missing->package +
                           ", or save the picture as a file.");
}

void copy_picture(const ClipboardProgram& clipboard, std::string_view png,
                  const CancelToken& cancel) {
  ChildProgram child(clipboard.program, clipboard.arguments);
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(png.data());
  const bool taken = child.write({bytes, png.size()}, cancel);
  const int status = child.finish(cancel);
  if (taken && status == 0) return;
  const std::string why = child.error_output();
  throw std::runtime_error(
      "Cannot copy the picture: " + printable(clipboard.program.filename().string()) +
      (why.empty() ? " ended with code " + std::to_string(status) + "."
                   : " says: " + printable(why)));
}

}  // namespace alphascope
