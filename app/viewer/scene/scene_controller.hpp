// Makes the scene follow the session's answers and the display controls. Workers make geometry and
// meshes, and the last picture stays until these are ready. Pictures are drawn only after a change.
// A part that does not fit into memory is left out with a message.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "app/session/session.hpp"
#include "app/viewer/jobs/picture_saver.hpp"
#include "app/viewer/scene/ball_stand_in.hpp"
#include "core/document/reference/appearance.hpp"
#include "core/document/session/session_file.hpp"
#include "core/geometry/real_point.hpp"
#include "core/run/worker.hpp"
#include "core/write/write_complex.hpp"
#include "ui/layer.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/scene/mesh/beside_body.hpp"
#include "ui/scene/mesh/drawing_memory.hpp"
#include "ui/scene/pick/pick.hpp"
#include "ui/scene/picture/frame_grab.hpp"
#include "ui/scene/picture/record_frames.hpp"
#include "ui/scene/quality.hpp"
#include "ui/scene/scene.hpp"

namespace alphascope {

// The balls of a molecule, and the geometry made from them for drawing.
struct DrawnMolecule {
  std::shared_ptr<const OpenedMolecule> opened;  // the source of the next two
  std::shared_ptr<const Molecule> molecule;
  std::shared_ptr<const PreparedBalls> prepared;
  std::shared_ptr<const BallGeometry> geometry;
  std::shared_ptr<const BallPicker> picker;  // picks in geometry
};

class SceneController {
 public:
  // Free memory for drawing in bytes, if known. Called from any thread.
  using FreeMemory = std::function<std::optional<std::uint64_t>()>;
  // Has the signature of build_mesh(). Runs on the worker's thread.
  using MeshMaker = std::function<ComplexMesh(
      const BallGeometry& balls, const std::vector<Rgb8>& colours, const AlphaComplex& complex,
      const MeshOptions& options, const CancelToken& cancel)>;
  // The constructor needs a current OpenGL context. `wake` as in Worker.
  SceneController(std::function<void()> wake, FreeMemory free_memory,
                  MeshMaker make_mesh = &build_mesh);

  // New balls of the same molecule (another selection, model or radius) appear together with their
  // answer, or after show_without_answer(). The balls of another molecule appear as soon as
  // possible.
  void set_molecule(std::shared_ptr<const OpenedMolecule> opened);
  std::shared_ptr<const Molecule> molecule() const;  // the molecule set last
  void set_answer(std::shared_ptr<const Answer> answer);
  void show_without_answer();  // for balls that get no answer
  // Draws the differences from the reference, if there are any.
  void set_agreement(std::shared_ptr<const Agreement> agreement);
  // `line_scale` as in SceneStyle.
  void set_display(const DisplayControls& display, Theme theme, float line_scale = 1);
  // The picture follows when the caps that close the tetrahedra at the cut are ready.
  void set_clip(const Clip& clip);
  // Sets hidden atoms and colours chosen by the user. The picture follows when its simplices are
  // ready.
  void set_appearance(const Appearance& appearance);
  // The appearance on screen, for the balls of drawn(). Null: all balls visible, no chosen colours.
  const std::shared_ptr<const BallAppearance>& drawn_looks() const { return drawn_looks_; }
  // Sets the layers of panels. Layers of other balls than those of the complex on screen are left
  // out. A worker makes large layers, and the last drawn layers stay until these are ready.
  void set_layers(const Layers& layers);
  void pointer(const PointerEvent& event);
  // The line of sight through a pixel of the picture, Å in the file's coordinates. Nothing if there
  // is no picture.
  std::optional<Ray> ray(int x, int y) const;
  void reset_view();
  // Call before an action that starts from the present view. Without it the view of a new molecule
  // is fitted only with its first picture.
  void settle_view(const ViewportInfo& viewport);
  // The present view; nothing if no molecule is drawn.
  std::optional<CameraPlace> camera() const;
  void move_camera(const CameraPlace& camera);
  // The view before other atoms of the file were fitted into it, once; then nothing.
  std::optional<CameraPlace> take_left_view() { return std::exchange(left_view_, std::nullopt); }
  // Sets the view for the next picture with other balls. Nothing: the view then shows all of them.
  void set_camera_when_drawn(const std::optional<CameraPlace>& camera);

  // True while a newer answer or other balls are being computed, so that the picture is outdated.
  void set_pending(bool pending) { pending_ = pending; }

