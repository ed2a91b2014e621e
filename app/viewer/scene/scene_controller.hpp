// Keeps the scene in step with the session's answers and the display controls. Geometry and meshes
// are filled on a worker; the last picture stays until they are there, and pictures are drawn only
// when something changed. What does not fit into memory is not drawn, and is told.
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

// A molecule's balls, and what was made of them for drawing.
struct DrawnMolecule {
  std::shared_ptr<const OpenedMolecule> opened;  // of which the next two are
  std::shared_ptr<const Molecule> molecule;
  std::shared_ptr<const PreparedBalls> prepared;
  std::shared_ptr<const BallGeometry> geometry;
  std::shared_ptr<const BallPicker> picker;  // of geometry
};

class SceneController {
 public:
  // Bytes that are free for drawing, if that is known; asked from any thread.
  using FreeMemory = std::function<std::optional<std::uint64_t>()>;
  // build_mesh(); on the worker's thread.
  using MeshMaker = std::function<ComplexMesh(
      const BallGeometry& balls, const std::vector<Rgb8>& colours, const AlphaComplex& complex,
      const MeshOptions& options, const CancelToken& cancel)>;
  // An OpenGL context must be current; `wake` as in Worker.
  SceneController(std::function<void()> wake, FreeMemory free_memory,
                  MeshMaker make_mesh = &build_mesh);

  // Other balls of the same molecule (another selection, model or radius) appear with their answer,
  // or with show_without_answer(); those of another molecule as soon as possible.
  void set_molecule(std::shared_ptr<const OpenedMolecule> opened);
  std::shared_ptr<const Molecule> molecule() const;  // last set
  void set_answer(std::shared_ptr<const Answer> answer);
  void show_without_answer();  // there will be none
  // Draws what differs from the reference, if anything does.
  void set_agreement(std::shared_ptr<const Agreement> agreement);
  // `line_scale` as in SceneStyle.
  void set_display(const DisplayControls& display, Theme theme, float line_scale = 1);
  // The picture follows when what closes the tetrahedra at the cut is made.
  void set_clip(const Clip& clip);
  // Hidden atoms and own colours. The picture follows when its simplices are made.
  void set_appearance(const Appearance& appearance);
  // Of drawn(): what of that is on screen; null: nothing.
  const std::shared_ptr<const BallAppearance>& drawn_looks() const { return drawn_looks_; }
  // What panels want drawn; layers of other balls than the complex on screen are left out. Large
  // ones are made on a worker's thread, and what was drawn before stays until they are there.
  void set_layers(const Layers& layers);
  void pointer(const PointerEvent& event);
  // The line of sight through a pixel of the picture, Å in the file's coordinates; none without a
  // picture.
  std::optional<Ray> ray(int x, int y) const;
  void reset_view();
  // To be called before what starts from the present view: that of a molecule that has just come
  // fits it with its first picture only.
  void settle_view(const ViewportInfo& viewport);
  // Where the view stands; none where there is none.
  std::optional<CameraPlace> camera() const;
  void move_camera(const CameraPlace& camera);
  // Where the view stood before other atoms of a file were fitted into it, once; else none.
  std::optional<CameraPlace> take_left_view() { return std::exchange(left_view_, std::nullopt); }
  // Instead of showing all of the molecule that is on its way; none: shows all.
  void set_camera_when_drawn(const std::optional<CameraPlace>& camera);

  // A newer answer, or other balls, are being computed: the picture will be another.
  void set_pending(bool pending) { pending_ = pending; }

  // Takes finished meshes. True: another complex is shown from the next render() on, which must not
  // be left out, or what is said of the complex would be ahead of the picture.
  bool poll();
  // Before the panels: a new picture is begun now, which a GPU draws while the panels are drawn.
  // Nothing where there is none, where OpenGL draws in software, and where panels add to the
  // picture. render() comes nevertheless, and draws again if anything has changed.
  void begin_picture(ViewportInfo& viewport, bool interacting);
  void draw_meanwhile() { scene_.set_draws_meanwhile(true); }  // also in software
  // Once OpenGL has finished all: how long the picture took is known.
  void note_finished() { take_time(true); }
  // What belongs to the picture and is drawn by the panels; before them.
  void describe(ViewportInfo& viewport) const;
  // Something is still on its way to the screen: a mesh, or a finer picture.
  bool busy() const {
    return mesh_worker_.activity().busy || layer_worker_.activity().busy ||
           beside_worker_.activity().busy || pick_worker_.activity().busy ||
           cap_worker_.activity().busy || paint_worker_.activity().busy;
  }
  bool wants_frame() const { return !covered_ && (dirty_ || refine_); }
  // Whether a mesh of the next complex will need the faces that only one tetrahedron has.
  bool draws_outside() const { return mesh_options().outside(); }
  // Of what is drawn and of what is being made, at most; without differences.
  std::uint64_t held_bytes() const;
  // Seconds until a finer picture is due; a large number when none is.
  double seconds_to_refinement() const;

