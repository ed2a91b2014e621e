// alphascope-cli screenshot: a picture of a complex, without a display. Part of the program that
// start_screenshot.cpp starts.
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iostream>
#include <new>
#include <sstream>

#include "app/cli/commands.hpp"
#include "app/cli/outputs.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/text.hpp"
#include "app/session/result_header.hpp"
#include "app/session/system_memory.hpp"
#include "core/molecule/printable.hpp"
#include "ui/scene/ball_colours.hpp"
#include "ui/scene/beside_body.hpp"
#include "ui/scene/screenshot.hpp"

namespace alphascope::cli {
namespace {

// "1920x1080"; the bounds are render_screenshot's.
void set_size(const std::string& text, ScreenshotOptions& picture) {
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, picture.width);
  if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
    const auto height = std::from_chars(width.ptr + 1, end, picture.height);
    if (height.ec == std::errc() && height.ptr == end) return;
  }
  throw UsageError("--size takes WIDTHxHEIGHT in pixels, such as 1920x1080; not \"" + text + "\".");
}

// "ligands,ions" or "none".
AtomsBesideBody beside_body(const std::string& text) {
  AtomsBesideBody shown{false, false, false, false};
  if (text == "none") return shown;
  const std::pair<const char*, bool AtomsBesideBody::*> kinds[] = {
      {"ligands", &AtomsBesideBody::ligands},
      {"ions", &AtomsBesideBody::ions},
      {"waters", &AtomsBesideBody::waters},
      {"hydrogens", &AtomsBesideBody::hydrogens}};
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    const auto kind = std::find_if(std::begin(kinds), std::end(kinds),
                                   [&](const auto& k) { return word == k.first; });
    if (kind == std::end(kinds)) {
      throw UsageError(
          "--beside takes ligands, ions, waters and hydrogens, with commas between, or "
          "none; not \"" +
          word + "\".");
    }
    shown.*kind->second = true;
  }
  return shown;
}

ScreenshotOptions picture_options(const ScreenshotCommandOptions& options) {
  ScreenshotOptions picture;
  set_size(options.size, picture);
  picture.transparent = options.transparent;
  picture.legend = !options.no_legend;
  picture.scale_bar = options.scale_bar;
  picture.style.theme = options.light ? Theme::light : Theme::dark;
  picture.style.balls = !options.no_balls;
  if (options.grown) {
    picture.balls.grown = true;
    picture.balls.scale = 1;
  }
  picture.balls.alpha = options.request.alpha_angstrom2;
  picture.balls.solvent_radius = options.request.solvent_radius_angstrom;
  picture.mesh.shrink = options.shrink;
  if (options.simplex_colours == "alpha") picture.mesh.colouring = ComplexColouring::alpha;
  picture.mesh.boundary = options.boundary;
  picture.mesh.tetrahedra = !options.boundary;
  picture.mesh.triangles = picture.mesh.edges = !options.request.tetrahedra_only;
  return picture;
}

// A file in memory that has a path as long as this object is there.
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
    bytes << std::ifstream(path(), std::ios::binary).rdbuf();
    return std::move(bytes).str();
  }

 private:
  int descriptor_;
};

}  // namespace

ExitCode run_screenshot(const ScreenshotCommandOptions& options) {
  ScreenshotOptions picture = picture_options(options);
  const AtomsBesideBody shown = beside_body(options.beside);
  const RunContext& context = run_context();
  require_readable({options.input.file});
  Outputs outputs(files_read(options.input));
  AtomicFile* const file = outputs.add("--output", options.out.string());
  if (file == nullptr) throw UsageError("--output needs the name of a file, or -.");
  const Input input = open_one_model(options.input, "A picture shows one model.", context);
  EngineCache engines(&make_engine);
  const EngineAnswer result = engines.compute(input.prepared().balls, options.request, context);
  const std::vector<std::uint32_t>& atoms = input.prepared().atom_of_ball;
  picture.texts = picture_texts(complex_header(input, result));
  picture.free_bytes = available_or(options.drawing_memory_mb);
  picture.beside_body = [&](const BallGeometry& balls) {
    return build_beside_body(balls, input.molecule(), input.prepared(), shown, context.cancel).mesh;
  };
  const MemoryFile drawn;  // the renderer writes to a path, which standard output has none of
  const std::string not_drawn =
      render_screenshot(*input.prepared().balls, result.complex,
                        options.colours == "chain" ? colours_by_chain(input.molecule(), atoms)
                                                   : colours_by_element(input.molecule(), atoms),
                        picture, drawn.path(), context);
  file->write(drawn.bytes());
  outputs.commit();
  clear_progress();
  if (!not_drawn.empty()) std::cerr << "alphascope-cli: " << not_drawn << "\n";
  std::cout << input_text(input) << complex_text(result.complex, verbosity()) << "picture     "
            << printable(options.out.string()) << ", " << picture.width << " x " << picture.height
            << "\n";
  return ExitCode::ok;
}

}  // namespace alphascope::cli
