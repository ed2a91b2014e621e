// See the header.
#include "core/geometry/principal_axes.hpp"

#include <algorithm>
#include <cmath>

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

MainAxis main_axis(const BallSet& balls) {
  constexpr std::size_t kMostLookedAt = 1'000'000;
  constexpr double kAlike = 0.01;  // of the largest spread; copies differ by rounding only
  const std::size_t stride = 1 + balls.size() / kMostLookedAt;
  RealPoint sum;
  double count = 0;
  for (std::size_t i = 0; i < balls.size(); i += stride, ++count) {
    sum = sum + real_point(balls.centres[i]);
  }
  const RealPoint middle = (1 / count) * sum;
  Matrix3 spread{}, vectors;
  for (std::size_t i = 0; i < balls.size(); i += stride) {
    const RealPoint p = real_point(balls.centres[i]) - middle;
    const double at[] = {p.x, p.y, p.z};
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) spread[j][k] += at[j] * at[k];
    }
  }
  diagonalise(spread, vectors);
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](std::size_t j, std::size_t k) { return spread[j][j] > spread[k][k]; });
  const auto of = [&](std::size_t n) { return spread[order[n]][order[n]]; };
  const bool flat = of(0) - of(1) <= kAlike * of(0) && of(1) - of(2) > kAlike * of(0);
  const std::size_t chosen = order[flat ? 2 : 0];
  MainAxis result;
  result.middle_angstrom = balls.lattice.unit_angstrom() * middle;
  const RealPoint axis{vectors[0][chosen], vectors[1][chosen], vectors[2][chosen]};
  // Its largest component is positive, so that a profile always begins at the same end.
  const double values[] = {axis.x, axis.y, axis.z};
  const double largest = *std::max_element(
      values, values + 3, [](double a, double b) { return std::fabs(a) < std::fabs(b); });
  if (of(0) > 0) result.axis = (largest < 0 ? -1.0 : 1.0) * unit_vector(axis);
  return result;
}

}  // namespace alphascope
