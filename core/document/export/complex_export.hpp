// Exports of a complex for other programs, for window and command line. The ending of the file's
// name determines the format.
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
  const char* what;      // content and target programs, as a phrase
  bool colours = false;  // it has colours
  bool script = false;   // opens two more files, which are written too
};
std::span<const ExportFormatInfo> export_formats();
// The format by the ending of a name, in upper or lower case; null if there is no such format.
const ExportFormatInfo* export_format_of(const std::filesystem::path& path);
const ExportFormatInfo* export_format_from_id(const std::string& id);
// ".ply, .obj, …"
std::string export_endings();

// Colours of the boundary's vertices; `solid` gives each solid one colour.
enum class ExportColours : std::uint8_t { element, chain, solid };

// A request to export the complex on screen.
struct ExportRequest {
  std::filesystem::path path;  // its ending determines the format
  ExportColours colours = ExportColours::element;
};

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
