// SPDX-License-Identifier: GPL-3.0-or-later
// Starts alphascope-cli-draw in place of this program, for screenshot and frames. It is the same
// command line with the renderer, whose 60 libraries are loaded for pictures only.
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "app/cli/failure.hpp"
#include "app/cli/pictures/picture_options.hpp"
#include "app/cli/text/terminal.hpp"

namespace alphascope::cli {

#ifdef ALPHASCOPE_DRAWING_FOLDER
namespace {

constexpr const char* kDrawingProgram = "alphascope-cli-draw";

// Returns where the program may be: beside this one in a build folder, or in a folder of its own in
// an installation.
std::vector<std::filesystem::path> candidates() {
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe").parent_path();
  return {folder / kDrawingProgram,
          (folder / ALPHASCOPE_DRAWING_FOLDER / kDrawingProgram).lexically_normal()};
}

[[noreturn]] void start_drawing(const std::vector<std::string>& given) {
  std::vector<char*> arguments;
  for (const std::string& argument : given) {
    // The type of execv's parameter; it changes nothing.
    arguments.push_back(const_cast<char*>(argument.c_str()));
  }
  arguments.push_back(nullptr);
  // A signal that came before execv() would be lost, so it is handled here.
  run_context().cancel.throw_if_cancelled();
  std::string tried;
  for (const std::filesystem::path& program : candidates()) {
    ::execv(program.c_str(), arguments.data());  // returns only on failure
    tried += (tried.empty() ? "" : " nor ") + program.string() + " (" + std::strerror(errno) + ")";
  }
  throw std::runtime_error("The program that draws cannot be started: neither " + tried +
                           ". Reinstall alphascope-cli with all of its files.");
}

}  // namespace

ExitCode run_screenshot(const ScreenshotCommandOptions& options) {
  start_drawing(options.arguments);
}

ExitCode run_frames(const FramesCommandOptions& options) {
  start_drawing(options.picture.arguments);
}

#else

namespace {

[[noreturn]] void refuse() {
  throw UsageError(
      "This alphascope-cli was built without its renderer (ALPHASCOPE_BUILD_VIEWER=OFF), so it "
      "cannot draw pictures. Build it with ALPHASCOPE_BUILD_VIEWER=ON to use screenshot and "
      "frames.");
}

}  // namespace

ExitCode run_screenshot(const ScreenshotCommandOptions&) {
  refuse();
}

ExitCode run_frames(const FramesCommandOptions&) {
  refuse();
}

#endif

}  // namespace alphascope::cli
