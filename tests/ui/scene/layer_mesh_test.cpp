// SPDX-License-Identifier: GPL-3.0-or-later
// Tests layers of panels as arrays, and as pixels of the scene.
#include "ui/scene/mesh/layer_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/rgb8.hpp"
#include "tests/ui/molecule_fixture.hpp"
#include "tests/ui/scene/picture_difference.hpp"
#include "tests/ui/scene/texture_pixels.hpp"
#include "ui/scene/pick/pick.hpp"
#include "ui/scene/picture/draw_marks.hpp"
#include "ui/scene/scene.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {
namespace {

using testing::rod;

constexpr Colour kGreen{0.1f, 0.8f, 0.2f, 1}, kViolet{0.8f, 0.1f, 0.8f, 1};

RealPoint middle(const BallGeometry& balls) {
  return {balls.origin[0], balls.origin[1], balls.origin[2]};
}

Layers one(const Layer& layer) {
  return {std::make_shared<const Layer>(layer)};
}

// --- arrays

std::array<double, 3> of(const std::vector<float>& values, std::size_t i) {
  return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}

SmoothMesh tube(const std::vector<LayerSphere>& spheres) {
  SmoothMesh mesh;
  add_tube(spheres, {0, 0, 0}, {1, 2, 3}, mesh);
  return mesh;
}

// Distance (Å) of a point from the nearest sphere; negative inside of one.
double outside_of(const std::vector<LayerSphere>& spheres, const std::array<double, 3>& p) {
  double least = 1e9;
  for (const LayerSphere& s : spheres) {
    const RealPoint offset = RealPoint{p[0], p[1], p[2]} - s.centre_angstrom;
    least = std::min(least, length(offset) - s.radius_angstrom);
  }
  return least;
}

std::vector<LayerSphere> wavy(int spheres) {
  std::vector<LayerSphere> result;
  for (int k = 0; k < spheres; ++k) {
    const double t = 0.1 * k;
    result.push_back({{t, 2 * std::sin(0.3 * t), std::cos(0.2 * t)}, 1 + 0.5 * std::sin(t), {}});
  }
  return result;
}

// Faces, spheres and tubes of several layers share arrays.
TEST(LayerPick, AHitSaysOfWhichLayerItIs) {
  BallGeometry balls;
  balls.centres = {{0, 0, 0},  {2, 0, 0},  {0, 2, 0},  {0, 0, 2},
                   {20, 0, 0}, {22, 0, 0}, {20, 2, 0}, {20, 0, 2}};
  balls.radii.assign(balls.centres.size(), 0.1f);
  Layer nothing, first, second, spheres, tube;
  first.body = second.body = second.translucent = spheres.body = tube.body = true;
  first.tetrahedra = {{0, 1, 2, 3}};
  second.tetrahedra = {{4, 5, 6, 7}};
  spheres.spheres = {{{0, 20, 0}, 1}, {{20, 20, 0}, 1}};
  tube.tubes = {{{{-2, 40, 0}, 1}, {{2, 40, 0}, 1}}};
  Layers layers;
  for (const Layer& layer : {nothing, first, second, spheres, first, tube}) {
    layers.push_back(std::make_shared<const Layer>(layer));
  }
  const auto mesh = std::make_shared<const LayerMesh>(build_layer_mesh(balls, layers));
  const PickLayers picks = body_layers(mesh);
  const auto hit = [&](double x, double y) {
    return nearest_hit(picks, {{{x, y, -50}, {0, 0, 1}}});
  };
  const auto is = [&](const std::optional<Hit>& found, std::string_view kind, std::size_t layer) {
    return found && found->layer == kind && found->index == layer;
  };
  EXPECT_TRUE(is(hit(0.5, 0.5), kBodies, 1)) << "of equal ones the first";
  EXPECT_TRUE(is(hit(20.5, 0.5), kBodies, 2));
  EXPECT_TRUE(is(hit(0, 20), kBodies, 3));
  EXPECT_TRUE(is(hit(20, 20), kBodies, 3));
  EXPECT_TRUE(is(hit(0, 40), kTubes, 5));
  EXPECT_FALSE(hit(50, 50));
}

TEST(TubeMesh, ItsSurfaceIsThatOfTheBalls) {
  const std::vector<LayerSphere> spheres = wavy(120);
  const SmoothMesh mesh = tube(spheres);
  ASSERT_GT(mesh.points(), 1000u);
  for (std::size_t i = 0; i < mesh.points(); ++i) {
    EXPECT_LT(std::fabs(outside_of(spheres, of(mesh.xyz, i))), 0.02) << i;
  }
}

TEST(TubeMesh, IsClosedAndLooksOutwards) {
  const SmoothMesh mesh = tube(wavy(40));
  ASSERT_EQ(mesh.corners.size() % 3, 0u);
  double volume = 0;
  for (std::size_t t = 0; t < mesh.corners.size(); t += 3) {
    std::array<RealPoint, 3> p;
    RealPoint normal;
    for (int k = 0; k < 3; ++k) {
      const auto corner = static_cast<std::size_t>(mesh.corners[t + k]);
      const auto [x, y, z] = of(mesh.xyz, corner);
      const auto [a, b, c] = of(mesh.normals, corner);
      p[k] = {x, y, z};
      normal = normal + RealPoint{a, b, c};
      EXPECT_NEAR(a * a + b * b + c * c, 1, 1e-5);
    }
    const RealPoint face = cross(p[1] - p[0], p[2] - p[0]);
    EXPECT_GE(dot(face, normal), -1e-6);
    volume += dot(p[0], cross(p[1], p[2])) / 6;
  }
  // For a closed surface the sum does not depend on the origin. It is a tube of 4 Å with radii
  // between 0.9 and 1.5 Å, and two half balls.
  EXPECT_GT(volume, 12);
  EXPECT_LT(volume, 35);
}

// Where rings cross each other, no triangle may be lit from inside.
TEST(TubeMesh, LooksOutwardsAroundABend) {
  std::vector<LayerSphere> spheres;
  for (int k = 0; k < 60; ++k) {
    const double angle = 0.1 * k;  // around a circle of 1 Å, by balls of 2 Å
    spheres.push_back(
        {{std::cos(angle), std::sin(angle), 0.05 * k}, 2 + std::sin(0.3 * k) / 4, {}});
  }
  const SmoothMesh mesh = tube(spheres);
  ASSERT_GT(mesh.corners.size(), 3 * spheres.size());
  for (std::size_t t = 0; t < mesh.corners.size(); t += 3) {
    std::array<RealPoint, 3> p;
    RealPoint normal;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = static_cast<std::size_t>(mesh.corners[t + k]);
      const auto [x, y, z] = of(mesh.xyz, corner);
      const auto [a, b, c] = of(mesh.normals, corner);
      p[k] = {x, y, z};
      normal = normal + RealPoint{a, b, c};
    }
    ASSERT_GE(dot(cross(p[1] - p[0], p[2] - p[0]), normal), -1e-6);
  }
  for (std::size_t i = 0; i < mesh.points(); ++i) {
    EXPECT_LT(outside_of(spheres, of(mesh.xyz, i)), 1e-5) << i;
  }
}

