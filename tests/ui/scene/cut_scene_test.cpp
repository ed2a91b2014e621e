// SPDX-License-Identifier: GPL-3.0-or-later
// Tests pictures of a cut scene pixel by pixel. The part cut away is gone, balls and tetrahedra are
// closed in their colours, and everything else is unchanged.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/rgb8.hpp"
#include "tests/ui/molecule_fixture.hpp"
#include "tests/ui/scene/picture_difference.hpp"
#include "ui/scene/mesh/layer_mesh.hpp"
#include "ui/scene/picture/placed_label.hpp"
#include "ui/scene/scene.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {
namespace {

using testing::kRed;

constexpr int kWidth = 320, kHeight = 240;

Clip clip_of(const std::string& text) {
  return read_clip(text).resolved({0, 0, 1}, {0, 0, 0});
}

class CutScene : public ::testing::Test {
 protected:
  // One ball of 2 Å around the origin, seen along -z from so far that it is whole.
  CutScene() { show({{0, 0, 0}}, {2}, {kRed}); }

  void show(std::vector<std::array<float, 3>> centres, std::vector<float> radii,
            const std::vector<Rgb8>& colours) {
    auto balls = std::make_shared<BallGeometry>();
    balls->centres = std::move(centres);
    balls->radii = std::move(radii);
    geometry = balls;
    scene.set_balls(make_ball_data(geometry, colours, geometry->radii));
    scene.set_viewpoint({{0, 0, 20}, {0, 0, 0}, {0, 1, 0}, 0});
    cut("off");
  }
  void cut(const std::string& text) {
    style.cut = Cut(clip_of(text), {0, 0, 0});
    scene.set_style(style);
  }
  Image picture() { return scene.grab(kWidth, kHeight, false); }

  // The pixel that shows a place.
  std::array<double, 2> place(const std::array<double, 3>& at) const {
    return project_point(scene.sight(), at, kWidth, kHeight).value();
  }
  static std::array<int, 3> pixel(const Image& image, double x, double y) {
    const auto i = 4 * (static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x));
    return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]};
  }
  std::array<int, 3> at(const Image& image, const std::array<double, 3>& point) const {
    const auto p = place(point);
    return pixel(image, p[0], p[1]);
  }
  static bool is(const std::array<int, 3>& colour, const Rgb8& c, int tolerance = 2) {
    return std::abs(colour[0] - c.r) <= tolerance && std::abs(colour[1] - c.g) <= tolerance &&
           std::abs(colour[2] - c.b) <= tolerance;
  }
  bool is_background(const std::array<int, 3>& colour) const {
    const Colour& b = palette(style.theme).scene;
    const auto byte = [](float v) { return static_cast<std::uint8_t>(std::lround(255 * v)); };
    return is(colour, {byte(b.r), byte(b.g), byte(b.b)});
  }
  int coloured(const Image& image, const Rgb8& colour) const {
    int count = 0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) count += is(pixel(image, x, y), colour);
    }
    return count;
  }
  int drawn(const Image& image) const {
    int count = 0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) count += !is_background(pixel(image, x, y));
    }
    return count;
  }
  double pixels_per_angstrom() { return 1 / scene.angstrom_per_pixel(); }

  EglContext context;
  Scene scene;
  SceneStyle style{.ambient_occlusion = false};
  std::shared_ptr<const BallGeometry> geometry;
};

TEST_F(CutScene, APlaneThroughABallTakesHalfOfIt) {
  const Image whole = picture();
  cut("x=0");
  const Image half = picture();
  EXPECT_NEAR(drawn(half), drawn(whole) / 2.0, 0.02 * drawn(whole));
  for (const double y : {-1.5, 0.0, 1.0}) {
    EXPECT_TRUE(is_background(at(half, {0.2, y, 0}))) << y;
    EXPECT_EQ(at(half, {-0.2, y, 0}), at(whole, {-0.2, y, 0})) << y;  // as without the cut
  }
  cut("-x=0");
  EXPECT_TRUE(is_background(at(picture(), {-0.2, 0, 0})));
  cut("off");
  EXPECT_EQ(testing::differing_pixels(picture(), whole), 0);
}

TEST_F(CutScene, TheCapIsADiscInTheBallsColour) {
  for (const bool orthographic : {false, true}) {
    style.orthographic = orthographic;
    for (const double z : {0.0, 1.0, -1.0}) {
      cut("z=" + std::to_string(z));
      const Image image = picture();
      const double scale = pixels_per_angstrom() * (orthographic ? 1 : 20 / (20 - z));
      const double radius = std::sqrt(4 - z * z) * scale;
      for (const double share : {0.0, 0.5, 0.9}) {
        const double r = share * radius / scale;
        EXPECT_TRUE(is(at(image, {r, 0, z}), kRed)) << z << " " << share;
        EXPECT_TRUE(is(at(image, {-0.6 * r, -0.8 * r, z}), kRed)) << z << " " << share;
      }
      // The cap's rim is darker.
      const double inner = radius - 0.08 * scale;
      EXPECT_NEAR(coloured(image, kRed), M_PI * inner * inner, 0.06 * M_PI * radius * radius) << z;
    }
  }
}

