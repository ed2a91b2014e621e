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
#include "app/cli/screenshot_session.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/text.hpp"
#include "app/session/result_header.hpp"
#include "app/session/system_memory.hpp"
#include "core/document/display_preset.hpp"
#include "core/molecule/printable.hpp"
#include "ui/scene/ball_colours.hpp"
#include "ui/scene/beside_body.hpp"
#include "ui/scene/display_style.hpp"
#include "ui/scene/draw_marks.hpp"
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

// What the window's Display panel would say.
DisplayControls display(const ScreenshotCommandOptions& options) {
  DisplayControls d;
  d.triangles = d.edges = true;
  if (const auto preset = preset_named(options.preset)) d = with_preset(d, *preset);
  if (options.request.tetrahedra_only) d.triangles = d.edges = false;
  if (options.no_balls) d.balls = false;
  if (options.grown) {
    d.grown_balls = true;
    d.ball_scale = 1;
  }
  if (options.boundary) {
    d.boundary = true;
    d.tetrahedra = false;
  }
  if (options.shrink > 0) d.shrink = static_cast<float>(options.shrink);
  d.ball_colour = options.colours == "chain" ? ColourBy::chain : ColourBy::element;
  d.complex_colour = options.simplex_colours == "alpha" ? ColourBy::alpha : d.ball_colour;
  d.orthographic = options.orthographic;
  if (options.no_shadows) d.ambient_occlusion = false;
  if (options.depth_cue) d.depth_cue = static_cast<float>(*options.depth_cue);
  if (options.outlines) d.silhouettes = static_cast<float>(*options.outlines);
  if (options.samples) d.samples = static_cast<int>(*options.samples);
  return d;
}

// Of the file; what is drawn is show()'s.
ScreenshotOptions picture_options(const ScreenshotCommandOptions& options) {
  ScreenshotOptions picture;
  set_size(options.size, picture);
  picture.transparent = options.transparent;
  picture.legend = !options.no_legend;
  picture.scale_bar = options.scale_bar;
  const ClipWords clip = read_clip(options.clip);
  if (!clip.error.empty()) throw UsageError("--clip: " + clip.error);
  if (clip.clip.on()) picture.clip = clip;
  return picture;
}

void show(const DisplayControls& display, Theme theme, const Request& request,
          ScreenshotOptions& picture) {
  picture.style = scene_style(display, theme);
  picture.style.line_scale = mark_unit(picture.width, picture.height);
  picture.mesh = mesh_options(display, theme);
  picture.balls = ball_style(display, &request);
}

