// SPDX-License-Identifier: GPL-3.0-or-later
// Compares picking with brute force: every ball, triangle and line of a real complex, along many
// lines of sight. Also tests the simplex that each cell of a mesh stands for.
#include "ui/scene/pick/pick.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>

#include "core/engine/engine.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/rgb8.hpp"
#include "core/read/read_molecule.hpp"
#include "core/selection/prepare_balls.hpp"

namespace alphascope {
namespace {

using Vector = std::array<double, 3>;

Vector corner(const BallGeometry& balls, BallIndex i) {
  const auto& c = balls.centres[i];
  return {c[0], c[1], c[2]};
}
double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector combine(const Vector& a, double s, const Vector& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The depth at which the ray meets the triangle's plane, if inside all three sides. The program
// uses another method.
double plane_depth(const Vector& a, const Vector& b, const Vector& c, const Ray& ray) {
  constexpr double kNowhere = std::numeric_limits<double>::infinity();
  const Vector normal = cross(combine(b, -1, a), combine(c, -1, a));
  const double towards = dot(normal, ray.direction);
  if (towards == 0) return kNowhere;
  const double t = dot(normal, combine(a, -1, ray.start)) / towards;
  const Vector p = combine(ray.start, t, ray.direction);
  const Vector corners[] = {a, b, c};
  for (int k = 0; k < 3; ++k) {
    const Vector& from = corners[k];
    const Vector side = combine(corners[(k + 1) % 3], -1, from);
    if (dot(normal, cross(side, combine(p, -1, from))) < 0) return kNowhere;
  }
  return t >= 0 ? t : kNowhere;
}

class PickTest : public ::testing::Test {
 protected:
  void load(double alpha, MeshOptions options, bool tetrahedra_only = false) {
    const PreparedBalls prepared =
        prepare_balls(read_molecule(ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb"));
    geometry = std::make_shared<const BallGeometry>(*prepared.balls);
    complex = make_cgal_engine(prepared.balls)->compute({alpha, tetrahedra_only}, {});
    mesh = std::make_shared<const ComplexMesh>(
        build_mesh(*geometry, std::vector<Rgb8>(geometry->centres.size()), complex, options));
    layers = mesh_layers(mesh, geometry);
  }

  // Rays from all around towards places among the balls.
  std::vector<Ray> rays(int count) const {
    std::mt19937 random(7);
    std::normal_distribution<double> direction;
    std::uniform_int_distribution<std::size_t> ball(0, geometry->centres.size() - 1);
    std::vector<Ray> result;
    for (int i = 0; i < count; ++i) {
      Vector from{direction(random), direction(random), direction(random)};
      const double scale = 60 / std::sqrt(dot(from, from));
      for (double& x : from) x *= scale;
      Vector to = corner(*geometry, static_cast<BallIndex>(ball(random)));
      for (double& x : to) x += direction(random);
      result.push_back({from, combine(to, -1, from)});
    }
    return result;
  }

  std::optional<Hit> in_layer(std::string_view id, const PickLine& line) const {
    for (const PickLayer& layer : layers) {
      if (layer.id == id) return layer.pick(line);
    }
    return std::nullopt;
  }

  std::shared_ptr<const BallGeometry> geometry;
  AlphaComplex complex;
  std::shared_ptr<const ComplexMesh> mesh;
  PickLayers layers;
};

TEST_F(PickTest, BallsAsWithoutBoxes) {
  load(0, {});
  const BallPicker picker(geometry);
  for (const double scale : {0.3, 1.0, 2.5}) {
    const std::vector<float> radii = drawn_radii(*geometry, {.scale = scale});
    const double margin = picker.margin(radii);
    int hits = 0;
    for (const Ray& ray : rays(2000)) {
      const auto expected = pick_ball(*geometry, radii, ray),
                 found = picker.pick(radii, margin, ray);
      ASSERT_EQ(found.has_value(), expected.has_value());
      if (!found) continue;
      EXPECT_EQ(found->ball, expected->ball);
      ++hits;
    }
    EXPECT_GT(hits, 600) << scale;
  }
}

// The balls are in order or shuffled. Picking must find the same ball, and test few of them.
TEST(BoxTree, TriesFewThingsInAnyOrder) {
  constexpr int kSide = 36;
  auto ordered = std::make_shared<BallGeometry>();
  for (int i = 0; i < kSide * kSide * kSide; ++i) {
    const auto at = [](int k) { return 2.0f * static_cast<float>(k % kSide); };
    ordered->centres.push_back({at(i), at(i / kSide), at(i / kSide / kSide)});
    ordered->radii.push_back(0.7f);
  }
  auto shuffled = std::make_shared<BallGeometry>(*ordered);
  std::shuffle(shuffled->centres.begin(), shuffled->centres.end(), std::mt19937(3));
  for (const auto& balls : {ordered, shuffled}) {
    const auto box = [&](std::size_t i) {
      const auto& c = balls->centres[i];
      return Box{{c[0] - 1, c[1] - 1, c[2] - 1}, {c[0] + 1, c[1] + 1, c[2] + 1}};
    };
    const BoxTree tree(balls->centres.size(), box);
    const BallPicker picker(balls);
    std::size_t tried = 0, hits = 0;
    for (int i = 0; i < 100; ++i) {
      const Ray ray{{-50, 11.0 + 0.37 * i, 62.0 - 0.41 * i}, {1, 0.01 * i, -0.005 * i}};
      tree.visit([&](const Box& b) { return meets(ray, b, 0, 1e9); },
                 [&](std::size_t) { ++tried; });
      const auto expected = pick_ball(*balls, balls->radii, ray);
      const auto found = picker.pick(balls->radii, picker.margin(balls->radii), ray);
      ASSERT_EQ(expected.has_value(), found.has_value());
      if (!found) continue;
      EXPECT_EQ(found->ball, expected->ball);
      ++hits;
    }
    EXPECT_GT(hits, 50u);
    EXPECT_LT(tried / 100, balls->centres.size() / 20);
  }
}

TEST(BoxTree, StopsWhenCancelled) {
  const CancelToken cancel;
  std::atomic<std::size_t> asked{0};
  constexpr std::size_t kThings = std::size_t{1} << 22;
  const auto box = [&](std::size_t i) {
    if (++asked == 1000) cancel.cancel();
    const auto x = static_cast<float>(i);
    return Box{{x, x, x}, {x, x, x}};
  };
  EXPECT_THROW(BoxTree(kThings, box, cancel), Cancelled);
  EXPECT_LT(asked, kThings / 2);
}

TEST_F(PickTest, FacesOfTetrahedra) {
  constexpr int kFaces[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};
  // Without shrinking, translucent tetrahedra have all faces, and others only outer ones. Both show
  // the same faces first.
  for (const bool translucent : {false, true}) {
    load(3, {.translucent = translucent});
    int hits = 0;
    for (const Ray& ray : rays(400)) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto& t : complex.tetrahedra.simplices) {
        for (const auto& f : kFaces) {
          nearest =
              std::min(nearest, plane_depth(corner(*geometry, t[f[0]]), corner(*geometry, t[f[1]]),
                                            corner(*geometry, t[f[2]]), ray));
        }
      }
      const auto hit = in_layer("tetrahedra", {ray, 0});
      ASSERT_EQ(hit.has_value(), std::isfinite(nearest));
      if (!hit) continue;
      EXPECT_NEAR(hit->depth, nearest, 1e-6);
      // The named tetrahedron has a face there.
      const HitSimplex simplex = hit_simplex(*hit, complex);
      double own = std::numeric_limits<double>::infinity();
      for (const auto& f : kFaces) {
        own = std::min(own, plane_depth(corner(*geometry, simplex.balls.at(f[0])),
                                        corner(*geometry, simplex.balls.at(f[1])),
                                        corner(*geometry, simplex.balls.at(f[2])), ray));
      }
      EXPECT_NEAR(own, hit->depth, 1e-6);
      EXPECT_EQ(simplex.kind, SimplexClass::interior);
      ++hits;
    }
    EXPECT_GT(hits, 200);
  }
}

TEST_F(PickTest, TrianglesAndBoundaryFaces) {
  for (const bool singular_only : {false, true}) {
    load(
        2,
        {.tetrahedra = false, .boundary = true, .triangles = true, .singular_only = singular_only});
    int hits = 0, faces = 0;
    for (const Ray& ray : rays(400)) {
      double nearest = std::numeric_limits<double>::infinity(),
             outside = std::numeric_limits<double>::infinity();
      std::size_t expected = 0, expected_outside = 0;
      for (std::size_t i = 0; i < complex.triangles.size(); ++i) {
        const auto& t = complex.triangles.simplices[i];
        const double depth = plane_depth(corner(*geometry, t[0]), corner(*geometry, t[1]),
                                         corner(*geometry, t[2]), ray);
        const SimplexClass kind = complex.triangles.classes[i];
        if ((!singular_only || kind == SimplexClass::singular) && depth < nearest) {
          nearest = depth;
          expected = i;
        }
        if (kind == SimplexClass::regular && depth < outside) {
          outside = depth;
          expected_outside = i;
        }
      }
      const auto hit = in_layer("triangles", {ray, 0}), face = in_layer("boundary", {ray, 0});
      ASSERT_EQ(hit.has_value(), std::isfinite(nearest));
      ASSERT_EQ(face.has_value(), std::isfinite(outside));
      const auto named = [&](const Hit& h, std::size_t i) {
        const auto& t = complex.triangles.simplices[i];
        const HitSimplex simplex = hit_simplex(h, complex);
        EXPECT_EQ(simplex.balls, std::vector<BallIndex>(t.begin(), t.end()));
        EXPECT_EQ(simplex.kind, complex.triangles.classes[i]);
        EXPECT_EQ(simplex.angstrom2,
                  complex.lattice.square_angstrom(complex.triangles.alpha_values[i]));
        EXPECT_TRUE(has_simplex(complex, simplex.balls));
      };
      if (hit) named(*hit, expected), ++hits;
      if (face) named(*face, expected_outside), ++faces;
    }
    EXPECT_GT(hits, 40);
    EXPECT_GT(faces, 150);
  }
}

TEST_F(PickTest, LinesWithinTheirSpread) {
  load(1.4, {.tetrahedra = false, .edges = true, .singular_only = false});
  constexpr double kSpread = 0.3;  // per length of the direction: the lines lie about one away
  int hits = 0;
  for (const Ray& ray : rays(100)) {
    // Uses many points on each line instead of a formula.
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& e : complex.edges.simplices) {
      const Vector a = corner(*geometry, e[0]), along = combine(corner(*geometry, e[1]), -1, a);
      for (int i = 0; i <= 100; ++i) {
        const Vector p = combine(combine(a, i / 100.0, along), -1, ray.start);
        const double t = dot(p, ray.direction) / dot(ray.direction, ray.direction);
        const Vector beside = combine(p, -t, ray.direction);
        if (t > 0 && std::sqrt(dot(beside, beside)) <= kSpread * t) {
          nearest = std::min(nearest, std::sqrt(dot(beside, beside)));
        }
      }
    }
    const auto hit = in_layer("edges", {ray, kSpread});
    EXPECT_TRUE(hit.has_value() || !std::isfinite(nearest));
    if (!hit) continue;
    ++hits;
    // The named line comes that near.
    const HitSimplex edge = hit_simplex(*hit, complex);
    ASSERT_EQ(edge.balls.size(), 2u);
    const Vector a = corner(*geometry, edge.balls[0]),
                 along = combine(corner(*geometry, edge.balls[1]), -1, a);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 100; ++i) {
      const Vector p = combine(combine(a, i / 100.0, along), -1, ray.start);
      const double t = dot(p, ray.direction) / dot(ray.direction, ray.direction);
      const Vector beside = combine(p, -t, ray.direction);
      least = std::min(least, std::sqrt(dot(beside, beside)) - kSpread * t);
    }
    EXPECT_LE(least, 0.02);
  }
  EXPECT_GT(hits, 60);
  for (const Ray& ray : rays(100)) EXPECT_FALSE(in_layer("edges", {ray, 0})) << "no width";
}

TEST_F(PickTest, TheNearestLayerWinsAndSaysWhere) {
  load(3, {.boundary = true, .edges = true, .singular_only = false});
  ASSERT_EQ(layers.size(), 3u);
  int edges = 0, faces = 0;
  for (const Ray& ray : rays(300)) {
    const PickLine line{ray, 0.06};  // Å: the direction reaches to the balls
    const auto hit = nearest_hit(layers, line);
    for (const PickLayer& layer : layers) {
      const auto other = layer.pick(line);
      if (!other) continue;
      ASSERT_TRUE(hit);
      EXPECT_LE(hit->depth, other->depth);
    }
    if (!hit) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_DOUBLE_EQ(hit->at[k], ray.start[k] + hit->depth * ray.direction[k]);
    }
    edges += hit->layer == "edges";
    faces += hit->layer == "boundary";
  }
  EXPECT_GT(edges, 15) << "a line wins over the faces that it bounds";
  EXPECT_GT(faces, 15);
}

TEST_F(PickTest, TetrahedraOnlyHaveNeitherClassesNorAlphaValues) {
  load(3, {.tetrahedra = false, .boundary = true}, true);
  int hits = 0;
  for (const Ray& ray : rays(100)) {
    const auto hit = nearest_hit(layers, {ray, 0});
    if (!hit) continue;
    ++hits;
    const HitSimplex face = hit_simplex(*hit, complex);
    EXPECT_EQ(face.balls.size(), 3u);
    EXPECT_FALSE(face.kind);
    EXPECT_FALSE(face.angstrom2);
    EXPECT_TRUE(has_simplex(complex, face.balls));
  }
  EXPECT_GT(hits, 10);
}

TEST_F(PickTest, WhatTheComplexHas) {
  load(1.4, {});
  for (const auto& e : complex.edges.simplices) EXPECT_TRUE(has_simplex(complex, {e[0], e[1]}));
  EXPECT_FALSE(has_simplex(complex, {0, 326}));
  EXPECT_FALSE(has_simplex(complex, {0, 100, 200, 326}));
}

}  // namespace
}  // namespace alphascope
