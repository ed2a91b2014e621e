// SPDX-License-Identifier: GPL-3.0-or-later
// Turns options or a session into the data of pictures.
#include "app/cli/pictures/cli_pictures.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <utility>
#include <vector>

#include "app/cli/failure.hpp"
#include "app/cli/outputs.hpp"
#include "app/cli/pictures/screenshot_session.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/text/shell_words.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/session/result_header.hpp"
#include "app/session/system_memory.hpp"
#include "core/document/commands/number_input.hpp"
#include "core/document/picture/picture_preset.hpp"
#include "core/document/reference/reference.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/shortest_number.hpp"
#include "core/text/printable.hpp"
#include "core/text/text_parts.hpp"
#include "ui/annotation_layer.hpp"

namespace alphascope::cli {
namespace {

// Reads "1920x1080" or "85x64mm". PictureMaker checks the bounds.
void set_size(const std::string& text, PictureOptions& picture) {
  const char* const end = text.data() + text.size();
  double width = 0, height = 0;
  const auto across = std::from_chars(text.data(), end, width);
  if (across.ec == std::errc() && across.ptr != end && *across.ptr == 'x') {
    const auto down = std::from_chars(across.ptr + 1, end, height);
    const std::string_view unit(down.ptr, static_cast<std::size_t>(end - down.ptr));
    constexpr double kMost = 1e6;
    const bool sane =
        down.ec == std::errc() && width > 0 && height > 0 && width < kMost && height < kMost;
    if (sane && unit == "mm") {
      picture.width = pixels_of(width, picture.dpi);
      picture.height = pixels_of(height, picture.dpi);
      return;
    }
    if (sane && unit.empty() && width == std::floor(width) && height == std::floor(height)) {
      picture.width = static_cast<int>(width);
      picture.height = static_cast<int>(height);
      return;
    }
  }
  throw UsageError(
      "--size takes WIDTHxHEIGHT in pixels, such as 1920x1080, or in mm, such as 85x64mm; not \"" +
      text + "\". Each is from " + shortest_number(kPictureSizeRule.least) + " to " +
      shortest_number(kPictureSizeRule.most) + " pixels.");
}

// Reads "ligands,ions" or "none".
AtomsBesideBody beside_body(const std::string& text) {
  AtomsBesideBody shown{false, false, false, false};
  if (text == "none") return shown;
  for (const std::string& word : parts_of(text, ',')) {
    const auto kind = std::find_if(std::begin(kBesideKinds), std::end(kBesideKinds),
                                   [&](const BesideKind& k) { return word == k.id; });
    if (kind == std::end(kBesideKinds)) {
      throw UsageError(
          "--beside takes ligands, ions, waters and hydrogens, with commas between, or "
          "none; not \"" +
          word + "\".");
    }
    shown.*kind->member = true;
  }
  return shown;
}

// The paint of simplices: that of the balls, or one colour where simplices cannot have it.
Paint like_balls(const Paint& paint) {
  if (can_paint(scheme_info(paint.by), PaintTarget::simplices)) return paint;
  return {ColourBy::single, {}, {}, {}};
}

// Returns the settings of the window's section Display that correspond to the options.
DisplaySettings display(const ScreenshotCommandOptions& options) {
  DisplaySettings d;
  d.triangles = d.edges = true;
  if (const auto preset = preset_named(options.preset)) d = with_preset(d, *preset);
  if (options.request.tetrahedra_only) d.triangles = d.edges = false;
  d.ball_paint = options.ball_paint;
  d.complex_paint = options.simplex_paint.value_or(like_balls(options.ball_paint));
  for (const auto& [field, value] : options.display) {
    if (field == &display_field(&DisplaySettings::grown_balls)) d.ball_scale = 1;
    if (field == &display_field(&DisplaySettings::boundary)) d.tetrahedra = false;
  }
  for (const auto& [field, value] : options.display) set_number(*field, d, value);
  return d;
}

// Returns the options of the file: size, background and marks.
PictureOptions picture_options(const ScreenshotCommandOptions& options) {
  PictureOptions picture;
  set_size(kUsualSize, picture);
  if (const auto preset = preset_named(options.preset)) picture = with_preset(picture, *preset);
  picture.dpi = options.dpi.value_or(picture.dpi);
  if (!options.size.empty()) set_size(options.size, picture);
  picture.background = options.background.value_or(picture.background);
  picture.letters = options.letters.value_or(picture.letters);
  if (options.transparent) picture.background = kNoBackground;
  picture.legend = !options.no_legend;
  picture.scale_bar = options.scale_bar;
  picture.caption = options.caption;
  return picture;
}

void print_note(const std::string& note) {
  clear_progress();
  if (verbosity() != Verbosity::quiet) std::cerr << "alphascope-cli: " << printable(note) << "\n";
}

Appearance appearance(const Molecule& molecule, const AppearanceWords& words) {
  try {
    return read_appearance(molecule, words);
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--hide, --only and --atom-colours: ") + error.what() + ".");
  }
}

Annotations annotations(const BallReferences& atoms, const AnnotationWords& words) {
  try {
    return read_annotations(atoms, words);
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--labels and --measure: ") + error.what() +
                     (std::string_view(error.what()).ends_with('.') ? "" : "."));
  }
}

}  // namespace

