#include "core/cavity/cavity_measures.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/cavity/tetrahedron_outside.hpp"
#include "core/measure/exact_sum.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

// Sums over the tetrahedra of one cavity, in their order.
struct CavitySums {
  NeumaierSum whole, volume, area, arc, offset_volume, offset_area, offset_overlap;
  std::size_t corners = 0;

  void add(const OutsidePart& part) {
    whole.add(part.whole);
    volume.add(part.volume);
    arc.add(part.arc);
    offset_volume.add(part.offset_volume);
    offset_area.add(part.offset_area);
    offset_overlap.add(part.offset_overlap);
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
        unit_(ground.balls->lattice.unit_angstrom()) {}

  std::vector<CavityMeasures> measure() {
    number_tetrahedra();
    std::vector<CavityMeasures> measures(cavities_.size());
    std::vector<double> area_of_ball(ground_.balls->size());
    for (std::size_t c = 0; c < cavities_.size(); ++c) {
      sum_tetrahedra(c, area_of_ball, measures[c]);
    }
    parallel_many(cavities_.size(), cancel_,
                  [&](std::size_t c) { measure_mouths(cavities_[c], measures[c]); });
    return measures;
  }

 private:
  // The parts of all tetrahedra of all cavities, one cavity after the other.
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

  OutsidePart part(std::uint32_t t) const {
    const auto& balls = ground_.triangulation->tetrahedra[t];
    FacesIn in;
    for (unsigned k = 0, e = 0; k < 4; ++k) {
      in.balls |= unsigned{in_.vertices[balls[k]]} << k;
      in.triangles |= unsigned{in_.triangles[ground_.incidence.triangles_of_tetrahedron[t][k]]}
                      << k;
      for (unsigned l = k + 1; l < 4; ++l, ++e) {
        in.edges |= unsigned{in_.edges[edge_of_tetrahedron(ground_.incidence, t, k, l)]} << e;
      }
    }
    const GrownBall grown[4] = {ball(balls[0]), ball(balls[1]), ball(balls[2]), ball(balls[3])};
    return outside_part(grown, in, scale_.solvent_on_lattice);
  }

  void sum_tetrahedra(std::size_t c, std::vector<double>& area_of_ball, CavityMeasures& measures) {
    const Cavity& cavity = cavities_[c];
    CavitySums sums;
    for (std::size_t n = 0; n < cavity.tetrahedra.size(); ++n) {
      const OutsidePart& part = parts_[first_[c] + n];
      const auto& balls = ground_.triangulation->tetrahedra[cavity.tetrahedra[n]];
      sums.add(part);
      for (std::size_t k = 0; k < 4; ++k) area_of_ball[balls[k]] += part.area[k];
    }
    for (const BallIndex v : cavity.atoms) {
      const GrownBall grown = ball(v);
      const double area = std::exchange(area_of_ball[v], 0);
      sums.area.add(area);
      if (area > kLeastArea * grown.square_radius) measures.lining.push_back(v);
      if (grown.square_radius == 0) continue;
      // A patch moved by the solvent radius into its ball.
      const double share = 1 - scale_.solvent_on_lattice / grown.grown_radius;
      sums.offset_volume.add(area * grown.grown_radius * (1 - share * share * share) / 3);
      sums.offset_area.add(area * share * share);
    }
    set_sums(sums, measures);
  }

  void set_sums(const CavitySums& sums, CavityMeasures& measures) const {
    const double square = unit_ * unit_, cube = square * unit_;
    measures.volume_of_tetrahedra_angstrom3 = sums.whole.value() * cube;
    measures.volume_sa_angstrom3 = sums.volume.value() * cube;
    measures.area_sa_angstrom2 = sums.area.value() * square;
    measures.volume_ms_angstrom3 = (sums.volume.value() + sums.offset_volume.value()) * cube;
    const double steiner = sums.offset_area.value();
    measures.area_ms_steiner_angstrom2 = steiner * square;
    measures.area_ms_angstrom2 = (steiner - 2 * sums.offset_overlap.value()) * square;
    measures.arc_length_angstrom = sums.arc.value() * unit_;
    measures.corners = sums.corners;
  }

  void measure_mouths(const Cavity& cavity, CavityMeasures& measures) const {
    for (const Mouth& mouth : cavity.mouths) {
      NeumaierSum area, length;
      for (const std::uint32_t f : mouth.triangles) {
        const auto& balls = ground_.incidence.triangles[f];
        FacesIn in;
        for (unsigned k = 0; k < 3; ++k) {
          in.balls |= unsigned{in_.vertices[balls[k]]} << k;
          in.edges |= unsigned{in_.edges[ground_.incidence.edges_of_triangle[f][k]]} << k;
        }
        const GrownBall grown[3] = {ball(balls[0]), ball(balls[1]), ball(balls[2])};
        const MouthPart part = mouth_part(grown, in);
        area.add(part.area);
        length.add(part.length);
      }
      measures.mouths.push_back({area.value() * unit_ * unit_, length.value() * unit_});
    }
  }

  GrownBall ball(BallIndex i) const {
    return grown_ball(ground_.balls->centres[i], ground_.balls->radii[i], scale_.alpha_on_lattice);
  }

  // Areas of spheres of radius 1 that are rounding errors of sums of angles.
  static constexpr double kLeastArea = 1e-11;

  const CavityGround& ground_;
  const Membership& in_;
  const std::vector<Cavity>& cavities_;
  const CavityScale scale_;
  const CancelToken& cancel_;
  const double unit_;  // Å
  std::vector<std::size_t> first_;
  ResultArray<OutsidePart> parts_;
};

}  // namespace

MouthMeasures CavityMeasures::all_mouths() const {
  MouthMeasures all;
  for (const MouthMeasures& mouth : mouths) {
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

std::vector<std::uint32_t> by_falling_volume(const std::vector<CavityMeasures>& measures) {
  std::vector<std::uint32_t> order(measures.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return measures[a].volume_sa_angstrom3 > measures[b].volume_sa_angstrom3;
  });
  return order;
}

}  // namespace alphascope
