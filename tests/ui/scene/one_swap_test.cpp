// SPDX-License-Identifier: GPL-3.0-or-later
// Tests a slider that is dragged while meshes are slow. Text and picture of one frame belong to one
// alpha, and new pictures keep coming.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <mutex>
#include <thread>

#include "core/document/settings/request.hpp"
#include "tests/ui/viewer_fixture.hpp"

namespace alphascope::testing {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kMeshDelay{60};
constexpr std::size_t kMeshes = 20;  // in each half of a drag

double milliseconds(Clock::duration time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

class OneSwapTest : public ViewerTest {
 protected:
  struct Frame {
    double alpha = 0;  // in the caption
    std::string hash;
    std::array<std::size_t, 4> counts{};
    double legend_to = 0;  // alpha at its upper end; 0: there is none
    double covered = 0;    // share of the picture that the complex covers
    double green = 0;      // mean of pixels outside the background, 0 to 255
    std::size_t made = 0;  // meshes so far
  };

  explicit OneSwapTest(const HostOptions& host = {1100, 700, 1, "test"}) : ViewerTest(true, host) {
    viewer_.reset();
    ViewerOptions options;
    options.compare = false;
    options.preset = "fast";
    viewer_ = std::make_unique<Viewer>(*host_, options, Session::program_services(),
                                       [this](const auto&... what) { return slow_mesh(what...); });
    open_crambin();
    DisplaySettings& display = viewer_->state().settings.display;
    display.balls = display.ambient_occlusion = false;
    display.complex_paint.by = ColourBy::alpha;
    // A frame that waits for tables is not shown (FramePicture::waits_for_tables), but these tests
    // would look at it. So a page without tables is open.
    run("view.page timings\nwait-idle\n");
  }
  ~OneSwapTest() override { viewer_.reset(); }  // its worker uses this

  ComplexMesh slow_mesh(const BallGeometry& balls, const std::vector<Rgb8>& colours,
                        const AlphaComplex& complex, const MeshOptions& options,
                        const CancelToken& cancel) {
    ComplexMesh mesh = build_mesh(balls, colours, complex, options, cancel);
    std::this_thread::sleep_for(delay_);
    const std::lock_guard lock(mutex_);
    ++made_;
    return mesh;
  }

  // The background has the colour of the corner.
  void look_at_picture(Frame& frame) const {
    const Image image = picture_now();
    std::size_t count = 0;
    double green = 0;
    for (std::size_t i = 4; i < image.rgba.size(); i += 4) {
      if (std::equal(&image.rgba[i], &image.rgba[i] + 3, image.rgba.data())) continue;
      ++count;
      green += image.rgba[i + 1];
    }
    frame.covered = 4.0 * static_cast<double>(count) / static_cast<double>(image.rgba.size());
    frame.green = count > 0 ? green / static_cast<double>(count) : 0;
  }

  Frame frame(ScriptedInput& input) {
    viewer_->step(&input);
    const ViewState& s = viewer_->state();
    const AlphaComplex& shown = s.result->complex;
    const auto& legends = s.viewport.legends;
    Frame f{s.result->request.alpha_angstrom2,
            hash_text(shown.hash),
            {shown.vertices.size(), shown.edges.size(), shown.triangles.size(),
             shown.tetrahedra.size()},
            legends.empty() || legends[0].stops.empty() ? 0 : legends[0].stops.back().value};
    look_at_picture(f);
    const std::lock_guard lock(mutex_);
    f.made = made_;
    return f;
  }

  // Drags the slider to and fro in large steps, so that no two successive pictures look alike. It
  // ends after enough meshes. Then it does so again with pictures drawn while the window goes on.
  std::vector<Frame> drag() {
    const WidgetRect slider = viewer_->widgets().at("alpha.slider");
    ScriptedInput input;
    input.y = (slider.y0 + slider.y1) / 2;
    std::vector<Frame> frames;
    int i = 0;
    for (const bool meanwhile : {false, true}) {
      if (meanwhile) viewer_->render_asynchronously();
      const std::size_t enough = (frames.empty() ? 0 : frames.back().made) + kMeshes;
      do {
        const float share = 0.05f + 0.9f * static_cast<float>(std::fmod(0.382 * i, 1.0));
        input.x = slider.x0 + share * (slider.x1 - slider.x0);
        if (i++ == 0) viewer_->step(&input);  // over the slider before the press
        input.down[0] = true;
        frames.push_back(frame(input));
      } while (frames.back().made < enough && frames.size() < 10000);
    }
    input.down[0] = false;
    viewer_->step(&input);
    return frames;
  }

  Image picture_now() const {
    return texture_pixels(static_cast<unsigned>(viewer_->state().viewport.texture));
  }

  std::chrono::milliseconds delay_ = kMeshDelay;  // not changed while a mesh is made
  std::mutex mutex_;
  std::size_t made_ = 0;
};

TEST_F(OneSwapTest, ADragMixesNoTwoAlphasAndPicturesKeepComing) {
  const std::vector<Frame> frames = drag();
  // Counted, not timed, because other programs may take the cores at any time. A mesh is drawn
  // before the next but one is made, even if the slider has moved on. One mesh may be on its way to
  // the window.
  constexpr std::size_t kMostBetween = 3;
  std::size_t pictures = 0, made = frames.front().made;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    ASSERT_LE(frames[i].made - made, kMostBetween) << "frame " << i;
    if (frames[i].alpha == frames[i - 1].alpha) continue;
    made = frames[i].made;
    ++pictures;
  }
  EXPECT_GE(pictures, 10u);

  // Compares each of some pictures with the picture at rest of the same alpha.
  std::size_t checked = 0;
  double drawn = -1;
  for (const Frame& f : frames) {
    if (f.alpha != drawn && checked++ % 3 == 0) {
      viewer_->state().settings.request.alpha_angstrom2 = drawn = f.alpha;
      run("wait-idle\n");
    }
    if (f.alpha != drawn) continue;
    ScriptedInput nothing;
    const Frame rest = frame(nothing);
    const AlphaComplex complex = expected(f.alpha);
    EXPECT_EQ(f.hash, hash_text(complex.hash)) << f.alpha;
    EXPECT_EQ(f.counts, (std::array{complex.vertices.size(), complex.edges.size(),
                                    complex.triangles.size(), complex.tetrahedra.size()}));
    EXPECT_EQ(f.legend_to, rest.legend_to) << f.alpha;
    // Moving pictures may be coarser. The largest difference was 4 %, of a picture in which little
    // is covered.
    EXPECT_NEAR(f.covered, rest.covered, 0.06 * rest.covered) << f.alpha;
  }
  EXPECT_GE(checked, 10u);
}

// Colours of balls show exposed area. Large alphas bury nearly all atoms and small ones few, so
// pictures of two alphas differ in brightness.
TEST_F(OneSwapTest, ADragShowsExposedAreasOfTheAlphaThatItNames) {
  DisplaySettings& display = viewer_->state().settings.display;
  display.balls = true;
  display.tetrahedra = false;
  display.ball_scale = 1;
  display.ball_paint.by = ColourBy::exposed;
  run("wait-idle\n");
  const std::vector<Frame> frames = drag();
  const auto [darkest, brightest] =
      std::minmax_element(frames.begin(), frames.end(),
                          [](const Frame& a, const Frame& b) { return a.green < b.green; });
  EXPECT_GT(brightest->green, 1.2 * darkest->green) << "else nothing can be told apart";
  double drawn = -1;
  std::size_t checked = 0, others = 0;
  Frame rest;
  for (const Frame& f : frames) {
    if (f.alpha != drawn && others++ % 3 == 0) {
      viewer_->state().settings.request.alpha_angstrom2 = drawn = f.alpha;
      run("wait-idle\n");
      ScriptedInput nothing;
      rest = frame(nothing);
    }
    if (f.alpha != drawn) continue;
    EXPECT_NEAR(f.green, rest.green, 0.02 * rest.green) << f.alpha;
    ++checked;
  }
  EXPECT_GE(checked, 10u);
}

// The picture is so large that a sample takes long.
class RefinementTest : public OneSwapTest {
 protected:
  RefinementTest() : OneSwapTest({2560, 1600, 1, "test"}) {}

