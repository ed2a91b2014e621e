// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the camera in the whole window: going back and forward, glides in real time, double clicks,
// and clips saved under names.
#include "tests/ui/acting_host.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/widgets/keys.hpp"

namespace alphascope::testing {
namespace {

class CameraWindow : public ViewerTest {
 protected:
  CameraWindow() { open_crambin(); }
  ViewState& state() { return viewer_->state(); }
  NamedView view() {
    run("view.save_camera now\nframes 2\n");
    return state().settings.views.back();
  }
};

TEST_F(CameraWindow, GoesBackToEarlierViewsAndForwardAgain) {
  EXPECT_FALSE(state().viewport.has_earlier_view);
  const NamedView first = view();
  run("view.from x\nframes 2\n");
  const NamedView second = view();
  // A drag is one step, however many frames it takes.
  run("move view 0.5\ndown\nmove view 0.55\nmove view 0.6\nmove view 0.7\nup\nframes 4\n");
  const NamedView third = view();
  ASSERT_NE(third.position, second.position);
  run("key v\nframes 2\n");
  EXPECT_EQ(view().position, second.position);
  run("key v\nframes 2\n");
  EXPECT_EQ(view().position, first.position);
  EXPECT_FALSE(state().viewport.has_earlier_view);
  run("key shift+v\nframes 2\nkey shift+v\nframes 2\n");
  EXPECT_EQ(view().position, third.position);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(view().up[k], third.up[k], 1e-9);
  EXPECT_FALSE(state().viewport.has_later_view);
  run("key v\nframes 2\nview.from z\nframes 2\n");
  EXPECT_FALSE(state().viewport.has_later_view) << "another movement replaces the later views";
  run("open " + crambin().string() + "\nwait-idle\n");
  EXPECT_FALSE(state().viewport.has_earlier_view) << "another file begins anew";
}

TEST_F(CameraWindow, ADoubleClickSetsTheCentreOfRotation) {
  run("view.tetrahedra off\nview.zoom 2\nwait-idle\n");
  std::string place;
  for (int i = 0; i < 100 && !state().hovered; ++i) {
    place = "view 0." + std::to_string(3 + i % 5) + " 0." + std::to_string(25 + i / 5);
    run("move " + place + "\nwait-idle\nframes 2\n");
  }
  ASSERT_TRUE(state().hovered);
  const NamedView before = view();
  run("double-click " + place + "\nframes 4\n");
  const NamedView after = view();
  EXPECT_NE(after.focal_point, before.focal_point);
  ASSERT_EQ(state().settings.selection.items.size(), 1u);
  const AtomRef atom = std::get<AtomRef>(state().settings.selection.items.items().front());
  const Molecule& molecule = *viewer_->session().state().molecule;
  const auto& centre = molecule.atoms[atom.atom].position;
  EXPECT_NEAR(after.focal_point[0], molecule.lattice.angstrom(centre.x), 1e-3);
  EXPECT_NEAR(after.focal_point[1], molecule.lattice.angstrom(centre.y), 1e-3);
  EXPECT_NEAR(after.focal_point[2], molecule.lattice.angstrom(centre.z), 1e-3);
  run("key v\nframes 2\n");
  EXPECT_EQ(view().focal_point, before.focal_point);
}

TEST_F(CameraWindow, ClipsAreSavedUnderNames) {
  EXPECT_THROW(run("view.save_clip nothing\n"), std::exception);
  run("view.clip x=12\nview.save_clip entrance\nview.clip z=3:8\nview.save_clip middle\n"
      "view.clip off\nframes 2\n");
  ASSERT_EQ(state().settings.clips.size(), 2u);
  EXPECT_FALSE(state().settings.clip.on());
  run("view.saved_clip entrance\nframes 2\n");
  EXPECT_EQ(clip_text(state().settings.clip), "x=12");
  run("view.clip y=1\nview.save_clip entrance\nframes 2\n");
  EXPECT_EQ(state().settings.clips.size(), 2u) << "an older one of that name is replaced";
  run("view.rename_clip entrance door\nframes 2\n");
  EXPECT_EQ(state().settings.clips.front().name, "door");
  EXPECT_THROW(run("view.rename_clip door middle\n"), std::exception);
  run("view.forget_clip middle\nframes 2\n");
  ASSERT_EQ(state().settings.clips.size(), 1u);
  run("edit.undo\nframes 2\n");
  EXPECT_EQ(state().settings.clips.size(), 2u);
  const std::string file = (folder_ / "clips.json").string();
  run("file.save_session " + file + "\nwait-idle\nview.forget_clip door\nfile.open_session " +
      file + "\nwait-idle\n");
  ASSERT_EQ(state().settings.clips.size(), 2u);
  EXPECT_EQ(state().settings.clips[0].name, "door");
  EXPECT_EQ(clip_text(state().settings.clips[1].clip), "z=3:8");
}

TEST_F(CameraWindow, ThePanelListsSavedClips) {
  run("view.clip x=12\nview.save_clip entrance\nview.clip z=3:8\nview.section clip\nframes 3\n");
  run("click clip.saved\nframes 3\nclick clip.saved.entrance\nframes 3\n");
  EXPECT_EQ(clip_text(state().settings.clip), "x=12");
  run("click clip.save\nframes 3\n");
  EXPECT_TRUE(state().palette.show);
  EXPECT_EQ(state().palette.asking, "view.save_clip");
}

// A window in which a user acts in real time.
class Gliding : public ::testing::Test {
 protected:
  Gliding() : host_({600, 440, 1, "test"}) {
    ViewerOptions options;
    options.compare = false;
    options.preset = "fast";
    options.samples = 1;
    options.file = crambin();
    viewer_ = std::make_unique<Viewer>(host_, options);
    settle();
  }
  void settle() {
    do {
      host_.play({}, 0.3);
      viewer_->run();
    } while (viewer_->busy() || !viewer_->state().result);
  }
  // The lines of sight in the frames after this key.
  std::vector<RealPoint> sights(std::vector<ActingHost::Act> acts, double seconds) {
    std::vector<RealPoint> seen;
    host_.after_frame = [&] { seen.push_back(viewer_->state().viewport.into_view); };
    host_.play(std::move(acts), seconds);
    viewer_->run();
    host_.after_frame = nullptr;
    return seen;
  }
  // Directions other than the first and the last one.
  static std::size_t between(const std::vector<RealPoint>& seen) {
    std::size_t count = 0;
    for (const RealPoint& sight : seen) {
      count += length(sight - seen.front()) > 1e-6 && length(sight - seen.back()) > 1e-6;
    }
    return count;
  }
  ActingHost::Act tap(double at, int key) {
    return {at, [this, key] { host_.tap(key); }};
  }

