// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the regular triangulation and K_alpha in rationals.
#include "tests/support/reference/rational_oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/geometry/alpha.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"

namespace alphascope::testing {
namespace {

using Vector = std::vector<Rational>;

// Solves a·x = b by elimination; false when a is singular.
bool solve(std::vector<Vector> a, Vector b, Vector& x) {
  const std::size_t n = b.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    while (pivot < n && a[pivot][c] == 0) ++pivot;
    if (pivot == n) return false;
    std::swap(a[c], a[pivot]);
    std::swap(b[c], b[pivot]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == c || a[r][c] == 0) continue;
      const Rational factor = a[r][c] / a[c][c];
      for (std::size_t k = c; k < n; ++k) a[r][k] -= factor * a[c][k];
      b[r] -= factor * b[c];
    }
  }
  x.resize(n);
  for (std::size_t c = 0; c < n; ++c) x[c] = b[c] / a[c][c];
  return true;
}

std::array<Rational, 3> centre(const BallSet& balls, BallIndex i) {
  return {Rational(balls.centres[i].x), Rational(balls.centres[i].y), Rational(balls.centres[i].z)};
}

Rational weight(const BallSet& balls, BallIndex i) {
  return Rational(balls.radii[i]) * Rational(balls.radii[i]);
}

// Height of the lifted point: |p|² - w.
Rational height(const BallSet& balls, BallIndex i) {
  const auto p = centre(balls, i);
  return p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - weight(balls, i);
}

std::vector<BallIndex> visible_balls(const BallSet& balls) {
  std::map<std::array<int, 3>, BallIndex> at;
  for (BallIndex i = 0; i < balls.size(); ++i) {
    const LatticePoint& p = balls.centres[i];
    const auto [entry, fresh] = at.insert({{p.x, p.y, p.z}, i});
    if (!fresh && balls.radii[i] > balls.radii[entry->second]) entry->second = i;
  }
  std::vector<BallIndex> visible;
  for (const auto& [p, i] : at) visible.push_back(i);
  return visible;  // sorted lexicographically by centres
}

// Axes onto which the centres project without loss of a dimension of their affine hull.
std::vector<int> spanning_axes(const BallSet& balls, const std::vector<BallIndex>& visible) {
  std::vector<Vector> rows;
  for (const BallIndex i : visible) {
    const auto p = centre(balls, i), o = centre(balls, visible[0]);
    rows.push_back({p[0] - o[0], p[1] - o[1], p[2] - o[2]});
  }
  std::vector<int> axes;
  std::size_t used = 0;
  for (int axis = 0; axis < 3; ++axis) {
    std::size_t pivot = used;
    while (pivot < rows.size() && rows[pivot][axis] == 0) ++pivot;
    if (pivot >= rows.size()) continue;
    std::swap(rows[used], rows[pivot]);
    for (std::size_t r = used + 1; r < rows.size(); ++r) {
      const Rational factor = rows[r][axis] / rows[used][axis];
      for (int k = 0; k < 3; ++k) rows[r][k] -= factor * rows[used][k];
    }
    axes.push_back(axis);
    ++used;
  }
  return axes;
}

// True when the lifted point of e is above the hyperplane through the cell's points. Every height
// grows by a positive infinitesimal, which is infinitely larger for a lexicographically larger
// centre. `visible` is in that order, and the cell holds positions in it.
bool above(const std::vector<Rational>& heights, const std::vector<std::size_t>& cell,
           const Vector& barycentric, std::size_t e) {
  Rational difference = heights[e];
  for (std::size_t n = 0; n < cell.size(); ++n) difference -= barycentric[n] * heights[cell[n]];
  if (difference != 0) return difference > 0;
  for (std::size_t at = heights.size(); at-- > 0;) {
    if (at == e) return true;
    const auto n = std::find(cell.begin(), cell.end(), at) - cell.begin();
    if (static_cast<std::size_t>(n) < cell.size() && barycentric[n] != 0) return barycentric[n] < 0;
  }
  return true;
}

class CellSearch {
 public:
  CellSearch(const BallSet& balls, const std::vector<BallIndex>& visible)
      : balls_(balls), visible_(visible), axes_(spanning_axes(balls, visible)) {
    for (const BallIndex i : visible) heights_.push_back(height(balls, i));
  }

  // Calls found(cell) with the cell's ball indices in ascending order.
  template <class Found>
  void run(const Found& found) {
    std::vector<std::size_t> cell;
    extend(0, cell, found);
  }

 private:
  template <class Found>
  void extend(std::size_t from, std::vector<std::size_t>& cell, const Found& found) {
    if (cell.size() == axes_.size() + 1) {
      if (!valid(cell)) return;
      std::vector<BallIndex> simplex;
      for (const std::size_t at : cell) simplex.push_back(visible_[at]);
      std::sort(simplex.begin(), simplex.end());
      found(simplex);
      return;
    }
    for (std::size_t at = from; at < visible_.size(); ++at) {
      cell.push_back(at);
      extend(at + 1, cell, found);
      cell.pop_back();
    }
  }