  // Draws when something changed or a finer picture is due. `patient`: as fine as possible,
  // whatever it takes (for pictures).
  void render(ViewportInfo& viewport, bool interacting, bool patient);
  // What is drawn under a pixel of the picture: of drawn() and drawn_answer(). `near`: pixels
  // beside a line that still are on it.
  std::optional<Hit> pick(int x, int y, double near) const;
  // Atoms that are drawn and are no balls of drawn().
  const BesideBody& beside_body() const { return beside_body_; }
  // What is drawn in the colour of what is selected, balls on or off: balls of drawn() and places
  // of beside_body(), both ascending.
  struct Selected {
    std::vector<BallIndex> balls;
    std::vector<std::size_t> beside;
    bool outlines = false;  // only rims, which hide little
    friend bool operator==(const Selected&, const Selected&) = default;
  };
  void set_selected(const Selected& selected);
  // So that these fill the view, as they are looked at now.
  void zoom_to(const Selected& what);
  // So that their middle is that of the view, which turns about it; direction and size stay.
  void centre_on(const Selected& what);
  // What is on screen, which may still be older than what was set; null before the first, and
  // while it makes room for the next.
  const DrawnMolecule* drawn() const { return drawn_molecule_.get(); }
  // Areas and volumes of the complex on screen, where its colours are made of them; else null.
  std::shared_ptr<const MeasuredUnion> drawn_measures() const {
    return ball_painting_ ? ball_painting_->measures : nullptr;
  }
  // Whose complex is on screen, and may still be older than what was set; null: none.
  const std::shared_ptr<const Answer>& drawn_answer() const { return drawn_answer_; }
  // Of the picture on screen; `size` as of make_clip_handle().
  ClipHandle clip_handle(const Clip& clip, const std::array<double, 3>& pivot, double size) const;
  // At the same point from as far, from this side; `towards_viewer` has length 1.
  void look_from(const std::array<double, 3>& towards_viewer);
  // Turned by the least angle until it is normal to this line (unit vector).
  void look_across(const RealPoint& line);
  void zoom(double factor);
  NamedView named_view(const std::string& name) const;
  void go_to(const NamedView& view);
  // What is on screen, for PictureSaver. Throws std::runtime_error when nothing is, or when there
  // is no memory for the picture.
  PictureToSave picture(const ScreenshotRequest& request) const;
  // The same for a recording: on another thread, later. Throws the same.
  FrameSource frames(const RecordRequest& request) const;
  // Milliseconds of the first picture of drawn_answer(): mesh, upload, draw; empty before it is
  // there.
  const std::vector<StageTime>& picture_stages() const { return picture_stages_; }
  // Where what is on screen comes from; empty when nothing is. texts(): to go into pictures of it.
  ComplexHeader header() const;
  PictureTexts texts() const;
  // ui/caption.hpp, of the complex on screen; empty without one.
  std::vector<std::string> caption(CaptionParts parts) const;

 private:
  using Clock = std::chrono::steady_clock;