  // The first sample is drawn after a while without changes.
  void wait_for_sample() {
    const Image before = picture_now();
    const Clock::time_point begun = Clock::now();
    while (picture_now().rgba == before.rgba) {
      ASSERT_LT(Clock::now() - begun, std::chrono::seconds(200)) << "on however busy a machine";
      viewer_->step(nullptr);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  // The shortest time in milliseconds of steps that draw a sample.
  double shortest_of(int steps) {
    double shortest = HUGE_VAL;
    for (int i = 0; i < steps; ++i) {
      const Clock::time_point begun = Clock::now();
      viewer_->step(nullptr);
      viewer_->finish_frame();
      shortest = std::min(shortest, milliseconds(Clock::now() - begun));
    }
    return shortest;
  }
};

// A sample of a fine picture delays the next picture, so an outdated picture gets none.
TEST_F(RefinementTest, APictureThatIsToBeReplacedIsNotRefined) {
  DisplaySettings& display = viewer_->state().settings.display;
  display.balls = display.ambient_occlusion = true;
  display.samples = 1;
  run("wait-idle\n");
  delay_ = std::chrono::milliseconds(500);
  display.samples = 1000;  // never done
  wait_for_sample();
  const double sample = shortest_of(5);
  wait_for_sample();
  const Image refined = picture_now();
  set_alpha(viewer_->state().settings.request,
            viewer_->state().settings.request.alpha_angstrom2 + 1);
  const double wanted = viewer_->state().settings.request.alpha_angstrom2;
  int waited = 0;
  while (viewer_->state().result->request.alpha_angstrom2 != wanted) {
    viewer_->step(nullptr);
    if (viewer_->state().result->request.alpha_angstrom2 == wanted) break;
    ++waited;
    // A sample that is as quick as the panels may be drawn.
    if (sample > 25) {
      EXPECT_EQ(picture_now().rgba, refined.rgba) << "frame " << waited;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_GT(waited, 1);
  wait_for_sample();  // a sample of the new picture
}

}  // namespace
}  // namespace alphascope::testing