TEST(TubeMesh, OneSphereIsABall) {
  const std::vector<LayerSphere> sphere{{{5, 6, 7}, 2, {}}};
  const SmoothMesh mesh = tube(sphere);
  double low = 1e9, high = -1e9;
  for (std::size_t i = 0; i < mesh.points(); ++i) {
    EXPECT_NEAR(outside_of(sphere, of(mesh.xyz, i)), 0, 1e-5);
    low = std::min(low, of(mesh.xyz, i)[2]);
    high = std::max(high, of(mesh.xyz, i)[2]);
  }
  EXPECT_NEAR(low, 5, 1e-5);
  EXPECT_NEAR(high, 9, 1e-5);
}

TEST(TubeMesh, SpheresHaveColoursOfTheirOwn) {
  const SmoothMesh mesh = tube({{{0, 0, 0}, 1, {}}, {{3, 0, 0}, 1, kGreen}});
  EXPECT_EQ(mesh.rgb[1], 2);
  EXPECT_EQ(mesh.rgb[mesh.rgb.size() - 2], 204);
}

TEST(TubeMesh, HostileSpheresGiveFinitePoints) {
  const SmoothMesh mesh = tube({{{0, 0, 0}, 1, {}},
                                {{0, 0, 0}, 2, {}},
                                {{1, 0, 0}, 0, {}},
                                {{1, 0, 0}, -1, {}},
                                {{0.1, 0, 0}, 9, {}},
                                {{0, 0, 0}, 1, {}}});
  ASSERT_GT(mesh.points(), 0u);
  for (const float x : mesh.xyz) EXPECT_TRUE(std::isfinite(x));
  for (const float x : mesh.normals) EXPECT_TRUE(std::isfinite(x));
  EXPECT_EQ(tube({}).points(), 0u);
}

TEST(LayerMesh, SolidTetrahedraShowTheirOutsideWithEdges) {
  const BallGeometry balls(*rod());
  Layer layer;
  layer.body = true;
  layer.tetrahedra = {{0, 1, 4, 16}, {1, 4, 16, 20}};  // with one face in common
  const LayerMesh mesh = build_layer_mesh(balls, one(layer));
  EXPECT_EQ(mesh.opaque.faces.points(), 3u * 6);
  EXPECT_EQ(mesh.opaque.edges.points(), 2u * 9);
  EXPECT_EQ(mesh.marks.faces.points(), 0u);
  EXPECT_TRUE(mesh.fades_rest);
  EXPECT_GE(layer_points(one(layer)).all(),
            mesh.opaque.faces.points() + mesh.opaque.edges.points());
  layer.tetrahedra = {{0, 1, 4, 99999}};
  EXPECT_THROW(build_layer_mesh(balls, one(layer)), std::invalid_argument);
}