  // Takes finished meshes. True: from the next render() on another complex is shown. This render()
  // must not be skipped, or texts about the complex would run ahead of the picture.
  bool poll();
  // Call before the panels: begins a new picture, which a GPU draws while the panels are drawn. It
  // has no effect without changes, with software OpenGL, or when panels add to the picture. A later
  // render() is needed in any case, and draws again after a change.
  void begin_picture(ViewportInfo& viewport, bool interacting);
  void draw_meanwhile() { scene_.set_draws_meanwhile(true); }  // with software OpenGL too
  // Call when OpenGL has finished: the time of the picture is then known.
  void note_finished() { take_time(true); }
  // Call before the panels. Fills in the data about the picture that panels draw.
  void describe(ViewportInfo& viewport) const;
  // True while a mesh or a finer picture is on its way to the screen.
  bool busy() const {
    return mesh_worker_.activity().busy || layer_worker_.activity().busy ||
           beside_worker_.activity().busy || pick_worker_.activity().busy ||
           cap_worker_.activity().busy || paint_worker_.activity().busy;
  }
  bool wants_frame() const { return !covered_ && (dirty_ || refine_); }
  // Whether the next mesh will need the outer faces, which belong to one tetrahedron only.
  bool draws_outside() const { return mesh_options().outside(); }
  // Upper bound of the bytes of the picture on screen and of the one being made, without
  // differences.
  std::uint64_t held_bytes() const;
  // Seconds until a finer picture is due; a large number if none is.
  double seconds_to_refinement() const;

  // Draws after a change, or when a finer picture is due. `patient`: at the finest quality, however
  // long it takes (for saved pictures).
  void render(ViewportInfo& viewport, bool interacting, bool patient);
  // The item drawn under a pixel of the picture, in drawn() or drawn_answer(). `near`: distance in
  // pixels at which a line is still hit.
  std::optional<Hit> pick(int x, int y, double near) const;
  // The drawn atoms that are not balls of drawn().
  const BesideBody& beside_body() const { return beside_body_; }
  // Items drawn in the colour of the selection, even when balls are switched off. They are balls of
  // drawn() and places in beside_body(), both ascending.
  struct Selected {
    std::vector<BallIndex> balls;
    std::vector<std::size_t> beside;
    bool outlines = false;  // only rims, which hide less
    friend bool operator==(const Selected&, const Selected&) = default;
  };
  void set_selected(const Selected& selected);
  // Moves the view until these items fill it. Its direction stays.
  void zoom_to(const Selected& what);
  // Moves the view's centre of rotation to the middle of these items. Direction and scale stay.
  void centre_on(const Selected& what);
  // The molecule on screen, which may be older than the one set. Null before the first picture, and
  // while memory is made free for the next.
  const DrawnMolecule* drawn() const { return drawn_molecule_.get(); }
  // Areas and volumes of the complex on screen, if its colours depend on them; else null.
  std::shared_ptr<const MeasuredUnion> drawn_measures() const {
    return ball_painting_ ? ball_painting_->measures : nullptr;
  }
  // The answer whose complex is on screen, which may be older than the one set. Null: none.
  const std::shared_ptr<const Answer>& drawn_answer() const { return drawn_answer_; }
  // The handle for the picture on screen. `size` as in make_clip_handle().
  ClipHandle clip_handle(const Clip& clip, const std::array<double, 3>& pivot, double size) const;
  // Looks at the same point from this side, at the same distance. `towards_viewer` is a unit
  // vector.
  void look_from(const std::array<double, 3>& towards_viewer);
  // Turns the view until it is normal to this line (a unit vector), as side_across() does.
  void look_across(const RealPoint& line);
  void zoom(double factor);
  NamedView named_view(const std::string& name) const;
  void go_to(const NamedView& view);
  // The picture on screen, for PictureSaver. Throws std::runtime_error if nothing is drawn, or if
  // memory is too small for the picture.
  PictureToSave picture(const ScreenshotRequest& request) const;
  // The source of a recording's frames, which another thread calls later. Throws as picture() does.
  FrameSource frames(const RecordRequest& request) const;
  // Milliseconds for mesh, upload and drawing of the first picture of drawn_answer(). Empty before
  // this picture.
  const std::vector<StageTime>& picture_stages() const { return picture_stages_; }
  // The provenance of the picture on screen; empty if there is none. texts() gives it as texts for
  // saved pictures.
  ComplexHeader header() const;
  PictureTexts texts() const;
  // The caption (ui/caption.hpp) of the complex on screen; empty if there is none.
  std::vector<std::string> caption(CaptionParts parts) const;

 private:
  using Clock = std::chrono::steady_clock;

