// SPDX-License-Identifier: GPL-3.0-or-later
// Tests balls seen from close by. Each pixel must show what the line of sight through its centre
// meets. The test computes that from the ball, the eye and the angle of the view alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/rgb8.hpp"
#include "tests/ui/molecule_fixture.hpp"
#include "tests/ui/scene/texture_pixels.hpp"
#include "ui/scene/pick/ball_pick.hpp"
#include "ui/scene/scene.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {
namespace {

using testing::kBlue;
using testing::kRed;
using Vector = std::array<double, 3>;

constexpr int kWidth = 240, kHeight = 160;
constexpr double kUsualDegrees = 25;  // from the bottom to the top of the picture

double tangent_of(double degrees) {
  return std::tan(degrees * M_PI / 360);
}

double product(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct Sphere {
  Vector centre;  // the eye is at the origin and looks along -z
  double radius;
};

// A sphere at this distance from the eye. It is `degrees` from the middle of the picture, towards
// the top right.
Sphere sphere_at(double distance, double degrees, double radius) {
  const double a = degrees * M_PI / 180;
  return {{0.8 * distance * std::sin(a), 0.6 * distance * std::sin(a), -distance * std::cos(a)},
          radius};
}

// The part of a line of sight inside the ball, ahead of the eye or behind it.
std::optional<std::pair<double, double>> inside_of(const Sphere& sphere, const Vector& direction) {
  const double length2 = product(direction, direction);
  const double along = product(sphere.centre, direction) / length2;
  const double beside2 = product(sphere.centre, sphere.centre) - along * along * length2;
  if (beside2 > sphere.radius * sphere.radius) return std::nullopt;
  const double half = std::sqrt((sphere.radius * sphere.radius - beside2) / length2);
  return std::pair(along - half, along + half);
}

enum class Seen { nothing, red, blue };

class BallPicture : public ::testing::Test {
 protected:
  void show(const std::vector<Sphere>& spheres) {
    auto balls = std::make_shared<BallGeometry>();
    for (const Sphere& s : spheres) {
      balls->centres.push_back({static_cast<float>(s.centre[0]), static_cast<float>(s.centre[1]),
                                static_cast<float>(s.centre[2])});
      balls->radii.push_back(static_cast<float>(s.radius));
    }
    std::vector<Rgb8> colours(spheres.size(), kBlue);
    colours[0] = kRed;
    geometry = balls;
    scene.set_balls(make_ball_data(geometry, colours, geometry->radii));
    scene.set_style(style);
  }
  void look(double degrees) {
    tangent = tangent_of(degrees);
    const double wider = tangent / tangent_of(kUsualDegrees);
    scene.set_viewpoint({{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, wider * kWidth / kHeight});
  }
  // The direction through a place of the picture, in pixels from its top left.
  Vector direction(double x, double y) const {
    return {(2 * x / kWidth - 1) * tangent * kWidth / kHeight, (1 - 2 * y / kHeight) * tangent, -1};
  }

  // Compares the picture with the expected value of a line of sight. Where that changes within half
  // a pixel, both values are accepted.
  template <class Expected>
  int count_wrong(RenderQuality quality, const Expected& expected) {
    scene.render(kWidth, kHeight, quality);
    const Image image = testing::upright(testing::texture_pixels(scene.texture()));
    const Colour& b = palette(style.theme).scene;
    int wrong = 0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const Seen here = expected(direction(x + 0.5, y + 0.5));
        bool border = false;
        for (int k = 0; k < 8; ++k) {
          const double across = 0.5 * std::cos(k * M_PI / 4), up = 0.5 * std::sin(k * M_PI / 4);
          border = border || expected(direction(x + 0.5 + across, y + 0.5 + up)) != here;
        }
        if (border) continue;
        const auto* pixel =
            &image.rgba[4 * (static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x))];
        const double off = std::fabs(pixel[0] - 255.0 * b.r) + std::fabs(pixel[1] - 255.0 * b.g) +
                           std::fabs(pixel[2] - 255.0 * b.b);
        const Seen drawn = off < 12 ? Seen::nothing : pixel[0] > pixel[2] ? Seen::red : Seen::blue;
        wrong += drawn != here;
      }
    }
    return wrong;
  }
  // Compares picking with the expectation, pixel by pixel.
  template <class Expected>
  int count_wrong_picks(const Expected& expected) const {
    int wrong = 0;
    for (int y = 0; y < kHeight; y += 3) {
      for (int x = 0; x < kWidth; x += 3) {
        const Ray ray = scene.ray(x, y);
        const auto hit = pick_ball(*geometry, geometry->radii, ray, style.cut.along(ray));
        const Seen picked = !hit ? Seen::nothing : hit->ball == 0 ? Seen::red : Seen::blue;
        wrong += picked != expected(direction(x + 0.5, y + 0.5));
      }
    }
    return wrong;
  }

