// SPDX-License-Identifier: GPL-3.0-or-later
// Exports of a complex for other programs, for window and command line. The ending of the file's
// name determines the format.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/document/export/export_request.hpp"
#include "core/document/store/answer.hpp"
#include "core/write/write_complex.hpp"

namespace alphascope {

struct ExportFormatInfo {
  const char* id;        // the ending without its dot: "ply"
  const char* name;      // "PLY"
  const char* what;      // content and target programs, as a phrase
  bool colours = false;  // it has colours
  // Of a script, which opens two more files that are written too: the ending of the name of its
  // surface, "-boundary.glb". Null: no script.
  const char* surface = nullptr;
};
std::span<const ExportFormatInfo> export_formats();
// The format by the ending of a name, in upper or lower case; null if there is no such format.
const ExportFormatInfo* export_format_of(const std::filesystem::path& path);
const ExportFormatInfo* export_format_from_id(const std::string& id);
// ".ply, .obj, …"
std::string export_endings();

struct ExportSource {
  const EngineAnswer& answer;
  const Molecule& molecule;
  const PreparedBalls& prepared;
  ComplexHeader header;  // provenance
  ExportColours colours = ExportColours::element;
  bool times = true;  // false: tables omit values that depend on time and threads
};

// The files of an export to `path`: the file itself. For a script also NAME-balls.pqr and
// NAME-boundary.glb or .obj in the same folder.
std::vector<std::filesystem::path> export_files(const ExportFormatInfo& format,
                                                const std::filesystem::path& path);

// Writes to `files`, which must be open for export_files(format, path), in this order. Returns
// lines on the written content and on parts that the format omits, without line ends. Does not
// commit. Throws WriteError, Cancelled, and std::invalid_argument with a sentence if the format
// cannot hold the complex.
std::vector<std::string> write_export(const ExportSource& source, const ExportFormatInfo& format,
                                      const std::filesystem::path& path,
                                      const std::vector<AtomicFile*>& files,
                                      const RunContext& context);

}  // namespace alphascope