  static ComplexHeader header_of(const OpenedMolecule& opened, const EngineAnswer& answer);
  struct Sweep;  // the common data of its frames
  Picture sweep_picture(Sweep& sweep, double alpha, const RunContext& context) const;
  // Colours of balls, for the balls themselves or for the simplices between them.
  struct Painting {
    Paint paint;
    std::shared_ptr<const DrawnMolecule> molecule;
    std::shared_ptr<const Answer> answer;  // null if the paint does not depend on the complex
    std::shared_ptr<const MeasuredUnion> measures;  // if the paint shows exposed areas; else null
    PaintedBalls balls;
  };
  struct PaintTask {
    std::shared_ptr<const DrawnMolecule> molecule;
    std::shared_ptr<const Answer> answer;  // null if the paint does not depend on the complex
    Paint paint;
  };
  static std::shared_ptr<const Painting> make_painting(const PaintTask& task,
                                                       std::shared_ptr<const Painting> earlier,
                                                       const RunContext& context);
  // One colour for each ball.
  using BallColours = std::shared_ptr<const std::vector<Rgb8>>;
  // Hidden balls and chosen colours for each ball; null if there are none.
  static std::shared_ptr<const BallAppearance> make_looks(const DrawnMolecule& molecule,
                                                          const Appearance& appearance);
  static std::vector<float> radii_of(const DrawnMolecule& molecule, const BallStyle& style,
                                     const BallAppearance* looks);
  static const std::vector<bool>& hidden_of(const BallAppearance* looks);
  ComplexMesh make_mesh(const DrawnMolecule& molecule, const std::vector<Rgb8>& colours,
                        const AlphaComplex& complex, const MeshOptions& options,
                        const BallAppearance* looks, const CancelToken& cancel) const;
  std::optional<PaintKey> ball_key() const;
  std::optional<PaintKey> simplex_key() const;
  void describe_colours(ViewportInfo& viewport) const;
  std::string not_drawn() const;  // the missing parts of the picture; empty: none
  void submit_painting();
  void show_ball_colours();
  void update_radii();
  void submit();
  bool outdated() const;
  bool draws_nothing() const;  // because memory is too small
  struct BallLook {
    Paint paint;
    BallStyle style;
  };
  // A clip as drawn, with the caps of the tetrahedra that it cuts.
  struct DrawnCaps {
    Clip clip;
    std::shared_ptr<const CapMesh> mesh;  // null: none
    std::optional<PickLayer> pick;        // of mesh
  };
  struct Drawing {
    std::shared_ptr<const DrawnMolecule> molecule;
    std::shared_ptr<const Answer> answer;
    std::shared_ptr<BallData> balls;  // null: the balls are those on screen
    BallLook look;                    // colours of the balls, and their radii if the balls are new
    std::vector<float> radii;
    std::shared_ptr<const BallAppearance> looks;  // for balls and simplices; may be null
    std::shared_ptr<const Painting> ball_painting;
    // Null unless simplices have colours of balls.
    std::shared_ptr<const Painting> simplex_painting;
    std::shared_ptr<const ComplexMesh> mesh;
    std::shared_ptr<MeshData> mesh_data;
    MeshOptions options;  // of mesh
    double mesh_milliseconds = 0;
    BallColours simplex_colours;
    DrawnCaps caps;
    std::shared_ptr<CapData> cap_data;
    std::shared_ptr<const DifferenceMesh> differences;
    std::shared_ptr<DifferenceData> difference_data;
    std::string not_drawn;  // the missing parts and the reason; empty: none
  };
  // The inputs of caps: those of the mesh that they close.
  struct CapTask {
    std::shared_ptr<const DrawnMolecule> molecule;
    std::shared_ptr<const Answer> answer;
    std::shared_ptr<const ComplexMesh> mesh;
    MeshOptions options;
    BallColours colours;
    std::shared_ptr<const BallAppearance> looks;
  };
  static DrawnCaps make_caps(const CapTask& task, const Clip& clip, const CancelToken& cancel);
  void submit_caps();
  void show_caps(DrawnCaps caps, std::shared_ptr<CapData> data);
  Cut cut_of(const Clip& clip) const;
  struct DrawnLayers {
    Layers layers;
    std::shared_ptr<const LayerMesh> mesh;  // null: none
    std::string not_drawn;                  // why layers are missing; empty: none
    PickLayers picks;                       // of mesh
    std::optional<PickLayer> atoms;         // of mesh, picked before all others
  };
  // The inputs of a drawing, copied for the worker's job.
  struct Wanted {
    std::shared_ptr<const DrawnMolecule> drawn;
    std::shared_ptr<const OpenedMolecule> opened;
    std::shared_ptr<const Answer> answer;
    std::shared_ptr<const Agreement> agreement;
    BallLook look;
    Paint complex_paint;
    MeshOptions mesh;
    Clip clip;
    Appearance appearance;
    std::shared_ptr<const Painting> ball_painting, simplex_painting;  // on screen; may be null
  };
  std::optional<std::uint64_t> free_memory_for(const DrawingTask& task);
  Worker::Delivery make_drawing(const Wanted& wanted, const RunContext& context);
  void make_room();
  void take(Drawing drawing);
  void show(Drawing drawing);
  void make_balls(Drawing& drawing) const;
  void show_balls(Drawing& drawing);
  void show_nothing(const std::string& why);
  void show_no_memory();
  void submit_layers(const Layers& layers);
  void submit_beside_body();
  void submit_picks();
  void show_layers(DrawnLayers layers, std::shared_ptr<LayerData> data);
  void forget_layers();                            // the scene drops its layers
  BallLook ball_look(const Answer* answer) const;  // as the controls set it
  SceneStyle scene_style() const;
  SceneStyle drawn_style() const;  // of the picture on screen, perhaps without balls
  void draw_selected();
  // The items as balls, with the radii of the geometry and not as drawn.
  BallGeometry drawn_places(const Selected& what) const;
  ViewProblem find_view_problem() const;
  void note_times(RenderQuality quality, double picture_milliseconds);
  void take_time(bool wait);
  void choose_stand_in(bool at_rest);
  void check_view(ViewportInfo& viewport, bool interacting);
  void draw(RenderQuality quality, bool patient);
  RenderQuality quality_for_change(bool follows_computation) const;
  bool unfinished() const;  // the picture on screen could get more samples
  MeshOptions mesh_options() const;