TEST_F(CutScene, ASlabHasACapOnEitherSide) {
  cut("z=0:2");
  const Image front = picture();
  const double scale = pixels_per_angstrom() * 20 / 19;
  EXPECT_NEAR(coloured(front, kRed), M_PI * 3 * scale * scale, 0.15 * M_PI * 3 * scale * scale);
  scene.set_viewpoint({{0, 0, -20}, {0, 0, 0}, {0, 1, 0}, 0});
  EXPECT_TRUE(is(at(picture(), {0, 0, -1}), kRed));
  scene.set_viewpoint({{20, 0, 0}, {0, 0, 0}, {0, 1, 0}, 0});
  const Image side = picture();
  EXPECT_FALSE(is_background(at(side, {0, 0, 0.9})));
  EXPECT_TRUE(is_background(at(side, {0, 0, 1.2})));
}

// Where two balls overlap, each point of the cut belongs to the ball with the smaller power
// distance.
TEST_F(CutScene, OverlappingCapsShowPowerCells) {
  const Rgb8 blue = testing::kBlue;
  show({{-1, 0, 0}, {1, 0, 0}}, {2, 1.5f}, {kRed, blue});
  cut("z=0");
  const Image image = picture();
  const double border = (2.0 * 2 - 1.5 * 1.5) / 4;  // x where powers are equal
  for (const double y : {-0.5, 0.0, 0.7}) {
    EXPECT_TRUE(is(at(image, {border - 0.15, y, 0}), kRed)) << y;
    EXPECT_TRUE(is(at(image, {border + 0.15, y, 0}), blue)) << y;
  }
}

TEST_F(CutScene, TranslucentBallsAreCutToo) {
  style.ball_opacity = 0.5;
  cut("x=0");
  const Image image = picture();
  EXPECT_TRUE(is_background(at(image, {0.3, 0, 0})));
  EXPECT_FALSE(is_background(at(image, {-0.3, 0, 0})));
}

class CutMesh : public CutScene {
 protected:
  CutMesh() {
    show({{-4, -4, -3}, {4, -4, -3}, {0, 4, -3}, {0, 0, 5}}, {1, 1, 1, 1},
         std::vector<Rgb8>(4, kRed));
    complex.tetrahedra.simplices.push_back({0, 1, 2, 3});
    complex.tetrahedra_only = true;  // no classes of triangles show the outside
    style.balls = false;
  }
  void draw(const MeshOptions& options, const std::string& text) {
    cut(text);
    const std::vector<Rgb8> colours(4, kRed);
    const auto mesh =
        std::make_shared<const ComplexMesh>(build_mesh(*geometry, colours, complex, options));
    caps = std::make_shared<const CapMesh>(
        build_cap_mesh(*geometry, colours, complex, options, mesh->scale, style.cut));
    scene.set_mesh(make_mesh_data(mesh));
    scene.set_caps(make_cap_data(caps));
  }
  double cap_area() const {
    double area = 0;
    const auto& xyz = caps->faces.xyz;
    for (std::size_t t = 0; 9 * t < xyz.size(); ++t) {
      RealPoint p[3];
      for (std::size_t k = 0; k < 3; ++k) {
        p[k] = {xyz[9 * t + 3 * k], xyz[9 * t + 3 * k + 1], xyz[9 * t + 3 * k + 2]};
      }
      area += length(cross(p[1] - p[0], p[2] - p[0])) / 2;
    }
    return area;
  }
  AlphaComplex complex;
  std::shared_ptr<const CapMesh> caps;
};

TEST_F(CutMesh, ATetrahedronIsClosedInItsColour) {
  draw({}, "z=1");
  EXPECT_NEAR(cap_area(), 32.0 / 4, 1e-5);  // half as long and half as wide as the base
  const Image image = picture();
  EXPECT_TRUE(is(at(image, {0, 0, 1}), kRed));
  EXPECT_TRUE(is(at(image, {-0.7, -0.8, 1}), kRed));
  scene.set_caps(nullptr);  // without caps one looks inside
  EXPECT_FALSE(is(at(picture(), {0, 0, 1}), kRed));
  draw({}, "y=0");  // four corners: two above or one
  EXPECT_GT(cap_area(), 1);
  EXPECT_EQ(caps->faces.source.size() * 9, caps->faces.xyz.size());
}

