// SPDX-License-Identifier: GPL-3.0-or-later
// Exports of cavities for other programs: surfaces, spheres that fill them, scripts. Window and
// command line both use them.
#pragma once

#include <span>
#include <string>

#include "core/document/cavities/cavity_records.hpp"
#include "core/document/cavities/cavity_tables.hpp"
#include "core/document/export/file_writer.hpp"
#include "core/document/export/shape_export.hpp"

namespace alphascope {

template <class T>
struct Definition;

std::span<const ShapeExportInfo> cavity_exports();

// Exports the rows of `facts`, in their order. `header` states their provenance in printable text.
struct CavityExportSource {
  const CavityFacts& facts;
  ShapeHeader header;
};

// Writes a mesh for each cavity, in its colour, as GLB if `glb` is true, otherwise as PLY. Does not
// commit. Throws WriteError.
void write_cavity_surfaces(const CavityExportSource& source, bool glb, AtomicFile& file);
// Writes spheres as atoms of a PQR file. Uses the caller's task arena. Does not commit. Throws
// WriteError and Cancelled.
void write_cavity_spheres(const CavityExportSource& source, AtomicFile& file,
                          const CancelToken& cancel);

// A script for ChimeraX or PyMOL, by `format`. Throws std::invalid_argument with a sentence if
// ChimeraX cannot read a file's name.
std::string cavity_script(const CavityExportSource& source, ShapeExport format,
                          const ShapeScriptFiles& files);

// Writes the table on screen. Requires Inputs::atoms, which must be those of `source`.
Definition<FileWriter> cavity_export(const ShapeExportInfo& format, const CavityRowsWanted& rows,
                                     const RecordSource& source);

}  // namespace alphascope
