// SPDX-License-Identifier: GPL-3.0-or-later
// Formats of shapes (cavities or channels) for other programs, and the files of each format.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace alphascope {

enum class ShapeExport : std::uint8_t { ply, glb, spheres, chimerax, pymol };
struct Molecule;

struct ShapeExportInfo {
  ShapeExport format;
  const char* ending;  // ".ply"
  const char* name;    // "PLY: surfaces"
  const char* what;    // content and target programs, as a phrase
  const char* id;      // of the derived result
};

bool is_script(ShapeExport format);

// The files of an export to `path`: the file itself. For a script also NAME-spheres.pqr and, for
// ChimeraX, NAME-surface.glb in the same folder.
std::vector<std::filesystem::path> shape_export_files(ShapeExport format,
                                                      const std::filesystem::path& path);

// Provenance as keys and values, all printable.
using ShapeHeader = std::vector<std::pair<std::string, std::string>>;

// Files that a script opens beside the molecule's: absolute paths; empty: none.
struct ShapeScriptFiles {
  std::filesystem::path spheres, surface;
};
// Takes the files from shape_export_files().
ShapeScriptFiles script_files(ShapeExport format, const std::filesystem::path& path);
// A sentence if the programs cannot open the molecule's file; empty if they can.
std::string why_no_script(const Molecule& molecule);

}  // namespace alphascope
