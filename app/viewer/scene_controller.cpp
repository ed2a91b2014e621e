// See the header.
#include "app/viewer/scene_controller.hpp"

#include <algorithm>
#include <new>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "app/session/result_header.hpp"
#include "ui/scene/ball_colours.hpp"
#include "ui/scene/draw_marks.hpp"

namespace alphascope {
namespace {

constexpr double kRefineAfterSeconds = 0.25;
constexpr double kNotDue = 1e9;
// Newer pictures that arrive sooner than this follow the hand; saying so would flicker.
constexpr std::chrono::milliseconds kOutdatedAfter{300};
// A mesh that is newer than the one on screen is worth finishing: else a slow one would never be
// seen while the slider is dragged. What it is of no more is cancelled by set_molecule().
constexpr std::chrono::milliseconds kFinishes = std::chrono::hours(24);
// Points of panels' layers that are made between two frames: a millisecond or two. More are made on
// a worker's thread.
constexpr std::size_t kMostPointsAtOnce = 60000;
const std::string kNoMemory = std::string(kNothingDrawn) + " Choose" + kShowLess;

std::shared_ptr<const std::vector<Rgb8>> shared(std::vector<Rgb8> colours) {
  return std::make_shared<const std::vector<Rgb8>>(std::move(colours));
}

std::shared_ptr<const DrawnMolecule> make_drawn(std::shared_ptr<const OpenedMolecule> opened,
                                                const RunContext& context) {
  auto drawn = std::make_shared<DrawnMolecule>();
  const auto& [molecule, prepared] = std::tie(opened->molecule, opened->prepared);
  drawn->geometry = std::make_shared<const BallGeometry>(*prepared->balls);
  drawn->picker = std::make_shared<const BallPicker>(drawn->geometry);
  context.cancel.throw_if_cancelled();
  drawn->by_element = shared(colours_by_element(*molecule, prepared->atom_of_ball));
  drawn->by_chain = shared(colours_by_chain(*molecule, prepared->atom_of_ball));
  context.cancel.throw_if_cancelled();
  drawn->molecule = molecule;
  drawn->prepared = prepared;
  drawn->opened = std::move(opened);
  return drawn;
}

// Without balls, for want of memory.
std::shared_ptr<const DrawnMolecule> undrawn(std::shared_ptr<const OpenedMolecule> opened) {
  auto drawn = std::make_shared<DrawnMolecule>();
  drawn->molecule = opened->molecule;
  drawn->prepared = opened->prepared;
  drawn->opened = std::move(opened);
  drawn->geometry = std::make_shared<const BallGeometry>();
  drawn->picker = std::make_shared<const BallPicker>(drawn->geometry);
  drawn->by_element = drawn->by_chain = shared({});
  return drawn;
}

ComplexColouring colouring(ColourBy colour) {
  switch (colour) {
    case ColourBy::single:
      return ComplexColouring::single;
    case ColourBy::alpha:
      return ComplexColouring::alpha;
    case ColourBy::element:
    case ColourBy::chain:
    case ColourBy::exposed:
    case ColourBy::exposed_residue:
      break;
  }
  return ComplexColouring::balls;
}

}  // namespace

SceneController::SceneController(std::function<void()> wake, FreeMemory free_memory,
                                 MeshMaker make_mesh)
    : free_memory_(std::move(free_memory)),
      make_mesh_(std::move(make_mesh)),
      mesh_worker_(wake, kFinishes),
      layer_worker_(wake),
      beside_worker_(std::move(wake)) {}

std::shared_ptr<const Molecule> SceneController::molecule() const {
  return opened_ ? opened_->molecule : nullptr;
}

void SceneController::set_molecule(std::shared_ptr<const OpenedMolecule> opened) {
  const bool same_molecule = viewed_ == opened->molecule;
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
  // Asked every frame: what is on its way must not be begun again.
  const bool there = drawn_molecule_ && drawn_molecule_->prepared == prepared_;
  if (!waiting_ && (there || mesh_worker_.activity().busy)) return;
  waiting_ = false;
  submit();
}

void SceneController::set_display(const DisplayControls& display, Theme theme) {
  const DisplayControls before = std::exchange(display_, display);
  const bool new_theme = theme != theme_;
  theme_ = theme;
  if (before == display && !new_theme) return;
  scene_.set_style(scene_style());
  if (before.ball_colour != display.ball_colour || new_theme) update_colours();
  if (new_theme) draw_selected();
  if (before.ball_scale != display.ball_scale || before.grown_balls != display.grown_balls) {
    update_radii();
  }
  if (before.beside != display.beside) submit_beside_body();
  const bool lacks_exposure = is_exposure(display.ball_colour) && !is_exposure_shown() &&
                              before.ball_colour != display.ball_colour;
  if (mesh_options() != requested_mesh_ || before.complex_colour != display.complex_colour ||
      lacks_exposure) {
    submit();
  }
  dirty_ = true;
}

SceneStyle SceneController::scene_style() const {
  SceneStyle style;
  style.balls = display_.balls;
  style.ball_opacity = display_.ball_opacity;
  style.complex_opacity = display_.complex_opacity;
  style.ambient_occlusion = display_.ambient_occlusion;
  style.theme = theme_;
  return style;
}

void SceneController::update_colours() {
  if (!drawn_molecule_) return;
  scene_.set_ball_colours(
      ball_colours(*drawn_molecule_, display_.ball_colour, drawn_exposure_.get()));
  dirty_ = true;
}

SceneController::BallLook SceneController::ball_look(const Answer* answer) const {
  BallLook look{display_.ball_colour, {}};
  look.style.scale = display_.ball_scale;
  look.style.grown = display_.grown_balls && answer != nullptr;
  if (look.style.grown) {
    look.style.alpha = answer->request.alpha_angstrom2;
    look.style.solvent_radius = answer->request.solvent_radius_angstrom;
  }
  return look;
}

void SceneController::update_radii() {
  if (!drawn_molecule_) return;
  radii_ = drawn_radii(*drawn_molecule_->geometry, ball_look(drawn_answer_.get()).style);
  scene_.set_ball_radii(radii_);
  draw_selected();
  dirty_ = true;
}

MeshOptions SceneController::mesh_options() const {
  MeshOptions options;
  options.tetrahedra = display_.tetrahedra;
  options.boundary = display_.boundary;
  options.triangles = display_.triangles;
  options.edges = display_.edges;
  options.singular_only = display_.singular_only;
  options.shrink = display_.shrink;
  options.translucent = display_.complex_opacity < 1;
  options.colouring = colouring(display_.complex_colour);
  options.single_colour = to_rgb8(palette(theme_).complex_single);
  return options;
}

void SceneController::submit() {
  requested_mesh_ = mesh_options();
  if (!prepared_ || waiting_) return;  // what is awaited will be made with the new options
  const Wanted wanted{drawn_molecule_,
                      opened_,
                      answer_,
                      agreement_,
                      display_.complex_colour == ColourBy::element,
                      ball_look(answer_.get()),
                      requested_mesh_,
                      answer_ && answer_ == drawn_answer_ ? drawn_measures() : nullptr};
  mesh_worker_.submit(
      [this, wanted](const RunContext& context) -> Worker::Delivery {
        try {
          return make_drawing(wanted, context);
        } catch (const std::bad_alloc&) {
          return [this, opened = wanted.opened] {
            if (opened == opened_) show_nothing(kNoMemory);
          };
        }
      },
      [this](const Worker::Failure& failure) {
        if (!failure.cancelled) show_nothing("Nothing is drawn: " + failure.message);
      });
}

// On the worker's thread.
Worker::Delivery SceneController::make_drawing(const Wanted& wanted, const RunContext& context) {
  const auto& [drawn, opened, answer, agreement, by_element, look, mesh, measures] = wanted;
  const std::size_t balls = opened->prepared->balls->size();
  const bool known =
      drawn && drawn->prepared == opened->prepared && drawn->geometry->centres.size() == balls;
  const DrawingPlan plan = plan_drawing({known ? 0 : balls, answer ? &answer->complex : nullptr,
                                         agreement ? &agreement->comparison : nullptr, mesh},
                                        free_memory_());
  pending_bytes_ = plan.complete() ? plan.wanted_bytes : drawing_budget(plan.free_bytes);
  if (!plan.complete() && drawn) return [this] { make_room(); };
  Drawing drawing;
  drawing.not_drawn = not_drawn_text(plan);
  drawing.answer = answer;
  drawing.molecule = !plan.balls ? undrawn(opened) : known ? drawn : make_drawn(opened, context);
  const DrawnMolecule& m = *drawing.molecule;
  drawing.look = look;
  if (!known || look.style.grown) drawing.radii = drawn_radii(*m.geometry, look.style);
  if (answer && plan.balls && is_exposure(look.colour) && !answer->complex.tetrahedra_only) {
    drawing.exposure = make_exposure(m, *answer, look.colour, measures, context);
  }
  if (!known) {
    drawing.balls = make_ball_data(m.geometry, ball_colours(m, look.colour, drawing.exposure.get()),
                                   drawing.radii);
  }
  if (answer && plan.balls) {
    drawing.mesh = std::make_shared<const ComplexMesh>(make_mesh_(
        *m.geometry, by_element ? *m.by_element : *m.by_chain, answer->complex, plan.mesh));
    context.cancel.throw_if_cancelled();
    drawing.mesh_data = make_mesh_data(drawing.mesh);
    drawing.picks = mesh_layers(drawing.mesh);
  }
  if (plan.differences) {
    drawing.differences = std::make_shared<const DifferenceMesh>(
        build_difference_mesh(*m.geometry, agreement->comparison));
    drawing.difference_data = make_difference_data(drawing.differences);
  }
  return [this, drawing] { take(drawing); };
}

// Tries again without what is on screen; its last picture stays, and tells that it is outdated.
void SceneController::make_room() {
  forget_layers();
  scene_.set_balls(std::make_shared<const BallGeometry>(), {});
  drawn_molecule_ = nullptr;
  drawn_answer_ = nullptr;
  drawn_mesh_ = nullptr;
  drawn_differences_ = nullptr;
  drawn_exposure_ = nullptr;
  picks_.clear();
  submit();
}

void SceneController::show_nothing(const std::string& why) {
  Drawing nothing;
  nothing.molecule = undrawn(opened_);
  nothing.answer = answer_;
  nothing.not_drawn = why;
  show(std::move(nothing));
}

void SceneController::take(Drawing drawing) {
  if (drawing.molecule->prepared != prepared_) return;
  try {
    show(std::move(drawing));
  } catch (const std::bad_alloc&) {
    show_nothing(kNoMemory);
  }
}

void SceneController::show(Drawing drawing) {
  const bool new_balls = drawing.molecule != drawn_molecule_;
  outdated_since_.reset();  // the next that is awaited may take its time as well
  const bool keep_view = viewed_ == drawing.molecule->molecule;
  drawn_answer_ = drawing.answer;
  not_drawn_ = drawing.not_drawn;
  drawn_molecule_ = drawing.molecule;
  if (new_balls) forget_layers();  // they go with the balls
  drawn_exposure_ = std::move(drawing.exposure);
  if (new_balls || display_.grown_balls) show_balls(drawing);
  if (is_exposure(display_.ball_colour)) update_colours();
  alpha_legend_ = drawing.mesh && drawing.mesh->scale ? std::optional(drawing.mesh->scale->legend())
                                                      : std::nullopt;
  drawn_mesh_ = std::move(drawing.mesh);
  picks_ = std::move(drawing.picks);
  drawn_differences_ = std::move(drawing.differences);
  scene_.set_mesh(std::move(drawing.mesh_data));
  scene_.set_differences(std::move(drawing.difference_data));
  dirty_ = true;
  if (!new_balls) return;
  submit_beside_body();
  viewed_ = draws_nothing() ? nullptr : drawn_molecule_->molecule;
  if (!keep_view) quality_.forget();
  // Other atoms of the same molecule keep the view, unless it shows none of them.
  if (!keep_view || find_view_problem() != ViewProblem::none) scene_.reset_view();
}

// Colours and radii come with the drawing, unless the controls have changed since it was begun.
void SceneController::show_balls(Drawing& drawing) {
  const BallLook wanted = ball_look(drawn_answer_.get());
  const bool look_is_new = drawing.balls && drawing.look.colour != wanted.colour;
  const std::size_t count = drawn_molecule_->geometry->centres.size();
  const bool radii_fit = drawing.look.style == wanted.style && drawing.radii.size() == count;
  const bool with_radii = drawing.balls != nullptr;
  if (with_radii) {
    scene_.set_balls(std::move(drawing.balls));
  } else if (count == 0) {
    scene_.set_balls(drawn_molecule_->geometry, {});
  }
  if (look_is_new) update_colours();
  if (!radii_fit) return update_radii();
  radii_ = std::move(drawing.radii);
  if (!with_radii) scene_.set_ball_radii(radii_);
  draw_selected();
}

ViewProblem SceneController::find_view_problem() const {
  if (!drawn_molecule_ || draws_nothing()) return ViewProblem::none;
  const bool complex = drawn_mesh_ && drawn_mesh_->points() > 0;
  const std::vector<float> not_drawn;
  if (!complex && !display_.balls) return ViewProblem::none;  // nothing is switched on
  return view_problem(*drawn_molecule_->geometry, display_.balls ? radii_ : not_drawn,
                      scene_.sight(), complex);
}

void SceneController::set_layers(const Layers& layers) {
  Layers fitting;
  std::vector<std::pair<std::string, std::uint64_t>> keys;
  for (const auto& layer : layers) {
    if (!drawn_answer_ || layer->balls != drawn_answer_->balls) continue;
    fitting.push_back(layer);
    keys.emplace_back(layer->id, layer->key);
  }
  if (draws_nothing()) fitting.clear(), keys.clear();
  if (keys == wanted_layers_) return;
  wanted_layers_ = keys;
  layer_worker_.cancel();
  if (fitting.empty()) return show_layers({}, nullptr);
  if (layer_points(fitting).all() > kMostPointsAtOnce) return submit_layers(fitting);
  auto mesh =
      std::make_shared<const LayerMesh>(build_layer_mesh(*drawn_molecule_->geometry, fitting));
  show_layers({fitting, mesh, {}, body_layers(mesh)}, make_layer_data(mesh));
}

void SceneController::submit_layers(const Layers& layers) {
  const auto tell = [this](const std::string& why) {
    show_layers({{}, nullptr, why, {}}, nullptr);
  };
  layer_worker_.submit(
      [this, tell, layers, drawn = drawn_molecule_](const RunContext&) -> Worker::Delivery {
        const std::string not_drawn = layers_not_drawn_text(layer_points(layers), free_memory_());
        if (!not_drawn.empty()) return [tell, not_drawn] { tell(not_drawn); };
        auto mesh = std::make_shared<const LayerMesh>(build_layer_mesh(*drawn->geometry, layers));
        return
            [this, layers, drawn, mesh, picks = body_layers(mesh), data = make_layer_data(mesh)] {
              if (drawn == drawn_molecule_) show_layers({layers, mesh, {}, picks}, data);
            };
      },
      [tell](const Worker::Failure& failure) {
        if (!failure.cancelled) tell("What is chosen below is not drawn: " + failure.message);
      });
}

void SceneController::show_layers(DrawnLayers layers, std::shared_ptr<LayerData> data) {
  drawn_layers_ = std::move(layers);
  scene_.set_layers(std::move(data));
  dirty_ = true;
}

// What was drawn before stays until it is there.
void SceneController::submit_beside_body() {
  if (!drawn_molecule_ || drawn_molecule_->prepared->left_out.empty()) {
    beside_worker_.cancel();
    return;
  }
  beside_worker_.submit([this, drawn = drawn_molecule_,
                         shown = display_.beside](const RunContext& c) -> Worker::Delivery {
    BesideBody atoms =
        build_beside_body(*drawn->geometry, *drawn->molecule, *drawn->prepared, shown, c.cancel);
    std::optional<PickLayer> pick;
    if (atoms.mesh) pick = ball_layer(kBesideBody, atoms.mesh->spheres, 1);
    return [this, drawn, pick, data = make_layer_data(atoms.mesh), atoms] {
      if (drawn != drawn_molecule_) return;
      beside_body_ = atoms;
      beside_body_pick_ = pick;
      scene_.set_beside_body(data);
      dirty_ = true;
    };
  });
}

void SceneController::forget_layers() {
  beside_worker_.cancel();
  beside_body_ = {};
  beside_body_pick_.reset();
  selected_ = {};
  layer_worker_.cancel();
  wanted_layers_.clear();
  drawn_layers_ = {};
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

bool SceneController::poll() {
  const std::shared_ptr<const Answer> before = drawn_answer_;
  mesh_worker_.poll();
  layer_worker_.poll();
  beside_worker_.poll();
  return before != drawn_answer_;
}

std::uint64_t SceneController::held_bytes() const {
  const std::uint64_t pending = busy() ? pending_bytes_.load() : 0;
  if (!drawn_molecule_) return pending;
  return pending + drawn_bytes(drawn_molecule_->geometry->centres.size(), drawn_mesh_.get()) +
         layer_bytes(layer_points(drawn_layers_.layers));
}

double SceneController::seconds_to_refinement() const {
  if (!refine_) return kNotDue;
  const std::chrono::duration<double> since = Clock::now() - last_change_;
  return std::max(0.0, kRefineAfterSeconds - since.count());
}

void SceneController::describe(ViewportInfo& viewport) const {
  viewport.legend = legend();
  viewport.not_drawn = not_drawn();
  if (!drawn_layers_.not_drawn.empty()) {
    viewport.not_drawn += (viewport.not_drawn.empty() ? "" : " ") + drawn_layers_.not_drawn;
  }
  viewport.problem = view_problem_;
  const std::array<double, 3> forward = scene_.sight().forward;
  viewport.into_view = {forward[0], forward[1], forward[2]};
}

void SceneController::render(ViewportInfo& viewport, bool interacting, bool patient) {
  const bool old = viewport.texture != 0 && (pending_ || outdated());
  if (!old) outdated_since_.reset();
  if (old && !outdated_since_) outdated_since_ = Clock::now();
  viewport.outdated = outdated_since_ && Clock::now() - *outdated_since_ >= kOutdatedAfter;
  if (viewport.width < 8 || viewport.height < 8 || !drawn_molecule_) return;
  if (viewport.width != width_ || viewport.height != height_) {
    width_ = viewport.width;
    height_ = viewport.height;
    dirty_ = true;
  }
  const bool change = std::exchange(dirty_, false);
  if (change) last_change_ = Clock::now();
  view_checked_ = view_checked_ && !change;
  const bool refine_now = refine_ && !interacting && seconds_to_refinement() <= 0;
  if (!change && !refine_now && !(patient && drawn_ != RenderQuality::fine)) {
    return check_view(viewport, interacting);
  }
  const RenderQuality target = patient                 ? RenderQuality::fine
                               : refine_now && !change ? quality_.at_rest()
                                                       : quality_.moving();
  try {
    quality_.note(target, scene_.render(width_, height_, target));
  } catch (const std::bad_alloc&) {
    return show_nothing(kNoMemory);
  }
  drawn_ = target;
  refine_ = quality_.at_rest() > target;
  viewport.texture = scene_.texture();
  viewport.angstrom_per_pixel = draws_nothing() ? 0 : scene_.angstrom_per_pixel();
  viewport.labels.clear();
  if (drawn_layers_.mesh) {
    viewport.labels = labels_seen(drawn_layers_.mesh->labels, scene_.sight(), width_, height_);
  }
  check_view(viewport, interacting);
}

// Not while the hand is moving the view: it is on its way.
void SceneController::check_view(ViewportInfo& viewport, bool interacting) {
  if (interacting || std::exchange(view_checked_, true)) return;
  viewport.problem = view_problem_ = find_view_problem();
}

PictureTexts SceneController::texts() const {
  if (!drawn_molecule_) return {};
  constexpr const char* kProgram = "alphascope";
  const OpenedMolecule& opened = *drawn_molecule_->opened;
  const Provenance balls =
      provenance(*opened.molecule, opened.options.balls, opened.prepared->report);
  ComplexHeader header{{"program", program_text(kProgram)}};
  if (drawn_answer_) {
    header = result_header(kProgram, balls, opened.molecule->notes, *drawn_answer_);
  } else {
    header.insert(header.end(), balls.begin(), balls.end());
  }
  PictureTexts texts = picture_texts(header);
  if (const std::string lacks = not_drawn(); !lacks.empty()) texts.emplace_back("Warning", lacks);
  return texts;
}

// Of the molecule wanted, and newer than what is on screen.
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
  picture.colours = ball_colours(*drawn_molecule_, display_.ball_colour, drawn_exposure_.get());
  picture.radii = radii_;
  picture.mesh = drawn_mesh_;
  picture.differences = drawn_differences_;
  picture.layers = std::move(layers);
  picture.beside_body = beside_body_.mesh;
  picture.style = scene_style();
  picture.viewpoint = scene_.viewpoint();
  picture.picture = {request.options.width,
                     request.options.height,
                     request.options.transparent,
                     theme_,
                     request.options.legend ? legend() : std::nullopt,
                     request.options.scale_bar,
                     {}};
  picture.texts = texts();
  picture.path = request.path;
  return picture;
}

}  // namespace alphascope
