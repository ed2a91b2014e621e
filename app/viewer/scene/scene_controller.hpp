// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the scene follow the session's answers and the controls. Workers make geometry and meshes,
// and the last picture stays until these are ready. Pictures are drawn only after a change. A part
// that does not fit into memory is left out with a message.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "app/session/session.hpp"
#include "app/viewer/saving/picture_saver.hpp"
#include "app/viewer/scene/drawing_maker.hpp"
#include "app/viewer/scene/scene_controls.hpp"
#include "app/viewer/scene/shown_picture.hpp"
#include "ui/layer.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/scene/picture/record_frames.hpp"

namespace alphascope {

class SceneController {
 public:
  // The constructor needs a current OpenGL context. `wake` as in Worker. `make_mesh` runs on a
  // worker's thread.
  SceneController(std::function<void()> wake, FreeMemory free_memory,
                  MeshMaker make_mesh = &build_mesh);

  // New balls of the same molecule (another selection, model or radius) appear together with their
  // answer, or after show_without_answer(). The balls of another molecule appear as soon as
  // possible.
  void set_molecule(std::shared_ptr<const OpenedMolecule> opened);
  void close();                                      // shows nothing, as before the first molecule
  std::shared_ptr<const Molecule> molecule() const;  // the molecule set last
  void set_answer(std::shared_ptr<const Answer> answer);
  void show_without_answer();  // for balls that get no answer
  // Draws the differences from the reference, if there are any.
  void set_agreement(std::shared_ptr<const Agreement> agreement);
  // `line_scale` as in SceneStyle.
  void set_display(const DisplaySettings& display, Theme theme, float line_scale = 1);
  // The picture follows when the caps that close the tetrahedra at the cut are ready.
  void set_clip(const Clip& clip);
  // Sets hidden atoms and colours chosen by the user. The picture follows when its simplices are
  // ready.
  void set_appearance(const Appearance& appearance);
  // Objects follow when a worker has made them; those of the last list stay until then.
  void set_objects(const DrawnObjects& objects);
  // True while a newer answer or other balls are being computed, so that the picture is outdated.
  void set_pending(bool pending) { pending_ = pending; }
  void pointer(const PointerEvent& event);

  // The picture on screen, which may be older than what is set.
  ShownPicture& shown() { return shown_; }
  const ShownPicture& shown() const { return shown_; }
  const DrawnPicture& drawn() const { return shown_.drawn(); }
  Cameras& cameras() { return shown_.cameras(); }
  const Cameras& cameras() const { return shown_.cameras(); }

  // Takes finished meshes. If it returns true, the next render() shows another complex. That
  // render() must not be skipped, because texts already describe the new complex.
  bool poll();
  // Call before the panels: begins a new picture, which a GPU draws while the panels are drawn. It
  // has no effect without changes, or when panels add to the picture. With software OpenGL it draws
  // a first picture only, which the panels of the same frame then show. A later render() is needed
  // in any case, and draws again after a change.
  void begin_picture(ViewportInfo& viewport, bool interacting);
  // Draws in the background with software OpenGL too.
  void render_asynchronously() { shown_.canvas().drawing().set_renders_asynchronously(true); }
  // Call when OpenGL has finished: the time of the picture is then known.
  void note_finished() { shown_.pacing().take_time(true); }
  // Call before the panels. Fills in the data about the picture that panels draw.
  void describe(ViewportInfo& viewport) const;
  // True while a mesh or a finer picture is on its way to the screen.
  bool busy() const { return maker_.busy() || shown_.busy(); }
  bool wants_frame() const { return !covered_ && shown_.pacing().wants_frame(); }
  // Whether the next mesh will need the outer faces, which belong to one tetrahedron only.
  bool draws_outer_faces() const;
  // Upper bound of the bytes of the picture on screen and of the one being made, without
  // differences.
  std::uint64_t held_bytes() const { return (busy() ? maker_.bytes() : 0) + shown_.bytes(); }
  // Seconds until a finer picture is due; a large number if none is.
  double seconds_to_refinement() const;

  // Draws after a change, or when a finer picture is due. `patient`: at the finest quality, however
  // long it takes (for saved pictures).
  void render(ViewportInfo& viewport, bool interacting, bool patient);

  // The picture on screen, for PictureSaver. Throws std::runtime_error if nothing is drawn, or if
  // memory is too small for the picture.
  PictureToSave picture(const ScreenshotRequest& request) const;
  // The source of a recording's frames, which another thread calls later. Throws as picture() does.
  FrameSource frames(const RecordRequest& request) const;
  // The provenance of the picture on screen, as texts of saved pictures; empty if there is none.
  PictureTexts texts() const { return drawn().texts(controls_.display.balls); }

 private:
  void submit();
  void make_room();
  void take(Drawing drawing);
  void show_nothing(const std::string& why);
  void show_no_memory();
  bool outdated() const;  // the picture is older than the wanted molecule or its answer
  void check_view(ViewportInfo& viewport, bool interacting);
  float line_scale_of(int height) const;

  const FreeMemory free_memory_;
  const MeshMaker make_mesh_;
  SceneControls controls_;
  // The wanted picture.
  std::shared_ptr<const OpenedMolecule> opened_;
  std::shared_ptr<const Answer> answer_;
  std::shared_ptr<const Agreement> agreement_;  // for answer_; set only if something differs
  bool waiting_ = false;                        // no new picture is drawn before the answer
  MeshOptions requested_mesh_;
  bool pending_ = false;
  bool covered_ = false;  // as in ViewportInfo: a covered picture is drawn again when it is visible
  bool view_checked_ = false;  // since the last picture
  ViewProblem view_problem_ = ViewProblem::none;
  ShownPicture shown_;
  DrawingMaker maker_;  // after what its deliveries use
};

}  // namespace alphascope
