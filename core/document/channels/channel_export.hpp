// SPDX-License-Identifier: GPL-3.0-or-later
// Exports of a channel for other programs: its surface, spheres along its line, scripts. Window and
// command line both use them.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/document/channels/channel_results.hpp"
#include "core/document/export/file_writer.hpp"
#include "core/document/export/shape_export.hpp"

namespace alphascope {

struct RecordSource;

std::span<const ShapeExportInfo> channel_exports();

// Provenance of a channel in printable text, with the notes of the molecule's reader. Requires
// found.channel.
ShapeHeader channel_header(const FoundChannel& found, const RecordSource& source);

// Writes a tube in the colours of the profile's bands, as GLB if `glb` is true, otherwise as PLY.
// Does not commit. Throws WriteError.
void write_channel_surface(const FoundChannel& found, const RecordSource& source, bool glb,
                           AtomicFile& file);
// Writes the samples as atoms of a PQR file, each with its clearance. Samples with no room for a
// point are skipped. Does not commit. Throws WriteError.
void write_channel_spheres(const FoundChannel& found, const RecordSource& source, AtomicFile& file);
// A script for ChimeraX or PyMOL, by `format`. It colours the atoms that touch at the bottleneck.
// Throws std::invalid_argument with a sentence if ChimeraX cannot read a file's name.
std::string channel_script(const FoundChannel& found, const RecordSource& source,
                           ShapeExport format, const ShapeScriptFiles& files);

// Writes a channel that exists already, so the result does not depend on the complex on screen.
Definition<FileWriter> channel_export(const ShapeExportInfo& format,
                                      const std::shared_ptr<const FoundChannel>& found,
                                      const RecordSource& source);

}  // namespace alphascope
