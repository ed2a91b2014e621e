// SPDX-License-Identifier: GPL-3.0-or-later
// Tests picking in a cut scene. Nothing cut away is hit, kept parts are hit as before, and caps are
// hit where they are drawn.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/rgb8.hpp"
#include "tests/ui/molecule_fixture.hpp"
#include "ui/clip_handle.hpp"
#include "ui/scene/pick/pick.hpp"

namespace alphascope {
namespace {

using Vector = std::array<double, 3>;

Vector on(const Ray& ray, double depth) {
  Vector p = ray.start;
  for (std::size_t k = 0; k < 3; ++k) p[k] += depth * ray.direction[k];
  return p;
}

class CutPick : public ::testing::Test {
 protected:
  std::vector<Ray> rays(int count) const {
    std::mt19937 random(11);
    std::normal_distribution<double> direction;
    std::vector<Ray> result;
    for (int i = 0; i < count; ++i) {
      Ray ray;
      const auto& ball = geometry->centres[random() % geometry->centres.size()];
      double length = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        ray.start[k] = direction(random);
        length += ray.start[k] * ray.start[k];
      }
      for (std::size_t k = 0; k < 3; ++k) {
        ray.start[k] *= 80 / std::sqrt(length);
        ray.direction[k] = ball[k] + direction(random) - ray.start[k];
      }
      result.push_back(ray);
    }
    return result;
  }
  // Goes along the ray in small steps to the first point inside any ball. Returns the ball with the
  // least power distance there.
  std::optional<std::size_t> first_ball(const Ray& ray, const Cut& cut) const {
    constexpr double kStep = 2e-4;
    for (double t = 0.5; t < 1.6; t += kStep) {
      const Vector p = on(ray, t);
      if (!cut.keeps(p)) continue;
      std::optional<std::size_t> found;
      double least = 0;
      for (std::size_t i = 0; i < geometry->centres.size(); ++i) {
        double power = -double(geometry->radii[i]) * geometry->radii[i];
        for (std::size_t k = 0; k < 3; ++k) power += std::pow(p[k] - geometry->centres[i][k], 2);
        if (power < least) {
          least = power;
          found = i;
        }
      }
      if (found) return found;
    }
    return std::nullopt;
  }

