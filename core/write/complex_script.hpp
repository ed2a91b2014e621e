// Scripts that show a complex in ChimeraX, PyMOL and VMD: its balls as atoms and the boundary of
// its tetrahedra, from files that are written beside the script.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace alphascope {

struct ComplexScript {
  std::filesystem::path balls;     // PQR; absolute
  std::filesystem::path boundary;  // GLB for ChimeraX, OBJ for PyMOL and VMD; absolute
  struct Group {
    std::string name;                    // a symbol of an element, or a chain
    std::array<std::uint8_t, 3> colour;  // sRGB
  };
  std::vector<Group> groups;
  bool by_chain = false;                                    // the groups are chains
  std::vector<std::pair<std::string, std::string>> header;  // printable; becomes comments
};

// Balls are drawn this much smaller, as in the window, so that the boundary shows.
inline constexpr double kScriptBallScale = 0.25;

// Throws std::invalid_argument, with a sentence, for a file name that ChimeraX's language cannot
// say (script_words.hpp).
std::string chimerax_complex_script(const ComplexScript& script);
std::string pymol_complex_script(const ComplexScript& script);
// VMD takes its own colours, by element or by chain.
std::string vmd_complex_script(const ComplexScript& script);

}  // namespace alphascope
