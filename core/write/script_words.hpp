// SPDX-License-Identifier: GPL-3.0-or-later
// File names, colours and comments in the languages of ChimeraX, PyMOL and VMD.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace alphascope {

// A line "# key value" for each entry.
std::string script_comments(const std::vector<std::pair<std::string, std::string>>& header);

// The colour as "#ff8000", with `before` in place of "#".
std::string hex_colour(const std::array<std::uint8_t, 3>& colour, const char* before);

// The name in quotes. Throws std::invalid_argument, with a sentence, if ChimeraX's language cannot
// express it. These are names with a control character, a backslash, or both kinds of quotes.
std::string chimerax_name(const std::filesystem::path& path);

// A Python expression with this value; needs "import os".
std::string python_name(const std::filesystem::path& path);

// A Python statement; also needs "from pymol import cmd".
std::string pymol_load(const std::filesystem::path& path, const char* object);

// The name in quotes for Tcl.
std::string tcl_name(const std::filesystem::path& path);

}  // namespace alphascope
