// SPDX-License-Identifier: GPL-3.0-or-later
// Tests contents of pictures of the scene on a software OpenGL context. baseline_test.cpp compares
// whole pictures.
#include "ui/scene/scene.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/predicates/exact_alpha.hpp"
#include "core/predicates/perturbation.hpp"
#include "tests/ui/molecule_fixture.hpp"
#include "tests/ui/scene/picture_difference.hpp"
#include "tests/ui/scene/png_pixels.hpp"
#include "tests/ui/scene/rod_picture.hpp"
#include "tests/ui/scene/texture_pixels.hpp"
#include "ui/scene/gl/sample_place.hpp"
#include "ui/scene/picture/frame_grab.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {
namespace {

using testing::complex_of;
using testing::differing_pixels;
using testing::rod;
using testing::two_colours;

struct PictureCounts {
  int background = 0, red = 0, blue = 0, other = 0;
  int drawn() const { return red + blue + other; }
};

// Lighting changes brightness, not the dominant component.
PictureCounts count_colours(const Image& image, Theme theme) {
  const Colour& scene = palette(theme).scene;
  const int background[3] = {static_cast<int>(scene.r * 255 + 0.5f),
                             static_cast<int>(scene.g * 255 + 0.5f),
                             static_cast<int>(scene.b * 255 + 0.5f)};
  PictureCounts counts;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const std::uint8_t* p = &image.rgba[i];
    int difference = 0;
    for (int c = 0; c < 3; ++c) difference += std::abs(p[c] - background[c]);
    if (difference <= 6) {
      ++counts.background;
    } else if (p[0] > p[1] + 40 && p[0] > p[2] + 40) {
      ++counts.red;
    } else if (p[2] > p[0] + 40 && p[2] > p[1] + 20) {
      ++counts.blue;
    } else {
      ++counts.other;
    }
  }
  return counts;
}

class SceneTest : public ::testing::Test {
 protected:
  void load(double alpha, const MeshOptions& options = {}) {
    scene.set_balls(geometry, two_colours(balls->size()));
    show(alpha, options);
  }
  void show(double alpha, const MeshOptions& options = {}) {
    scene.set_mesh(make_mesh_data(std::make_shared<const ComplexMesh>(
        build_mesh(*geometry, two_colours(balls->size()), complex_of(balls, alpha), options))));
  }

  EglContext context;
  Scene scene;
  std::shared_ptr<const BallSet> balls = rod();
  std::shared_ptr<const BallGeometry> geometry = std::make_shared<const BallGeometry>(*balls);
};

TEST_F(SceneTest, EmptySceneIsBackgroundOnly) {
  const PictureCounts counts = count_colours(scene.grab(320, 200, false), Theme::dark);
  EXPECT_EQ(counts.background, 320 * 200);
}

TEST_F(SceneTest, BallsAppearInTheirColours) {
  load(0);
  scene.set_mesh(nullptr);
  const PictureCounts counts = count_colours(scene.grab(320, 200, false), Theme::dark);
  EXPECT_GT(counts.red, 500);
  EXPECT_GT(counts.blue, 500);
  EXPECT_GT(counts.background, 20000);
}

TEST_F(SceneTest, TetrahedraAloneAreDrawn) {
  load(0);
  scene.set_style({.balls = false});
  EXPECT_GT(count_colours(scene.grab(320, 200, false), Theme::dark).drawn(), 1000);
  scene.set_mesh(nullptr);
  EXPECT_EQ(count_colours(scene.grab(320, 200, false), Theme::dark).drawn(), 0);
}

TEST_F(SceneTest, AnotherAlphaGivesAnotherPicture) {
  load(-1.5);
  const Image before = scene.grab(320, 200, false);
  show(2);
  EXPECT_GT(differing_pixels(before, scene.grab(320, 200, false)), 500);
  show(-1.5);
  EXPECT_EQ(differing_pixels(before, scene.grab(320, 200, false)), 0);
}

