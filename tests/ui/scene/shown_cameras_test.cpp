// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the camera of the picture on screen: moves, named views, and views of other balls.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "app/viewer/scene/cameras.hpp"
#include "tests/ui/scene/rod_picture.hpp"
#include "ui/panels/whole_state.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope::testing {
namespace {

class ShownCameras : public ::testing::Test {
 protected:
  ShownCameras() {
    picture_.molecule = molecule_of(rod(3));
    show();
    cameras_.follow(cameras_.before(*picture_.molecule), [] { return ViewProblem::none; });
    ViewportInfo viewport;
    viewport.width = 120;
    viewport.height = 90;
    cameras_.settle(viewport);
  }
  // Null `deposited`: of a file of its own.
  static std::shared_ptr<const DrawnMolecule> molecule_of(
      const std::shared_ptr<const BallSet>& balls,
      std::shared_ptr<const Molecule> deposited = nullptr, const std::string& assembly = {}) {
    const PicturedMolecule carbons = testing::carbons(balls);
    auto opened = std::make_shared<OpenedMolecule>();
    opened->molecule = carbons.molecule;
    opened->prepared = carbons.prepared;
    opened->options.assembly = assembly;
    opened->deposited = deposited ? std::move(deposited) : carbons.molecule;
    return make_drawn(std::move(opened), {});
  }
  void show() {
    const auto& geometry = picture_.molecule->geometry;
    canvas_.change().set_balls(geometry, two_colours(geometry->centres.size()));
  }

  EglContext context_;
  Canvas canvas_;
  DrawnPicture picture_;
  Cameras cameras_{canvas_, picture_};
};

TEST_F(ShownCameras, GoBackToANamedViewBitForBit) {
  const NamedView first = cameras_.named("first");
  EXPECT_EQ(first.name, "first");
  cameras_.zoom(2);
  cameras_.look_from({0.6, 0, 0.8});
  EXPECT_NE(cameras_.named("first").position, first.position);
  canvas_.take_change();
  cameras_.go_to(first);
  EXPECT_TRUE(canvas_.changed());
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(cameras_.named("first").position[k], first.position[k], 1e-9);
  }
}

TEST_F(ShownCameras, LookAcrossTheLineOfSightFromTheSide) {
  const Viewpoint before = canvas_.scene().viewpoint();
  RealPoint line{before.focal_point[0] - before.position[0],
                 before.focal_point[1] - before.position[1],
                 before.focal_point[2] - before.position[2]};
  const double distance = length(line);
  line = unit_vector(line);
  cameras_.look_across(line);
  const Viewpoint after = canvas_.scene().viewpoint();
  const RealPoint back{after.position[0] - after.focal_point[0],
                       after.position[1] - after.focal_point[1],
                       after.position[2] - after.focal_point[2]};
  EXPECT_NEAR(length(back), distance, 1e-6 * distance);
  EXPECT_NEAR(dot(back, line), 0, 1e-6 * distance);
  const RealPoint up{before.up[0], before.up[1], before.up[2]};
  EXPECT_NEAR(dot(back, up), 0, 0.1 * distance) << "neither from above nor from below";
}

TEST_F(ShownCameras, CentreOnBallsAtTheSameScale) {
  BallGeometry one;
  one.centres = {{1, 2, 3}};
  one.radii = {1};
  const double distance = canvas_.scene().sight().distance;
  cameras_.centre_on(one);
  EXPECT_EQ(canvas_.scene().viewpoint().focal_point, (std::array<double, 3>{1, 2, 3}));
  EXPECT_NEAR(canvas_.scene().sight().distance, distance, 1e-9);
  cameras_.zoom_to(one);
  EXPECT_LT(canvas_.scene().sight().distance, distance);
}

