// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the sandbox in the whole window: presets, and changes by command, typing and mouse. Undo
// and sessions restore them, and every answer is CGAL's.
#include "tests/ui/viewer_fixture.hpp"
#include "ui/panels/sandbox/sandbox_edit.hpp"

namespace alphascope::testing {
namespace {

class SandboxTest : public ViewerTest {
 protected:
  void open_preset(const std::string& id) {
    run("sandbox.new " + id + "\nframes 2\nwait-idle\nframes 2\nwait-idle\n");
  }
  ViewState& state() { return viewer_->state(); }
  const Sandbox& sandbox() { return *state().settings.open.sandbox; }
  const AlphaComplex& complex() { return state().result->complex; }
  void expect_exact() {
    EXPECT_EQ(complex().hash, expected(state().settings.request.alpha_angstrom2).hash);
    EXPECT_EQ(state().result->balls->size(), sandbox().balls.size());
  }
  std::size_t drawn(FlatKind kind) {
    std::size_t count = 0;
    for (const FlatShape& shape : state().sandbox.shapes) count += shape.kind == kind;
    return count;
  }
  // Returns where the view shows this point of the drawing, such as "0.25 0.5" for scripts.
  std::string in_view(const FlatPoint& place) {
    const SandboxState& m = state().sandbox;
    const ViewportInfo& v = state().viewport;
    const double x = 0.5 + (place[0] - m.middle[0]) * m.pixels_per_angstrom / v.width;
    const double y = 0.5 - (place[1] - m.middle[1]) * m.pixels_per_angstrom / v.height;
    return std::to_string(x) + " " + std::to_string(y);
  }
  void drag(const FlatPoint& from, const FlatPoint& to) {
    const std::string end = in_view(to);
    run("move view " + in_view(from) + "\nframes 2\ndown\nframes 2\nmove view " + end +
        "\nframes 2\nup\nframes 2\nwait-idle\nframes 2\n");
  }
};

TEST_F(SandboxTest, APresetIsOpenedToBeChanged) {
  open_preset("square");
  ASSERT_TRUE(state().settings.open.sandbox);
  EXPECT_TRUE(sandbox().flat);
  EXPECT_EQ(sandbox().balls.size(), 4u);
  run("alpha.set 8\nwait-idle\nframes 2\n");
  expect_exact();
  EXPECT_EQ(complex().triangles.size(), 2u);
  EXPECT_EQ(drawn(FlatKind::triangle), 2u);
  EXPECT_EQ(drawn(FlatKind::edge_inside), 1u);
  EXPECT_TRUE(viewer_->widgets().contains("sandbox.counts"));
  EXPECT_FALSE(viewer_->widgets().contains("view.legend"));
}

TEST_F(SandboxTest, MovesOfBallsAreTimed) {
  open_preset("square");
  const Sandbox before = sandbox();
  const std::string line = run("ball-moves 3\n");
  EXPECT_TRUE(line.starts_with("moves of 4 balls: ")) << line;
  for (std::size_t ball = 0; ball < 4; ++ball) {
    EXPECT_EQ(sandbox().balls[ball] == before.balls[ball], ball == 3) << "each of three has moved";
  }
  expect_exact();
}

TEST_F(SandboxTest, ChangesAreComputedAndUndone) {
  open_preset("square");
  run("alpha.set 8\nwait-idle\n");
  const std::uint64_t before = complex().hash;
  run("sandbox.add 2 2 0 1\nwait-idle\nframes 2\n");
  ASSERT_EQ(sandbox().balls.size(), 5u);
  expect_exact();
  EXPECT_EQ(complex().triangles.size(), 4u);
  run("sandbox.move 5 9 2 0\nsandbox.resize 5 2.5\nwait-idle\nframes 2\n");
  EXPECT_EQ(sandbox().balls[4], (SandboxBall{{9000, 2000, 0}, 2500}));
  expect_exact();
  run("sandbox.remove 5\nwait-idle\nframes 2\n");
  EXPECT_EQ(complex().hash, before);
  run("edit.undo\nwait-idle\nframes 2\n");
  EXPECT_EQ(sandbox().balls.size(), 5u);
  expect_exact();
}

TEST_F(SandboxTest, RefusesWhatCannotBe) {
  open_preset("square");
  const auto refused = [&](const std::string& line) {
    return viewer_->commands().run_line(line).state == Outcome::State::refused;
  };
  EXPECT_TRUE(refused("sandbox.move 9 0 0 0"));
  EXPECT_TRUE(refused("sandbox.add nan 0 0"));
  EXPECT_TRUE(refused("sandbox.resize 1 0"));
  EXPECT_TRUE(refused("sandbox.new nothing"));
  EXPECT_EQ(sandbox().balls.size(), 4u);
  open_crambin();
  EXPECT_FALSE(state().settings.open.sandbox) << "of another file";
  EXPECT_TRUE(refused("sandbox.add 0 0 0"));
}

TEST_F(SandboxTest, TheMouseMovesResizesAndAdds) {
  open_preset("square");
  run("frames 3\n");
  drag({4, 4}, {6, 5});
  EXPECT_EQ(sandbox().balls[2].centre, (LatticePoint{6000, 5000, 0}));
  drag({0, 1.5}, {0, 2.5});
  EXPECT_EQ(sandbox().balls[0].radius, 2500);
  EXPECT_EQ(sandbox().balls[0].centre, (LatticePoint{0, 0, 0}));
  expect_exact();
  run("edit.undo\nwait-idle\nframes 2\n");
  EXPECT_EQ(sandbox().balls[0].radius, 1500) << "one entry a drag";
  EXPECT_EQ(sandbox().balls[2].centre, (LatticePoint{6000, 5000, 0}));
  run("move view " + in_view({-2, 4}) + "\ndouble-click view " + in_view({-2, 4}) +
      "\nframes 2\nwait-idle\nframes 2\n");
  ASSERT_EQ(sandbox().balls.size(), 5u);
  EXPECT_EQ(sandbox().balls[4].centre, (LatticePoint{-2000, 4000, 0}));
  run("key delete\nframes 2\nwait-idle\nframes 2\n");
  EXPECT_EQ(sandbox().balls.size(), 4u);
}

TEST_F(SandboxTest, AnEmptySandboxIsNoError) {
  open_preset("line");
  for (int i = 0; i < 5; ++i) run("sandbox.remove 1\nwait-idle\n");
  EXPECT_TRUE(sandbox().balls.empty());
  EXPECT_EQ(complex().vertices.size(), 0u);
  EXPECT_EQ(state().error, "");
  run("sandbox.add 1 1 0 1\nwait-idle\nframes 2\n");
  expect_exact();
  EXPECT_EQ(complex().vertices.size(), 1u);
}

TEST_F(SandboxTest, SpaceToPlaneAndBackToTheFile) {
  open_preset("cube");
  EXPECT_FALSE(sandbox().flat);
  EXPECT_FALSE(shows_flat_drawing(state()));
  run("sandbox.flat on\nwait-idle\nframes 2\nwait-idle\n");
  EXPECT_TRUE(shows_flat_drawing(state()));
  EXPECT_EQ(complex().tetrahedra.size(), 0u);
  expect_exact();
  run("sandbox.by_hand off\nwait-idle\nframes 2\n");
  EXPECT_FALSE(state().settings.open.sandbox);
  EXPECT_EQ(state().result->balls->size(), 8u);
  EXPECT_NE(state().result->balls->centres[4].z, 0);
}

// The place of a ball in the picture of a three-dimensional set, as "0.25 0.5" for scripts.
class SpaceSandboxTest : public SandboxTest {
 protected:
  std::string place_of_ball(std::size_t ball) {
    const ViewportInfo& v = state().viewport;
    for (int y = 4; y < v.height; y += 24) {
      for (int x = 4; x < v.width; x += 24) {
        const std::string place =
            std::to_string((x + 0.5) / v.width) + " " + std::to_string((y + 0.5) / v.height);
        run("move view " + place + "\nframes 1\n");
        const auto& over = state().hovered;
        const AtomRef* atom = over ? std::get_if<AtomRef>(&*over) : nullptr;
        if (atom != nullptr && atom->atom == ball) return place;
      }
    }
    ADD_FAILURE() << "ball " << ball << " is not seen";
    return "0.5 0.5";
  }
  static std::string beside(const std::string& place, double right, double down) {
    std::istringstream numbers(place);
    double x = 0, y = 0;
    numbers >> x >> y;
    return std::to_string(x + right) + " " + std::to_string(y + down);
  }
  void drag_in_space(const std::string& from, const std::string& to) {
    run("move view " + from + "\nframes 2\ndown\nframes 2\nmove view " + to +
        "\nframes 2\nwait-idle\nup\nframes 2\nwait-idle\nframes 2\n");
  }
};

TEST_F(SpaceSandboxTest, TheMouseMovesABallParallelToTheScreen) {
  open_preset("cube");
  run("view.ball_size 1\nview.from z\nwait-idle\nframes 2\n");  // x to the right, y upwards
  const Sandbox before = sandbox();
  const std::string place = place_of_ball(4);
  drag_in_space(place, beside(place, 0.1, 0));
  const LatticePoint& was = before.balls[4].centre;
  const LatticePoint& is = sandbox().balls[4].centre;
  EXPECT_GT(is.x, was.x + 200);
  EXPECT_EQ(is.y, was.y);
  EXPECT_EQ(is.z, was.z);
  EXPECT_EQ(is.x % 100, 0) << "a multiple of the step";
  for (std::size_t i = 0; i < 8; ++i) {
    if (i == 4) continue;
    EXPECT_EQ(sandbox().balls[i], before.balls[i]);
  }
  expect_exact();
  // The dragged ball is still under the mouse.
  run("move view " + beside(place, 0.1, 0) + "\nframes 2\n");
  ASSERT_TRUE(state().hovered);
  EXPECT_EQ(std::get<AtomRef>(*state().hovered).atom, 4u);
  run("edit.undo\nwait-idle\nframes 2\n");
  EXPECT_EQ(sandbox(), before) << "one entry a drag";
}

TEST_F(SpaceSandboxTest, TheWheelWithCtrlResizesAndADragBesideBallsTurnsTheView) {
  open_preset("cube");
  run("view.ball_size 1\nview.from z\nwait-idle\nframes 2\n");
  const Sandbox before = sandbox();
  const RealPoint into = state().viewport.into_view;
  drag_in_space("0.02 0.5", "0.1 0.6");
  EXPECT_EQ(sandbox(), before);
  EXPECT_NE(state().viewport.into_view.x, into.x);
  run("view.from z\nwait-idle\nframes 2\n");
  const std::string place = place_of_ball(4);
  run("move view " + place + "\nframes 1\n");
  ScriptedInput input;
  input.x = state().mouse.x;
  input.y = state().mouse.y;
  input.control = true;
  viewer_->step(&input);
  input.wheel = 2;
  viewer_->step(&input);
  run("wait-idle\nframes 2\n");
  EXPECT_EQ(sandbox().balls[4].radius, before.balls[4].radius + 200);
  EXPECT_EQ(sandbox().balls[4].centre, before.balls[4].centre);
  expect_exact();
}

TEST_F(SandboxTest, IsInSessionFiles) {
  open_preset("hidden");
  run("sandbox.move 2 0.5 0.25 0\nwait-idle\n");
  const Sandbox saved = sandbox();
  const fs::path file = folder_ / "s.json";
  run("file.save_session " + file.string() + "\nwait-idle\n");
  open_crambin();
  run("open " + file.string() + "\nwait-idle\nframes 2\nwait-idle\n");
  ASSERT_TRUE(state().settings.open.sandbox);
  EXPECT_EQ(sandbox(), saved);
  expect_exact();
}

TEST_F(SandboxTest, IsSavedAsADrawing) {
  open_preset("ring");
  run("alpha.set 1\nwait-idle\nfile.export " + (folder_ / "ring.svg").string() + "\nwait-idle\n");
  const std::string svg = bytes("ring.svg");
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
  EXPECT_NE(svg.find("8 of 8 centres"), std::string::npos);
  run("file.export " + (folder_ / "balls.xyzr").string() + "\nwait-idle\n");
  EXPECT_NE(bytes("balls.xyzr").find("2.800"), std::string::npos);
}

}  // namespace
}  // namespace alphascope::testing
