// SPDX-License-Identifier: GPL-3.0-or-later
// Tests how edges and faces look: rods, lines around faces, smooth light, shadows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/molecule/rgb8.hpp"
#include "tests/ui/scene/picture_difference.hpp"
#include "ui/scene/scene.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {
namespace {

constexpr int kWidth = 200, kHeight = 160;
constexpr Rgb8 kGreen{60, 200, 90};

// Balls at given places, seen along -z from 20 Å, without perspective by default.
class CellPicture : public ::testing::Test {
 protected:
  void load(const std::vector<std::array<float, 3>>& centres, ComplexMesh mesh) {
    BallSet balls;  // only sizes and the box come from these
    for (const auto& c : centres) {
      balls.centres.push_back({static_cast<std::int32_t>(1000 * c[0]),
                               static_cast<std::int32_t>(1000 * c[1]),
                               static_cast<std::int32_t>(1000 * c[2])});
      balls.radii.push_back(1000);
    }
    auto geometry = std::make_shared<BallGeometry>(balls);
    geometry->centres = centres;
    scene_.set_balls(geometry, std::vector<Rgb8>(centres.size(), kGreen));
    scene_.set_mesh(make_mesh_data(std::make_shared<const ComplexMesh>(std::move(mesh))));
    scene_.set_viewpoint({{0, 0, 20}, {0, 0, 0}, {0, 1, 0}, 0});
    style_.balls = style_.ambient_occlusion = false;
    style_.orthographic = true;
    style_.rod_radius = 0.5f;
  }

  Image drawn() {
    scene_.set_style(style_);
    return scene_.grab(kWidth, kHeight, false);
  }
  double pixels_per_angstrom() const { return 1 / scene_.angstrom_per_pixel(); }

  static int green(const Image& image, int x, int y) {
    return image.rgba[4 * (static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)) + 1];
  }
  // The background has little green.
  static int rows_drawn(const Image& image, int x) {
    int rows = 0;
    for (int y = 0; y < kHeight; ++y) rows += green(image, x, y) > 45;
    return rows;
  }

  EglContext context_;
  Scene scene_;
  SceneStyle style_;
};

EdgeCells one_edge() {
  EdgeCells cells;
  cells.edges = {DrawnEdge{{0, 1}, packed(kGreen), packed(kGreen)}};
  return cells;
}

FaceCells two_faces() {
  FaceCells cells;
  cells.faces = {DrawnFace{{0, 1, 2}, packed(kGreen)}, DrawnFace{{0, 2, 3}, packed(kGreen)}};
  return cells;
}

ComplexMesh mesh_of(EdgeCells edges, FaceCells boundary = {}) {
  ComplexMesh mesh;
  mesh.edges = std::move(edges);
  mesh.boundary = std::move(boundary);
  return mesh;
}

TEST_F(CellPicture, AnEdgeIsARodAsThickAsAskedFor) {
  load({{-4, 0, 0}, {4, 0, 0}}, mesh_of(one_edge()));
  for (const float radius : {0.5f, 1.0f}) {
    style_.rod_radius = radius;
    const Image image = drawn();
    const double wanted = 2 * radius * pixels_per_angstrom();
    EXPECT_NEAR(rows_drawn(image, kWidth / 2), wanted, 2) << radius;
    // Its ends are round, so they extend by the radius.
    const int end = kWidth / 2 + static_cast<int>((4 + 0.7 * radius) * pixels_per_angstrom());
    EXPECT_GT(rows_drawn(image, end), 0);
    EXPECT_LT(rows_drawn(image, end), 0.85 * wanted);
    EXPECT_EQ(rows_drawn(image,
                         kWidth / 2 + static_cast<int>((4 + 1.2 * radius) * pixels_per_angstrom())),
              0);
  }
}

TEST_F(CellPicture, ARodIsLitAsARoundBodyIs) {
  load({{-4, 0, 0}, {4, 0, 0}}, mesh_of(one_edge()));
  style_.rod_radius = 1;
  const Image image = drawn();
  const int radius = static_cast<int>(pixels_per_angstrom());
  const int above = green(image, kWidth / 2, kHeight / 2 - radius / 2);
  const int below = green(image, kWidth / 2, kHeight / 2 + 3 * radius / 4);
  EXPECT_GT(above, below + 25) << "the light comes from above";
}

