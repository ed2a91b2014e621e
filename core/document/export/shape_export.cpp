// SPDX-License-Identifier: GPL-3.0-or-later
// Names the files of an export of shapes, and checks whether a script could open the molecule.
#include "core/document/export/shape_export.hpp"

#include "core/molecule/molecule.hpp"

namespace alphascope {

namespace fs = std::filesystem;

bool is_script(ShapeExport format) {
  return format == ShapeExport::chimerax || format == ShapeExport::pymol;
}

std::vector<fs::path> shape_export_files(ShapeExport format, const fs::path& path) {
  std::vector<fs::path> files{path};
  const auto beside = [&](const char* ending) {
    files.push_back(path.parent_path() / (path.stem().string() + ending));
  };
  if (is_script(format)) beside("-spheres.pqr");
  if (format == ShapeExport::chimerax) beside("-surface.glb");
  return files;
}

ShapeScriptFiles script_files(ShapeExport format, const fs::path& path) {
  const std::vector<fs::path> names = shape_export_files(format, path);
  ShapeScriptFiles files{fs::absolute(names.at(1)), {}};
  if (format == ShapeExport::chimerax) files.surface = fs::absolute(names.at(2));
  return files;
}

std::string why_no_script(const Molecule& molecule) {
  if (molecule.format == "PDB" || molecule.format == "mmCIF" || molecule.format == "PQR") return {};
  return "ChimeraX and PyMOL do not open " + molecule.format +
         " files. Give a PDB, mmCIF or PQR file.";
}

}  // namespace alphascope
