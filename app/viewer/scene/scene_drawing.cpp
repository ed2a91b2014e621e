// Drawings of a molecule and its complex: a worker makes them, and the main thread takes them into
// the scene.
#include <new>
#include <tuple>
#include <utility>

#include "app/viewer/scene/scene_controller.hpp"
#include "core/complex/own_dimension.hpp"
#include "core/run/freed_elsewhere.hpp"
#include "core/run/picture_stages.hpp"
#include "ui/scene/display_style.hpp"

namespace alphascope {
namespace {

std::shared_ptr<const DrawnMolecule> make_drawn(std::shared_ptr<const OpenedMolecule> opened,
                                                const RunContext& context) {
  auto drawn = std::make_shared<DrawnMolecule>();
  const auto& [molecule, prepared] = std::tie(opened->molecule, opened->prepared);
  drawn->geometry = std::make_shared<const BallGeometry>(*prepared->balls);
  drawn->picker = std::make_shared<const BallPicker>(drawn->geometry);
  context.cancel.throw_if_cancelled();
  drawn->molecule = molecule;
  drawn->prepared = prepared;
  drawn->opened = std::move(opened);
  return drawn;
}

// Whether the same sandbox was edited. Its view stays, so that a dragged ball stays under the
// mouse.
bool changes_sandbox(const DrawnMolecule* before, const DrawnMolecule& now) {
  return before != nullptr && before->opened && now.opened && before->opened->options.sandbox &&
         now.opened->options.sandbox && before->opened->deposited == now.opened->deposited;
}

// Whether both molecules have the same balls. Two drawings begun before the first one is shown both
// make these balls.
bool has_same_balls(const DrawnMolecule* before, const DrawnMolecule& now) {
  return before != nullptr && before->opened == now.opened && before->prepared == now.prepared &&
         before->geometry->centres.size() == now.geometry->centres.size();
}

// A molecule without balls, for too little memory.
std::shared_ptr<const DrawnMolecule> undrawn(std::shared_ptr<const OpenedMolecule> opened) {
  auto drawn = std::make_shared<DrawnMolecule>();
  drawn->molecule = opened->molecule;
  drawn->prepared = opened->prepared;
  drawn->opened = std::move(opened);
  drawn->geometry = std::make_shared<const BallGeometry>();
  drawn->picker = std::make_shared<const BallPicker>(drawn->geometry);
  return drawn;
}

}  // namespace

MeshOptions SceneController::mesh_options() const {
  return alphascope::mesh_options(display_, theme_);
}

void SceneController::submit() {
  requested_mesh_ = mesh_options();
  if (!prepared_ || waiting_) return;  // the awaited drawing will use the new options
  const Wanted wanted{
      drawn_molecule_,        opened_,         answer_, agreement_,  ball_look(answer_.get()),
      display_.complex_paint, requested_mesh_, clip_,   appearance_, ball_painting_,
      simplex_painting_};
  mesh_worker_.submit(
      [this, wanted](const RunContext& context) -> Worker::Delivery {
        try {
          return make_drawing(wanted, context);
        } catch (const std::bad_alloc&) {
          return [this, opened = wanted.opened] {
            if (opened == opened_) show_no_memory();
          };
        }
      },
      [this](const Worker::Failure& failure) {
        if (!failure.cancelled) show_nothing("Nothing is drawn: " + failure.message);
      });
}

// Reading the amount of free memory takes about as long as the mesh of a small molecule. A reading
// therefore serves for a second if it exceeds the complex a thousandfold. The mesh takes only a few
// times the complex.
std::optional<std::uint64_t> SceneController::free_memory_for(const DrawingTask& task) {
  constexpr std::chrono::seconds kServesFor{1};
  constexpr std::uint64_t kBytesABall = 200, kPlenty = 1000;
  const std::uint64_t small =
      task.balls * kBytesABall + (task.complex ? bytes_of(*task.complex) : 0);
  const Clock::time_point now = Clock::now();
  if (!free_read_ || now - free_read_at_ > kServesFor || *free_read_ / kPlenty < small) {
    free_read_ = free_memory_();
    free_read_at_ = now;
  }
  return free_read_;
}

// Runs on the worker's thread.
Worker::Delivery SceneController::make_drawing(const Wanted& wanted, const RunContext& context) {
  const auto& [drawn, opened, answer, agreement, look, complex_paint, mesh, clip, appearance,
               ball_painting, simplex_painting] = wanted;
  const std::size_t balls = opened->prepared->balls->size();
  const bool known =
      drawn && drawn->prepared == opened->prepared && drawn->geometry->centres.size() == balls;
  const DrawingTask task{known ? 0 : balls, answer ? &answer->complex : nullptr,
                         agreement ? &agreement->comparison : nullptr, mesh};
  DrawingPlan plan = plan_drawing(task, free_memory_for(task));
  if (!plan.complete()) {
    wait_until_freed();  // the previous picture's memory
    plan = plan_drawing(task, free_memory_());
  }
  pending_bytes_ = plan.complete() ? plan.wanted_bytes : drawing_budget(plan.free_bytes);
  if (!plan.complete() && drawn) return [this] { make_room(); };
  Drawing drawing;
  drawing.not_drawn = not_drawn_text(plan);
  drawing.answer = answer;
  drawing.molecule = !plan.balls ? undrawn(opened) : known ? drawn : make_drawn(opened, context);
  const DrawnMolecule& m = *drawing.molecule;
  drawing.look = look;
  drawing.looks = make_looks(m, appearance);
  const BallAppearance* const looks = drawing.looks.get();
  if (!known || look.style.grown) drawing.radii = radii_of(m, look.style, looks);
  if (plan.balls) {
    drawing.ball_painting =
        make_painting({drawing.molecule, answer, look.paint}, ball_painting, context);
  }
  if (!known && plan.balls) {
    drawing.balls = make_ball_data(m.geometry, painted(drawing.ball_painting->balls.colours, looks),
                                   drawing.radii);
  } else if (!known) {
    drawing.balls = make_ball_data(m.geometry, {}, {});
  }
  if (answer && plan.balls) {
    const Clock::time_point begun = Clock::now();
    if (plan.mesh.colouring == ComplexColouring::balls) {
      const bool as_balls = complex_paint == look.paint;
      drawing.simplex_painting =
          make_painting({drawing.molecule, answer, complex_paint},
                        as_balls ? drawing.ball_painting : simplex_painting, context);
    }
    const Painting& of_simplices =
        drawing.simplex_painting ? *drawing.simplex_painting : *drawing.ball_painting;
    drawing.simplex_colours =
        std::make_shared<const std::vector<Rgb8>>(painted(of_simplices.balls.colours, looks));
    const InOwnDimension own(*answer->balls, answer->complex);
    drawing.mesh = freed_elsewhere(
        make_mesh(m, *drawing.simplex_colours, own.complex(), plan.mesh, looks, context.cancel));
    drawing.mesh_data = make_mesh_data(drawing.mesh);
    drawing.mesh_milliseconds =
        std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
    drawing.options = plan.mesh;
    drawing.caps = make_caps(
        {drawing.molecule, answer, drawing.mesh, plan.mesh, drawing.simplex_colours, drawing.looks},
        clip, context.cancel);
    drawing.cap_data = make_cap_data(drawing.caps.mesh);
  }
  if (plan.differences) {
    drawing.differences = std::make_shared<const DifferenceMesh>(
        build_difference_mesh(*m.geometry, agreement->comparison));
    drawing.difference_data = make_difference_data(drawing.differences);
  }
  return [this, drawing] { take(drawing); };
}

// Removes the picture from the scene and tries again. The last image stays, marked as outdated.
void SceneController::make_room() {
  forget_layers();
  scene_.set_balls(std::make_shared<const BallGeometry>(), {});
  drawn_molecule_ = nullptr;
  drawn_answer_ = nullptr;
  drawn_mesh_ = nullptr;
  drawn_differences_ = nullptr;
  ball_painting_ = simplex_painting_ = nullptr;
  drawn_simplex_colours_ = nullptr;
  drawn_caps_.mesh = nullptr;
  drawn_caps_.pick.reset();
  picks_.clear();
  pick_worker_.cancel();
  submit();
}

void SceneController::show_nothing(const std::string& why) {
  Drawing nothing;
  nothing.molecule = undrawn(opened_);
  nothing.answer = answer_;
  nothing.not_drawn = why;
  show(std::move(nothing));
}

void SceneController::show_no_memory() {
  show_nothing(std::string(kNothingDrawn) + " Choose" + kShowLess);
}

void SceneController::take(Drawing drawing) {
  if (drawing.molecule->prepared != prepared_) return;
  if (drawing.mesh) {
    const std::string beyond = beyond_opengl_text(
        *drawing.mesh, drawing.molecule->geometry->centres.size(), scene_.most_cells());
    if (!beyond.empty()) {
      drawing.mesh = nullptr;
      drawing.mesh_data = nullptr;
      drawing.not_drawn = beyond;
    }
  }
  try {
    show(std::move(drawing));
  } catch (const std::bad_alloc&) {
    show_no_memory();
  }
}

// A drawing may arrive after others that were begun later. Its result must therefore follow from
// its own data and the controls, not from the picture at its start.
void SceneController::show(Drawing drawing) {
  take_time(true);
  const bool new_balls = !has_same_balls(drawn_molecule_.get(), *drawing.molecule);
  if (new_balls && !drawing.balls) {
    make_balls(drawing);
  } else if (!new_balls) {
    drawing.molecule = drawn_molecule_;
    drawing.balls = nullptr;
  }
  outdated_since_.reset();  // the time limit starts anew for the next awaited picture
  const bool of_sandbox = changes_sandbox(drawn_molecule_.get(), *drawing.molecule);
  const bool keep_view = viewed_ && (of_sandbox || same_atoms(*viewed_, *drawing.molecule->opened));
  // The scene's origin is the middle of all balls, which may have moved.
  const std::optional<CameraPlace> before = camera();
  const bool same_file = viewed_ && viewed_->deposited == drawing.molecule->opened->deposited;
  const std::optional<NamedView> place =
      keep_view && new_balls && drawn_molecule_ ? std::optional(named_view("")) : std::nullopt;
  new_picture_ = true;
  const bool first_of_answer = drawn_answer_ != drawing.answer;
  drawn_answer_ = drawing.answer;
  not_drawn_ = drawing.not_drawn;
  drawn_molecule_ = drawing.molecule;
  if (new_balls) forget_layers();  // layers belong to their balls
  const bool new_painting = ball_painting_ != drawing.ball_painting;
  ball_painting_ = std::move(drawing.ball_painting);
  simplex_painting_ = std::move(drawing.simplex_painting);
  // Each drawing makes its own looks, which are mostly equal.
  const bool new_looks = (drawn_looks_ || drawing.looks) && !new_balls;
  drawn_looks_ = drawing.looks;
  if (new_balls || display_.grown_balls) show_balls(drawing);
  if ((new_painting && !new_balls) || new_looks) show_ball_colours();
  if (ball_painting_ && ball_painting_->paint != display_.ball_paint) submit_painting();
  if (new_looks) update_radii();
  drawn_mesh_ = std::move(drawing.mesh);
  // The second mesh of an answer reuses the faces that the device found.
  const double on_device =
      first_of_answer && drawing.answer ? drawing.answer->outside_milliseconds : 0;
  picture_stages_ = {{std::string(stage::kMesh), on_device + drawing.mesh_milliseconds, false}};
  submit_picks();
  drawn_differences_ = std::move(drawing.differences);
  drawn_options_ = drawing.options;
  drawn_simplex_colours_ = std::move(drawing.simplex_colours);
  scene_.set_mesh(std::move(drawing.mesh_data));
  show_caps(std::move(drawing.caps), std::move(drawing.cap_data));
  if (drawn_caps_.clip != clip_) submit_caps();
  scene_.set_differences(std::move(drawing.difference_data));
  dirty_ = true;
  if (!new_balls) return;
  submit_beside_body();
  viewed_ = draws_nothing() ? nullptr : drawn_molecule_->opened;
  if (!keep_view) quality_.forget(), balls_.forget();
  if (place) go_to(*place);
  // The view stays for other atoms of the same molecule, unless it shows none of them.
  const ViewProblem problem = find_view_problem();
  const bool shows_none = problem != ViewProblem::none && problem != ViewProblem::cut_away;
  if (!keep_view || shows_none) {
    if (same_file && !wanted_camera_) left_view_ = before;
    scene_.reset_view();
  }
  if (wanted_camera_ && !draws_nothing()) move_camera(*std::exchange(wanted_camera_, {}));
}

// Starts after the picture is shown: the user points at nothing new at once, and at nothing while
// alpha moves.
void SceneController::submit_picks() {
  picks_.clear();
  if (!drawn_mesh_ || drawn_mesh_->empty()) return pick_worker_.cancel();
  pick_worker_.submit([this, mesh = drawn_mesh_,
                       balls = drawn_molecule_->geometry](const RunContext&) -> Worker::Delivery {
    return [this, mesh, layers = mesh_layers(mesh, balls)] {
      if (mesh == drawn_mesh_) picks_ = layers;
    };
  });
}

// The upload of balls and edges counts as part of the drawing.
void SceneController::note_times(RenderQuality quality, double picture_milliseconds) {
  if (!stand_in_) quality_.note(quality, picture_milliseconds);
  if (!stand_in_ && display_.balls) balls_.note(quality, picture_milliseconds);
  const double upload = scene_.take_upload_milliseconds();
  if (picture_stages_.size() != 1) return;
  picture_stages_.push_back({std::string(stage::kUpload), upload, false});
  picture_stages_.push_back({std::string(stage::kDraw), picture_milliseconds - upload, false});
}

// Makes the balls of a drawing that expected its balls on screen, when these have gone meanwhile.
void SceneController::make_balls(Drawing& drawing) const {
  const DrawnMolecule& m = *drawing.molecule;
  const std::size_t count = m.geometry->centres.size();
  drawing.radii = radii_of(m, drawing.look.style, drawing.looks.get());
  const std::vector<Rgb8> colours = drawing.ball_painting
                                        ? drawing.ball_painting->balls.colours
                                        : std::vector<Rgb8>(count, kNoValueColour);
  drawing.balls = make_ball_data(m.geometry, painted(colours, drawing.looks.get()), drawing.radii);
}

// Colours and radii come with the drawing, unless the controls have changed since its start.
void SceneController::show_balls(Drawing& drawing) {
  const BallLook wanted = ball_look(drawn_answer_.get());
  const std::size_t count = drawn_molecule_->geometry->centres.size();
  const bool radii_fit = drawing.look.style == wanted.style && drawing.radii.size() == count;
  const bool with_radii = drawing.balls != nullptr;
  if (with_radii) scene_.set_balls(std::move(drawing.balls));
  if (!radii_fit) return update_radii();
  radii_ = std::move(drawing.radii);
  if (!with_radii) scene_.set_ball_radii(radii_);
  draw_selected();
}

}  // namespace alphascope
