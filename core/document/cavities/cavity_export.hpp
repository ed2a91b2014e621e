// What can be written of cavities for other programs: surfaces, spheres that fill them, scripts.
// The same for window and command line.
#pragma once

#include <span>
#include <string>

#include "core/document/cavities/cavity_records.hpp"
#include "core/document/cavities/cavity_tables.hpp"
#include "core/document/export/file_writer.hpp"
#include "core/document/export/shape_export.hpp"

namespace alphascope {

std::span<const ShapeExportInfo> cavity_exports();

// Of the rows of the facts, in their order. `header`: printable; where it comes from.
struct CavityExportSource {
  const CavityFacts& facts;
  ShapeHeader header;
};

// A mesh for each cavity, in its colour. `glb`: else a PLY file. Does not commit. Throws
// WriteError.
void write_cavity_surfaces(const CavityExportSource& source, bool glb, AtomicFile& file);
// As atoms of a PQR file. In the caller's task arena. Does not commit. Throws WriteError,
// Cancelled.
void write_cavity_spheres(const CavityExportSource& source, AtomicFile& file,
                          const CancelToken& cancel);

// `format`: chimerax or pymol. Throws std::invalid_argument, a sentence, for a name that ChimeraX
// cannot read.
std::string cavity_script(const CavityExportSource& source, ShapeExport format,
                          const ShapeScriptFiles& files);

// Of the table on screen. Not without Inputs::atoms, which are those of `source`.
Definition<FileWriter> cavity_export(const ShapeExportInfo& format, const CavityRowsWanted& rows,
                                     const RecordSource& source);

}  // namespace alphascope