// The tetrahedron has its base of 32 Å² at z = -3, and its top at z = 5. The area of a section
// grows with the square of its distance from the top.
TEST_F(CutMesh, ASlabClosesItOnBothSides) {
  draw({}, "z=0:2");
  const auto section = [](double z) { return 32 * std::pow((5 - z) / 8, 2); };
  EXPECT_NEAR(cap_area(), section(1) + section(-1), 1e-4);
}

TEST_F(CutMesh, ShrunkTetrahedraAreClosedAsTheyAreDrawn) {
  draw({.shrink = 0.5}, "z=-1");  // through the centre of mass, which does not move
  EXPECT_NEAR(cap_area(), 32 * std::pow(6.0 / 8, 2) / 4, 1e-4);
}

// The caps are as translucent as the tetrahedra.
TEST_F(CutMesh, TranslucentOnesAreClosedToo) {
  style.complex_opacity = 0.5;
  draw({.translucent = true}, "z=1");
  EXPECT_NEAR(cap_area(), 32.0 / 4, 1e-5);
  const auto red = [&] { return at(picture(), {0, 0, 1})[0]; };
  const int closed = red();
  EXPECT_LT(closed, kRed.r - 20);
  scene.set_caps(nullptr);
  EXPECT_GT(closed, red() + 20);
}

TEST_F(CutMesh, EveryLayerEndsAtThePlane) {
  const MeshOptions only_boundary{.tetrahedra = false, .boundary = true};
  for (const MeshOptions& options : {MeshOptions{}, only_boundary}) {
    draw(options, "x=-0.5");
    const Image image = picture();
    EXPECT_FALSE(is_background(at(image, {-1, -1, 0})));
    for (double x = -0.2; x < 4; x += 0.3) {
      EXPECT_TRUE(is_background(at(image, {x, -2, -3}))) << x;
    }
  }
}

TEST_F(CutMesh, LayersOfPanelsAreCutAsWell) {
  auto layer = std::make_shared<Layer>();
  layer->colour = {0, 1, 0, 1};
  layer->fades_rest = false;
  layer->spheres = {{{-2, 0, 0}, 1}, {{2, 0, 0}, 1}};
  layer->tubes = {{{{-2, 3, 0}, 0.4}, {{2, 3, 0}, 0.4}}};
  layer->labels = {{{-2, 0, 0}, "kept"}, {{2, 0, 0}, "cut"}};
  auto balls = std::make_shared<BallSet>();
  layer->balls = balls;
  const auto mesh = std::make_shared<const LayerMesh>(build_layer_mesh(*geometry, {layer}));
  scene.set_layers(make_layer_data(mesh));
  const std::array<double, 3> places[] = {{2, 0, 0}, {1.5, 3, 0}};
  cut("off");
  for (const auto& p : places) EXPECT_FALSE(is_background(at(picture(), p)));
  cut("x=0");
  const Image image = picture();
  for (const auto& p : places) {
    EXPECT_TRUE(is_background(at(image, p)));
    EXPECT_FALSE(is_background(at(image, {-p[0], p[1], p[2]})));
  }
  const auto labels = labels_seen(mesh->labels, scene.sight(), style.cut, kWidth, kHeight);
  ASSERT_EQ(labels.size(), 1u);
  EXPECT_EQ(labels[0].text, "kept");
}

// Without perspective a ball has one size at any distance. A place is seen where its line of sight
// passes.
TEST_F(CutScene, OrthographicPicturesHaveNoPerspective) {
  style.orthographic = true;
  show({{-3, 0, 6}, {3, 0, -6}}, {1, 1}, {kRed, testing::kBlue});
  const Image image = picture();
  int left = 0, right = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      (x < kWidth / 2 ? left : right) += !is_background(pixel(image, x, y));
    }
  }
  EXPECT_GT(left, 100);
  EXPECT_NEAR(left, right, 0.03 * left);
  const auto p = place({3, 0, -6});
  const Ray ray = scene.ray(p[0] - 0.5, p[1] - 0.5);
  EXPECT_NEAR(ray.start[0], 3, 1e-6);
  EXPECT_NEAR(ray.start[1], 0, 1e-6);
  scene.set_style({.ambient_occlusion = false});
  EXPECT_GT(drawn(picture()), 0);
}

TEST_F(CutScene, ZoomingWithoutPerspectiveKeepsWhatOneLooksAt) {
  style.orthographic = true;
  cut("off");
  const double before = drawn(picture());
  scene.wheel(2);
  const double after = drawn(picture());
  EXPECT_GT(after, 1.2 * before);
  const Viewpoint view = scene.viewpoint();
  style.orthographic = false;  // the same size at the focal point
  cut("off");
  EXPECT_NEAR(drawn(picture()), after, 0.05 * after);
  EXPECT_EQ(scene.viewpoint().position, view.position);
}

}  // namespace
}  // namespace alphascope
