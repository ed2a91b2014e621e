// SPDX-License-Identifier: GPL-3.0-or-later
// Writes file names, colours and comments in the languages of other programs.
#include "core/write/script_words.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <stdexcept>

#include "core/text/printable.hpp"

namespace alphascope {
namespace {

// A Python literal of these bytes.
std::string bytes_literal(const std::string& bytes) {
  std::string text = "b'";
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f && c != '\'' && c != '\\') {
      text += c;
    } else {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\x%02x", byte);
      text += escape;
    }
  }
  return text + "'";
}

}  // namespace

std::string script_comments(const std::vector<std::pair<std::string, std::string>>& header) {
  std::string text;
  for (const auto& [key, value] : header) {
    text += "# " + key + " " + printable(value);
    // A backslash at the end would join the next line to the comment.
    if (text.back() == '\\') text += ' ';
    text += '\n';
  }
  return text;
}

std::string hex_colour(const std::array<std::uint8_t, 3>& colour, const char* before) {
  char text[16];
  std::snprintf(text, sizeof text, "%s%02x%02x%02x", before, colour[0], colour[1], colour[2]);
  return text;
}

std::string chimerax_name(const std::filesystem::path& path) {
  const std::string name = path.string();
  const bool control = std::any_of(name.begin(), name.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
  });
  const bool single = name.find('\'') != name.npos, both = single && name.find('"') != name.npos;
  if (control || both || name.find('\\') != name.npos) {
    throw std::invalid_argument(
        "A ChimeraX script cannot name the file " + printable(name) +
        ": its name has a control character, a backslash or both kinds of quotes. Rename it, or "
        "write a PyMOL script (.pml).");
  }
  const char quote = single ? '"' : '\'';
  return quote + name + quote;
}

std::string python_name(const std::filesystem::path& path) {
  return "os.fsdecode(" + bytes_literal(path.string()) + ")";
}

std::string pymol_load(const std::filesystem::path& path, const char* object) {
  return "cmd.load(" + python_name(path) + ", '" + object + "')\n";
}

std::string tcl_name(const std::filesystem::path& path) {
  std::string text = "\"";
  for (const char c : path.string()) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain =
        std::isalnum(byte) != 0 || byte >= 0x80 || c == '/' || c == '.' || c == '_' || c == '-';
    if (plain) {
      text += c;
    } else {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\%03o", byte);
      text += escape;
    }
  }
  return text + "\"";
}

}  // namespace alphascope
