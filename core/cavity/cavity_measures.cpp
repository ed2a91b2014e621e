// SPDX-License-Identifier: GPL-3.0-or-later
// Measures cavities: sums over their tetrahedra in fixed point, so that no order of summation
// changes a bit.
#include "core/cavity/cavity_measures.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <optional>

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
#include "core/triangulation/buckets.hpp"
#include "core/triangulation/incidence.hpp"
#include "core/triangulation/membership.hpp"
#include "core/triangulation/triangulation_maker.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kGrain = 512;

// Units of the fixed-point sums, for all lengths, areas and volumes of one set of grown balls.
struct Scales {
  double length, area, volume;
};

Scales scales_of(const BallSet& balls, const CavityScale& scale) {
  double reach = 1 + std::fabs(scale.solvent_on_lattice);
  std::mutex mutex;
  parallel_ranges(0, balls.size(), kGrain, [&](std::size_t first, std::size_t end) {
    double own = 0;
    for (std::size_t i = first; i != end; ++i) {
      const LatticePoint& p = balls.centres[i];
      const GrownBall ball = grown_ball(p, balls.radii[i], scale.alpha_on_lattice);
      for (const std::int32_t x : {p.x, p.y, p.z}) own = std::max(own, std::fabs(double(x)));
      own = std::max(own, ball.grown_radius);
    }
    const std::lock_guard lock(mutex);
    reach = std::max(reach, own);
  });
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

  void add(const CavitySums& other) {
    whole.add(other.whole);
    volume.add(other.volume);
    area.add(other.area);
    arc.add(other.arc);
    offset_volume.add(other.offset_volume);
    offset_area.add(other.offset_area);
    offset_overlap.add(other.offset_overlap);
    corners += other.corners;
  }
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
        sum_(scales_of(*ground.balls, scale)),
        of_ball_(ground.balls->size()) {}

  std::vector<CavityMeasures> measure(TriangulationMaker* maker) {
    number_items();
    number_atoms_of_balls();
    sums_.resize(cavities_.size());
    add_tetrahedra(maker);
    std::vector<CavityMeasures> measures(cavities_.size());
    add_atoms();
    parallel_each(0, cavities_.size(), [&](std::size_t c) {
      if (cancel_.cancelled()) return;
      list_lining(c, measures[c]);
      set_sums(sums_[c], measures[c]);
      measure_mouths(cavities_[c], measures[c]);
    });
    cancel_.throw_if_cancelled();
    return measures;
  }

 private:
  // The tetrahedra or the atoms of all cavities, one cavity after the other.
  struct Items {
    std::vector<std::size_t> first{0};  // of each cavity; one more at the end
    ResultArray<std::uint32_t> index;

    // `list` of each cavity.
    void fill(const std::vector<Cavity>& cavities, std::vector<std::uint32_t> Cavity::*list,
              const CancelToken& cancel) {
      for (const Cavity& cavity : cavities) first.push_back(first.back() + (cavity.*list).size());
      index.resize(first.back());
      parallel_ranges(0, index.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        if (cancel.cancelled()) return;
        for (std::size_t n = begin, c = cavity_of(begin); n < end; ++c) {
          for (const std::size_t last = std::min(end, first[c + 1]); n < last; ++n)
            index[n] = (cavities[c].*list)[n - first[c]];
        }
      });
      cancel.throw_if_cancelled();
    }
    std::size_t size() const { return index.size(); }
    std::size_t cavity_of(std::size_t n) const {
      return static_cast<std::size_t>(std::upper_bound(first.begin(), first.end(), n) -
                                      first.begin()) -
             1;
    }
  };
  void number_items() {
    tetrahedra_.fill(cavities_, &Cavity::tetrahedra, cancel_);
    atoms_.fill(cavities_, &Cavity::atoms, cancel_);
    area_of_atom_.resize(atoms_.size());
    is_lining_.resize(atoms_.size());
    parallel_many(atoms_.size(), cancel_, [&](std::size_t n) { area_of_atom_[n].clear(); });
  }
  // For each ball its places among the atoms of all cavities. There are seldom more than two.
  void number_atoms_of_balls() {
    parallel_many(atoms_.size(), cancel_,
                  [&](std::size_t n) { of_ball_.count(atoms_.index[n], 1); });
    of_ball_.end_counting();
    place_.resize(atoms_.size());
    parallel_many(atoms_.size(), cancel_, [&](std::size_t n) {
      place_[of_ball_.place_for(atoms_.index[n])] = static_cast<std::uint32_t>(n);
    });
  }
  SharedFixedSum* area_of(BallIndex ball, std::size_t cavity) {
    for (std::uint32_t n = of_ball_.begin(ball); n < of_ball_.end(ball); ++n) {
      if (place_[n] >= atoms_.first[cavity] && place_[n] < atoms_.first[cavity + 1])
        return &area_of_atom_[place_[n]];
    }
    return nullptr;  // not in K_alpha, so without area
  }

  // Calls add(n, cavity, sums) for all items. Each thread sums on its own.
  template <class Add>
  void sum_by_cavity(const Items& items, const Add& add) {
    std::mutex mutex;
    parallel_ranges(0, items.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      if (cancel_.cancelled()) return;
      for (std::size_t n = begin, c = items.cavity_of(begin); n < end; ++c) {
        CavitySums own;
        for (const std::size_t last = std::min(end, items.first[c + 1]); n < last; ++n)
          add(n, c, own);
        const std::lock_guard lock(mutex);
        sums_[c].add(own);
      }
    });
    cancel_.throw_if_cancelled();
  }
  // A device has no pieces of balls that are smaller than the solvent radius.
  bool has_small_balls() const {
    return 0 != parallel_sum(0, ground_.balls->size(), kGrain, [&](std::size_t v, std::size_t end) {
             std::uint64_t small = 0;
             for (; v != end; ++v)
               small += ball(static_cast<BallIndex>(v)).grown_radius < scale_.solvent_on_lattice;
             return small;
           });
  }
  void add_tetrahedra(TriangulationMaker* maker) {
    std::optional<ResultArray<OutsidePart>> parts;
    if (maker != nullptr && !has_small_balls())
      parts = maker->outside_parts(in_, tetrahedra_.index, scale_.solvent_on_lattice, cancel_);
    sum_by_cavity(tetrahedra_, [&](std::size_t n, std::size_t c, CavitySums& sums) {
      const OutsidePart of = parts ? (*parts)[n] : part(tetrahedra_.index[n]);
      sums.add(of, sum_);
      const auto& balls = ground_.triangulation->tetrahedra[tetrahedra_.index[n]];
      for (std::size_t k = 0; k < 4; ++k) {
        if (SharedFixedSum* const area = area_of(balls[k], c)) area->add(of.area[k], sum_.area);
      }
    });
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
    const double area[4] = {part.area[0], part.area[1], part.area[2], part.area[3]};
    for (unsigned k = 0; k < 4; ++k) part.area[order[k]] = area[k];
    return part;
  }

  void add_atoms() {
    sum_by_cavity(atoms_, [&](std::size_t n, std::size_t, CavitySums& sums) {
      const GrownBall grown = ball(atoms_.index[n]);
      const double area = area_of_atom_[n].value(sum_.area);
      sums.area.add(area, sum_.area);
      is_lining_[n] = area > kLeastArea * grown.square_radius ? 1 : 0;
      if (grown.square_radius == 0) return;
      // The patch is moved by the solvent radius into its ball, but not beyond the ball's centre.
      const double share = std::max(0.0, 1 - scale_.solvent_on_lattice / grown.grown_radius);
      sums.offset_volume.add(area * grown.grown_radius * (1 - share * share * share) / 3,
                             sum_.volume);
      sums.offset_area.add(area * share * share, sum_.area);
    });
  }
  void list_lining(std::size_t c, CavityMeasures& measures) const {
    for (std::size_t n = atoms_.first[c]; n < atoms_.first[c + 1]; ++n) {
      if (is_lining_[n]) measures.lining.push_back(atoms_.index[n]);
    }
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
    measures.mouths.resize(cavity.mouths.size());
    parallel_each(0, cavity.mouths.size(), [&](std::size_t m) {
      if (!cancel_.cancelled()) measures.mouths[m] = measured(cavity.mouths[m]);
    });
  }
  MouthMeasures measured(const Mouth& mouth) const {
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
    return {area.value(sum_.area) * unit_ * unit_, length.value(sum_.length) * unit_};
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
  Items tetrahedra_, atoms_;
  Buckets of_ball_;
  ResultArray<std::uint32_t> place_;  // among atoms_, by ball
  ResultArray<SharedFixedSum> area_of_atom_;
  ResultArray<std::uint8_t> is_lining_;  // of each atom
  std::vector<CavitySums> sums_;
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
                                             const CavityScale& scale, const CancelToken& cancel,
                                             TriangulationMaker* maker) {
  return CavityMeasurer(ground, membership, cavities, scale, cancel).measure(maker);
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
