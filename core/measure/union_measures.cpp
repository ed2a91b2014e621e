// SPDX-License-Identifier: GPL-3.0-or-later
// Sums the terms of all simplices in private sums of the threads, and turns them into measures in
// Å.
#include "core/measure/union_measures.hpp"

#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <stdexcept>

#include "core/complex/alpha_complex.hpp"
#include "core/measure/ball_sums.hpp"
#include "core/measure/edge_rows.hpp"
#include "core/measure/exact_sum.hpp"
#include "core/measure/simplex_terms.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

// The number of simplices that a thread takes at a time, and of balls in one term of the total.
constexpr std::size_t kPart = 2048, kBlock = 4096;
// Bytes that the private sums of all threads may take together.
constexpr std::size_t kMostPrivate = std::size_t{1} << 30;

struct Values {
  static constexpr bool kDerivatives = false;
  static constexpr int kCount = kMeasuredQuantities;
};
struct ValuesAndDerivatives {
  static constexpr bool kDerivatives = true;
  static constexpr int kCount = kMeasuredQuantities + 7;
};

struct Scales {
  PerQuantity<double> of;
  double length, wall;
};
// The places of a ball's sums: the quantities, then the derivatives.
constexpr std::size_t kAreaSlope = kMeasuredQuantities, kAreaGradient = kAreaSlope + 1,
                      kVolumeGradient = kAreaGradient + 3;
constexpr std::size_t place(MeasuredQuantity q) {
  return static_cast<std::size_t>(q);
}
// length and wall are only for derivatives.
template <class What>
Scales scales_of(const GrownBall& ball) {
  if (!What::kDerivatives || !(ball.grown_radius > 0)) return {quantity_scales(ball), 0, 0};
  const int bits = bits_above(ball.grown_radius);
  return {quantity_scales(ball), fixed_scale(bits + kLengthBits),
          fixed_scale(2 * bits + kWallBits)};
}

struct Scene {
  std::vector<GrownBall> balls;
  std::vector<Scales> scales;
  std::vector<std::uint8_t> open;  // 1: in the complex, and not interior
  EdgeRows rows;
};

// The sums of one thread.
template <class What>
class PrivateSums {
 public:
  static constexpr bool kDerivatives = What::kDerivatives;
  using Sums = std::array<FixedSum, What::kCount>;
  explicit PrivateSums(const Scene& scene) : scene_(scene), sums_(scene.balls.size(), Sums{}) {}

  const GrownBall& ball(BallIndex i) const { return scene_.balls[i]; }
  const Sums& sums(BallIndex i) const { return sums_[i]; }
  void add(MeasuredQuantity q, BallIndex i, double x) {
    sums_[i][place(q)] += fixed_term(x, scene_.scales[i].of[q]);
  }
  void area_slope(BallIndex i, double x) {
    sums_[i][kAreaSlope] += fixed_term(x, scene_.scales[i].length);
  }
  void area_gradient(BallIndex i, const Vector3<double>& v) {
    add_vector(kAreaGradient, i, v, scene_.scales[i].length);
  }
  void volume_gradient(BallIndex i, const Vector3<double>& v) {
    add_vector(kVolumeGradient, i, v, scene_.scales[i].wall);
  }

 private:
  void add_vector(std::size_t first, BallIndex i, const Vector3<double>& v, double scale) {
    sums_[i][first] += fixed_term(v.x, scale);
    sums_[i][first + 1] += fixed_term(v.y, scale);
    sums_[i][first + 2] += fixed_term(v.z, scale);
  }
  const Scene& scene_;
  std::vector<Sums> sums_;
};

template <class What>
Scene make_scene(const BallSet& balls, const AlphaComplex& complex) {
  Scene scene;
  scene.balls.resize(balls.size());
  scene.scales.resize(balls.size());
  scene.open.assign(balls.size(), 0);
  parallel_ranges(0, balls.size(), kBlock, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      scene.balls[i] = grown_ball(balls.centres[i], balls.radii[i], complex.alpha_on_lattice);
      scene.scales[i] = scales_of<What>(scene.balls[i]);
    }
  });
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    scene.open[complex.vertices.simplices[v][0]] = is_open(complex.vertices.classes[v]) ? 1 : 0;
  }
  scene.rows = EdgeRows(balls.size(), complex.edges.simplices);
  return scene;
}

