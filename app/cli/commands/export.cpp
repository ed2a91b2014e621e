// SPDX-License-Identifier: GPL-3.0-or-later
// Runs alphascope-cli export: writes a complex, its boundary or its balls for another program.
#include <iostream>

#include "app/cli/command.hpp"
#include "app/cli/failure.hpp"
#include "app/cli/option_groups.hpp"
#include "app/cli/outputs.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/cli/text/text.hpp"
#include "app/options/option_values.hpp"
#include "app/session/engine_cache.hpp"
#include "core/document/export/complex_export.hpp"
#include "core/run/work_threads.hpp"
#include "core/text/printable.hpp"

namespace alphascope::cli {
namespace {

struct ExportOptions {
  InputOptions input;
  Request request;
  std::filesystem::path out;  // "-" for standard output
  // An id in core/document/export/complex_export.hpp. Empty: by the ending of `out`.
  std::string as;
  std::string colours = "element";
};

namespace fs = std::filesystem;

const ExportFormatInfo& format_of(const ExportOptions& options) {
  if (!options.as.empty()) return *export_format_from_id(options.as);
  if (const ExportFormatInfo* const format = export_format_of(options.out)) return *format;
  if (options.out == "-")
    throw UsageError("Standard output has no ending. Name the format with --as.");
  throw UsageError("--output " + options.out.string() + ": the ending must be one of " +
                   export_endings() + ", or say the format with --as.");
}

ExportColours colours_of(const ExportOptions& options) {
  return options.colours == "chain"   ? ExportColours::chain
         : options.colours == "solid" ? ExportColours::solid
                                      : ExportColours::element;
}

// Opens all files of the format, before the computation.
std::vector<AtomicFile*> open_files(const ExportFormatInfo& format, const fs::path& path,
                                    Outputs& outputs) {
  if (format.surface != nullptr && path == "-") {
    throw UsageError(
        "A script opens files that are written beside it, so it cannot go to standard output. Name "
        "a file.");
  }
  std::vector<AtomicFile*> files;
  const std::string ending = std::string(".") + format.id;
  for (const fs::path& file : export_files(format, path)) {
    // Files beside the first have names that the format chooses.
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

ExitCode run_export(const ExportOptions& options) {
  if (options.out.empty()) throw UsageError("--output needs the name of a file, or -.");
  const ExportFormatInfo& format = format_of(options);
  require_readable({options.input.file});
  Outputs outputs(files_read(options.input));
  const std::vector<AtomicFile*> files = open_files(format, options.out, outputs);
  const Input input = open_one_model(options.input, "export writes one model.", run_context());
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

OptionCommand table_of_export(ExportOptions& options) {
  OptionCommand command{
      "export", "Write the boundary, simplices or balls for another program, by the ending", {}};
  std::string formats;
  for (const ExportFormatInfo& format : export_formats()) {
    formats += (formats.empty() ? "" : "|") + std::string(format.id);
  }
  command.options = {
      one_file(options.input), alpha(options.request),
      required(path_option({"-o,--output", "OUT.EXT", "File to write; - for standard output"},
                           options.out)),
      with_default(choice_option({"--as", formats, "Format"}, options.as),
                   "by the ending of OUT.EXT"),
      choice_option({"--colours", "element|chain|solid", "Colours of the boundary"},
                    options.colours)};
  append(command.options, engine(options.request, true));
  append(command.options, input(options.input));
  command.check = [&options] { require_tuple_engine(options.request); };
  return command;
}

}  // namespace

Command export_command() {
  return make_command<ExportOptions>(table_of_export, run_export,
                                     {"alphascope-cli export 1crn.pdb --alpha 1.4 -o 1crn.glb"});
}

}  // namespace alphascope::cli