  ActingHost host_;
  std::unique_ptr<Viewer> viewer_;
};

TEST_F(Gliding, CommandsMoveTheViewInSmallSteps) {
  const auto seen = sights({tap(0.1, '1')}, 1.5);
  EXPECT_GE(between(seen), 3u);
  EXPECT_NEAR(seen.back().x, -1, 1e-9) << "from +x";
  settle();
  host_.play({}, 1);
  viewer_->run();
  EXPECT_LT(host_.frames, 20) << "nothing moves any more";
}

TEST_F(Gliding, OffTheViewJumps) {
  viewer_->state().window.glide = false;
  const auto seen = sights({tap(0.1, '1')}, 1);
  EXPECT_EQ(between(seen), 0u);
  EXPECT_NEAR(seen.back().x, -1, 1e-9);
}

TEST_F(Gliding, AKeyEndsAGlideAtItsEnd) {
  bool ended = false;
  const auto seen = sights({tap(0.1, '1'),
                            {0.2,
                             [&] {
                               host_.tap(key::kT);
                               ended = true;
                             }}},
                           1);
  EXPECT_TRUE(ended);
  EXPECT_LT(between(seen), 8u);
  EXPECT_NEAR(seen.back().x, -1, 1e-9);
}

}  // namespace
}  // namespace alphascope::testing
