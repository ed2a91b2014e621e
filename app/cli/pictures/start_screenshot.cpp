// alphascope-cli screenshot and frames, as everybody starts them: goes over to alphascope-cli-draw,
// which is the same command line with the renderer. Its 60 libraries are loaded for pictures only.
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

// Beside this program, as it is built, or where it is installed.
std::vector<std::filesystem::path> candidates() {
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe").parent_path();
  return {folder / kDrawingProgram,
          (folder / ALPHASCOPE_DRAWING_FOLDER / kDrawingProgram).lexically_normal()};
}

[[noreturn]] void start_drawing(const std::vector<std::string>& given) {
  std::vector<char*> arguments;
  for (const std::string& argument : given) {
    arguments.push_back(const_cast<char*>(argument.c_str()));  // execv's type; it changes nothing
  }
  arguments.push_back(nullptr);
  run_context().cancel.throw_if_cancelled();  // the other program knows of no signal before it
  std::string tried;
  for (const std::filesystem::path& program : candidates()) {
    ::execv(program.c_str(), arguments.data());  // returns only when it fails
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
      "draws no pictures. Build it with the viewer to use screenshot and frames.");
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