// One tetrahedron has at most two faces behind a pixel, one of them perhaps seen from behind. Each
// lets 70 % of the light behind it through.
TEST_F(SceneTest, TranslucentTetrahedraLetTheBackgroundThrough) {
  MeshOptions options;
  options.translucent = true;
  AlphaComplex one = complex_of(balls, 0);
  one.tetrahedra.simplices.resize(1);
  scene.set_balls(geometry, two_colours(balls->size()));
  scene.set_mesh(make_mesh_data(std::make_shared<const ComplexMesh>(
      build_mesh(*geometry, two_colours(balls->size()), one, options))));
  for (const Theme theme : {Theme::dark, Theme::light}) {
    const auto picture = [&](double opacity) {
      scene.set_style({.balls = false, .complex_opacity = opacity, .theme = theme});
      return scene.grab(640, 400, false);
    };
    const Image opaque = picture(1), translucent = picture(0.3);
    const double background = 255 * palette(theme).scene.b;
    double seen_opaque = 0, seen_translucent = 0;  // difference in blue, of which red has least
    int pixels = 0;
    for (std::size_t i = 0; i < opaque.rgba.size(); i += 4) {
      const double off = std::abs(opaque.rgba[i + 2] - background);
      if (off < 10) continue;
      ++pixels;
      seen_opaque += off;
      seen_translucent += std::abs(translucent.rgba[i + 2] - background);
    }
    EXPECT_GT(pixels, 20);
    EXPECT_LT(seen_translucent, 0.7 * seen_opaque);
    EXPECT_GT(seen_translucent, 0.15 * seen_opaque);
  }
}

// In a moving picture, only faces towards the viewer are drawn, each once. The order of a
// tetrahedron's corners must not matter.
TEST_F(SceneTest, AMovingTranslucentTetrahedronShowsItsFront) {
  constexpr double kOpacity = 0.3;
  const AlphaComplex all = complex_of(balls, 0);
  MeshOptions options;
  options.translucent = true;
  options.colouring = ComplexColouring::single;
  scene.set_balls(geometry, two_colours(balls->size()));
  const auto draft = [&](double opacity) {
    SceneStyle style{.balls = false, .complex_opacity = opacity};
    style.ambient_occlusion = false;
    style.depth_cue = style.outlines = style.face_lines = 0;
    scene.set_style(style);
    scene.render(400, 300, RenderQuality::draft);
    return testing::texture_pixels(scene.texture());
  };
  const auto volume = [&](const std::array<BallIndex, 4>& t) {
    return determinant(lifted_vector(*balls, t[0], t[1]), lifted_vector(*balls, t[0], t[2]),
                       lifted_vector(*balls, t[0], t[3]));
  };
  for (const bool positive : {false, true}) {
    AlphaComplex one = all;
    std::erase_if(one.tetrahedra.simplices,
                  [&](const auto& t) { return (volume(t) > 0) != positive; });
    ASSERT_FALSE(one.tetrahedra.simplices.empty()) << positive;
    one.tetrahedra.simplices.resize(1);
    scene.set_mesh(make_mesh_data(std::make_shared<const ComplexMesh>(
        build_mesh(*geometry, two_colours(balls->size()), one, options))));
    for (int view = 0; view < 6; ++view) {
      const Image opaque = draft(1), translucent = draft(kOpacity);
      int seen = 0, otherwise = 0;
      for (std::size_t i = 0; i < opaque.rgba.size(); i += 4) {
        const double behind = opaque.rgba[2], before = opaque.rgba[i + 2];
        if (std::abs(before - behind) < 30) continue;
        ++seen;
        const double expected = kOpacity * before + (1 - kOpacity) * behind;
        otherwise += std::abs(translucent.rgba[i + 2] - expected) > 8 ? 1 : 0;
      }
      EXPECT_GT(seen, 30) << view;
      EXPECT_LE(otherwise, seen / 10) << "of " << seen << ", view " << view << " " << positive;
      scene.pointer_move(100, 100, false, false);
      scene.pointer_button(PointerButton::left, true);
      scene.pointer_move(150, 130, false, false);
      scene.pointer_button(PointerButton::left, false);
    }
  }
}

// A style without the effects that only pictures at rest have.
SceneStyle plain_style(double complex_opacity, Theme theme) {
  SceneStyle style{.balls = false, .complex_opacity = complex_opacity};
  style.theme = theme;
  style.ambient_occlusion = false;
  style.depth_cue = style.outlines = 0;
  return style;
}