template <class Sink>
void add_vertex(const AlphaComplex& complex, const Scene& scene, std::size_t v, Sink& sink) {
  const BallIndex i = complex.vertices.simplices[v][0];
  if (scene.open[i]) vertex_terms(i, sink);
}
template <class Sink>
void add_edge(const AlphaComplex& complex, const Scene& scene, std::size_t e, Sink& sink) {
  const auto& [i, j] = complex.edges.simplices[e];
  const bool ends[2] = {scene.open[i] != 0, scene.open[j] != 0};
  if (ends[0] || ends[1]) edge_terms({i, j}, ends, is_open(complex.edges.classes[e]), sink);
}
template <class Sink>
void add_triangle(const AlphaComplex& complex, const Scene&, std::size_t f, Sink& sink) {
  const auto& [i, j, k] = complex.triangles.simplices[f];
  const int sides = open_sides(complex.triangles.classes[f]);
  if (sides > 0) triangle_terms({i, j, k}, sides, sink);
}
// The faces without a tetrahedron behind them, as bits by the opposite ball.
std::uint32_t open_faces(const SimplexList<3>& triangles, const BallIndex (&i)[4]) {
  std::uint32_t open = 0;
  for (std::uint32_t m = 0; m < 4; ++m) {
    const std::size_t face = find_triangle(
        triangles.simplices, {i[m == 0 ? 1 : 0], i[m <= 1 ? 2 : 1], i[m == 3 ? 2 : 3]});
    open |= std::uint32_t{is_open(triangles.classes[face])} << m;
  }
  return open;
}
template <class Sink>
void add_tetrahedron(const AlphaComplex& complex, const Scene& scene, std::size_t t, Sink& sink) {
  const auto& [i, j, k, l] = complex.tetrahedra.simplices[t];
  const BallIndex ball[4] = {i, j, k, l};
  OpenFaces open = open_balls_and_edges(
      ball, [&](BallIndex b) { return scene.open[b] != 0; },
      [&](BallIndex a, BallIndex b) {
        return is_open(complex.edges.classes[scene.rows.find(complex.edges.simplices, a, b)]);
      });
  if constexpr (Sink::kDerivatives) {
    if (open.edges != 0) open.faces = open_faces(complex.triangles, ball);
  }
  tetrahedron_terms(ball, open, sink);
}

// Parts of all four lists. A free thread takes the next part.
class Parts {
 public:
  explicit Parts(const AlphaComplex& complex)
      : sizes_{complex.tetrahedra.size(), complex.triangles.size(), complex.edges.size(),
               complex.vertices.size()} {}
  // Calls visit(list, begin, end). The lists come by falling dimension, those that take longest
  // first.
  template <class Visit>
  void take(const Visit& visit) {
    for (std::size_t list = 0; list < 4; ++list) {
      for (;;) {
        const std::size_t begin = next_[list].fetch_add(kPart, std::memory_order_relaxed);
        if (begin >= sizes_[list]) break;
        visit(list, begin, std::min(begin + kPart, sizes_[list]));
      }
    }
  }

 private:
  std::array<std::size_t, 4> sizes_;
  std::array<std::atomic<std::size_t>, 4> next_ = {};
};

template <class Sink>
void add_part(const AlphaComplex& complex, const Scene& scene, std::size_t list, std::size_t begin,
              std::size_t end, Sink& sink) {
  const auto each = [&](auto add) {
    for (std::size_t s = begin; s < end; ++s) add(complex, scene, s, sink);
  };
  switch (list) {
    case 0:
      return each([](auto&... all) { add_tetrahedron(all...); });
    case 1:
      return each([](auto&... all) { add_triangle(all...); });
    case 2:
      return each([](auto&... all) { add_edge(all...); });
    default:
      return each([](auto&... all) { add_vertex(all...); });
  }
}

template <class What>
std::vector<PrivateSums<What>> sum_simplices(const AlphaComplex& complex, const Scene& scene,
                                             const RunContext& context) {
  const std::size_t bytes = std::max<std::size_t>(1, scene.balls.size()) * 8 * What::kCount;
  const std::size_t workers = std::min<std::size_t>(tbb::this_task_arena::max_concurrency(),
                                                    std::max<std::size_t>(1, kMostPrivate / bytes));
  std::vector<PrivateSums<What>> sums;
  sums.reserve(workers);
  for (std::size_t w = 0; w < workers; ++w) sums.emplace_back(scene);
  Parts parts(complex);
  parallel_each(0, workers, [&](std::size_t w) {
    parts.take([&](std::size_t list, std::size_t begin, std::size_t end) {
      context.cancel.throw_if_cancelled();
      add_part(complex, scene, list, begin, end, sums[w]);
    });
  });
  return sums;
}

template <class What>
class Results {
 public:
  Results(const AlphaComplex& complex, const Scene& scene,
          const std::vector<PrivateSums<What>>& sums)
      : unit_(complex.lattice.unit_angstrom()), scene_(scene), sums_(sums) {}

