// SPDX-License-Identifier: GPL-3.0-or-later
// BallGeometry: conversion from the lattice, bounding box and principal axes. Also radii as drawn.
#include "ui/scene/mesh/ball_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/alpha.hpp"
#include "core/geometry/grown_radius.hpp"
#include "core/geometry/principal_axes.hpp"
#include "core/predicates/spanning_balls.hpp"

namespace alphascope {
namespace {

Matrix3 covariance(const std::vector<std::array<float, 3>>& points) {
  std::array<double, 3> mean{};
  for (const auto& p : points) {
    for (int k = 0; k < 3; ++k) mean[k] += p[k] / static_cast<double>(points.size());
  }
  Matrix3 sum{};
  for (const auto& p : points) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) sum[i][j] += (p[i] - mean[i]) * (p[j] - mean[j]);
    }
  }
  return sum;
}

// The longest axis points right, the second upwards. Their signs are fixed (largest component
// positive), so that a molecule always appears the same way.
Matrix3 view_axes(const std::vector<std::array<float, 3>>& points) {
  Matrix3 a = covariance(points), vectors;
  diagonalise(a, vectors);
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int i, int j) { return a[i][i] > a[j][j]; });
  Matrix3 axes;
  for (int i = 0; i < 2; ++i) {
    for (int k = 0; k < 3; ++k) axes[i][k] = vectors[k][order[i]];
    const auto largest = std::max_element(axes[i].begin(), axes[i].end(), [](double x, double y) {
      return std::fabs(x) < std::fabs(y);
    });
    if (*largest < 0) {
      for (double& x : axes[i]) x = -x;
    }
  }
  const auto &u = axes[0], &v = axes[1];
  axes[2] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  return axes;
}

}  // namespace

BallGeometry::BallGeometry(const BallSet& balls) : dimension(dimension_of_centres(balls)) {
  if (balls.size() == 0) return;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{kInfinity, kInfinity, kInfinity};
  std::array<double, 3> high{-kInfinity, -kInfinity, -kInfinity};
  const double unit = balls.lattice.unit_angstrom();
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const LatticePoint& c = balls.centres[i];
    const std::array<double, 3> centre{c.x * unit, c.y * unit, c.z * unit};
    const double radius = balls.radii[i] * unit;
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], centre[k] - radius);
      high[k] = std::max(high[k], centre[k] + radius);
    }
  }
  for (int k = 0; k < 3; ++k) {
    origin[k] = 0.5 * (low[k] + high[k]);
    bounds[2 * k] = low[k] - origin[k];
    bounds[2 * k + 1] = high[k] - origin[k];
  }
  centres.resize(balls.size());
  radii.resize(balls.size());
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const LatticePoint& c = balls.centres[i];
    centres[i] = {static_cast<float>(c.x * unit - origin[0]),
                  static_cast<float>(c.y * unit - origin[1]),
                  static_cast<float>(c.z * unit - origin[2])};
    radii[i] = static_cast<float>(balls.radii[i] * unit);
  }
  axes = view_axes(centres);
}

std::vector<float> drawn_radii(const BallGeometry& balls, const BallStyle& style) {
  std::vector<float> result(balls.radii.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    double radius = balls.radii[i];
    if (style.grown) {
      radius = grown_radius(radius, style.solvent_radius, style.alpha);
    }
    result[i] = static_cast<float>(radius * style.scale);
  }
  return result;
}

}  // namespace alphascope