  const FreeMemory free_memory_;
  // Free memory at the last reading, bytes. Only the mesh worker uses these two.
  std::optional<std::uint64_t> free_read_;
  Clock::time_point free_read_at_;
  const MeshMaker make_mesh_;
  Scene scene_;
  QualityChooser quality_;
  // The wanted picture.
  std::shared_ptr<const OpenedMolecule> opened_;
  std::shared_ptr<const PreparedBalls> prepared_;  // of opened_
  std::shared_ptr<const Answer> answer_;
  std::shared_ptr<const Agreement> agreement_;  // for answer_; set only if something differs
  bool waiting_ = false;                        // no new picture is drawn before the answer
  // The picture on screen.
  std::shared_ptr<const DrawnMolecule> drawn_molecule_;
  std::shared_ptr<const Answer> drawn_answer_;
  std::vector<std::pair<std::string, std::uint64_t>> wanted_layers_;  // ids and keys
  DrawnLayers drawn_layers_;
  BesideBody beside_body_;
  std::optional<PickLayer> beside_body_pick_;
  std::shared_ptr<const OpenedMolecule> viewed_;  // the molecule for which the camera was set
  std::string not_drawn_;
  std::optional<CameraPlace> left_view_;
  std::optional<CameraPlace> wanted_camera_;  // for the next picture with other balls
  bool pending_ = false;
  std::optional<Clock::time_point> outdated_since_;
  std::vector<float> radii_;  // Å, as drawn
  double pick_margin_ = 0;    // BallPicker::margin() for radii_
  // Stages of the drawn complex, complete after its first picture.
  std::vector<StageTime> picture_stages_;
  BallStandIn balls_;
  bool stand_in_ = false;  // the last picture has no balls
  PickLayers picks_;       // of drawn_mesh_; empty until they are made
  Selected selected_;
  std::shared_ptr<const ComplexMesh> drawn_mesh_;
  MeshOptions drawn_options_;          // of drawn_mesh_
  BallColours drawn_simplex_colours_;  // of drawn_mesh_
  DrawnCaps drawn_caps_;
  std::shared_ptr<const DifferenceMesh> drawn_differences_;
  std::shared_ptr<const Painting> ball_painting_, simplex_painting_;  // null: none
  std::shared_ptr<const BallAppearance> drawn_looks_;
  DisplayControls display_;
  Clip clip_;
  Appearance appearance_;
  Theme theme_ = Theme::dark;
  float line_scale_ = 1;
  MeshOptions requested_mesh_;
  bool dirty_ = true;
  bool covered_ = false;  // as in ViewportInfo: a covered picture is drawn again when it is visible
  bool view_checked_ = false;  // since the last picture
  ViewProblem view_problem_ = ViewProblem::none;
  bool refine_ = false;  // the picture on screen could be finer
  RenderQuality drawn_ = RenderQuality::draft;
  bool new_picture_ = false;  // since the last picture while the user moved something
  Clock::time_point last_change_ = Clock::now();
  int width_ = 0, height_ = 0;
  std::atomic<std::uint64_t> pending_bytes_ = 0;  // of the drawing that the worker makes
  // Last members, so that their threads are joined before their jobs' data is destroyed.
  Worker mesh_worker_, layer_worker_, beside_worker_, pick_worker_, cap_worker_, paint_worker_;
};

}  // namespace alphascope