// While something moves, a face has one light, and its highlight is that of one corner.
TEST_F(SceneTest, LightForEachFaceLooksLikeLightForEachPixel) {
  load(0);
  for (const bool orthographic : {false, true}) {
    SceneStyle style = plain_style(1, Theme::dark);
    style.orthographic = orthographic;
    scene.set_style(style);
    scene.render(400, 300, RenderQuality::medium);
    const Image at_rest = testing::texture_pixels(scene.texture());
    scene.render(400, 300, RenderQuality::draft);
    const Image moving = testing::texture_pixels(scene.texture());
    int drawn = 0, otherwise = 0;
    for (std::size_t i = 0; i < at_rest.rgba.size(); i += 4) {
      int difference = 0, seen = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        difference = std::max(difference, std::abs(at_rest.rgba[i + c] - moving.rgba[i + c]));
        seen = std::max(seen, std::abs(at_rest.rgba[i + c] - at_rest.rgba[c]));
      }
      drawn += seen > 6 ? 1 : 0;
      otherwise += difference > 6 ? 1 : 0;
    }
    EXPECT_GT(drawn, 4000) << orthographic;
    EXPECT_LT(otherwise, drawn / 50) << orthographic;
  }
}

// Light through a tetrahedron's four triangles, none of which hides another. It is exact at rest.
// While something moves, all layers count together.
TEST_F(SceneTest, AsMuchShinesThroughTranslucentLayersThatMove) {
  constexpr double kOpacity = 0.4;
  AlphaComplex one = complex_of(balls, 0);
  ASSERT_FALSE(one.tetrahedra.simplices.empty());
  const auto t = one.tetrahedra.simplices.front();
  one.tetrahedra = {};
  one.edges = {};
  one.triangles = {};
  for (const auto& f : {std::array{t[0], t[1], t[2]}, std::array{t[0], t[1], t[3]},
                        std::array{t[0], t[2], t[3]}, std::array{t[1], t[2], t[3]}}) {
    one.triangles.simplices.push_back(f);
    one.triangles.alpha_values.push_back(0);
    one.triangles.classes.push_back(SimplexClass::singular);
  }
  MeshOptions options{.tetrahedra = false, .triangles = true, .translucent = true};
  options.colouring = ComplexColouring::single;
  scene.set_balls(geometry, two_colours(balls->size()));
  scene.set_mesh(make_mesh_data(std::make_shared<const ComplexMesh>(
      build_mesh(*geometry, two_colours(balls->size()), one, options))));
  // The same picture on a dark and a light background. The difference is the light that shines
  // through.
  const auto through = [&](RenderQuality quality, bool drawn) {
    std::array<Image, 2> pictures;
    for (const Theme theme : {Theme::dark, Theme::light}) {
      SceneStyle style = plain_style(drawn ? kOpacity : 1e-6, theme);
      style.face_lines = 0;
      scene.set_style(style);
      scene.render(1200, 900, quality);
      pictures[theme == Theme::light] = testing::texture_pixels(scene.texture());
    }
    std::vector<int> result;
    for (std::size_t i = 0; i < pictures[0].rgba.size(); i += 4) {
      result.push_back(pictures[1].rgba[i] - pictures[0].rgba[i]);
    }
    return result;
  };
  const std::vector<int> none = through(RenderQuality::medium, false);
  const std::vector<int> at_rest = through(RenderQuality::medium, true);
  const std::vector<int> moving = through(RenderQuality::draft, true);
  int two_layers = 0, otherwise = 0;
  for (std::size_t i = 0; i < none.size(); ++i) {
    const double expected = (1 - kOpacity) * (1 - kOpacity) * none[i];
    two_layers += std::abs(at_rest[i] - expected) <= 3 ? 1 : 0;
    otherwise += std::abs(moving[i] - at_rest[i]) > 3 ? 1 : 0;
  }
  EXPECT_GT(two_layers, 100);
  EXPECT_LE(otherwise, two_layers / 20);
}

TEST_F(SceneTest, RendersIntoATextureAtEveryQualityAndSize) {
  load(0);
  for (const RenderQuality quality :
       {RenderQuality::sketch, RenderQuality::draft, RenderQuality::medium, RenderQuality::fine}) {
    for (const int width : {8, 333, 640}) {
      scene.reset_view();
      EXPECT_GT(scene.render(width, 201, quality), 0.0);
      const Image picture = testing::texture_pixels(scene.texture());
      const double samples = quality == RenderQuality::sketch ? 0.5 : 1;
      ASSERT_EQ(picture.width, std::lround(width * samples));
      ASSERT_EQ(picture.height, std::lround(201 * samples));
      const PictureCounts counts = count_colours(picture, Theme::dark);
      EXPECT_GT(counts.background, 0);
      // The rod lies along the longer side of a picture. It is small in a narrow one.
      EXPECT_GT(counts.drawn(), width == 8 ? 3 : 4000 * samples * samples) << width;
    }
  }
}

