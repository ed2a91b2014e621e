// SPDX-License-Identifier: GPL-3.0-or-later
// Measures cavities: sums over their tetrahedra in fixed point, so that no order of summation
// changes a bit.
#include "core/cavity/cavity_measures.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/tetrahedron_order.hpp"
#include "core/cavity/tetrahedron_outside.hpp"
#include "core/complex/face_class.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/measure/exact_sum.hpp"
#include "core/measure/wide_fixed_sum.hpp"
#include "core/predicates/orthosphere.hpp"
#include "core/run/parallel.hpp"
#include "core/triangulation/hash_steps.hpp"
#include "core/triangulation/incidence.hpp"
#include "core/triangulation/membership.hpp"

namespace alphascope {
namespace {

// Units of the fixed-point sums, for all lengths, areas and volumes of one set of grown balls.
struct Scales {
  double length, area, volume;
};

Scales scales_of(const BallSet& balls, const CavityScale& scale) {
  double reach = 1 + std::fabs(scale.solvent_on_lattice);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const LatticePoint& p = balls.centres[i];
    const GrownBall ball = grown_ball(p, balls.radii[i], scale.alpha_on_lattice);
    for (const std::int32_t x : {p.x, p.y, p.z}) reach = std::max(reach, std::fabs(double(x)));
    reach = std::max(reach, ball.grown_radius);
  }
  // `reach` bounds all coordinates and radii. No term exceeds 16 times the square or the cube of
  // twice `reach`.
  const int bits = bits_above(reach) + 1;
  return {WideFixedSum::scale(bits + 4), WideFixedSum::scale(2 * bits + 4),
          WideFixedSum::scale(3 * bits + 4)};
}

// Sums over the tetrahedra of one cavity; the same bits in any order.
struct CavitySums {
  WideFixedSum whole, volume, area, arc, offset_volume, offset_area, offset_overlap;
  std::size_t corners = 0;

  void add(const OutsidePart& part, const Scales& of) {
    whole.add(part.whole, of.volume);
    volume.add(part.volume, of.volume);
    arc.add(part.arc, of.length);
    offset_volume.add(part.offset_volume, of.volume);
    offset_area.add(part.offset_area, of.area);
    offset_overlap.add(part.offset_overlap, of.area);
    corners += part.corners;
  }
};

class CavityMeasurer {
 public:
  CavityMeasurer(const CavityGround& ground, const Membership& membership, const Cavities& cavities,
                 const CavityScale& scale, const CancelToken& cancel)
      : ground_(ground),
        in_(membership),
        cavities_(cavities.cavities),
        scale_(scale),
        cancel_(cancel),
        unit_(ground.balls->lattice.unit_angstrom()),
        sum_(scales_of(*ground.balls, scale)) {}

  std::vector<CavityMeasures> measure() {
    number_tetrahedra();
    std::vector<CavityMeasures> measures(cavities_.size());
    // Between cavities all sums of a thread are 0.
    tbb::enumerable_thread_specific<std::vector<WideFixedSum>> area_of_ball(
        [&] { return std::vector<WideFixedSum>(ground_.balls->size()); });
    parallel_each(0, cavities_.size(), [&](std::size_t c) {
      if (cancel_.cancelled()) return;
      sum_tetrahedra(c, area_of_ball.local(), measures[c]);
      measure_mouths(cavities_[c], measures[c]);
    });
    cancel_.throw_if_cancelled();
    return measures;
  }

 private:
  // Computes the parts of all tetrahedra of all cavities, one cavity after the other.
  void number_tetrahedra() {
    first_.assign(1, 0);
    for (const Cavity& cavity : cavities_)
      first_.push_back(first_.back() + cavity.tetrahedra.size());
    ResultArray<std::uint32_t> tetrahedra(first_.back());
    for (std::size_t c = 0; c < cavities_.size(); ++c) {
      std::copy(cavities_[c].tetrahedra.begin(), cavities_[c].tetrahedra.end(),
                tetrahedra.begin() + static_cast<std::ptrdiff_t>(first_[c]));
    }
    parts_.resize(tetrahedra.size());
    parallel_many(parts_.size(), cancel_, [&](std::size_t n) { parts_[n] = part(tetrahedra[n]); });
  }

  // Takes the balls of a tetrahedron by their centres, so that the order of the file changes no
  // bit.
  OutsidePart part(std::uint32_t t) const {
    const auto& balls = ground_.triangulation->tetrahedra[t];
    const std::array<unsigned, 4> order = order_by_centres(*ground_.balls, balls);
    FacesIn in;
    for (unsigned k = 0, e = 0; k < 4; ++k) {
      in.balls |= unsigned{in_.vertices[balls[order[k]]]} << k;
      in.triangles |=
          unsigned{in_.triangles[ground_.incidence.triangles_of_tetrahedron[t][order[k]]]} << k;
      for (unsigned l = k + 1; l < 4; ++l, ++e) {
        const auto [first, second] = std::minmax(order[k], order[l]);
        in.edges |= unsigned{in_.edges[edge_of_tetrahedron(ground_.incidence, t, first, second)]}
                    << e;
      }
    }
    const GrownBall grown[4] = {ball(balls[order[0]]), ball(balls[order[1]]), ball(balls[order[2]]),
                                ball(balls[order[3]])};
    OutsidePart part = outside_part(grown, in, scale_.solvent_on_lattice);
    const std::array<double, 4> area = part.area;
    for (unsigned k = 0; k < 4; ++k) part.area[order[k]] = area[k];
    return part;
  }