  void fill(const BallSet& balls, UnionMeasures& measures, UnionDerivatives* derivatives) const {
    const std::size_t n = scene_.balls.size();
    each_quantity([&](MeasuredQuantity q) { measures.of_ball[q].resize(n); });
    if (derivatives != nullptr) {
      derivatives->area_by_centre_angstrom.resize(n);
      derivatives->volume_by_centre_angstrom2.resize(n);
      derivatives->area_by_radius_angstrom.resize(n);
      derivatives->volume_by_radius_angstrom2.resize(n);
    }
    parallel_ranges(0, n, kBlock, [&](std::size_t first, std::size_t end) {
      for (std::size_t i = first; i < end; ++i) {
        const PerQuantity<double> ball = ball_results(static_cast<BallIndex>(i));
        each_quantity(
            [&](MeasuredQuantity q) { measures.of_ball[q][i] = in_angstrom(q, ball[q], unit_); });
        if constexpr (What::kDerivatives) {
          fill_derivatives(i, balls.radii[i], ball[MeasuredQuantity::area], *derivatives);
        }
      }
    });
  }

 private:
  double value(BallIndex i, std::size_t n, double scale) const {
    FixedSum sum = 0;
    for (const auto& part : sums_) sum += part.sums(i)[n];
    return sum_value(sum, scale);
  }
  PerQuantity<double> ball_results(BallIndex i) const {
    PerQuantity<double> sums;
    each_quantity(
        [&](MeasuredQuantity q) { sums[q] = value(i, place(q), scene_.scales[i].of[q]); });
    return ball_measures(scene_.balls[i].grown_radius, scene_.open[i] != 0, sums);
  }
  void fill_derivatives(std::size_t i, double radius, double area, UnionDerivatives& to) const {
    const auto ball = static_cast<BallIndex>(i);
    const Scales& scales = scene_.scales[i];
    const auto gradient = [&](std::size_t first, double scale) {
      return Gradient{value(ball, first, scale), value(ball, first + 1, scale),
                      value(ball, first + 2, scale)};
    };
    const Gradient a = gradient(kAreaGradient, scales.length),
                   v = gradient(kVolumeGradient, scales.wall);
    to.area_by_centre_angstrom[i] = {a.x * unit_, a.y * unit_, a.z * unit_};
    to.volume_by_centre_angstrom2[i] = {v.x * unit_ * unit_, v.y * unit_ * unit_,
                                        v.z * unit_ * unit_};
    // d sqrt(r² + alpha) / dr = r / R.
    const double grown = scene_.balls[i].grown_radius;
    const double slope = grown > 0 ? radius / grown : 0;
    const double by_grown =
        grown > 0 ? 2 * area / grown + value(ball, kAreaSlope, scales.length) : 0;
    to.area_by_radius_angstrom[i] = by_grown * slope * unit_;
    to.volume_by_radius_angstrom2[i] = area * slope * unit_ * unit_;
  }

  const double unit_;  // Å
  const Scene& scene_;
  const std::vector<PrivateSums<What>>& sums_;
};

// The sum of all values, in blocks of fixed length that threads can share.
double total(const std::vector<double>& values) {
  const std::size_t blocks = (values.size() + kBlock - 1) / kBlock;
  std::vector<NeumaierSum> sums(blocks);
  parallel_each(0, blocks, [&](std::size_t b) {
    const std::size_t end = std::min(values.size(), (b + 1) * kBlock);
    for (std::size_t i = b * kBlock; i < end; ++i) sums[b].add(values[i]);
  });
  NeumaierSum all;
  for (const NeumaierSum& sum : sums) {
    all.add(sum.sum);
    all.add(sum.lost);
  }
  return all.value();
}

template <class What>
void measure(const BallSet& balls, const AlphaComplex& complex, UnionDerivatives* derivatives,
             const RunContext& context, UnionMeasures& measures) {
  const Scene scene = make_scene<What>(balls, complex);
  const auto sums = sum_simplices<What>(complex, scene, context);
  Results<What>(complex, scene, sums).fill(balls, measures, derivatives);
  each_quantity([&](MeasuredQuantity q) { measures.total[q] = total(measures.of_ball[q]); });
}

}  // namespace

void require_same_balls(const BallSet& balls, const AlphaComplex& complex) {
  if (complex.tetrahedra_only) {
    throw std::invalid_argument("a complex of tetrahedra alone has no area; compute the whole one");
  }
  const bool fits =
      complex.vertices.size() == 0 || complex.vertices.simplices.back()[0] < balls.size();
  if (!fits || complex.lattice != balls.lattice) {
    throw std::invalid_argument("the complex to be measured is of other balls");
  }
}

UnionMeasures measure_union(const BallSet& balls, const AlphaComplex& complex,
                            const MeasureOptions& options, const RunContext& context) {
  require_same_balls(balls, complex);
  UnionMeasures measures;
  const auto measured = [&] {
    if (options.derivatives == nullptr) {
      measure<Values>(balls, complex, nullptr, context, measures);
    } else {
      measure<ValuesAndDerivatives>(balls, complex, options.derivatives, context, measures);
    }
  };
  if (options.threads > 0) {
    tbb::task_arena(options.threads).execute(measured);
  } else {
    measured();
  }
  return measures;
}

}  // namespace alphascope