TEST_F(SceneTest, ANarrowerPictureCutsNothingOff) {
  const auto touches_a_side = [](const Image& image) {
    int marked = 0;
    const Colour& c = palette(Theme::dark).scene;
    for (int y = 0; y < image.height; ++y) {
      for (const int x : {0, image.width - 1}) {
        const std::uint8_t* p = &image.rgba[4 * (std::size_t(y) * image.width + x)];
        marked += std::abs(p[0] - 255 * c.r) > 12 || std::abs(p[2] - 255 * c.b) > 12;
      }
    }
    return marked > 0;
  };
  load(0);
  scene.render(640, 320, RenderQuality::draft);
  const double usual = scene.angstrom_per_pixel();
  for (const int width : {320, 160, 80}) {
    const Image narrow = scene.grab(width, 320, false);
    EXPECT_FALSE(touches_a_side(narrow)) << width;
    EXPECT_GT(count_colours(narrow, Theme::dark).drawn(), 100) << width;
  }
  EXPECT_GT(scene.viewpoint().least_aspect, 0.25);
  scene.render(640, 320, RenderQuality::draft);
  EXPECT_DOUBLE_EQ(scene.angstrom_per_pixel(), usual) << "wide again, it is as it was";
  EXPECT_EQ(scene.viewpoint().least_aspect, 0) << "a session saved now says nothing of it";
}

TEST_F(SceneTest, AViewpointMovesToAnotherScene) {
  load(0);
  scene.render(320, 200, RenderQuality::draft);
  scene.pointer_move(100, 100, false, false);
  scene.pointer_button(PointerButton::left, true);
  scene.pointer_move(180, 150, false, false);
  scene.pointer_button(PointerButton::left, false);
  const Image turned = scene.grab(320, 200, false);
  Scene other;
  other.set_balls(geometry, two_colours(balls->size()));
  other.set_mesh(make_mesh_data(std::make_shared<const ComplexMesh>(
      build_mesh(*geometry, two_colours(balls->size()), complex_of(balls, 0), {}))));
  EXPECT_GT(differing_pixels(turned, other.grab(320, 200, false)), 500);
  other.set_viewpoint(scene.viewpoint());
  EXPECT_EQ(differing_pixels(turned, other.grab(320, 200, false)), 0);
}

TEST_F(SceneTest, DraggingTurnsAndResetRestores) {
  load(0);
  const Image before = scene.grab(320, 200, false);
  scene.render(320, 200, RenderQuality::draft);
  scene.pointer_move(100, 100, false, false);
  scene.pointer_button(PointerButton::left, true);
  scene.pointer_move(180, 150, false, false);
  scene.pointer_button(PointerButton::left, false);
  EXPECT_GT(differing_pixels(before, scene.grab(320, 200, false)), 500);
  scene.reset_view();
  EXPECT_EQ(differing_pixels(before, scene.grab(320, 200, false)), 0);
}

TEST_F(SceneTest, ARayThroughEveryBallsPixelPicksABallThere) {
  load(0);
  scene.set_mesh(nullptr);
  std::vector<float> radii = drawn_radii(*geometry, {});
  scene.render(640, 400, RenderQuality::draft);
  const Image image = scene.grab(640, 400, false);
  int background = 0, wrong = 0;
  for (int y = 3; y < 400; y += 7) {
    for (int x = 3; x < 640; x += 7) {
      const std::uint8_t* p = &image.rgba[(std::size_t(y) * 640 + x) * 4];
      const auto ball = pick_ball(*geometry, radii, scene.ray(x, y));
      if (!ball) ++background;
      const bool red = p[0] > p[2] + 40, blue = p[2] > p[0] + 40;
      const bool first_half = ball && ball->ball < geometry->centres.size() / 2;
      wrong += (red && (!ball || !first_half)) || (blue && (!ball || first_half));
    }
  }
  EXPECT_GT(background, 1000);
  EXPECT_LE(wrong, 20);  // of 5,200: pixels on an outline
}

// A sketch has half as many pixels each way, rounded. Mouse positions are still pixels of the view.
TEST_F(SceneTest, TheLineOfSightIsTheSameInASketch) {
  load(0);
  for (const RenderQuality quality : {RenderQuality::sketch, RenderQuality::draft}) {
    scene.render(641, 401, quality);
    const Ray ray = scene.ray(320, 200);
    const ViewFrustum sight = scene.sight();
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(ray.direction[k], sight.forward[k], 1e-12);
  }
}

TEST_F(SceneTest, WheelZoomsIn) {
  load(0);
  scene.render(320, 200, RenderQuality::draft);
  const double before = scene.angstrom_per_pixel();
  scene.wheel(3);
  EXPECT_LT(scene.angstrom_per_pixel(), before);
}

