// SPDX-License-Identifier: GPL-3.0-or-later
// Scripts that show a complex in ChimeraX, PyMOL and VMD. The balls appear as atoms, with the
// boundary of the tetrahedra. Both are read from files beside the script.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace alphascope {

struct ComplexScript {
  std::filesystem::path balls;     // PQR; absolute path
  std::filesystem::path boundary;  // GLB for ChimeraX, OBJ for PyMOL and VMD; absolute path
  struct Group {
    std::string name;                    // an element's symbol or a chain
    std::array<std::uint8_t, 3> colour;  // sRGB
  };
  std::vector<Group> groups;
  bool by_chain = false;                                    // whether the groups are chains
  std::vector<std::pair<std::string, std::string>> header;  // printable; written as comments
};

// The scale of balls, the same as in the window. Smaller balls leave the boundary visible.
inline constexpr double kScriptBallScale = 0.25;

// Throws std::invalid_argument with a sentence if ChimeraX's language cannot express a file name
// (script_words.hpp).
std::string chimerax_complex_script(const ComplexScript& script);
std::string pymol_complex_script(const ComplexScript& script);
// VMD uses its own colours, by element or by chain.
std::string vmd_complex_script(const ComplexScript& script);

}  // namespace alphascope