  static ComplexHeader header_of(const OpenedMolecule& opened, const EngineAnswer& answer);
  struct Sweep;  // what the frames of one have in common
  Picture sweep_picture(Sweep& sweep, double alpha, const RunContext& context) const;
  // Colours of balls: for themselves, or for the simplices between them.
  struct Painting {
    Paint paint;
    std::shared_ptr<const DrawnMolecule> molecule;
    std::shared_ptr<const Answer> answer;           // null where the paint asks for no complex
    std::shared_ptr<const MeasuredUnion> measures;  // of exposed areas; else null
    PaintedBalls balls;
  };
  struct PaintTask {
    std::shared_ptr<const DrawnMolecule> molecule;
    std::shared_ptr<const Answer> answer;  // null: none
    Paint paint;
  };
  static std::shared_ptr<const Painting> make_painting(const PaintTask& task,
                                                       std::shared_ptr<const Painting> earlier,
                                                       const RunContext& context);
  // One a ball.
  using BallColours = std::shared_ptr<const std::vector<Rgb8>>;
  // The same with hidden balls and own colours; `looks` may be null.
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
  std::string not_drawn() const;  // what the picture lacks; empty: nothing
  void submit_painting();
  void show_ball_colours();
  void update_radii();
  void submit();
  bool outdated() const;
  bool draws_nothing() const;  // for want of memory
  struct BallLook {
    Paint paint;
    BallStyle style;
  };
  // What is drawn of a clip, and the tetrahedra that it cuts.
  struct DrawnCaps {
    Clip clip;
    std::shared_ptr<const CapMesh> mesh;  // null: none
    std::optional<PickLayer> pick;        // of mesh
  };
  struct Drawing {
    std::shared_ptr<const DrawnMolecule> molecule;
    std::shared_ptr<const Answer> answer;
    std::shared_ptr<BallData> balls;  // of another molecule than on screen; null: the same
    BallLook look;                    // of the balls, and their radii where they are new
    std::vector<float> radii;
    std::shared_ptr<const BallAppearance> looks;  // of all that is drawn; may be null
    std::shared_ptr<const Painting> ball_painting;
    std::shared_ptr<const Painting> simplex_painting;  // null unless they have colours of balls
    std::shared_ptr<const ComplexMesh> mesh;
    std::shared_ptr<MeshData> mesh_data;
    MeshOptions options;  // of mesh
    double mesh_milliseconds = 0;
    BallColours simplex_colours;
    DrawnCaps caps;
    std::shared_ptr<CapData> cap_data;
    std::shared_ptr<const DifferenceMesh> differences;
    std::shared_ptr<DifferenceData> difference_data;
    std::string not_drawn;  // what is missing and why; empty: nothing
  };
  // What caps are made of: as the mesh that they close.
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
    std::string not_drawn;                  // why; empty: all is
    PickLayers picks;                       // of mesh
    std::optional<PickLayer> atoms;         // of mesh, before all else
  };
  // What a job of the worker needs.
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
  void forget_layers();                            // the scene has
  BallLook ball_look(const Answer* answer) const;  // as the controls have it
  SceneStyle scene_style() const;
  SceneStyle drawn_style() const;  // of what is on screen, perhaps without balls
  void draw_selected();
  // With their own radii.
  BallGeometry drawn_places(const Selected& what) const;
  ViewProblem find_view_problem() const;
  void note_times(RenderQuality quality, double picture_milliseconds);
  void take_time(bool wait);
  void choose_stand_in(bool at_rest);
  void check_view(ViewportInfo& viewport, bool interacting);
  void draw(RenderQuality quality, bool patient);
  RenderQuality quality_for_change(bool follows_computation) const;
  bool unfinished() const;  // the picture on screen could have more samples
  MeshOptions mesh_options() const;

  const FreeMemory free_memory_;
  std::optional<std::uint64_t> free_read_;  // the mesh worker's, as the next
  Clock::time_point free_read_at_;
  const MeshMaker make_mesh_;
  Scene scene_;
  QualityChooser quality_;
  // Wanted on screen.
  std::shared_ptr<const OpenedMolecule> opened_;
  std::shared_ptr<const PreparedBalls> prepared_;  // of opened_
  std::shared_ptr<const Answer> answer_;
  std::shared_ptr<const Agreement> agreement_;  // of answer_, and only when something differs
  bool waiting_ = false;                        // for the answer: until then nothing new is drawn
  // On screen.
  std::shared_ptr<const DrawnMolecule> drawn_molecule_;
  std::shared_ptr<const Answer> drawn_answer_;
  std::vector<std::pair<std::string, std::uint64_t>> wanted_layers_;  // ids and keys
  DrawnLayers drawn_layers_;
  BesideBody beside_body_;
  std::optional<PickLayer> beside_body_pick_;
  std::shared_ptr<const OpenedMolecule> viewed_;  // that the camera was set for
  std::string not_drawn_;
  std::optional<CameraPlace> left_view_;
  std::optional<CameraPlace> wanted_camera_;  // of the next molecule
  bool pending_ = false;
  std::optional<Clock::time_point> outdated_since_;
  std::vector<float> radii_;  // Å, as drawn
  double pick_margin_ = 0;    // BallPicker::margin() of them
  // Of what is drawn; not all there before its first picture.
  std::vector<StageTime> picture_stages_;
  BallStandIn balls_;
  bool stand_in_ = false;  // the last picture is without balls
  PickLayers picks_;       // of drawn_mesh_, or none yet
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
  bool covered_ = false;       // as ViewportInfo says: what changed is drawn when it is seen again
  bool view_checked_ = false;  // since the last picture
  ViewProblem view_problem_ = ViewProblem::none;
  bool refine_ = false;  // the picture on screen could be finer
  RenderQuality drawn_ = RenderQuality::draft;
  bool new_picture_ = false;  // since the last one that followed a hand
  Clock::time_point last_change_ = Clock::now();
  int width_ = 0, height_ = 0;
  std::atomic<std::uint64_t> pending_bytes_ = 0;  // of what the worker makes
  // Last: joined before what their jobs use goes.
  Worker mesh_worker_, layer_worker_, beside_worker_, pick_worker_, cap_worker_, paint_worker_;
};

}  // namespace alphascope