TEST_F(SceneTest, LightThemeHasALightBackground) {
  load(0);
  scene.set_style({.theme = Theme::light});
  const Image image = scene.grab(320, 200, false);
  EXPECT_GT(image.rgba[0], 240);
  EXPECT_GT(count_colours(image, Theme::light).red, 500);
}

TEST_F(SceneTest, TransparentPictureHasClearBackgroundAndOpaqueBalls) {
  load(0);
  const Image image = scene.grab(320, 200, true);
  int clear = 0, opaque = 0;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    clear += image.rgba[i] == 0;
    opaque += image.rgba[i] == 255;
  }
  EXPECT_GT(clear, 20000);
  EXPECT_GT(opaque, 1000);
}

// A program that quits waits for the picture that is being drawn. So drawing must be able to stop
// between samples.
TEST_F(SceneTest, APictureCanBeCancelledBetweenItsSamples) {
  load(0);
  std::vector<double> shares;
  RunContext run;
  run.progress = [&](std::string_view, double share) { shares.push_back(share); };
  const Image whole = scene.grab(320, 200, false, run);
  EXPECT_EQ(shares, (std::vector<double>{0, 0.25, 0.5, 0.75}));
  shares.clear();
  run.progress = [&](std::string_view, double share) {
    shares.push_back(share);
    if (share > 0) run.cancel.cancel();
  };
  EXPECT_THROW(scene.grab(320, 200, true, run), Cancelled);
  EXPECT_EQ(shares.size(), 2u);
  EXPECT_EQ(differing_pixels(whole, scene.grab(320, 200, false)), 0) << "as if nothing had been";
}

// A picture of one sample has two colours at an edge. The mean of several samples has more.
TEST_F(SceneTest, EdgesOfAPictureAreSmooth) {
  load(0);
  scene.set_style({.ball_opacity = 1, .ambient_occlusion = false});
  const Image image = scene.grab(320, 200, true);
  int between = 0;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    between += image.rgba[i] > 0 && image.rgba[i] < 255;
  }
  EXPECT_GT(between, 100);
}

TEST_F(SceneTest, SamplesAddUpToThePictureOfAFileAndStartAgainAtAMove) {
  load(0);
  SceneStyle style;
  style.depth_cue = 0.5f;
  style.outlines = 2;
  style.samples = 5;
  scene.set_style(style);
  const Image file = scene.grab(160, 100, false);
  const auto rest = [&] {
    for (int k = 1; k <= style.samples; ++k) {
      scene.render(160, 100, RenderQuality::fine);
      EXPECT_EQ(scene.samples_drawn(), k);
    }
    scene.render(160, 100, RenderQuality::fine);
    EXPECT_EQ(scene.samples_drawn(), style.samples) << "there are no more";
    return testing::upright(testing::texture_pixels(scene.texture()));
  };
  EXPECT_EQ(testing::unequal_pixels(rest(), file), 0);
  const Viewpoint before = scene.viewpoint();
  scene.pointer_button(PointerButton::left, true);
  scene.pointer_move(60, 20, false, false);
  scene.pointer_button(PointerButton::left, false);
  EXPECT_EQ(scene.samples_drawn(), 0);
  scene.set_viewpoint(before);
  EXPECT_EQ(testing::unequal_pixels(rest(), file), 0);
}

// Ambient occlusion needs no background.
TEST_F(SceneTest, TransparentPicturesHaveTheSameShadows) {
  load(0);
  scene.set_style({.ambient_occlusion = false});
  const Image plain = scene.grab(160, 100, true);
  scene.set_style({.ambient_occlusion = true});
  const Image clear = scene.grab(160, 100, true), opaque = scene.grab(160, 100, false);
  long darker = 0;
  int like_opaque = 0, inside = 0;
  for (std::size_t i = 0; i < clear.rgba.size(); i += 4) {
    EXPECT_EQ(clear.rgba[i + 3], plain.rgba[i + 3]);
    if (clear.rgba[i + 3] < 255) continue;
    ++inside;
    darker += plain.rgba[i] - clear.rgba[i];
    like_opaque += std::abs(clear.rgba[i] - opaque.rgba[i]) <= 2;
  }
  EXPECT_GT(darker, 5 * inside);
  EXPECT_EQ(like_opaque, inside);
}

