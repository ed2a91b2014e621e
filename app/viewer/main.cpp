// SPDX-License-Identifier: GPL-3.0-or-later
// The main function of alphascope: reads the arguments, runs the window, returns the exit code.
#include <sys/stat.h>

#include <csignal>
#include <cstdio>
#include <future>
#include <iostream>
#include <memory>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "app/options/exit_code.hpp"
#include "app/session/clean_exit.hpp"
#include "app/session/system_memory.hpp"
#include "app/viewer/options.hpp"
#include "app/viewer/read_ahead.hpp"
#include "app/viewer/script/script.hpp"
#include "app/viewer/viewer.hpp"
#include "core/document/session/preferences.hpp"
#include "core/document/session/session_file.hpp"
#include "core/files/atomic_file.hpp"
#include "core/files/read_error.hpp"
#include "core/geometry/shortest_number.hpp"
#include "core/run/program_heap.hpp"
#include "core/text/printable.hpp"
#include "core/text_files/small_text.hpp"
#include "ui/panels/failure_kind.hpp"
#include "ui/panels/whole_state.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

// Size and scale from the command line, otherwise from the preferences.
HostOptions host_options(const ViewerOptions& options) {
  Preferences p;
  if (!options.preferences.empty()) p = read_preferences(options.preferences).preferences;
  const bool sized = options.width > 0;
  return {sized ? options.width : p.width, sized ? options.height : p.height,
          options.scale > 0 ? options.scale : p.scale, "Alphascope"};
}

}  // namespace
}  // namespace alphascope