// Another assembly is fitted into the view. The replaced view is kept, so that an undo can restore
// it.
TEST_F(ShownCameras, FitOtherBallsAndKeepTheViewThatTheyReplace) {
  cameras_.zoom(3);
  const auto left = cameras_.place();
  const auto same_file = picture_.molecule->opened->deposited;
  const auto next = molecule_of(rod(5), same_file, "2");
  const Cameras::Before before = cameras_.before(*next);
  EXPECT_FALSE(before.keep);
  EXPECT_TRUE(before.same_file);
  picture_.molecule = next;
  show();
  cameras_.follow(before, [] { return ViewProblem::none; });
  EXPECT_FALSE(canvas_.scene().view_is_set()) << "the next picture fits it";
  EXPECT_EQ(cameras_.take_left(), left);
  EXPECT_EQ(cameras_.take_left(), std::nullopt);
}

TEST_F(ShownCameras, GlideToAViewThatIsKnownAtOnce) {
  using namespace std::chrono_literals;
  const auto before = cameras_.place();
  cameras_.glide([&] { cameras_.zoom(2); });
  EXPECT_FALSE(cameras_.gliding()) << "glides are off";
  cameras_.move(*before);
  cameras_.set_glides(true);
  cameras_.glide([&] { cameras_.zoom(4); });
  ASSERT_TRUE(cameras_.gliding());
  const auto target = cameras_.place();
  EXPECT_NE(target, before);
  EXPECT_EQ(cameras_.named("").position[2], before->position[2] + before->origin[2])
      << "the picture has not moved yet";
  cameras_.step_glide(std::chrono::steady_clock::now() + 150ms);
  const double seen = cameras_.named("").position[2] - before->origin[2];
  EXPECT_LT(seen, before->position[2]);
  EXPECT_GT(seen, target->position[2]);
  EXPECT_EQ(cameras_.place(), target);
  cameras_.step_glide(std::chrono::steady_clock::now() + 1s);
  EXPECT_FALSE(cameras_.gliding());
  EXPECT_EQ(cameras_.place()->position, target->position);
  EXPECT_EQ(cameras_.place()->target, target->target);
  // The next move begins where the last one ends, not where the picture is.
  cameras_.glide([&] { cameras_.zoom(0.25); });
  cameras_.glide([&] { cameras_.zoom(4); });
  cameras_.set_glides(false);
  EXPECT_FALSE(cameras_.gliding());
  EXPECT_NEAR(cameras_.place()->position[2], target->position[2], 1e-9);
}

TEST_F(ShownCameras, TakeTheViewThatIsSetForTheNextBalls) {
  cameras_.zoom(3);
  const auto wanted = cameras_.place();
  cameras_.reset();
  cameras_.set_when_drawn(wanted);
  const auto next = molecule_of(rod(3));
  const Cameras::Before before = cameras_.before(*next);
  EXPECT_FALSE(before.same_file);
  picture_.molecule = next;
  show();
  cameras_.follow(before, [] { return ViewProblem::none; });
  ASSERT_TRUE(cameras_.place());
  EXPECT_EQ(cameras_.place()->position, wanted->position);
  EXPECT_EQ(cameras_.place()->target, wanted->target);
  EXPECT_EQ(cameras_.take_left(), std::nullopt);
}

TEST_F(ShownCameras, KeepTheViewOfTheSameAtomsUnlessItShowsNone) {
  const auto again = std::make_shared<OpenedMolecule>(*picture_.molecule->opened);
  again->prepared = std::make_shared<const PreparedBalls>(*again->prepared);
  ASSERT_TRUE(cameras_.is_set_for(*again));
  const auto next = make_drawn(again, {});
  cameras_.zoom(3);
  const auto kept = cameras_.place();
  const Cameras::Before before = cameras_.before(*next);
  ASSERT_TRUE(before.keep);
  picture_.molecule = next;
  show();
  cameras_.follow(before, [] { return ViewProblem::none; });
  EXPECT_TRUE(canvas_.scene().view_is_set());
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(cameras_.place()->position[k], kept->position[k], 1e-9);
  }
  cameras_.follow(before, [] { return ViewProblem::nothing_in_view; });
  EXPECT_FALSE(canvas_.scene().view_is_set());
}

}  // namespace
}  // namespace alphascope::testing
