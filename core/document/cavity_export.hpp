// What can be written of cavities for other programs: surfaces, spheres that fill them, scripts.
// The same for window and command line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/document/cavity_records.hpp"
#include "core/document/cavity_tables.hpp"
#include "core/document/file_writer.hpp"

namespace alphascope {

enum class CavityExport : std::uint8_t { ply, glb, spheres, chimerax, pymol };

struct CavityExportInfo {
  CavityExport format;
  const char* ending;  // ".ply"
  const char* name;    // "PLY: surfaces"
  const char* what;    // what is in it, and for whom: a phrase
  const char* id;      // of the derived result
};
std::span<const CavityExportInfo> cavity_exports();

// Of the rows of the facts, in their order. `header`: printable; where it comes from.
struct CavityExportSource {
  const CavityFacts& facts;
  std::vector<std::pair<std::string, std::string>> header;
};

// A mesh for each cavity, in its colour. `glb`: else a PLY file. Does not commit. Throws
// WriteError.
void write_cavity_surfaces(const CavityExportSource& source, bool glb, AtomicFile& file);
// As atoms of a PQR file. In the caller's task arena. Does not commit. Throws WriteError,
// Cancelled.
void write_cavity_spheres(const CavityExportSource& source, AtomicFile& file,
                          const CancelToken& cancel);

// Files that a script opens besides the molecule's; absolute, or empty for none.
struct CavityScriptFiles {
  std::filesystem::path spheres, surface;
};
// A sentence where the programs do not open the molecule's file, or there is none; empty: they do.
std::string why_no_cavity_script(const Molecule& molecule);
// `format`: chimerax or pymol. Throws std::invalid_argument, a sentence, for a name that ChimeraX
// cannot read.
std::string cavity_script(const CavityExportSource& source, CavityExport format,
                          const CavityScriptFiles& files);

// The files that an export to `path` is: itself and, of a script, NAME-spheres.pqr and, for
// ChimeraX, NAME-surface.glb in the same folder.
std::vector<std::filesystem::path> cavity_export_files(CavityExport format,
                                                       const std::filesystem::path& path);
// Of the table on screen. Not without Inputs::atoms, which are those of `source`.
Definition<FileWriter> cavity_export(const CavityExportInfo& format, const CavityRowsWanted& rows,
                                     const RecordSource& source);

}  // namespace alphascope