namespace {

using alphascope::ExitCode;

int status_of(ExitCode code) {
  return static_cast<int>(code);
}

// Thrown for an action that failed, with the exit code of this kind of failure.
struct NotDone : std::runtime_error {
  NotDone(ExitCode why, const std::string& text) : std::runtime_error(text), code(why) {}
  ExitCode code;
};

ExitCode code_of(alphascope::ErrorKind kind) {
  using alphascope::ErrorKind;
  switch (kind) {
    case ErrorKind::request:
      return ExitCode::usage;
    case ErrorKind::input:
      return ExitCode::unreadable_input;
    case ErrorKind::output:
      return ExitCode::unwritable_output;
    case ErrorKind::computing:
      break;
  }
  return ExitCode::computing_failed;
}

ExitCode code_of(const std::exception& error) {
  if (const auto* const not_done = dynamic_cast<const NotDone*>(&error)) return not_done->code;
  return code_of(alphascope::kind_of(error, alphascope::ErrorKind::computing));
}

// With less free memory no window is opened. An empty window took 120 MB when measured.
constexpr std::uint64_t kLeastFreeBytes = 150 << 20;

// Draws frames until no work is left, however long that takes. A result may start the next job, so
// it waits for several frames without work.
void wait_until_idle(alphascope::Viewer& viewer) {
  constexpr double kFrame = 0.02;  // seconds
  alphascope::ScriptedInput no_input;
  for (int quiet = 0; quiet < 4; quiet = viewer.busy() ? 0 : quiet + 1) {
    if (viewer.busy()) viewer.host().wait_events(kFrame);
    viewer.step(&no_input);
  }
}

void record_lesson(alphascope::Viewer& viewer, const alphascope::ViewerOptions& options) {
  viewer.draw_shots_only();
  wait_until_idle(viewer);
  if (!viewer.state().error.empty()) return;  // the lesson was not opened
  const alphascope::Outcome outcome = viewer.commands().run(
      "file.record",
      {options.record->string(), "lesson:" + alphascope::shortest_number(options.record_seconds),
       std::to_string(options.record_width), std::to_string(options.record_height)});
  if (!outcome.done()) throw std::runtime_error(outcome.why);
  wait_until_idle(viewer);
}

int drive(alphascope::Viewer& viewer, const alphascope::ViewerOptions& options,
          const std::string& script_text) {
  if (options.script) {
    std::istringstream script(script_text);
    try {
      alphascope::run_script(viewer, script, options.script->string(), std::cout);
    } catch (const alphascope::ScriptError& error) {
      throw NotDone(code_of(error.kind), error.what());
    }
  }
  if (options.record) record_lesson(viewer, options);
  if (options.shot) {
    std::istringstream wait("wait-idle\n");
    alphascope::run_script(viewer, wait, "--shot", std::cout);
    alphascope::ScriptedInput no_input;
    viewer.shoot(*options.shot, &no_input);
  }
  // What failed in between counts, unless the script dismissed the message.
  const alphascope::ViewState& state = viewer.state();
  const std::string problem = state.session_problem ? state.session_problem->text : "";
  const std::string& refused = state.lessons.first_refused;
  const std::pair<const std::string&, ExitCode> failures[] = {
      {state.error, code_of(state.error_kind)},
      {state.withdrawn_error, code_of(state.withdrawn_kind)},
      {state.first_compute_error, ExitCode::computing_failed},
      {problem, ExitCode::unreadable_input},
      {refused, ExitCode::unreadable_input}};
  for (const auto& [error, code] : failures) {
    if (!error.empty()) throw NotDone(code, error);
  }
  return status_of(ExitCode::ok);
}

// Notes the input files before an output is opened.
void note_inputs(const alphascope::ViewerOptions& options) {
  using alphascope::FileKind;
  const auto note = [](const std::filesystem::path& file, bool session) {
    alphascope::note_read(file, session ? FileKind::session : FileKind::other);
  };
  if (options.file) note(*options.file, alphascope::looks_like_session(*options.file));
  if (options.session) note(*options.session, true);
  if (options.script) note(*options.script, false);
  note(options.lesson, false);  // the name of a built-in lesson is noted too, which does no harm
}

// Checks the output of --shot before a window is opened and anything is computed.
void check_shot(const std::filesystem::path& shot) {
  alphascope::refuse_to_replace_input("--shot " + shot.string(), shot);
  struct stat status {};
  const bool written_directly = ::stat(shot.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
  if (!written_directly) alphascope::AtomicFile{shot};
}

constexpr std::uint64_t kLargestScript = std::uint64_t{16} << 20;  // bytes

int open_window(alphascope::ViewerOptions options) {
  note_inputs(options);
  if (options.shot) check_shot(*options.shot);
  std::string script;
  if (options.script) {
    script = alphascope::read_small_text(
        *options.script,
        {"the script", kLargestScript, "A script has a command a line: alphascope --script-help"});
  }
  const bool scripted = options.script || options.shot || options.record;
  // The output of a script must not depend on the user's preferences.
  if (!scripted && !options.preferences_given) {
    options.preferences = alphascope::preferences_folder();
  }
  alphascope::HostOptions host_options = alphascope::host_options(options);
  // An OpenGL driver ends the program without a message if an allocation fails. So the program ends
  // here with one.
  const auto free = alphascope::available_bytes();
  if (free && *free < kLeastFreeBytes) {
    std::fprintf(stderr,
                 "alphascope: too little memory is free to open a window (%llu MB; see also ulimit "
                 "-v). Close other programs, or compute with alphascope-cli.\n",
                 static_cast<unsigned long long>(*free / 1000000));
    return status_of(ExitCode::computing_failed);
  }
  // The fonts take a tenth of the time to the first frame. A thread makes them while the driver of
  // OpenGL is loaded.
  std::future<alphascope::BuiltFonts> fonts;
  host_options.scale_is_known = [&fonts](float scale) {
    fonts = std::async(std::launch::async, [scale] { return alphascope::build_fonts(scale); });
  };
  alphascope::Session::Services services = alphascope::Session::program_services();
  if (options.file && !alphascope::looks_like_session(*options.file)) {
    services.open_molecule = alphascope::read_ahead(*options.file, services.open_molecule);
  }
  std::unique_ptr<alphascope::Host> host;
  try {
    host = scripted ? alphascope::make_egl_host(host_options)
                    : alphascope::make_glfw_host(host_options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "alphascope: %s\n", alphascope::printable(error.what()).c_str());
    return status_of(ExitCode::no_display);
  }
  alphascope::Viewer viewer(*host, options, std::move(services), &alphascope::build_mesh,
                            fonts.valid() ? fonts.get() : alphascope::BuiltFonts{});
  if (scripted) return drive(viewer, options, script);
  viewer.run();
  return status_of(ExitCode::ok);
}

int run(int argc, char** argv) {
  const alphascope::ParsedOptions parsed = alphascope::parse_options(argc, argv);
  if (!parsed.exit_code) return open_window(parsed.options);
  std::fputs(parsed.text.c_str(), *parsed.exit_code == 0 ? stdout : stderr);
  return *parsed.exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  alphascope::start_heap_on_large_pages();
  alphascope::prepare_clean_exit("alphascope", status_of(ExitCode::computing_failed));
  alphascope::end_on_signals({SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU});
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("alphascope: there is not enough memory for the window.\n", stderr);
    return status_of(ExitCode::computing_failed);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "alphascope: %s\n", alphascope::printable(error.what()).c_str());
    return status_of(code_of(error));
  }
}