  Rational coordinate(std::size_t at, std::size_t row) const {
    return row == axes_.size() ? Rational(1) : centre(balls_, visible_[at])[axes_[row]];
  }

  bool valid(const std::vector<std::size_t>& cell) const {
    const std::size_t n = cell.size();
    std::vector<Vector> matrix(n, Vector(n));
    for (std::size_t row = 0; row < n; ++row) {
      for (std::size_t column = 0; column < n; ++column) {
        matrix[row][column] = coordinate(cell[column], row);
      }
    }
    Vector barycentric;
    if (!solve(matrix, Vector(n), barycentric)) return false;
    for (std::size_t e = 0; e < visible_.size(); ++e) {
      if (std::find(cell.begin(), cell.end(), e) != cell.end()) continue;
      Vector right(n);
      for (std::size_t row = 0; row < n; ++row) right[row] = coordinate(e, row);
      solve(matrix, right, barycentric);
      if (!above(heights_, cell, barycentric, e)) return false;
    }
    return true;
  }

  const BallSet& balls_;
  const std::vector<BallIndex>& visible_;
  std::vector<int> axes_;
  std::vector<Rational> heights_;
};

std::vector<BallIndex> without(const std::vector<BallIndex>& simplex, std::size_t dropped) {
  std::vector<BallIndex> face = simplex;
  face.erase(face.begin() + static_cast<std::ptrdiff_t>(dropped));
  return face;
}

template <int N>
void add_simplex(SimplexList<N>& list, const std::vector<BallIndex>& simplex,
                 const Rational& value) {
  if (simplex.size() != N) return;
  std::array<BallIndex, N> s{};
  std::copy(simplex.begin(), simplex.end(), s.begin());
  list.simplices.push_back(s);
  list.alpha_values.push_back(nearest_float(value));
  list.classes.push_back(SimplexClass::singular);
}

// Finds classes by asking every simplex of one dimension more. `largest`: vertices of the largest
// simplices, all of which are interior.
template <int N>
void set_classes(SimplexList<N>& list, const SimplexList<N + 1>& cofaces, int largest) {
  for (std::size_t n = 0; n < list.size(); ++n) {
    std::size_t count = 0, interior = 0;
    for (std::size_t c = 0; c < cofaces.size(); ++c) {
      const auto& coface = cofaces.simplices[c];
      if (!std::includes(coface.begin(), coface.end(), list.simplices[n].begin(),
                         list.simplices[n].end())) {
        continue;
      }
      ++count;
      interior += cofaces.classes[c] == SimplexClass::interior;
    }
    const bool filled = N == largest       ? true
                        : N + 1 == largest ? count == 2
                                           : count > 0 && interior == count;
    list.classes[n] = filled      ? SimplexClass::interior
                      : count > 0 ? SimplexClass::regular
                                  : SimplexClass::singular;
  }
}

}  // namespace

Orthosphere orthosphere(const BallSet& balls, std::span<const BallIndex> simplex) {
  const auto p = centre(balls, simplex[0]);
  const std::size_t n = simplex.size() - 1;
  std::vector<std::array<Rational, 3>> d(n);
  Vector half(n), t;
  for (std::size_t k = 0; k < n; ++k) {
    const auto q = centre(balls, simplex[k + 1]);
    for (int a = 0; a < 3; ++a) d[k][a] = q[a] - p[a];
    // q and p have equal powers at p + x: 2 d·x = |d|² + w_p - w_q.
    half[k] = (d[k][0] * d[k][0] + d[k][1] * d[k][1] + d[k][2] * d[k][2] +
               weight(balls, simplex[0]) - weight(balls, simplex[k + 1])) /
              2;
  }
  std::vector<Vector> gram(n, Vector(n));
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      gram[a][b] = d[a][0] * d[b][0] + d[a][1] * d[b][1] + d[a][2] * d[b][2];
    }
  }
  solve(gram, half, t);
  std::array<Rational, 3> x;
  for (std::size_t k = 0; k < n; ++k) {
    for (int a = 0; a < 3; ++a) x[a] += t[k] * d[k][a];
  }
  return {p[0] + x[0], p[1] + x[1], p[2] + x[2],
          x[0] * x[0] + x[1] * x[1] + x[2] * x[2] - weight(balls, simplex[0])};
}

Rational power_excess(const BallSet& balls, const Orthosphere& sphere, BallIndex m) {
  const auto q = centre(balls, m);
  const Rational dx = sphere.x - q[0], dy = sphere.y - q[1], dz = sphere.z - q[2];
  return dx * dx + dy * dy + dz * dz - weight(balls, m) - sphere.rho;
}

