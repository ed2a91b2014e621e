// SPDX-License-Identifier: GPL-3.0-or-later
// Runs alphascope-cli screenshot: draws a complex without a display. Part of the program that
// start_screenshot.cpp starts.
#include <sys/mman.h>
#include <unistd.h>

#include <fstream>
#include <iostream>
#include <new>
#include <sstream>

#include "app/cli/failure.hpp"
#include "app/cli/outputs.hpp"
#include "app/cli/pictures/cli_pictures.hpp"
#include "app/cli/pictures/picture_options.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/cli/text/text.hpp"
#include "core/text/printable.hpp"

namespace alphascope::cli {
namespace {

// A file in memory, with a path that is valid during the object's lifetime.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("picture", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw std::bad_alloc();
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }
  std::string bytes() const {
    std::ostringstream bytes;
    // Without exceptions, a failure could go unnoticed and return a part of the bytes.
    bytes.exceptions(std::ios::badbit | std::ios::failbit);
    bytes << std::ifstream(path(), std::ios::binary).rdbuf();
    return std::move(bytes).str();
  }

 private:
  int descriptor_;
};

}  // namespace

ExitCode run_screenshot(const ScreenshotCommandOptions& options) {
  const RunContext& context = run_context();
  Outputs outputs(files_of_picture(options));
  AtomicFile* const file = outputs.add("--output", options.out.string(), {".png"});
  if (file == nullptr) throw UsageError("--output needs the name of a file, or -.");
  CommandLinePictures cli_pictures(options, context);
  outputs.refuse_what_was_read();  // the session's molecule has been read by now
  const auto answer = cli_pictures.compute(std::nullopt, context);
  const EngineAnswer& result = *answer;
  const MemoryFile drawn;  // the renderer needs a path, which standard output lacks
  const std::string not_drawn =
      render_picture(cli_pictures.picture(answer, context), drawn.path(), context);
  file->write(drawn.bytes());
  outputs.commit();
  clear_progress();
  if (!not_drawn.empty()) std::cerr << "alphascope-cli: " << not_drawn << "\n";
  std::cout << input_text(cli_pictures.input()) << complex_text(result.complex) << "picture     "
            << printable(options.out.string()) << ", " << cli_pictures.options().width << " x "
            << cli_pictures.options().height << "\n";
  return ExitCode::ok;
}

}  // namespace alphascope::cli
