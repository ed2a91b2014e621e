// Scripts that show cavities or a channel in other programs: ChimeraX (.cxc) and PyMOL (.pml). They
// open the molecule, colour the atoms that line each cavity, and open spheres and surfaces where
// there are files of them.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/molecule/molecule.hpp"

namespace alphascope {

struct ScriptCavity {
  std::size_t number = 1;
  std::array<std::uint8_t, 3> colour{};  // sRGB
  // Indices into Molecule::atoms; copies that an assembly makes are not in the file, and left out.
  std::vector<std::size_t> lining;
};

struct ViewerScript {
  const Molecule* molecule = nullptr;
  std::filesystem::path file;              // of the molecule; absolute
  std::filesystem::path spheres, surface;  // PQR and GLB; absolute, or empty for none
  std::vector<ScriptCavity> cavities;      // or channels
  std::vector<std::pair<std::string, std::string>> header;  // printable; becomes comments
  std::string what = "cavity";                              // their name, before their number
};

// Throws std::invalid_argument, with a sentence, for a file name that ChimeraX's language cannot
// say: one with a line end or other control character, a backslash, or both kinds of quotes.
std::string chimerax_script(const ViewerScript& script);

// Its commands are Python, which can say every name.
std::string pymol_script(const ViewerScript& script);

}  // namespace alphascope