TEST(LayerMesh, OnlyBodiesFadeTheRestAndOnlyIfTheyShould) {
  const BallGeometry balls(*rod());
  Layer layer;
  layer.triangles = {{0, 1, 4}};
  EXPECT_FALSE(build_layer_mesh(balls, one(layer)).fades_rest);
  layer.body = true;
  EXPECT_TRUE(build_layer_mesh(balls, one(layer)).fades_rest);
  layer.fades_rest = false;
  EXPECT_FALSE(build_layer_mesh(balls, one(layer)).fades_rest);
}

// --- pixels

class LayersInTheScene : public ::testing::Test {
 protected:
  LayersInTheScene() {
    scene.set_balls(geometry, std::vector<Rgb8>(balls->size(), Rgb8{150, 150, 150}));
  }
  void show(const Layer& layer) {
    scene.set_layers(make_layer_data(
        std::make_shared<const LayerMesh>(build_layer_mesh(*geometry, one(layer)))));
  }
  // Lighting changes brightness, not the dominant component.
  static std::size_t green(const Image& image, int by = 30) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
      const std::uint8_t* p = &image.rgba[i];
      count += p[1] > p[0] + by && p[1] > p[2] + by / 2;
    }
    return count;
  }
  Image picture() { return scene.grab(400, 300, false); }
  // The pixel that shows a place.
  const std::uint8_t* at(const Image& image, const RealPoint& place) {
    const RealPoint p = place - middle(*geometry);
    const auto seen =
        labels_seen({{{p.x, p.y, p.z}, "here"}}, scene.sight(), {}, image.width, image.height);
    const auto x = static_cast<std::size_t>(seen.at(0).x), y = static_cast<std::size_t>(seen[0].y);
    return &image.rgba[4 * (y * static_cast<std::size_t>(image.width) + x)];
  }

  EglContext context;
  Scene scene;
  std::shared_ptr<const BallSet> balls = rod();
  std::shared_ptr<const BallGeometry> geometry = std::make_shared<const BallGeometry>(*balls);
};

TEST_F(LayersInTheScene, ASphereIsWhereItShouldBe) {
  scene.set_ball_radii(std::vector<float>(balls->size(), 0.1f));
  Layer layer;
  layer.body = true;
  layer.colour = kGreen;
  const RealPoint place = middle(*geometry) + RealPoint{3, 1, 0};
  layer.spheres = {{place, 1.5, {}}};
  EXPECT_EQ(green(picture()), 0u);
  show(layer);
  const Image image = picture();
  const std::uint8_t* p = at(image, place);
  EXPECT_GT(p[1], p[0] + 30);
  // A disc of its radius, in pixels.
  const double pixels = M_PI * std::pow(1.5 / scene.angstrom_per_pixel(), 2);
  EXPECT_NEAR(static_cast<double>(green(image)), pixels, 0.2 * pixels);
  layer.spheres[0].colour = kViolet;
  show(layer);
  EXPECT_EQ(green(picture()), 0u);
}

TEST_F(LayersInTheScene, ATubeIsWhereItShouldBe) {
  scene.set_ball_radii(std::vector<float>(balls->size(), 0.1f));
  Layer layer;
  layer.body = true;
  layer.colour = kGreen;
  const RealPoint from = middle(*geometry);
  const RealPoint right{geometry->axes[0][0], geometry->axes[0][1], geometry->axes[0][2]};
  layer.tubes = {{{from - 6 * right, 1, {}}, {from, 2, {}}, {from + 6 * right, 1, {}}}};
  show(layer);
  const Image image = picture();
  for (const double along : {-6.0, -3.0, 0.0, 3.0, 6.0}) {
    const std::uint8_t* p = at(image, from + along * right);
    EXPECT_GT(p[1], p[0] + 30) << along;
  }
  const std::uint8_t* beside = at(image, from + 8.5 * right);
  EXPECT_FALSE(beside[1] > beside[0] + 30);
}

TEST_F(LayersInTheScene, BodiesAreHiddenByBallsUnlessTheseFade) {
  scene.set_ball_radii(std::vector<float>(balls->size(), 2.5f));
  Layer layer;
  layer.body = true;
  layer.colour = kGreen;
  layer.spheres = {{middle(*geometry), 1.5, {}}};
  layer.fades_rest = false;
  show(layer);
  constexpr int kThroughPaleBalls = 6;
  EXPECT_EQ(green(picture(), kThroughPaleBalls), 0u);
  layer.fades_rest = true;
  show(layer);
  EXPECT_GT(green(picture(), kThroughPaleBalls), 100u);
}

