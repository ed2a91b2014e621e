// SPDX-License-Identifier: GPL-3.0-or-later
// The program's own options, and the notes of its help: formats, exit codes, examples.
#include "app/cli/command_table.hpp"

#include "app/cli/option_groups.hpp"
#include "app/options/manual_entries.hpp"
#include "app/options/option_values.hpp"
#include "app/session/version.hpp"
#include "core/document/export/complex_export.hpp"

namespace alphascope::cli {
namespace {

Option no_times_option(bool& times) {
  return flag_option(
      "--no-times",
      "Leave times and threads out of all results, so that equal requests give identical files",
      times, false);
}

// The options -q and -v.
Options verbosity_options(Verbosity& verbosity) {
  Option quiet{.names = "-q,--quiet",
               .text = "Print results and errors only: no notes, no times, no progress"};
  quiet.set = [&verbosity](const std::string&) { verbosity = Verbosity::quiet; };
  Option verbose{.names = "-v,--verbose",
                 .text =
                     "Also print progress as lines on standard error, and with each result the "
                     "time for opening and the memory used"};
  verbose.set = [&verbosity](const std::string&) { verbosity = Verbosity::verbose; };
  return {quiet, verbose};
}

OptionNotes format_notes() {
  OptionNotes notes{"Formats of export, by the ending", {}};
  for (const ExportFormatInfo& format : export_formats()) {
    std::string ending = "." + std::string(format.id);
    ending.resize(8, ' ');
    notes.lines.push_back(ending + format.name + ": " + format.what);
  }
  return notes;
}

OptionNotes exit_code_notes() {
  OptionNotes notes{"Exit codes", exit_code_lines()};
  notes.lines.push_back("With several files, the exit code is that of the first file that failed.");
  return notes;
}

OptionNotes example_notes(const std::vector<Command>& commands) {
  OptionNotes notes{"Examples", {}};
  for (const Command& command : commands) {
    const std::vector<std::string>& examples = command.table.examples;
    notes.lines.insert(notes.lines.end(), examples.begin(), examples.end());
  }
  return notes;
}

std::vector<OptionNotes> notes(const std::vector<Command>& commands) {
  return {
      example_notes(commands),
      format_notes(),
      {"Units",
       {"Lengths are in Å. Alpha is in Å²: a ball of radius r grows to sqrt(r² + alpha); negative",
        "alpha shrinks it. The solvent radius is added to every radius first (1.4 for water)."}},
      exit_code_notes()};
}

}  // namespace

OptionProgram command_table(CommandOptions& options) {
  OptionProgram program;
  program.name = "alphascope-cli";
  program.text = "The exact alpha complex of molecules, equal to CGAL's simplex by simplex";
  program.version = std::string(program_version()) + " (" + std::string(program_commit()) + ")";
  for (const Command& command : options.commands) {
    OptionCommand& table = program.commands.emplace_back(command.table);
    append(table.options, verbosity_options(options.verbosity));
    if (!command.times_are_the_result) table.options.push_back(no_times_option(options.times));
  }
  program.notes = notes(options.commands);
  program.usage_exit_code = static_cast<int>(ExitCode::usage);
  add_standard_options(program);
  add_manual_entries(program);
  return program;
}

}  // namespace alphascope::cli
