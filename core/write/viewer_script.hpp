// SPDX-License-Identifier: GPL-3.0-or-later
// Scripts that show cavities or a channel in ChimeraX (.cxc) and PyMOL (.pml). They open the
// molecule and colour the atoms that line each cavity. They also open files of spheres and
// surfaces, if there are any.
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
  // Indices into Molecule::atoms. An assembly's copies are left out, because the file does not have
  // them.
  std::vector<std::size_t> lining;
};

struct ViewerScript {
  const Molecule* molecule = nullptr;
  std::filesystem::path file;              // of the molecule; absolute path
  std::filesystem::path spheres, surface;  // PQR and GLB; absolute paths; empty: none
  std::vector<ScriptCavity> cavities;      // or channels
  std::vector<std::pair<std::string, std::string>> header;  // printable; written as comments
  std::string what = "cavity";                              // their name, written before the number
};

// Throws std::invalid_argument, with a sentence, if ChimeraX's language cannot express a file name.
// These are names with a line end or other control character, a backslash, or both kinds of quotes.
std::string chimerax_script(const ViewerScript& script);

// Its commands are Python, which can express every name.
std::string pymol_script(const ViewerScript& script);

}  // namespace alphascope