// A rod that is seen from its end has no direction in the picture, and must be a disc.
TEST_F(CellPicture, SeenFromItsEndARodIsADisc) {
  for (const bool orthographic : {true, false}) {
    load({{0, 0, -2}, {0, 0, 2}}, mesh_of(one_edge()));
    style_.orthographic = orthographic;
    style_.rod_radius = 1;
    const Image image = drawn();
    int pixels = 0;
    for (int x = 0; x < kWidth; ++x) pixels += rows_drawn(image, x);
    const double radius = pixels_per_angstrom() * (orthographic ? 1 : 20.0 / 18);
    EXPECT_NEAR(pixels / (M_PI * radius * radius), 1, 0.15) << orthographic;
  }
}

TEST_F(CellPicture, AThinRodIsStillALine) {
  load({{-4, 0, 0}, {4, 0, 0}}, mesh_of(one_edge()));
  style_.rod_radius = 0.001f;
  for (const bool orthographic : {true, false}) {
    style_.orthographic = orthographic;
    const int rows = rows_drawn(drawn(), kWidth / 2);
    EXPECT_GE(rows, 1);
    EXPECT_LE(rows, 3);
  }
}

// Depth is that of the rod's round side, not of the flat shape on which it is drawn.
TEST_F(CellPicture, ARodHasTheDepthOfARoundBody) {
  // A face through the rod's axis, in the plane of the picture. The half in front of it stays
  // visible.
  const std::vector<std::array<float, 3>> places{{-4, 0, 0}, {4, 0, 0}, {4, 6, 0}, {-4, 6, 0}};
  load(places, mesh_of(one_edge(), two_faces()));
  style_.rod_radius = 1;
  const Image both = drawn();
  load(places, mesh_of(one_edge()));
  style_.rod_radius = 1;
  const Image alone = drawn();
  const int radius = static_cast<int>(pixels_per_angstrom());
  for (int y = kHeight / 2 - radius + 2; y < kHeight / 2 + radius - 2; ++y) {
    EXPECT_NEAR(green(both, kWidth / 2, y), green(alone, kWidth / 2, y), 3) << y;
  }
}

TEST_F(CellPicture, FacesHaveDarkerLinesAroundThem) {
  load({{-4, -3, 0}, {4, -3, 0}, {4, 3, 0}, {-4, 3, 0}}, mesh_of({}, two_faces()));
  const Image plain = drawn();
  EXPECT_EQ(green(plain, kWidth / 2, kHeight / 2), green(plain, kWidth / 2 + 20, kHeight / 2));
  int last = 0;
  for (const float width : {1.0f, 3.0f}) {
    style_.face_lines = width;
    const Image lines = drawn();
    // The line between the two faces is a diagonal through the middle.
    int darkest = 255;
    for (int y = kHeight / 2 - 1; y <= kHeight / 2; ++y) {
      darkest = std::min(darkest, green(lines, kWidth / 2, y));
    }
    EXPECT_LT(darkest, green(plain, kWidth / 2, kHeight / 2) - 40);
    EXPECT_EQ(green(lines, kWidth / 2 + 20, kHeight / 2),
              green(plain, kWidth / 2 + 20, kHeight / 2));
    const int changed = testing::unequal_pixels(plain, lines);
    EXPECT_GT(changed, last + 50);
    last = changed;
  }
}

TEST_F(CellPicture, FacesAsSmallAsTheirLinesHaveNone) {
  load({{-4, -3, 0}, {4, -3, 0}, {4, 3, 0}, {-4, 3, 0}}, mesh_of({}, two_faces()));
  scene_.set_viewpoint({{0, 0, 4000}, {0, 0, 0}, {0, 1, 0}, 0});
  const Image plain = drawn();
  ASSERT_GT(testing::drawn_pixels(plain), 0);
  style_.face_lines = 1;
  EXPECT_EQ(testing::unequal_pixels(plain, drawn()), 0);
}

// A roof of two faces. Flat it has two shades; smooth, the shade does not jump at the ridge.
TEST_F(CellPicture, ASmoothBoundaryHasNoStepsOfLight) {
  const std::vector<std::array<float, 3>> places{{0, -3, 2}, {4, -3, 0}, {4, 3, 0},
                                                 {0, 3, 2},  {-4, 3, 0}, {-4, -3, 0}};
  FaceCells roof;
  for (const auto& balls :
       std::vector<std::array<BallIndex, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
    roof.faces.push_back({balls, packed(kGreen)});
  }
  const auto step = [&](const FaceCells& faces) {
    load(places, mesh_of({}, faces));
    const Image image = drawn();
    return std::abs(green(image, kWidth / 2 - 2, kHeight / 2) -
                    green(image, kWidth / 2 + 2, kHeight / 2));
  };
  EXPECT_GT(step(roof), 10);
  const float side = 0.4472136f, up = 0.8944272f;
  roof.normals = {{0, 0, 1}, {side, 0, up},  {side, 0, up},
                  {0, 0, 1}, {-side, 0, up}, {-side, 0, up}};
  EXPECT_LT(step(roof), 4);
  // Dark lines would show the faces again.
  const Image without_lines = drawn();
  style_.face_lines = 2;
  EXPECT_EQ(testing::unequal_pixels(without_lines, drawn()), 0);
  roof.normals.clear();
  load(places, mesh_of({}, roof));
  const Image flat = drawn();
  style_.face_lines = 0;
  EXPECT_GT(testing::unequal_pixels(flat, drawn()), 50) << "a flat boundary has them";
}

