// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that differences from CGAL are visible in the picture. The test has an engine that errs.
#include <gtest/gtest.h>

#include "tests/support/png_chunks.hpp"
#include "tests/ui/molecule_fixture.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/scene/mesh/difference_mesh.hpp"
#include "ui/scene/scene.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {
namespace {

using testing::crambin;

TEST(DifferenceMesh, HoldsEverySimplexThatDiffers) {
  const BallGeometry balls(*testing::rod());
  Comparison c;
  EXPECT_TRUE(build_difference_mesh(balls, c).empty());
  c.tetrahedra.missing = {{0, 1, 4, 16}};
  c.triangles.extra = {{0, 1, 4}};
  c.edges.missing = {{0, 1}, {1, 2}};
  c.vertices.extra = {{3}};
  const DifferenceMesh mesh = build_difference_mesh(balls, c);
  EXPECT_EQ(mesh.faces.points(), 3u * (4 + 1 + 8));
  EXPECT_EQ(mesh.edges.points(), 4u);
  EXPECT_EQ(mesh.faces.rgb[1], kMissingColour.g);
  EXPECT_EQ(mesh.faces.rgb[3 * 12 + 1], kExtraColour.g);
  c.vertices.extra = {{99999}};
  EXPECT_THROW(build_difference_mesh(balls, c), std::invalid_argument);
}

// Answers like CGAL, but leaves out one tetrahedron and makes up an edge.
class ErringEngine : public Engine {
 public:
  explicit ErringEngine(std::shared_ptr<const BallSet> balls)
      : right_(make_cgal_engine(std::move(balls))) {}
  AlphaComplex compute(const AlphaRequest& request, KnownResults& known,
                       const RunContext& context) override {
    AlphaComplex complex = right_->compute(request, known, context);
    auto& t = complex.tetrahedra;
    t.simplices.pop_back();
    if (!t.alpha_values.empty()) t.alpha_values.pop_back();
    if (!t.classes.empty()) t.classes.pop_back();
    auto& e = complex.edges;
    e.simplices.push_back({complex.vertices.simplices.front()[0], 326});
    e.alpha_values.push_back(0);
    e.classes.push_back(SimplexClass::singular);
    return complex;
  }

 private:
  std::unique_ptr<Engine> right_;
};

class DifferenceInTheWindow : public testing::ViewerTest {
 protected:
  void open_with(bool erring) {
    viewer_.reset();
    Session::Services services = Session::program_services();
    services.make_engine = [erring](EngineChoice choice, std::shared_ptr<const BallSet> balls,
                                    const EngineSettings& settings) {
      if (!erring || choice == EngineChoice::cgal) return make_engine(choice, balls, settings);
      return MadeEngine{std::make_unique<ErringEngine>(balls), ""};
    };
    ViewerOptions options;
    options.compare = false;
    options.draw_shots_only = true;
    viewer_ = std::make_unique<Viewer>(*host_, options, services);
    open_crambin();
  }

  // The pixels of the view alone, without panels. They do not contain the engine's route.
  std::string picture() {
    viewer_->calls().jobs.save_picture(
        ScreenshotRequest{folder_ / "picture.png", {.width = 480, .height = 320}});
    run("wait-idle\n");
    std::string pixels;
    for (const auto& [type, data] : testing::chunks_of(bytes("picture.png"))) {
      if (type == "IDAT") pixels += data;
    }
    return pixels;
  }
};

TEST_F(DifferenceInTheWindow, AnErringEngineIsSeenInThePictureAfterComparing) {
  open_with(true);
  const std::string before = picture();
  run("click bottom.timings\nclick timings.compare\nwait-idle\n");
  EXPECT_EQ(viewer_->state().badge.state, BadgeInfo::State::different);
  EXPECT_NE(viewer_->state().badge.text.find("tetrahedra: 1 missing, 0 extra"), std::string::npos)
      << viewer_->state().badge.text;
  EXPECT_TRUE(picture() != before);
  run("click alpha.preset.3\nwait-idle\nclick alpha.preset.0\nwait-idle\n");
  EXPECT_TRUE(picture() == before) << "of an answer that was not compared, nothing is known";
}

TEST_F(DifferenceInTheWindow, ARightEngineLeavesThePictureAsItIs) {
  open_with(false);
  const std::string before = picture();
  run("click bottom.timings\nclick timings.compare\nwait-idle\n");
  EXPECT_EQ(viewer_->state().badge.state, BadgeInfo::State::identical);
  EXPECT_TRUE(picture() == before);
}

// Lighting and shadows change brightness, not hue.
std::size_t magenta_pixels(const Image& image) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const std::uint8_t* p = &image.rgba[i];
    count += p[0] > 150 && p[2] > 100 && p[1] < 60;
  }
  return count;
}

TEST(DifferencesInTheScene, NothingHidesThem) {
  const EglContext context;
  Scene scene;
  const auto balls = testing::rod();
  const auto geometry = std::make_shared<const BallGeometry>(*balls);
  scene.set_balls(geometry, std::vector<Rgb8>(balls->size(), Rgb8{90, 160, 90}));
  const std::vector<float> large(balls->size(), 2.5f);  // Å: everything inside is covered
  scene.set_ball_radii(large);
  Comparison c;
  c.edges.missing = {{5, 6}};  // deep inside the rod
  c.tetrahedra.missing = {{100, 101, 104, 117}};
  EXPECT_EQ(magenta_pixels(scene.grab(640, 400, false)), 0u);
  scene.set_differences(make_difference_data(
      std::make_shared<const DifferenceMesh>(build_difference_mesh(*geometry, c))));
  EXPECT_GT(magenta_pixels(scene.grab(640, 400, false)), 100u);
  EXPECT_GT(magenta_pixels(scene.grab(640, 400, true)), 100u) << "also without background";
  scene.set_differences(nullptr);
  EXPECT_EQ(magenta_pixels(scene.grab(640, 400, false)), 0u);
}

}  // namespace
}  // namespace alphascope
