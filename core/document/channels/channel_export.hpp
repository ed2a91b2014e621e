// What can be written of a channel for other programs: its surface, spheres along its line,
// scripts. The same for window and command line.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/document/channels/channel_results.hpp"
#include "core/document/export/file_writer.hpp"
#include "core/document/export/record_source.hpp"
#include "core/document/export/shape_export.hpp"

namespace alphascope {

std::span<const ShapeExportInfo> channel_exports();

// Where a channel comes from, printable, with the notes of the molecule's reader. `found` has a
// channel.
ShapeHeader channel_header(const FoundChannel& found, const RecordSource& source);

// A tube in the colours of the profile's bands. `glb`: else a PLY file. Does not commit. Throws
// WriteError.
void write_channel_surface(const FoundChannel& found, const RecordSource& source, bool glb,
                           AtomicFile& file);
// The samples as atoms of a PQR file, each with its clearance; those that a point does not pass are
// left out. Does not commit. Throws WriteError.
void write_channel_spheres(const FoundChannel& found, const RecordSource& source, AtomicFile& file);
// Colours the atoms that touch at the bottleneck. `format`: chimerax or pymol. Throws
// std::invalid_argument, a sentence, for a name that ChimeraX cannot read.
std::string channel_script(const FoundChannel& found, const RecordSource& source,
                           ShapeExport format, const ShapeScriptFiles& files);

// Of what is there already, so that it depends on nothing on screen.
Definition<FileWriter> channel_export(const ShapeExportInfo& format,
                                      const std::shared_ptr<const FoundChannel>& found,
                                      const RecordSource& source);

}  // namespace alphascope