  EglContext context;
  Scene scene;
  SceneStyle style{.ambient_occlusion = false, .theme = Theme::light, .samples = 1};
  std::shared_ptr<const BallGeometry> geometry;
  double tangent = 0;
};

Seen seen_of_one(const Sphere& sphere, const Vector& direction) {
  const auto inside = inside_of(sphere, direction);
  return inside && inside->first > 0 ? Seen::red : Seen::nothing;
}

TEST_F(BallPicture, ABallNearTheEyeIsWhole) {
  for (const double degrees : {25.0, 60.0, 90.0}) {
    for (const double distance : {1.71, 1.8, 2.2, 4.0, 12.0}) {
      // In the middle, near the side, with the centre beside the picture, and beside the eye.
      for (const double aside : {0.0, 0.3 * degrees, 0.75 * degrees, 89.0, 100.0}) {
        const Sphere sphere = sphere_at(distance, aside, 1.7);
        show({sphere});
        look(degrees);
        const auto expected = [&](const Vector& d) { return seen_of_one(sphere, d); };
        EXPECT_EQ(count_wrong(RenderQuality::draft, expected), 0)
            << degrees << "°, " << distance << " Å, " << aside << "° aside";
        EXPECT_LE(count_wrong_picks(expected), 2) << degrees << " " << distance << " " << aside;
      }
    }
  }
}

TEST_F(BallPicture, ATranslucentBallIsWhole) {
  style.ball_opacity = 0.5;
  for (const RenderQuality quality : {RenderQuality::draft, RenderQuality::medium}) {
    for (const double aside : {0.0, 20.0}) {
      const Sphere sphere = sphere_at(1.9, aside, 1.7);
      show({sphere});
      look(60);
      EXPECT_EQ(count_wrong(quality, [&](const Vector& d) { return seen_of_one(sphere, d); }), 0)
          << aside;
    }
  }
}

// Checks the first picture after the size has grown, with exact transparency. A picture of opaque
// balls may come in between.
TEST_F(BallPicture, ATranslucentBallIsWholeWhenThePictureHasGrown) {
  const Sphere sphere = sphere_at(1.9, 20, 1.7);
  const auto draw = [&](float opacity, int width, int height) {
    style.ball_opacity = opacity;
    scene.set_style(style);
    scene.render(width, height, RenderQuality::medium);
  };
  show({sphere});
  look(60);
  for (const auto& [width, height] : {std::pair{kWidth / 2, kHeight}, {kWidth, kHeight / 2}}) {
    for (const bool opaque_between : {false, true}) {
      draw(0.5, width, height);
      if (opaque_between) draw(1, kWidth, kHeight);
      style.ball_opacity = 0.5;
      scene.set_style(style);
      EXPECT_EQ(count_wrong(RenderQuality::medium,
                            [&](const Vector& d) { return seen_of_one(sphere, d); }),
                0)
          << width << " x " << height << opaque_between;
    }
  }
}

