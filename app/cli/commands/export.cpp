// alphascope-cli export: a complex, its boundary or its balls in a file for another program.
#include <iostream>

#include "app/cli/commands.hpp"
#include "app/cli/outputs.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/cli/text/text.hpp"
#include "core/document/export/complex_export.hpp"
#include "core/run/work_threads.hpp"
#include "core/text/printable.hpp"

namespace alphascope::cli {
namespace {

namespace fs = std::filesystem;

const ExportFormatInfo& format_of(const ExportOptions& options) {
  if (!options.as.empty()) return *export_format_from_id(options.as);
  if (const ExportFormatInfo* const format = export_format_of(options.out)) return *format;
  if (options.out == "-") throw UsageError("--output - has no ending: say the format with --as.");
  throw UsageError("--output " + options.out.string() + ": the ending must be one of " +
                   export_endings() + ", or say the format with --as.");
}

ExportColours colours_of(const ExportOptions& options) {
  return options.colours == "chain"   ? ExportColours::chain
         : options.colours == "solid" ? ExportColours::solid
                                      : ExportColours::element;
}

// Opened before anything is computed.
std::vector<AtomicFile*> open_files(const ExportFormatInfo& format, const fs::path& path,
                                    Outputs& outputs) {
  if (format.script && path == "-") {
    throw UsageError("--output -: a script opens files that are written beside it. Name a file.");
  }
  std::vector<AtomicFile*> files;
  const std::string ending = std::string(".") + format.id;
  for (const fs::path& file : export_files(format, path)) {
    // Those beside a script are named by the format.
    files.push_back(file == path
                        ? outputs.add("--output", file.string(), {ending})
                        : outputs.add("--output", file.string(), {".pqr", ".glb", ".obj"}));
  }
  return files;
}

std::vector<std::string> write(const ExportSource& source, const ExportFormatInfo& format,
                               const fs::path& path, const std::vector<AtomicFile*>& files) {
  WorkThreads threads(source.answer.request.threads);
  try {
    std::vector<std::string> lines;
    threads.run([&] { lines = write_export(source, format, path, files, run_context()); });
    return lines;
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

}  // namespace

ExitCode run_export(const ExportOptions& options) {
  if (options.out.empty()) throw UsageError("--output needs the name of a file, or -.");
  const ExportFormatInfo& format = format_of(options);
  require_readable({options.input.file});
  Outputs outputs(files_read(options.input));
  const std::vector<AtomicFile*> files = open_files(format, options.out, outputs);
  const Input input = open_one_model(options.input, "A file shows one model.", run_context());
  EngineCache engines(&make_engine);
  const EngineAnswer result =
      engines.compute(input.prepared().balls, options.request, run_context());
  const ExportSource source{result,
                            input.molecule(),
                            input.prepared(),
                            complex_header(input, result),
                            colours_of(options),
                            times_wanted()};
  const std::vector<std::string> lines = write(source, format, options.out, files);
  outputs.commit();
  clear_progress();
  std::cout << input_text(input) << complex_text(result.complex);
  for (const fs::path& file : export_files(format, options.out)) {
    std::cout << "file        " << printable(file.string()) << "\n";
  }
  for (const std::string& line : lines) std::cout << "            " << line << "\n";
  return ExitCode::ok;
}

}  // namespace alphascope::cli
