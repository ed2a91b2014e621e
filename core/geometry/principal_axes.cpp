// SPDX-License-Identifier: GPL-3.0-or-later
// Eigenvectors of the spread of the centres, and the axes that follow from them.
#include "core/geometry/principal_axes.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/alpha.hpp"
#include "core/geometry/ball_set.hpp"

namespace alphascope {

// Cyclic Jacobi rotations. Ten sweeps reach double precision for 3 x 3 (it converges
// quadratically).
void diagonalise(Matrix3& a, Matrix3& vectors) {
  vectors = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int sweep = 0; sweep < 10; ++sweep) {
    for (std::size_t p = 0; p < 2; ++p) {
      for (std::size_t q = p + 1; q < 3; ++q) {
        if (std::fabs(a[p][q]) < 1e-300) continue;
        const double theta = 0.5 * std::atan2(2 * a[p][q], a[q][q] - a[p][p]);
        const double c = std::cos(theta), s = std::sin(theta);
        for (std::size_t k = 0; k < 3; ++k) {
          const double kp = a[k][p], kq = a[k][q];
          a[k][p] = c * kp - s * kq;
          a[k][q] = s * kp + c * kq;
        }
        for (std::size_t k = 0; k < 3; ++k) {
          const double pk = a[p][k], qk = a[q][k];
          a[p][k] = c * pk - s * qk;
          a[q][k] = s * pk + c * qk;
          const double vp = vectors[k][p], vq = vectors[k][q];
          vectors[k][p] = c * vp - s * vq;
          vectors[k][q] = s * vp + c * vq;
        }
      }
    }
  }
}

namespace {

struct Spread {
  RealPoint middle;  // lattice units
  // Unit vectors; the first is the one in which the centres spread most.
  std::array<RealPoint, 3> axes;
  std::array<double, 3> along;  // the spread
};

// The first component of largest size, up to rounding. Axes are turned so that it is positive. So
// profiles along an axis always begin at the same end.
double first_large_component(const RealPoint& axis) {
  constexpr double kAsLong = 1 - 1e-6;
  const double values[] = {axis.x, axis.y, axis.z};
  double longest = 0;
  for (const double value : values) longest = std::max(longest, std::fabs(value));
  std::size_t first = 0;
  while (std::fabs(values[first]) < kAsLong * longest) ++first;
  return values[first];
}

Spread spread_of(const BallSet& balls) {
  constexpr std::size_t kMostLookedAt = 1'000'000;
  const std::size_t stride = 1 + balls.size() / kMostLookedAt;
  RealPoint sum;
  double count = 0;
  for (std::size_t i = 0; i < balls.size(); i += stride, ++count) {
    sum = sum + real_point(balls.centres[i]);
  }
  Spread result;
  result.middle = (1 / count) * sum;
  Matrix3 spread{}, vectors;
  for (std::size_t i = 0; i < balls.size(); i += stride) {
    const RealPoint p = real_point(balls.centres[i]) - result.middle;
    const double at[] = {p.x, p.y, p.z};
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) spread[j][k] += at[j] * at[k];
    }
  }
  diagonalise(spread, vectors);
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](std::size_t j, std::size_t k) { return spread[j][j] > spread[k][k]; });
  for (std::size_t n = 0; n < 3; ++n) {
    const std::size_t of = order[n];
    result.along[n] = spread[of][of];
    const RealPoint axis{vectors[0][of], vectors[1][of], vectors[2][of]};
    result.axes[n] = (first_large_component(axis) < 0 ? -1.0 : 1.0) * unit_vector(axis);
  }
  return result;
}

// Spreads count as equal within this share of the largest one. The spreads of computed copies
// differ by rounding only, those in a crystal by more.
constexpr double kAlike = 0.01;  // of the largest spread
bool is_alike(const Spread& spread, std::size_t a, std::size_t b) {
  return spread.along[a] - spread.along[b] <= kAlike * spread.along[0];
}
// The index of the main axis.
std::size_t main_of(const Spread& spread) {
  return is_alike(spread, 0, 1) && !is_alike(spread, 1, 2) ? 2 : 0;
}

}  // namespace

MainAxis main_axis(const BallSet& balls) {
  const Spread spread = spread_of(balls);
  MainAxis result;
  result.middle_angstrom = balls.lattice.unit_angstrom() * spread.middle;
  if (spread.along[0] > 0) result.axis = spread.axes[main_of(spread)];
  return result;
}

std::vector<RealPoint> pore_axes(const BallSet& balls) {
  const Spread spread = spread_of(balls);
  if (!(spread.along[0] > 0)) return {MainAxis{}.axis};
  const std::size_t main = main_of(spread);
  if (main == 2 || is_alike(spread, 1, 2)) return {spread.axes[main]};
  return {spread.axes.begin(), spread.axes.end()};
}

}  // namespace alphascope