TEST_F(LayersInTheScene, SolidTetrahedraHaveDarkerEdges) {
  scene.set_style({.balls = false, .ambient_occlusion = false});
  Layer layer;
  layer.body = true;
  layer.colour = kGreen;
  layer.tetrahedra = {{0, 1, 4, 16}, {100, 101, 104, 116}};
  show(layer);
  const Image image = picture();
  std::size_t dark = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const std::uint8_t* p = &image.rgba[i];
    dark += p[1] > p[0] + 25 && p[1] < 105;
  }
  EXPECT_GT(green(image), 50u);
  EXPECT_GT(dark, 10u);
}

TEST(PlacedLabels, AreSeenWhereTheirPlaceIs) {
  ViewFrustum sight;  // at the origin, looking along -z, a right angle wide and high
  const auto seen = labels_seen({{{0, 0, -10}, "far"}, {{2, 1, -4}, "near"}, {{0, 0, 5}, "behind"}},
                                sight, {}, 200, 100);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen[0].text, "near");
  EXPECT_FLOAT_EQ(seen[0].x, 150);
  EXPECT_FLOAT_EQ(seen[0].y, 37.5f);
  EXPECT_FLOAT_EQ(seen[1].x, 100);
  EXPECT_FLOAT_EQ(seen[1].y, 50);
}

MarkFont type_of(float unit) {
  return {unit, 14 * unit,
          [unit](const std::string& text) { return 7 * unit * static_cast<float>(text.size()); }};
}

TEST(PlacedLabels, StandAroundTheirPlaceAndMakeWay) {
  const std::vector<PictureLabel> labels{{200, 100, "one"},
                                         {205, 103, "two"},
                                         {202, 98, "three"},
                                         {-5, 50, "outside"},
                                         {1, 1, "edge"}};
  const LabelLayout layout = lay_out_labels(labels, 400, 300, type_of(1));
  EXPECT_EQ(layout.left_out, 0u);
  const auto& texts = layout.texts;
  ASSERT_EQ(texts.size(), 4u);
  EXPECT_FLOAT_EQ(texts[0].x, 200 - 10.5f);
  EXPECT_FLOAT_EQ(texts[0].y, 100 - 7);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    EXPECT_GE(texts[i].x, 0);
    EXPECT_GE(texts[i].y, 0);
    for (std::size_t k = 0; k < i; ++k) {
      const bool apart = std::fabs(texts[i].y - texts[k].y) >= 14 || texts[i].x > texts[k].x + 35 ||
                         texts[k].x > texts[i].x + 35;
      EXPECT_TRUE(apart) << texts[i].text << " on " << texts[k].text;
    }
  }
}

// Nine labels fit at one place: one on it, and four lines above and below.
TEST(PlacedLabels, WhatFindsNoRoomIsLeftOutAndCounted) {
  const LabelLayout layout =
      lay_out_labels(std::vector<PictureLabel>(20, {200, 150, "here"}), 400, 300, type_of(1));
  ASSERT_EQ(layout.texts.size(), 9u);
  std::set<float> heights;
  for (const MarkText& text : layout.texts) heights.insert(text.y);
  EXPECT_EQ(heights.size(), 9u);
  EXPECT_EQ(layout.left_out, 11u);
  EXPECT_EQ(left_out_text(layout.left_out), "11 labels have no room here: zoom in");
  EXPECT_EQ(left_out_text(1), "1 label has no room here: zoom in");
  EXPECT_EQ(left_out_text(0), "");
}

// Words can be read on black, white and the middle grey.
TEST(PlacedLabels, CanBeReadOnAnything) {
  for (const std::uint8_t grey : {0, 128, 255}) {
    for (const Theme theme : {Theme::dark, Theme::light}) {
      Image image{1920, 1200, std::vector<std::uint8_t>(4 * 1920 * 1200, grey)};
      PictureMarks marks;
      marks.labels = {{960, 600, "12.3 Å²"}};
      EXPECT_EQ(draw_marks(image, marks, mark_colours(theme)), "");
      int dark = 0, light = 0, changed = 0;
      for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        changed += image.rgba[i] != grey;
        dark += image.rgba[i] < 70;
        light += image.rgba[i] > 185;
      }
      EXPECT_GT(changed, 300);
      EXPECT_LT(changed, 12000);
      EXPECT_GT(dark, 100) << int{grey};
      EXPECT_GT(light, 100) << int{grey};
    }
  }
}

}  // namespace
}  // namespace alphascope