TEST_F(BallPicture, ASavedPictureShowsTheSameBall) {
  const Sphere sphere = sphere_at(1.9, 20, 1.7);
  show({sphere});
  look(60);
  int expected = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      expected += seen_of_one(sphere, direction(x + 0.5, y + 0.5)) == Seen::red;
    }
  }
  const Image image = scene.grab(kWidth, kHeight, true);
  int drawn = 0;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) drawn += image.rgba[i] > 127;
  EXPECT_GT(expected, kWidth * kHeight / 2);
  EXPECT_LT(expected, kWidth * kHeight);
  EXPECT_NEAR(drawn, expected, 0.005 * expected);
}

// Depth is per pixel, so where balls meet the nearer one is seen.
TEST_F(BallPicture, OfBallsThatMeetTheNearerIsSeen) {
  const std::vector<Sphere> spheres{
      {{0.5, 0.3, -2.6}, 1.7}, {{-1.2, -0.4, -3.0}, 1.9}, {{2.2, 1.2, -2.9}, 1.5}};
  const auto expected = [&](const Vector& d) {
    double nearest = 1e30;
    Seen seen = Seen::nothing;
    for (std::size_t k = 0; k < spheres.size(); ++k) {
      const auto inside = inside_of(spheres[k], d);
      if (!inside || inside->first >= nearest) continue;
      nearest = inside->first;
      seen = k == 0 ? Seen::red : Seen::blue;
    }
    return seen;
  };
  show(spheres);
  for (const double degrees : {25.0, 90.0}) {
    look(degrees);
    EXPECT_EQ(count_wrong(RenderQuality::draft, expected), 0) << degrees;
    EXPECT_LE(count_wrong_picks(expected), 2) << degrees;
  }
}

// An opaque ball around the eye is not drawn. A translucent one is seen in all directions.
TEST_F(BallPicture, ABallAroundTheEyeIsSeenWhereItIsTranslucent) {
  for (const Sphere& sphere : {sphere_at(1.2, 0, 1.7), sphere_at(1.65, 140, 1.7)}) {
    show({sphere});
    look(60);
    const auto nothing = [](const Vector&) { return Seen::nothing; };
    EXPECT_EQ(count_wrong(RenderQuality::draft, nothing), 0);
    EXPECT_EQ(count_wrong_picks(nothing), 0);
    style.ball_opacity = 0.5;
    scene.set_style(style);
    const auto everywhere = [](const Vector&) { return Seen::red; };
    EXPECT_EQ(count_wrong(RenderQuality::draft, everywhere), 0);
    EXPECT_EQ(count_wrong(RenderQuality::medium, everywhere), 0);
    style.ball_opacity = 1;
  }
}

// A ball is cut, also around the eye. Its kept part ends in a cap.
TEST_F(BallPicture, ACutBallIsWholeUpToItsCap) {
  style.cut = Cut(read_clip("z=-2").resolved({0, 0, 1}, {0, 0, 0}), {0, 0, 0});
  for (const Sphere& sphere : {sphere_at(2.4, 0, 1.7), sphere_at(2.6, 30, 1.9),
                               sphere_at(2.0, 10, 2.4), sphere_at(1.0, 170, 4.0)}) {
    show({sphere});
    look(70);
    const auto expected = [&](const Vector& d) {
      auto inside = inside_of(sphere, d);
      if (!inside) return Seen::nothing;
      inside->first = std::max(inside->first, style.cut.along({{0, 0, 0}, d}).from);
      inside->second = std::min(inside->second, style.cut.along({{0, 0, 0}, d}).to);
      return inside->first < inside->second && inside->first > 0 ? Seen::red : Seen::nothing;
    };
    EXPECT_EQ(count_wrong(RenderQuality::draft, expected), 0) << sphere.radius;
    EXPECT_LE(count_wrong_picks(expected), 2) << sphere.radius;
  }
}

}  // namespace
}  // namespace alphascope