std::vector<std::filesystem::path> files_of_picture(const ScreenshotCommandOptions& options) {
  std::vector<std::filesystem::path> files;
  if (!options.input.file.empty()) files.push_back(options.input.file);
  if (!options.session.empty()) files.push_back(options.session);
  require_readable(files);
  for (const auto& file : files_read(options.input)) files.push_back(file);
  return files;
}

CommandLinePictures::CommandLinePictures(const ScreenshotCommandOptions& options,
                                         const RunContext& context)
    : command_(command_text(options.arguments, times_wanted())) {
  for (const std::string& note : options.notes) print_note(note);
  picture_.options = picture_options(options);
  picture_.clip = read_clip(options.clip);
  if (!picture_.clip.error.empty()) throw UsageError("--clip: " + picture_.clip.error);
  if (options.session.empty()) {
    follow_options(options, context);
  } else {
    follow_session(options, context);
  }
  picture_.line_scale = mark_unit(picture_.options.width, picture_.options.height);
  picture_.free_memory = [megabytes = options.drawing_memory_mb] {
    return available_or(megabytes);
  };
  if (auto layer = annotation_layer()) picture_.layers.push_back(std::move(layer));
  const OpenedMolecule& opened = input_.opened;
  maker_.emplace(PicturedMolecule{opened.molecule, opened.prepared, nullptr}, picture_);
}

// The layer of labels, distances, angles and marks for the drawn atoms.
std::shared_ptr<const Layer> CommandLinePictures::annotation_layer() const {
  const OpenedMolecule& opened = input_.opened;
  const BallReferences atoms(opened.molecule, opened.prepared);
  const std::vector<bool> hidden = atoms_of(*opened.molecule, picture_.appearance.hidden);
  const auto is_drawn = [&](std::size_t atom) {
    if (hidden[atom]) return false;
    if (atoms.ball(atoms.atom_of_molecule(atom))) return true;
    const auto& beside = opened.prepared->left_out;
    const auto at =
        std::lower_bound(beside.begin(), beside.end(), atom,
                         [](const LeftOutAtom& a, std::size_t i) { return a.atom < i; });
    return at != beside.end() && at->atom == atom &&
           shows(picture_.display.beside, at->reason, opened.molecule->atoms[atom].element);
  };
  const std::shared_ptr<const BallSet>& balls = opened.prepared->balls;
  std::shared_ptr<const BallSet> grown;
  if (annotations_.power_diagram) {
    grown = std::make_shared<const BallSet>(with_solvent(*balls, request_.solvent_radius_angstrom));
  }
  return make_annotation_layer(
      annotations_, {atoms, balls, is_drawn, palette(picture_.theme).warning, 1, std::move(grown)});
}

void CommandLinePictures::follow_options(const ScreenshotCommandOptions& options,
                                         const RunContext& context) {
  picture_.display = display(options);
  picture_.display.beside = beside_body(options.beside);
  picture_.theme = options.light ? Theme::light : Theme::dark;
  picture_.objects = options.objects;
  request_ = options.request;
  input_ = open_one_model(options.input, "A picture shows one model.", context);
  picture_.appearance = appearance(input_.molecule(), options.appearance);
  annotations_ = annotations(BallReferences(input_.opened.molecule, input_.opened.prepared),
                             options.annotations);
}

// Takes from the session the settings that the window uses for a saved picture. Drawings of pages
// below the view are not among them.
void CommandLinePictures::follow_session(const ScreenshotCommandOptions& options,
                                         const RunContext& context) {
  SessionToDraw found = open_session(options, context);
  for (const std::string& note : found.notes) print_note(note);
  const SessionDocument& s = found.session;
  picture_.display = s.settings.display;
  picture_.theme = s.view.light_theme ? Theme::light : Theme::dark;
  request_ = s.settings.request;
  // All engines give the same complex, and this machine may lack the session's engine.
  request_.engine = EngineChoice::automatic;
  picture_.appearance = s.settings.appearance;
  picture_.objects = s.settings.objects;
  annotations_ = s.settings.annotations;
  if (s.view.camera.any()) picture_.camera = s.view.camera;
  picture_.clip = {s.settings.clip, false, true, {}};
  input_ = std::move(found.input);
}

std::shared_ptr<const EngineAnswer> CommandLinePictures::compute(std::optional<double> alpha,
                                                                 const RunContext& context) {
  Request request = request_;
  if (alpha) request.alpha_angstrom2 = *alpha;
  return engines_.compute_shared(input_.prepared().balls, request, context);
}

PictureTexts CommandLinePictures::texts() const {
  ComplexHeader header{{"program", program_text()}};
  const Provenance balls = input_.provenance();
  header.insert(header.end(), balls.begin(), balls.end());
  PictureTexts texts = picture_texts(header);
  texts.emplace_back("alphascope:command", command_);
  return texts;
}

Picture CommandLinePictures::picture(const std::shared_ptr<const EngineAnswer>& answer,
                                     const RunContext& context) {
  PictureTexts texts = picture_texts(complex_header(input_, *answer));
  texts.emplace_back("alphascope:command", command_);
  Picture picture = maker_->make(answer, std::move(texts), context);
  for (const std::string& lacks : maker_->missing_colours()) {
    if (std::exchange(told_, lacks) != lacks) print_note(lacks);  // once for all frames
  }
  return picture;
}

}  // namespace alphascope::cli
