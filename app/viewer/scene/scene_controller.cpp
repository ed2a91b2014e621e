// Takes over answers and controls, draws pictures at a suitable quality, and describes them.
#include "app/viewer/scene/scene_controller.hpp"

#include <algorithm>
#include <new>
#include <utility>

#include "app/session/result_header.hpp"
#include "ui/scene/camera_place.hpp"
#include "ui/scene/display_style.hpp"
#include "ui/scene/picture/draw_marks.hpp"

namespace alphascope {
namespace {

constexpr double kRefineAfterSeconds = 0.25;
// Seconds for which a picture that waits for its replacement is not refined, if samples are slow.
// The replacement would have to wait for them.
constexpr double kReplacedWithinSeconds = 2;
constexpr double kNotDue = 1e9;
// Length of a slice of refinement, if one sample takes less.
constexpr double kSliceMilliseconds = 12;
constexpr const char* kStandIn = "While it moves, the complex stands in for the balls.";
// Newer pictures that arrive sooner follow the slider. Marking them as outdated would flicker.
constexpr std::chrono::milliseconds kOutdatedAfter{300};
// A mesh newer than the one on screen is always finished. Otherwise a slow mesh would never appear
// while the slider moves. set_molecule() cancels meshes of another molecule.
constexpr std::chrono::milliseconds kFinishes = std::chrono::hours(24);

bool is_large_enough(const ViewportInfo& viewport) {
  return viewport.width >= 8 && viewport.height >= 8;
}

}  // namespace

SceneController::SceneController(std::function<void()> wake, FreeMemory free_memory,
                                 MeshMaker make_mesh)
    : free_memory_(std::move(free_memory)),
      make_mesh_(std::move(make_mesh)),
      mesh_worker_(wake, kFinishes),
      layer_worker_(wake),
      beside_worker_(wake),
      pick_worker_(wake),
      cap_worker_(wake, kFinishes),
      paint_worker_(std::move(wake)) {
  scene_.set_style(scene_style());  // set_display() later sends changes only
}

std::shared_ptr<const Molecule> SceneController::molecule() const {
  return opened_ ? opened_->molecule : nullptr;
}

void SceneController::set_molecule(std::shared_ptr<const OpenedMolecule> opened) {
  const bool same_molecule = viewed_ && same_atoms(*viewed_, *opened);
  mesh_worker_.cancel();
  prepared_ = opened->prepared;
  opened_ = std::move(opened);
  answer_ = nullptr;
  agreement_ = nullptr;
  waiting_ = same_molecule;
  if (!waiting_) submit();
}

void SceneController::set_answer(std::shared_ptr<const Answer> answer) {
  if (!answer || answer->prepared != prepared_) return;
  answer_ = std::move(answer);
  agreement_ = nullptr;
  waiting_ = false;
  submit();
}

void SceneController::set_agreement(std::shared_ptr<const Agreement> agreement) {
  if (!agreement || agreement->ours != answer_ || agreement->comparison.identical()) return;
  agreement_ = std::move(agreement);
  submit();
}

void SceneController::show_without_answer() {
  if (!prepared_ || answer_) return;
  // Called in each frame, so a drawing in progress must not be started again.
  const bool there = drawn_molecule_ && drawn_molecule_->prepared == prepared_;
  if (!waiting_ && (there || mesh_worker_.activity().busy)) return;
  waiting_ = false;
  submit();
}

void SceneController::set_display(const DisplayControls& display, Theme theme, float line_scale) {
  const DisplayControls before = std::exchange(display_, display);
  const bool new_theme = theme != theme_;
  theme_ = theme;
  const bool new_scale = std::exchange(line_scale_, line_scale) != line_scale;
  if (before == display && !new_theme && !new_scale) return;
  scene_.set_style(drawn_style());
  if (before.ball_paint != display.ball_paint) submit_painting();
  if (new_theme) draw_selected();
  if (before.ball_scale != display.ball_scale || before.grown_balls != display.grown_balls) {
    update_radii();
  }
  if (before.beside != display.beside) submit_beside_body();
  if (mesh_options() != requested_mesh_ || before.complex_paint != display.complex_paint) submit();
  dirty_ = true;
}

SceneStyle SceneController::scene_style() const {
  SceneStyle style = alphascope::scene_style(display_, theme_);
  style.line_scale = line_scale_;
  style.cut = cut_of(drawn_caps_.clip);
  return style;
}

SceneController::BallLook SceneController::ball_look(const Answer* answer) const {
  return {display_.ball_paint, ball_style(display_, answer ? &answer->request : nullptr)};
}

void SceneController::update_radii() {
  if (!drawn_molecule_) return;
  radii_ = radii_of(*drawn_molecule_, ball_look(drawn_answer_.get()).style, drawn_looks_.get());
  scene_.set_ball_radii(radii_);
  draw_selected();
  dirty_ = true;
}

ViewProblem SceneController::find_view_problem() const {
  if (!drawn_molecule_ || draws_nothing()) return ViewProblem::none;
  const bool complex = drawn_mesh_ && !drawn_mesh_->empty();
  const std::vector<float> not_drawn;
  const Cut cut = scene_style().cut;
  const BallGeometry& all = *drawn_molecule_->geometry;
  const auto kept = [&](std::size_t i) {
    return std::all_of(cut.kept.begin(), cut.kept.end(), [&](const HalfSpace& space) {
      return space.depth(all.centres[i]) >= -all.radii[i];
    });
  };
  std::size_t i = 0;
  while (cut.on() && i < all.centres.size() && !kept(i)) ++i;
  if (cut.on() && i == all.centres.size()) return ViewProblem::cut_away;
  if (!complex && drawn_looks_ && drawn_looks_->hidden_balls > 0) {
    const bool any_ball = display_.balls && std::any_of(radii_.begin(), radii_.end(),
                                                        [](float radius) { return radius > 0; });
    if (!any_ball) return beside_body_.mesh ? ViewProblem::none : ViewProblem::all_hidden;
  }
  if (!complex && !display_.balls) return ViewProblem::none;  // nothing is switched on
  return view_problem(*drawn_molecule_->geometry, display_.balls ? radii_ : not_drawn,
                      scene_.sight(), complex);
}

void SceneController::pointer(const PointerEvent& event) {
  switch (event.kind) {
    case PointerEvent::Kind::move:
      scene_.pointer_move(event.x, event.y, event.control, event.shift);
      break;
    case PointerEvent::Kind::press:
    case PointerEvent::Kind::release: {
      constexpr PointerButton kButtons[] = {PointerButton::left, PointerButton::right,
                                            PointerButton::middle};
      scene_.pointer_move(event.x, event.y, event.control, event.shift);
      scene_.pointer_button(kButtons[event.button], event.kind == PointerEvent::Kind::press);
      break;
    }
    case PointerEvent::Kind::click:
      return;
    case PointerEvent::Kind::wheel:
      scene_.wheel(event.wheel);
      break;
    case PointerEvent::Kind::double_click:
      scene_.reset_view();
      break;
  }
  dirty_ = true;
}

void SceneController::reset_view() {
  scene_.reset_view();
  dirty_ = true;
}

void SceneController::settle_view(const ViewportInfo& viewport) {
  if (scene_.view_is_set() || !is_large_enough(viewport)) return;
  scene_.settle_view(viewport.width, viewport.height);
}

std::optional<CameraPlace> SceneController::camera() const {
  if (!drawn_molecule_ || draws_nothing()) return std::nullopt;
  return camera_place(scene_.viewpoint(), *drawn_molecule_->geometry);
}

void SceneController::set_camera_when_drawn(const std::optional<CameraPlace>& camera) {
  wanted_camera_ = camera;
}

void SceneController::move_camera(const CameraPlace& camera) {
  scene_.set_viewpoint(viewpoint_at(camera, *drawn_molecule_->geometry));
  dirty_ = true;
}

bool SceneController::poll() {
  const std::shared_ptr<const Answer> before = drawn_answer_;
  mesh_worker_.poll();
  layer_worker_.poll();
  beside_worker_.poll();
  pick_worker_.poll();
  cap_worker_.poll();
  paint_worker_.poll();
  return before != drawn_answer_;
}

std::uint64_t SceneController::held_bytes() const {
  const std::uint64_t pending = busy() ? pending_bytes_.load() : 0;
  if (!drawn_molecule_) return pending;
  return pending + drawn_bytes(drawn_molecule_->geometry->centres.size(), drawn_mesh_.get()) +
         layer_bytes(layer_points(drawn_layers_.layers));
}

double SceneController::seconds_to_refinement() const {
  if (!refine_ || covered_) return kNotDue;
  const auto left = [](double seconds, Clock::time_point since) {
    return std::max(0.0, seconds - std::chrono::duration<double>(Clock::now() - since).count());
  };
  double due = drawn_ == RenderQuality::fine ? 0 : left(kRefineAfterSeconds, last_change_);
  if (outdated_since_ && quality_.sample() > kSliceMilliseconds) {
    due = std::max(due, left(kReplacedWithinSeconds, *outdated_since_));
  }
  return due;
}

void SceneController::describe(ViewportInfo& viewport) const {
  describe_colours(viewport);
  viewport.not_drawn = not_drawn();
  if (!drawn_layers_.not_drawn.empty()) {
    viewport.not_drawn += (viewport.not_drawn.empty() ? "" : " ") + drawn_layers_.not_drawn;
  }
  if (stand_in_) {
    viewport.not_drawn += (viewport.not_drawn.empty() ? "" : " ") + std::string(kStandIn);
  }
  viewport.fades_rest = drawn_layers_.mesh && drawn_layers_.mesh->fades_rest;
  viewport.problem = view_problem_;
  viewport.hidden_balls = drawn_looks_ ? drawn_looks_->hidden_balls : 0;
  if (drawn_molecule_) {
    const BallGeometry& balls = *drawn_molecule_->geometry;
    for (std::size_t k = 0; k < 3; ++k) {
      viewport.box_middle[k] =
          balls.origin[k] + (balls.bounds[2 * k] + balls.bounds[2 * k + 1]) / 2;
      viewport.box_half[k] = (balls.bounds[2 * k + 1] - balls.bounds[2 * k]) / 2;
    }
  }
  const std::array<double, 3> forward = scene_.sight().forward;
  viewport.into_view = {forward[0], forward[1], forward[2]};
}

void SceneController::render(ViewportInfo& viewport, bool interacting, bool patient) {
  // Balls that wait for their first complex are not an outdated picture.
  const bool first = drawn_molecule_ && drawn_molecule_->prepared == prepared_ && !drawn_answer_;
  const bool old = viewport.texture != 0 && !first && (pending_ || outdated());
  if (!old) outdated_since_.reset();
  if (old && !outdated_since_) outdated_since_ = Clock::now();
  viewport.outdated = outdated_since_ && Clock::now() - *outdated_since_ >= kOutdatedAfter;
  if (!is_large_enough(viewport) || !drawn_molecule_) return;
  if (viewport.width != width_ || viewport.height != height_) {
    width_ = viewport.width;
    height_ = viewport.height;
    dirty_ = true;
  }
  covered_ = viewport.covered && scene_.view_is_set();
  if (covered_) return;
  const bool change = std::exchange(dirty_, false);
  if (change) last_change_ = Clock::now();
  view_checked_ = view_checked_ && !change;
  const bool refine_now = refine_ && !interacting && seconds_to_refinement() <= 0;
  const bool draws = change || refine_now || (patient && unfinished());
  take_time(draws);
  if (!draws) return check_view(viewport, interacting);
  const bool new_picture = std::exchange(new_picture_, false);
  const bool follows = interacting && (pending_ || new_picture);
  const RenderQuality target = patient                 ? RenderQuality::fine
                               : refine_now && !change ? quality_.at_rest()
                                                       : quality_for_change(follows);
  choose_stand_in((refine_now && !change) || patient);
  try {
    draw(target, patient);
  } catch (const std::bad_alloc&) {
    return show_no_memory();
  }
  drawn_ = target;
  refine_ = (quality_.at_rest() == RenderQuality::fine && unfinished()) ||
            target == RenderQuality::sketch || stand_in_;
  viewport.texture = scene_.texture();
  viewport.angstrom_per_pixel = draws_nothing() ? 0 : scene_.angstrom_per_pixel();
  viewport.labels.clear();
  if (drawn_layers_.mesh) {
    viewport.labels =
        labels_seen(drawn_layers_.mesh->labels, scene_.sight(), scene_style().cut, width_, height_);
  }
  check_view(viewport, interacting);
}

void SceneController::begin_picture(ViewportInfo& viewport, bool interacting) {
  const bool new_one = new_picture_ && dirty_ && !covered_;
  if (!new_one || !wanted_layers_.empty() || !scene_.draws_meanwhile()) return;
  render(viewport, interacting, false);
}

// Exact translucency is for pictures at rest only: it needs a pass for each layer.
RenderQuality SceneController::quality_for_change(bool follows_computation) const {
  const RenderQuality best = follows_computation ? quality_.while_computing() : quality_.moving();
  return scene_.draws_translucent() ? std::min(best, RenderQuality::draft) : best;
}

// Notes the time of a picture that the GPU may still be drawing. Call before a change on which the
// time depends.
void SceneController::take_time(bool wait) {
  if (const auto taken = scene_.take_milliseconds(wait)) note_times(drawn_, *taken);
}

// Draws as many samples of a fine picture as fit into a slice: at least one.
void SceneController::draw(RenderQuality quality, bool patient) {
  if (quality != RenderQuality::fine && !patient) {
    drawn_ = quality;
    scene_.start_render(width_, height_, quality);
    return take_time(false);
  }
  double taken = 0;
  do {
    const double milliseconds = scene_.render(width_, height_, quality);
    note_times(quality, milliseconds);
    taken += milliseconds;
    drawn_ = quality;
  } while (quality == RenderQuality::fine && unfinished() &&
           (patient || taken + quality_.sample() <= kSliceMilliseconds));
}

bool SceneController::unfinished() const {
  return drawn_ != RenderQuality::fine || scene_.samples_drawn() < display_.samples;
}

void SceneController::choose_stand_in(bool at_rest) {
  const bool faces = drawn_mesh_ && drawn_mesh_->faces_drawn() > 0;
  const bool without = display_.balls && balls_.wanted(at_rest, faces);
  if (std::exchange(stand_in_, without) != without) scene_.set_style(drawn_style());
}

SceneStyle SceneController::drawn_style() const {
  SceneStyle style = scene_style();
  if (stand_in_) style.balls = false;
  return style;
}

// Does nothing while the user moves the view, since a view on its way may show nothing.
void SceneController::check_view(ViewportInfo& viewport, bool interacting) {
  if (interacting || std::exchange(view_checked_, true)) return;
  viewport.problem = view_problem_ = find_view_problem();
}

ComplexHeader SceneController::header() const {
  if (!drawn_molecule_) return {};
  const OpenedMolecule& opened = *drawn_molecule_->opened;
  if (drawn_answer_) return header_of(opened, *drawn_answer_);
  const Provenance balls =
      provenance(*opened.molecule, opened.options.balls, opened.prepared->report);
  ComplexHeader header{{"program", program_text("alphascope")}};
  header.insert(header.end(), balls.begin(), balls.end());
  return header;
}

PictureTexts SceneController::texts() const {
  if (!drawn_molecule_) return {};
  PictureTexts texts = picture_texts(header());
  if (drawn_looks_) note_hidden_atoms(texts, drawn_looks_->hidden_balls);
  if (const std::string lacks = not_drawn(); !lacks.empty()) texts.emplace_back("Warning", lacks);
  return texts;
}

// Whether the picture on screen is older than the wanted molecule or its answer.
bool SceneController::outdated() const {
  if (!drawn_molecule_) return opened_ != nullptr;
  return drawn_molecule_->prepared != prepared_ || (answer_ && drawn_answer_ != answer_);
}

bool SceneController::draws_nothing() const {
  return drawn_molecule_ && drawn_molecule_->geometry->centres.empty() && !not_drawn_.empty();
}

PictureToSave SceneController::picture(const ScreenshotRequest& request) const {
  if (draws_nothing()) throw std::runtime_error(not_drawn_);
  if (!drawn_molecule_) {
    throw std::runtime_error("The picture is still being drawn. Save it when it is ready.");
  }
  const std::size_t balls = drawn_molecule_->geometry->centres.size();
  Layers layers;
  for (const auto& layer : drawn_layers_.layers) {
    if (layer->in_pictures) layers.push_back(layer);
  }
  require_room(request.options.width, request.options.height, free_memory_(),
               second_scene_bytes(balls, drawn_mesh_.get()) + layer_bytes(layer_points(layers)));
  PictureToSave picture;
  picture.balls = drawn_molecule_->geometry;
  picture.colours = painted(
      ball_painting_ ? ball_painting_->balls.colours : std::vector<Rgb8>(balls, kNoValueColour),
      drawn_looks_.get());
  picture.radii = radii_;
  picture.mesh = drawn_mesh_;
  picture.caps = drawn_caps_.mesh;
  picture.differences = drawn_differences_;
  picture.layers = std::move(layers);
  picture.beside_body = beside_body_.mesh;
  picture.style = scene_style();
  // Lines keep the share of the picture that they have in the window.
  if (height_ > 0) {
    picture.style.line_scale *=
        static_cast<float>(request.options.height) / static_cast<float>(height_);
  }
  picture.viewpoint = scene_.viewpoint();
  picture.picture = {
      request.options.width,
      request.options.height,
      request.options.transparent,
      theme_,
      request.options.legend ? legends_of(ball_key(), simplex_key()) : std::vector<ColourLegend>{},
      request.options.scale_bar,
      {},
      picture.style.cut,
      caption(request.options.caption)};
  picture.texts = texts();
  picture.path = request.path;
  return picture;
}

}  // namespace alphascope
