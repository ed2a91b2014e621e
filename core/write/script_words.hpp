// How file names, colours and comments are said in the languages of ChimeraX, PyMOL and VMD.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace alphascope {

// A line "# key value" for each.
std::string script_comments(const std::vector<std::pair<std::string, std::string>>& header);

// "#ff8000", with `before` in place of "#".
std::string hex_colour(const std::array<std::uint8_t, 3>& colour, const char* before);

// Quoted. Throws std::invalid_argument, with a sentence, for a name that ChimeraX's language cannot
// say: one with a control character, a backslash, or both kinds of quotes.
std::string chimerax_name(const std::filesystem::path& path);

// A Python expression that is this name; needs "import os".
std::string python_name(const std::filesystem::path& path);

// A Python statement; needs "from pymol import cmd" as well.
std::string pymol_load(const std::filesystem::path& path, const char* object);

// Quoted for Tcl.
std::string tcl_name(const std::filesystem::path& path);

}  // namespace alphascope
