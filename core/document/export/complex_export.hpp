// What can be written of a complex for other programs: the same for window and command line. The
// ending of the file's name says the format.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/document/store/answer.hpp"
#include "core/write/write_complex.hpp"

namespace alphascope {

enum class ExportFormat : std::uint8_t {
  ply,
  obj,
  stl,
  off,
  glb,
  vtu,
  vtp,
  xyzr,
  pqr,
  alpha,
  parallelac,
  svg,
  csv,
  chimerax,
  pymol,
  vmd
};

struct ExportFormatInfo {
  ExportFormat format;
  const char* id;        // the ending without its dot: "ply"
  const char* name;      // "PLY"
  const char* what;      // what is in it, and for whom: a phrase
  bool colours = false;  // there are some
  bool script = false;   // opens two more files, which are written beside it
};
std::span<const ExportFormatInfo> export_formats();
// By the ending of a name, in any case; null when there is no such format.
const ExportFormatInfo* export_format_of(const std::filesystem::path& path);
const ExportFormatInfo* export_format_from_id(const std::string& id);
// ".ply, .obj, …"
std::string export_endings();

// Of vertices of the boundary; a solid has one colour.
enum class ExportColours : std::uint8_t { element, chain, solid };

// The complex on screen, for another program.
struct ExportRequest {
  std::filesystem::path path;  // its ending says the format
  ExportColours colours = ExportColours::element;
};

struct ExportSource {
  const EngineAnswer& answer;
  const Molecule& molecule;
  const PreparedBalls& prepared;
  ComplexHeader header;  // where it comes from
  ExportColours colours = ExportColours::element;
  bool times = true;  // false: what depends on time and threads is left out of tables
};

// The files that an export to `path` is: itself and, of a script, NAME-balls.pqr and
// NAME-boundary.glb or .obj in the same folder.
std::vector<std::filesystem::path> export_files(const ExportFormatInfo& format,
                                                const std::filesystem::path& path);

// Writes to `files`, which are open for export_files(format, path), in this order. Returns what was
// written, and what the format leaves out, in lines without an end. Does not commit. Throws
// WriteError, Cancelled, and std::invalid_argument, a sentence, for what cannot be written so.
std::vector<std::string> write_export(const ExportSource& source, const ExportFormatInfo& format,
                                      const std::filesystem::path& path,
                                      const std::vector<AtomicFile*>& files,
                                      const RunContext& context);

}  // namespace alphascope
