// Formats in which shapes, of cavities or channels, are written for other programs, and the files
// that each of them is.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/molecule/molecule.hpp"

namespace alphascope {

enum class ShapeExport : std::uint8_t { ply, glb, spheres, chimerax, pymol };

struct ShapeExportInfo {
  ShapeExport format;
  const char* ending;  // ".ply"
  const char* name;    // "PLY: surfaces"
  const char* what;    // what is in it, and for whom: a phrase
  const char* id;      // of the derived result
};

bool is_script(ShapeExport format);

// The files that an export to `path` is: itself and, of a script, NAME-spheres.pqr and, for
// ChimeraX, NAME-surface.glb in the same folder.
std::vector<std::filesystem::path> shape_export_files(ShapeExport format,
                                                      const std::filesystem::path& path);

// Where a file comes from: keys and values, all printable.
using ShapeHeader = std::vector<std::pair<std::string, std::string>>;

// Files that a script opens besides the molecule's; absolute, or empty for none.
struct ShapeScriptFiles {
  std::filesystem::path spheres, surface;
};
// Of what shape_export_files() says.
ShapeScriptFiles script_files(ShapeExport format, const std::filesystem::path& path);
// A sentence where the programs do not open the molecule's file, or there is none; empty: they do.
std::string why_no_script(const Molecule& molecule);

}  // namespace alphascope