bool perturbed_conflict(const BallSet& balls, std::span<const BallIndex> tetrahedron, BallIndex m) {
  std::vector<BallIndex> five(tetrahedron.begin(), tetrahedron.end());
  five.push_back(m);
  std::sort(five.begin(), five.end(),
            [&](BallIndex a, BallIndex b) { return balls.centres[a] < balls.centres[b]; });
  std::vector<Rational> heights;
  std::vector<std::size_t> cell;
  std::vector<Vector> matrix(4, Vector(4));
  Vector right(4), barycentric;
  std::size_t at_m = 0;
  for (std::size_t at = 0; at < 5; ++at) {
    heights.push_back(height(balls, five[at]));
    const auto p = centre(balls, five[at]);
    if (five[at] == m) at_m = at;
    for (std::size_t row = 0; row < 4; ++row) {
      const Rational coordinate = row == 3 ? Rational(1) : p[row];
      (five[at] == m ? right[row] : matrix[row][cell.size()]) = coordinate;
    }
    if (five[at] != m) cell.push_back(at);
  }
  solve(matrix, right, barycentric);
  return !above(heights, cell, barycentric, at_m);
}

float nearest_float(const Rational& value) {
  const float infinity = std::numeric_limits<float>::infinity();
  const Rational overflow(mpz_class("340282356779733661637539395458142568448"));  // 2^128 - 2^103
  if (value >= overflow) return infinity;
  if (value <= -overflow) return -infinity;
  float around = static_cast<float>(value.get_d());
  if (std::isinf(around)) around = std::nextafter(around, 0.0f);
  float best = around;
  Rational best_distance = abs(value - Rational(around));
  for (const float f : {std::nextafter(around, -infinity), std::nextafter(around, infinity)}) {
    if (std::isinf(f)) continue;
    const Rational distance = abs(value - Rational(f));
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(f, &exponent), 24));
    if (distance < best_distance || (distance == best_distance && mantissa % 2 == 0)) {
      best = f;
      best_distance = distance;
    }
  }
  return best;
}

RationalOracle::RationalOracle(const BallSet& balls) : balls_(balls) {
  const std::vector<BallIndex> visible = visible_balls(balls);
  if (visible.empty()) return;
  std::vector<std::map<std::vector<BallIndex>, std::vector<std::vector<BallIndex>>>> levels(5);
  CellSearch(balls, visible).run([&](const std::vector<BallIndex>& cell) {
    levels[cell.size()][cell];
  });
  for (std::size_t size = 4; size > 1; --size) {
    for (const auto& [simplex, cofaces] : levels[size]) {
      for (std::size_t v = 0; v < size; ++v)
        levels[size - 1][without(simplex, v)].push_back(simplex);
    }
  }
  for (std::size_t size = 4; size >= 1; --size) {
    for (const auto& [simplex, cofaces] : levels[size]) {
      const Orthosphere sphere = orthosphere(balls, simplex);
      const bool free = std::all_of(visible.begin(), visible.end(), [&](BallIndex m) {
        return power_excess(balls, sphere, m) >= 0;
      });
      Rational value = sphere.rho;
      if (!free) {
        value = alpha_values_.at(cofaces.at(0));
        for (const auto& coface : cofaces) value = std::min(value, alpha_values_.at(coface));
      }
      alpha_values_[simplex] = value;
    }
  }
}

// `alpha` must be finite.
Rational rational(const LatticeAlpha& alpha) {
  if (alpha.is_double()) return Rational(alpha.below);
  std::string digits = alpha.text();
  const std::size_t point = digits.find('.');
  const std::size_t places = point == std::string::npos ? 0 : digits.size() - point - 1;
  if (point != std::string::npos) digits.erase(point, 1);
  Rational value(mpz_class(digits, 10), mpz_class("1" + std::string(places, '0')));
  value.canonicalize();
  return value;
}

AlphaComplex RationalOracle::complex(const LatticeAlpha& alpha_on_lattice) const {
  return complex_with_largest(alpha_on_lattice, 4);
}

AlphaComplex RationalOracle::own_complex(const LatticeAlpha& alpha_on_lattice) const {
  return complex_with_largest(alpha_on_lattice, dimension() + 1);
}

int RationalOracle::dimension() const {
  std::size_t largest = 0;
  for (const auto& [simplex, value] : alpha_values_) largest = std::max(largest, simplex.size());
  return static_cast<int>(largest) - 1;
}

AlphaComplex RationalOracle::complex_with_largest(const LatticeAlpha& alpha_on_lattice,
                                                  int largest) const {
  AlphaComplex complex;
  complex.lattice = balls_.lattice;
  complex.alpha_on_lattice = alpha_on_lattice;
  const bool infinite = std::isinf(alpha_on_lattice.below);
  const Rational alpha = infinite ? Rational(0) : rational(alpha_on_lattice);
  for (const auto& [simplex, value] : alpha_values_) {  // in lexicographic order
    if (infinite ? alpha_on_lattice.below < 0 : value > alpha) {
      continue;
    }
    add_simplex(complex.vertices, simplex, value);
    add_simplex(complex.edges, simplex, value);
    add_simplex(complex.triangles, simplex, value);
    add_simplex(complex.tetrahedra, simplex, value);
  }
  for (SimplexClass& c : complex.tetrahedra.classes) c = SimplexClass::interior;
  set_classes(complex.triangles, complex.tetrahedra, largest);
  set_classes(complex.edges, complex.triangles, largest);
  set_classes(complex.vertices, complex.edges, largest);
  complex.hash = complex_hash(complex);
  return complex;
}

}  // namespace alphascope::testing