// A small plate, 4 Å wide, 3 Å in front of a large one.
class TwoPlates : public CellPicture {
 protected:
  TwoPlates() {
    FaceCells plates = two_faces();
    for (const auto& balls : std::vector<std::array<BallIndex, 3>>{{4, 5, 6}, {4, 6, 7}}) {
      plates.faces.push_back({balls, packed(kGreen)});
    }
    load({{-30, -30, -3},
          {30, -30, -3},
          {30, 30, -3},
          {-30, 30, -3},
          {-2, -2, 0},
          {2, -2, 0},
          {2, 2, 0},
          {-2, 2, 0}},
         mesh_of({}, plates));
  }
  // Green at a place, in Å to the right of the middle and below it.
  int green_at(const Image& image, double x, double y) const {
    const double scale = pixels_per_angstrom();
    return green(image, kWidth / 2 + static_cast<int>(x * scale),
                 kHeight / 2 + static_cast<int>(y * scale));
  }
};

// The light comes from the upper left, so the shadow lies to the lower right. Occlusion is equal on
// both sides.
TEST_F(TwoPlates, WhatIsBeforeTheLightCastsAShadow) {
  style_.ambient_occlusion = true;
  style_.samples = 8;
  const Image image = drawn();
  EXPECT_LT(green_at(image, 3, 3), green_at(image, -3, -3) - 15);
  const int usual = green_at(image, 3, 3);
  style_.shadow_strength = 0.5f;
  const int weaker = green_at(drawn(), 3, 3);
  style_.shadow_strength = 0;
  const int none = green_at(drawn(), 3, 3);
  EXPECT_GT(weaker, usual + 5);
  EXPECT_GT(none, weaker + 5);
  style_.ambient_occlusion = false;
  const Image plain = drawn();
  EXPECT_EQ(green_at(plain, 3, 3), green_at(plain, -3, -3));
  EXPECT_EQ(none, green_at(plain, 3, 3));
}

TEST_F(TwoPlates, FrontsOfWhatIsTranslucentAreFinishedToo) {
  style_.complex_opacity = 0.6;
  const Image plain = drawn();
  const double beside = 2 + 1.5 / pixels_per_angstrom();
  style_.outlines = 2;
  const Image outlined = drawn();
  EXPECT_LT(green_at(outlined, beside, 0), 0.5 * green_at(plain, beside, 0));
  EXPECT_EQ(green_at(outlined, 0, 0), green_at(plain, 0, 0));
  EXPECT_EQ(green_at(outlined, 4, 0), green_at(plain, 4, 0));
  style_.outlines = 0;
  style_.depth_cue = 1;
  const Image faded = drawn();
  EXPECT_LT(green_at(faded, 4, 0), green_at(plain, 4, 0) - 20);
  style_.depth_cue = 0;
  style_.ambient_occlusion = true;
  style_.samples = 8;
  const Image shaded = drawn();
  EXPECT_LT(green_at(shaded, 3, 3), green_at(shaded, -3, -3) - 5);
}

// The ball at a corner of the small plate hides the plate's border.
TEST_F(TwoPlates, WhatIsOpaqueHidesOutlinesOfWhatIsTranslucent) {
  style_.complex_opacity = 0.6;
  style_.balls = true;
  const Image plain = drawn();
  style_.outlines = 2;
  const Image outlined = drawn();
  for (const double away : {-0.1, 0.05, 0.1}) {  // the ball is drawn with a radius of 0.3 Å
    EXPECT_EQ(green_at(outlined, 2 + away, 2), green_at(plain, 2 + away, 2)) << away;
  }
  EXPECT_LT(green_at(outlined, 2 + 1.5 / pixels_per_angstrom(), 0),
            green_at(plain, 2 + 1.5 / pixels_per_angstrom(), 0) - 30);
}

}  // namespace
}  // namespace alphascope