  void sum_tetrahedra(std::size_t c, std::vector<WideFixedSum>& area_of_ball,
                      CavityMeasures& measures) {
    const Cavity& cavity = cavities_[c];
    CavitySums sums;
    for (std::size_t n = 0; n < cavity.tetrahedra.size(); ++n) {
      const OutsidePart& part = parts_[first_[c] + n];
      const auto& balls = ground_.triangulation->tetrahedra[cavity.tetrahedra[n]];
      sums.add(part, sum_);
      for (std::size_t k = 0; k < 4; ++k) area_of_ball[balls[k]].add(part.area[k], sum_.area);
    }
    for (const BallIndex v : cavity.atoms) {
      const GrownBall grown = ball(v);
      const double area = std::exchange(area_of_ball[v], {}).value(sum_.area);
      sums.area.add(area, sum_.area);
      if (area > kLeastArea * grown.square_radius) measures.lining.push_back(v);
      if (grown.square_radius == 0) continue;
      // The patch is moved by the solvent radius into its ball, but not beyond the ball's centre.
      const double share = std::max(0.0, 1 - scale_.solvent_on_lattice / grown.grown_radius);
      sums.offset_volume.add(area * grown.grown_radius * (1 - share * share * share) / 3,
                             sum_.volume);
      sums.offset_area.add(area * share * share, sum_.area);
    }
    set_sums(sums, measures);
  }

  void set_sums(const CavitySums& sums, CavityMeasures& measures) const {
    const double square = unit_ * unit_, cube = square * unit_;
    const double volume = sums.volume.value(sum_.volume);
    measures.volume_of_tetrahedra_angstrom3 = sums.whole.value(sum_.volume) * cube;
    measures.volume_sa_angstrom3 = volume * cube;
    measures.area_sa_angstrom2 = sums.area.value(sum_.area) * square;
    measures.volume_ms_angstrom3 = (volume + sums.offset_volume.value(sum_.volume)) * cube;
    const double steiner = sums.offset_area.value(sum_.area);
    measures.area_ms_steiner_angstrom2 = steiner * square;
    measures.area_ms_angstrom2 = (steiner - 2 * sums.offset_overlap.value(sum_.area)) * square;
    measures.arc_length_angstrom = sums.arc.value(sum_.length) * unit_;
    measures.corners = sums.corners;
  }

  void measure_mouths(const Cavity& cavity, CavityMeasures& measures) const {
    for (const Mouth& mouth : cavity.mouths) {
      WideFixedSum area, length;
      for (const std::uint32_t f : mouth.triangles) {
        const auto& balls = ground_.incidence.triangles[f];
        const std::array<unsigned, 3> order = order_by_centres(*ground_.balls, balls);
        FacesIn in;
        for (unsigned k = 0; k < 3; ++k) {
          in.balls |= unsigned{in_.vertices[balls[order[k]]]} << k;
          in.edges |= unsigned{in_.edges[ground_.incidence.edges_of_triangle[f][order[k]]]} << k;
        }
        const GrownBall grown[3] = {ball(balls[order[0]]), ball(balls[order[1]]),
                                    ball(balls[order[2]])};
        const MouthPart part = mouth_part(grown, in);
        area.add(part.area, sum_.area);
        length.add(part.length, sum_.length);
      }
      measures.mouths.push_back(
          {area.value(sum_.area) * unit_ * unit_, length.value(sum_.length) * unit_});
    }
  }

  GrownBall ball(BallIndex i) const {
    return grown_ball(ground_.balls->centres[i], ground_.balls->radii[i], scale_.alpha_on_lattice);
  }

  // Areas below this are rounding errors of sums of angles (on a sphere of radius 1).
  static constexpr double kLeastArea = 1e-11;

  const CavityGround& ground_;
  const Membership& in_;
  const std::vector<Cavity>& cavities_;
  const CavityScale scale_;
  const CancelToken& cancel_;
  const double unit_;  // Å
  const Scales sum_;
  std::vector<std::size_t> first_;
  ResultArray<OutsidePart> parts_;
};

}  // namespace

MouthMeasures CavityMeasures::all_mouths() const {
  // Sorts by size, so that the sum does not depend on the order of the mouths.
  std::vector<MouthMeasures> sorted = mouths;
  std::sort(sorted.begin(), sorted.end(), [](const MouthMeasures& a, const MouthMeasures& b) {
    return a.area_angstrom2 != b.area_angstrom2 ? a.area_angstrom2 < b.area_angstrom2
                                                : a.length_angstrom < b.length_angstrom;
  });
  MouthMeasures all;
  for (const MouthMeasures& mouth : sorted) {
    all.area_angstrom2 += mouth.area_angstrom2;
    all.length_angstrom += mouth.length_angstrom;
  }
  return all;
}

std::vector<CavityMeasures> measure_cavities(const CavityGround& ground,
                                             const Membership& membership, const Cavities& cavities,
                                             const CavityScale& scale, const CancelToken& cancel) {
  return CavityMeasurer(ground, membership, cavities, scale, cancel).measure();
}

std::vector<std::uint32_t> by_falling_volume(const CavityGround& ground, const Cavities& cavities,
                                             const std::vector<CavityMeasures>& measures) {
  std::vector<std::uint32_t> order(measures.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto sink = [&](std::uint32_t c) -> const std::array<BallIndex, 4>& {
    return ground.triangulation->tetrahedra[cavities.cavities[c].deepest_sink];
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const double of_a = measures[a].volume_sa_angstrom3, of_b = measures[b].volume_sa_angstrom3;
    return of_a != of_b ? of_a > of_b : a != b && comes_first(*ground.balls, sink(a), sink(b));
  });
  return order;
}

}  // namespace alphascope
