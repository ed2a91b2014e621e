// Running the command that the arguments name; exceptions as messages and exit codes.
#include "app/cli/command_line.hpp"

#include <iostream>

#include "app/cli/command_table.hpp"
#include "app/cli/failure.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/options/parse_arguments.hpp"
#include "core/text/printable.hpp"
#include "core/text/text_parts.hpp"

namespace alphascope::cli {
namespace {

ExitCode run(const std::string& command, const CommandOptions& options) {
  if (command == "info") return run_info(options.info);
  if (command == "compute") return run_compute(options.compute);
  if (command == "cavities") return run_cavities(options.cavities);
  if (command == "channel") return run_channel(options.channel);
  if (command == "measure") return run_measure(options.measure);
  if (command == "export") return run_export(options.export_complex);
  if (command == "explain") return run_explain(options.explain);
  if (command == "steps") return run_steps(options.steps);
  if (command == "verify") return run_verify(options.verify);
  if (command == "bench") return run_bench(options.bench);
  if (command == "frames") return run_frames(options.frames);
  return run_screenshot(options.screenshot);
}

int parse_and_run(int argc, const char* const* argv) {
  CommandOptions options;
  options.screenshot.arguments.assign(argv, argv + argc);
  options.frames.picture.arguments = options.screenshot.arguments;
  const OptionProgram program = command_table(options);
  const ParsedArguments parsed = parse_arguments(program, argc, argv);
  if (parsed.ended) {
    if (parsed.exit_code == 0) {
      std::cout << parsed.text << std::flush;
    } else {  // some lines, which may quote what was typed
      for (const std::string& line : parts_of(parsed.text, '\n')) {
        std::cerr << printable(line) << '\n';
      }
    }
    return parsed.exit_code;
  }
  set_verbosity(options.verbosity);
  set_memory_remedy(*parsed.command);
  set_times_wanted(options.times);
  return static_cast<int>(run(parsed.command->name, options));
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (...) {
    const Failure failure = current_failure();
    print_error(failure.message);
    return failure.code == ExitCode::cancelled ? cancelled_status()
                                               : static_cast<int>(failure.code);
  }
}

}  // namespace alphascope::cli