void print_note(const std::string& note) {
  clear_progress();
  if (verbosity() != Verbosity::quiet) std::cerr << "alphascope-cli: " << printable(note) << "\n";
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

// What is drawn, and how.
struct Wanted {
  Input input;
  Request request;
  ScreenshotOptions picture;
  ColourBy balls = ColourBy::element, simplices = ColourBy::element;
  AtomsBesideBody beside;
  Appearance appearance;
};

Appearance appearance(const Molecule& molecule, const AppearanceWords& words) {
  try {
    return read_appearance(molecule, words);
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--hide, --only and --atom-colours: ") + error.what() + ".");
  }
}

Wanted by_options(const ScreenshotCommandOptions& options, const RunContext& context) {
  const DisplayControls shown = display(options);
  Wanted wanted{{},
                options.request,
                picture_options(options),
                shown.ball_colour,
                shown.ball_colour,
                beside_body(options.beside),
                {}};
  show(shown, options.light ? Theme::light : Theme::dark, options.request, wanted.picture);
  wanted.input = open_one_model(options.input, "A picture shows one model.", context);
  wanted.appearance = appearance(wanted.input.molecule(), options.appearance);
  return wanted;
}

// As the window's “Save picture” draws it, but for what pages below the view lay over it.
Wanted by_session(const ScreenshotCommandOptions& options, const RunContext& context) {
  SessionToDraw found = open_session(options, context);
  for (const std::string& note : found.notes) print_note(note);
  const SessionDocument& s = found.session;
  const DisplayControls& display = s.settings.display;
  const Theme theme = s.view.light_theme ? Theme::light : Theme::dark;
  Wanted wanted{std::move(found.input), s.settings.request,     picture_options(options),
                display.ball_colour,    display.complex_colour, display.beside,
                s.settings.appearance};
  // All engines answer alike, and this machine may lack the one that the window had.
  wanted.request.engine = EngineChoice::automatic;
  show(display, theme, s.settings.request, wanted.picture);
  if (s.view.camera.any()) wanted.picture.camera = s.view.camera;
  const Clip& clip = s.settings.clip;
  wanted.picture.clip = clip.on() ? std::optional(ClipWords{clip, false, true, {}}) : std::nullopt;
  return wanted;
}

std::vector<Rgb8> colours(ColourBy colour, const Wanted& wanted, const EngineAnswer& answer,
                          const RunContext& context) {
  const Molecule& molecule = wanted.input.molecule();
  const std::vector<std::uint32_t>& atoms = wanted.input.prepared().atom_of_ball;
  if (colour == ColourBy::element) return colours_by_element(molecule, atoms);
  if (colour == ColourBy::chain) return colours_by_chain(molecule, atoms);
  if (!is_exposure(colour) || answer.complex.tetrahedra_only) {
    return std::vector<Rgb8>(atoms.size(), kPlainBall);
  }
  const MeasuredUnion measured = measure_here(*answer.balls, answer.complex, context);
  return colours_by_exposure(
      {colour, measured.measures, *answer.balls, answer.complex.alpha_on_lattice}, molecule, atoms);
}

void add_colours(Wanted& wanted, const EngineAnswer& answer, const RunContext& context) {
  // The window's rule: simplices have their balls' colours by element, else by chain.
  const bool by_element = wanted.simplices == ColourBy::element;
  wanted.picture.simplex_colours =
      colours(by_element ? ColourBy::element : ColourBy::chain, wanted, answer, context);
  const bool legend =
      is_exposure(wanted.balls) && wanted.picture.style.balls && !answer.complex.tetrahedra_only;
  if (legend) wanted.picture.ball_legend = exposure_legend(wanted.balls);
}

}  // namespace

ExitCode run_screenshot(const ScreenshotCommandOptions& options) {
  const bool session = !options.session.empty();
  const RunContext& context = run_context();
  std::vector<std::filesystem::path> files;
  if (!options.input.file.empty()) files.push_back(options.input.file);
  if (session) files.push_back(options.session);
  require_readable(files);
  for (const auto& file : files_read(options.input)) files.push_back(file);
  Outputs outputs(files);
  AtomicFile* const file = outputs.add("--output", options.out.string());
  if (file == nullptr) throw UsageError("--output needs the name of a file, or -.");
  Wanted wanted = session ? by_session(options, context) : by_options(options, context);
  const Input& input = wanted.input;
  ScreenshotOptions& picture = wanted.picture;
  EngineCache engines(&make_engine);
  const EngineAnswer result = engines.compute(input.prepared().balls, wanted.request, context);
  add_colours(wanted, result, context);
  picture.texts = picture_texts(complex_header(input, result));
  picture.looks =
      ball_appearance(input.molecule(), input.prepared().atom_of_ball, wanted.appearance);
  if (picture.looks.hidden_balls > 0) {
    picture.texts.emplace_back("Hidden atoms", std::to_string(picture.looks.hidden_balls));
  }
  picture.free_bytes = available_or(options.drawing_memory_mb);
  picture.beside_body = [&](const BallGeometry& balls) {
    return build_beside_body(
               balls, input.molecule(),
               left_out_and_shown(input.molecule(), input.prepared(), wanted.appearance.hidden),
               wanted.beside, context.cancel)
        .mesh;
  };
  const MemoryFile drawn;  // the renderer writes to a path, which standard output has none of
  const std::string not_drawn = render_screenshot(*input.prepared().balls, result.complex,
                                                  colours(wanted.balls, wanted, result, context),
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
