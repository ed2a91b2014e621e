#include "app/cli/command_table.hpp"

#include <algorithm>
#include <stdexcept>

#include "app/cli/option_groups.hpp"
#include "app/options/did_you_mean.hpp"
#include "app/options/option_values.hpp"
#include "app/session/version.hpp"
#include "core/document/export/complex_export.hpp"

namespace alphascope::cli {
namespace {

constexpr std::string_view kTimesAreTheResult = "bench";

Option no_times_option(bool& times) {
  return flag_option("--no-times",
                     "Leave out times, threads and what follows from them, in all results: the "
                     "same question gives the same bytes",
                     times, false);
}

// -q and -v.
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

OptionCommand info(InfoOptions& options) {
  OptionCommand command{"info", "Report what files contain and which atoms are used", {}};
  command.options = many_files(options.files);
  append(command.options, input(options.input));
  command.options.push_back(
      flag_option("--residues", "List what residues are, and why", options.residues));
  command.options.push_back(flag_option("--each-residue", "The same with a line for every residue",
                                        options.each_residue));
  command.options.push_back(
      output("--json", "The same as JSON; - for standard output", options.json));
  command.options.push_back(
      output("--csv", "One row for each file and model; - for standard output", options.csv));
  command.check = [&options] { require_files(options.files); };
  return command;
}

OptionCommand compute(ComputeOptions& options) {
  OptionCommand command{"compute", "Compute the alpha complex of each file", {}};
  command.options = many_files(options.files);
  command.options.push_back(alpha(options.request));
  append(command.options, engine(options.request, true));
  append(command.options, input(options.input));
  append(command.options,
         {output("--json", "Counts, hash, times and provenance as JSON; - for standard output",
                 options.json),
          output("--csv",
                 "Counts and provenance, one row for each file and model; - for standard output",
                 options.csv),
          output("--out", "All simplices with their alpha values, as text", options.out)});
  command.check = [&options] {
    require_files(options.files);
    require_tuple_engine(options.request);
  };
  return command;
}

OptionCommand measure(MeasureCommandOptions& options) {
  OptionCommand command{
      "measure", "Exact area and volume of the union of balls, also by chain, residue or atom", {}};
  command.options = many_files(options.files);
  Option alpha = alpha_option("Alpha in Å², negative too", options.request.alpha_angstrom2);
  command.options.push_back(with_default(alpha, "0"));
  append(command.options, engine(options.request, true));
  std::erase_if(command.options, [](const Option& o) { return o.names == "--tetrahedra-only"; });
  Option per{.names = "--per",
             .value = "atom|residue|chain|component",
             .text = "What a row of the CSV is, and a list of the JSON",
             .fallback = "one row for all"};
  per.set = [&options, choices = per.choices()](const std::string& id) {
    require_choice(id, choices);
    const auto at = std::find(choices.begin(), choices.end(), id) - choices.begin();
    options.per = static_cast<MeasuredPer>(at + 1);
  };
  append(command.options,
         {per,
          flag_option("--derivatives",
                      "Also how area and volume change with centre and radius of each atom",
                      options.derivatives),
          output("--json", "Measures, counts, hash and times as JSON; - for standard output",
                 options.json),
          output("--csv", "Measures, one row for each group; - for standard output", options.csv)});
  append(command.options, input(options.input));
  command.check = [&options] {
    require_files(options.files);
    if (options.derivatives && options.per != MeasuredPer::atom) {
      throw std::invalid_argument("--derivatives are those of atoms: add --per atom");
    }
    require_tuple_engine(options.request);
  };
  return command;
}

OptionCommand export_complex(ExportOptions& options) {
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

OptionCommand verify(VerifyOptions& options) {
  OptionCommand command{
      "verify", "Compare with CGAL as sets of simplices; exit code 0 only if identical", {}};
  command.options = {one_file(options.input),
                     required(alphas(options.alphas, "Alphas in Å², such as -1,0,1.4"))};
  append(command.options, engine(options.request, true));
  append(command.options,
         {with_default(whole_number_option({"--cgal-threads", "N", "Threads for CGAL, 0 for all"},
                                           options.cgal_threads, kThreadRange),
                       "1"),
          flag_option("--definition",
                      "Also prove from the definition, without CGAL, that every simplex is right "
                      "and none is missing",
                      options.definition),
          whole_number_option({"--show", "N", "Differences printed for each kind of simplex"},
                              options.shown, {0, 1'000'000'000}),
          output("--json", "The comparison as JSON; - for standard output", options.json)});
  append(command.options, input(options.input));
  command.check = [&options] { require_tuple_engine(options.request); };
  return command;
}

// What only --suite thesis has.
Options thesis_suite(BenchOptions& options) {
  Options suite{
      choice_option({"--suite", "thesis",
                     "All engines, stages, ablations and figures of the thesis' chapter 4"},
                    options.suite),
      with_default(choices_option({"--engines", "cpu|gpu|tuples-cpu|tuples-gpu",
                                   "Engines of the suite, such as cpu,gpu"},
                                  options.engines),
                   "all that can run here"),
      number_option({"--seconds", "S",
                     "Time limit for a row; rows that need longer for one run are left out"},
                    options.seconds_per_row, {0.1, 86400, "s"}),
      flag_option("--no-ablation", "Leave out the rows that switch optimisations off",
                  options.ablation, false),
      output("--json", "The table as JSON; - for standard output", options.json),
      text_option({"--charts", "DIR", "The figures as SVG, into this folder"}, options.charts)};
  for (Option& option : suite) option.group = "The thesis' table and figures";
  return suite;
}

OptionCommand bench(BenchOptions& options) {
  OptionCommand command{
      "bench", "Time our engine and CGAL in one process, cold and warm; medians", {}};
  Option files = required(texts_option({"FILE", "FILE", kFileText}, options.files));
  command.options = {files, with_default(alphas(options.alphas, "Alphas in Å², such as -1,0,1.4"),
                                         "with --suite: 0,1.4,3 Å²")};
  append(command.options, engine(options.request, false));
  append(command.options,
         {whole_numbers_option({"--threads", "N", "CPU threads for both, such as 1,2; 0 for all"},
                               options.threads, kThreadRange),
          whole_number_option({"--runs", "N", "Runs of each"}, options.runs, {1, 1000}),
          output("--csv", "The table as CSV; - for standard output", options.csv)});
  append(command.options, input(options.input));
  append(command.options, thesis_suite(options));
  command.check = [&options] { require_tuple_engine(options.request); };
  return command;
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
  notes.lines.push_back("With several files the code is that of the first file that failed.");
  return notes;
}

std::vector<OptionNotes> notes() {
  return {
      {"Examples",
       {"alphascope-cli info 1crn.pdb",
        "alphascope-cli compute 1crn.pdb --alpha 0 --solvent 1.4 --json 1crn.json",
        "alphascope-cli compute 1k4c.crd.gz --alpha 1.4 --out 1k4c.alpha",
        "alphascope-cli compute 1d3z.cif.gz --model all --alpha 0 --solvent 1.4 --csv models.csv",
        "alphascope-cli compute pdb/*.pdb.gz --alpha 0 --solvent 1.4 --csv all.csv",
        "find pdb -name '*.cif.gz' | alphascope-cli info --files-from - --csv -",
        "zcat 1crn.pdb.gz | alphascope-cli compute - --alpha 1.4",
        "alphascope-cli cavities 4hhb.pdb.gz --csv cavities.csv",
        "alphascope-cli channel 1grm.pdb",
        "alphascope-cli channel 1grm.pdb --point 0,0,4.2 --along 0,1,0 --csv profile.csv",
        "alphascope-cli measure 4hhb.pdb.gz --solvent 1.4 --per residue --csv areas.csv",
        "alphascope-cli export 1crn.pdb --alpha 1.4 -o 1crn.glb",
        "alphascope-cli explain 1crn.pdb --simplex 3,4,7 --alpha 1.4",
        "alphascope-cli steps 1crn.pdb --ball \"A:CYS 16:SG\" --alpha 1.4",
        "alphascope-cli verify 1crn.pdb --alpha -1,0,1.4,10",
        "alphascope-cli bench 1k4c.crd.gz --alpha 0,1.4,3 --tetrahedra-only --csv times.csv",
        "alphascope-cli screenshot 1crn.pdb --alpha 1.4 --size 1920x1080 -o 1crn.png",
        "alphascope-cli screenshot --session 1crn.json --size 1920x1080 -o 1crn.png",
        "alphascope-cli frames 1crn.pdb --sweep alpha=-1:10:120 -o 1crn-%04d.png",
        "alphascope-cli frames 1crn.pdb --turntable 360:120 --alpha 1.4 -o 1crn.mp4"}},
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
  program.commands = {info(options.info),
                      compute(options.compute),
                      cavities_command(options.cavities),
                      channel_command(options.channel),
                      measure(options.measure),
                      export_complex(options.export_complex),
                      explain_command(options.explain),
                      steps_command(options.steps),
                      verify(options.verify),
                      bench(options.bench),
                      screenshot_command(options.screenshot),
                      frames_command(options.frames)};
  for (OptionCommand& command : program.commands) {
    append(command.options, verbosity_options(options.verbosity));
    if (command.name != kTimesAreTheResult) {
      command.options.push_back(no_times_option(options.times));
    }
  }
  program.notes = notes();
  program.usage_exit_code = static_cast<int>(ExitCode::usage);
  add_standard_options(program);
  return program;
}

}  // namespace alphascope::cli