TEST_F(SceneTest, ShadowsAndOutlinesFollowTheSizeOfTheView) {
  load(0);
  SceneStyle style;
  style.outlines = 2;
  SceneStyle plain;
  plain.ambient_occlusion = false;
  for (const RenderQuality quality : {RenderQuality::medium, RenderQuality::fine}) {
    for (const int width : {120, 200, 160}) {
      const auto drawn = [&](const SceneStyle& wanted) {
        scene.set_style(wanted);
        scene.render(width, 100, quality);
        return testing::texture_pixels(scene.texture());
      };
      const Image with = drawn(style);
      EXPECT_GT(differing_pixels(with, drawn(plain)), 500) << width;
      EXPECT_GT(count_colours(with, Theme::dark).background, 1000) << width;
    }
  }
}

// The jitters of a pixel are evenly spread, each used once. Otherwise edges would have steps.
TEST(SampleMean, PlacesOfSamplesAreSpreadEvenly) {
  for (const int count : {4, 16}) {
    const int side = count == 4 ? 2 : 4;
    std::set<std::pair<int, int>> cells;
    std::array<double, 2> sum{};
    for (int k = 0; k < count; ++k) {
      const auto place = sample_place(k);
      cells.insert({int((place[0] + 0.5) * side), int((place[1] + 0.5) * side)});
      for (std::size_t c = 0; c < 2; ++c) sum[c] += place[c] / count;
    }
    EXPECT_EQ(cells.size(), std::size_t(count));
    EXPECT_LT(std::fabs(sum[0]) + std::fabs(sum[1]), count == 16 ? 1e-9 : 0.3);
  }
}

TEST(FrameGrab, ColoursOfATransparentPictureAreNotMultiplied) {
  Image image{3, 1, {50, 25, 0, 128, 100, 50, 0, 255, 9, 9, 9, 0}};
  divide_by_alpha(image);
  EXPECT_EQ(image.rgba, (std::vector<std::uint8_t>{100, 50, 0, 128, 100, 50, 0, 255, 0, 0, 0, 0}));
}

TEST(Screenshot, WritesAPngWithoutADisplay) {
  const auto balls = rod();
  const auto path = std::filesystem::temp_directory_path() / "alphascope_screenshot_test.png";
  const PictureSettings settings = testing::plain_settings(balls->size(), 400, 300);
  testing::draw_carbons(balls, complex_of(balls, 0), settings, path);
  const Image image = testing::pixels_of(path);
  EXPECT_EQ(image.width, 400);
  EXPECT_EQ(image.height, 300);
  EXPECT_GT(count_colours(image, Theme::dark).red, 500);
  EXPECT_GT(count_colours(image, Theme::dark).blue, 500);
  std::filesystem::remove(path);
}

TEST(Screenshot, CanBeCancelledAtEachStepAndThenWritesNothing) {
  const auto balls = rod();
  const auto path = std::filesystem::temp_directory_path() / "alphascope_cancelled_test.png";
  const AlphaComplex complex = complex_of(balls, 0);
  std::vector<std::string> steps;
  RunContext all;
  all.progress = [&](std::string_view stage, double) { steps.emplace_back(stage); };
  const PictureSettings settings = testing::plain_settings(balls->size(), 64, 64);
  testing::draw_carbons(balls, complex, settings, path, all);
  ASSERT_TRUE(std::filesystem::remove(path));
  ASSERT_GE(steps.size(), 5u);
  for (std::size_t cancelled_at = 1; cancelled_at < steps.size(); ++cancelled_at) {
    RunContext context;
    std::size_t step = 0;
    context.progress = [&](std::string_view, double) {
      if (++step == cancelled_at) context.cancel.cancel();
    };
    EXPECT_THROW(testing::draw_carbons(balls, complex, settings, path, context), Cancelled)
        << cancelled_at;
    EXPECT_EQ(step, cancelled_at) << "no further step";
    EXPECT_FALSE(std::filesystem::exists(path));
  }
}

TEST(Screenshot, RefusesSizesAndFoldersThatCannotBe) {
  const auto balls = rod(2);
  const AlphaComplex complex = complex_of(balls, 0);
  PictureSettings settings = testing::plain_settings(balls->size(), 4, 300);
  EXPECT_THROW(testing::draw_carbons(balls, complex, settings, "/tmp/x.png"),
               std::invalid_argument);
  settings.options.width = 100;
  try {
    testing::draw_carbons(balls, complex, settings, "/no/such/folder/x.png");
    FAIL() << "wrote into a folder that does not exist";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/no/such/folder/x.png"), std::string::npos);
  }
}

}  // namespace
}  // namespace alphascope