  std::shared_ptr<const BallSet> balls = testing::rod(6);
  std::shared_ptr<const BallGeometry> geometry = std::make_shared<const BallGeometry>(*balls);
};

TEST_F(CutPick, BallsAreHitWhereTheyAreKept) {
  const BallPicker picker(geometry);
  const double margin = picker.margin(geometry->radii);
  int hits = 0, caps = 0, nothing = 0, other = 0;
  for (const char* text : {"x=0", "1,2,3=1", "z=0:3"}) {
    const Cut cut(read_clip(text).resolved({0, 0, 1}, {0, 0, 0}), {0, 0, 0});
    for (const Ray& ray : rays(60)) {
      const RayInterval kept = cut.along(ray);
      const auto found = picker.pick(geometry->radii, margin, ray, kept);
      const auto expected = first_ball(ray, cut);
      nothing += !found;
      if (found.has_value() != expected.has_value()) {
        ++other;  // it grazes a ball, or an edge of one
        continue;
      }
      if (!found) continue;
      ++hits;
      other += found->ball != *expected;
      const bool cap = std::fabs(found->depth - kept.from) * 80 < 0.05;
      caps += cap;
      EXPECT_TRUE(cap || cut.keeps(on(ray, found->depth)));
    }
  }
  EXPECT_GT(hits, 80);
  EXPECT_GT(caps, 20);
  EXPECT_GT(nothing, 8);
  EXPECT_LT(other, 6);
}

TEST_F(CutPick, TetrahedraAreHitInTheirCapsAndNowhereElse) {
  const AlphaComplex complex = testing::complex_of(balls, 2);
  const std::vector<Rgb8> colours = testing::two_colours(balls->size());
  const auto mesh =
      std::make_shared<const ComplexMesh>(build_mesh(*geometry, colours, complex, {}));
  const Cut cut(read_clip("1,1,0.2").resolved({}, {0, 0, 0}), {0, 0, 0});
  const auto caps = std::make_shared<const CapMesh>(
      build_cap_mesh(*geometry, colours, complex, {}, mesh->scale, cut));
  PickLayers layers = mesh_layers(mesh, geometry);
  layers.push_back(cap_layer(caps));
  int on_caps = 0, kept_hits = 0;
  for (const Ray& ray : rays(2000)) {
    const auto whole = nearest_hit(layers, {ray, 0});
    const auto hit = nearest_hit(layers, {ray, 0, cut.along(ray)});
    if (!hit) continue;
    EXPECT_EQ(hit->layer, "tetrahedra");
    const double depth = cut.kept[0].depth(hit->at);
    EXPECT_GT(depth, -1e-4);
    if (std::fabs(depth) < 1e-4) {
      ++on_caps;
      // The point is in the only tetrahedron there, on the inner side of its four planes.
      const auto& t = complex.tetrahedra.simplices.at(hit->index);
      for (std::size_t k = 0; k < 4; ++k) {
        RealPoint p[4];
        for (std::size_t j = 0; j < 4; ++j) {
          const auto& c = geometry->centres[t[(k + j) % 4]];
          p[j] = {c[0], c[1], c[2]};
        }
        const RealPoint n = cross(p[1] - p[0], p[2] - p[0]);
        const RealPoint at{hit->at[0], hit->at[1], hit->at[2]};
        EXPECT_GT(dot(n, at - p[0]) * dot(n, p[3] - p[0]), -1e-2);
      }
    } else if (whole && cut.keeps(whole->at)) {
      ++kept_hits;
      EXPECT_EQ(hit->index, whole->index);
    }
  }
  EXPECT_GT(on_caps, 100);
  EXPECT_GT(kept_hits, 100);
}

// Maps places of the file to the picture: 10 pixels for each Å, without perspective.
HandleView flat_view() {
  HandleView view;
  view.seen = [](const Vector& p) {
    return std::optional(PicturePoint{200 + 10 * p[0], 100 - 10 * p[1]});
  };
  return view;
}

TEST(ClipHandle, TheArrowMovesTheCutAsFarAsTheMouseGoes) {
  const Clip clip = read_clip("x=3").clip;
  const auto pivot = pivot_near(clip, {7, 2, 1});
  EXPECT_EQ(pivot, (Vector{3, 2, 1}));
  const ClipHandle handle = make_clip_handle(clip, pivot, flat_view(), 80);
  ASSERT_TRUE(handle.shown);
  EXPECT_NEAR(handle.middle[0], 230, 1e-9);
  EXPECT_GT(handle.tip[0], handle.middle[0] + 40);  // towards the part that is cut away
  EXPECT_EQ(part_at(handle, {handle.tip[0], handle.tip[1] + 3}, 5), HandlePart::move);
  EXPECT_EQ(part_at(handle, {handle.tip[0] + 30, handle.tip[1] + 30}, 5), HandlePart::none);
  EXPECT_DOUBLE_EQ(dragged(clip, handle, HandlePart::move, {25, 12}).position, 5.5);
  Clip flipped = clip;
  flipped.flipped = true;
  EXPECT_LT(make_clip_handle(flipped, pivot, flat_view(), 80).tip[0], handle.middle[0] - 40);
}

TEST(ClipHandle, ACutSeenFromTheFrontMovesUpAndDown) {
  const Clip clip = read_clip("z=3").clip;
  const ClipHandle handle = make_clip_handle(clip, {0, 0, 3}, flat_view(), 80);
  EXPECT_DOUBLE_EQ(dragged(clip, handle, HandlePart::move, {7, -20}).position, 5);
}

TEST(ClipHandle, TheRingTurnsTheCutAboutItsMiddle) {
  const Clip clip = read_clip("z=3").clip;
  const Vector pivot{1, 2, 3};
  const ClipHandle handle = make_clip_handle(clip, pivot, flat_view(), 80);
  EXPECT_EQ(part_at(handle, {handle.middle[0] + 80, handle.middle[1]}, 5), HandlePart::turn);
  const double quarter = 80 * M_PI / 2;  // pixels: a quarter of the way around
  const Clip right = dragged(clip, handle, HandlePart::turn, {quarter, 0});
  EXPECT_NEAR(right.normal[0], 1, 1e-9);  // the side that faced the viewer went to the right
  EXPECT_NEAR(right.position, 1, 1e-9);   // still through the pivot
  const Clip down = dragged(clip, handle, HandlePart::turn, {0, quarter});
  EXPECT_NEAR(down.normal[1], -1, 1e-9);
  EXPECT_NEAR(down.position, -2, 1e-9);
}

}  // namespace
}  // namespace alphascope
