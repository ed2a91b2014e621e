#include "core/measure/clipped.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/measure/ball_geometry.hpp"
#include "core/measure/ball_stars.hpp"
#include "core/measure/convex_piece.hpp"
#include "core/measure/exact_sum.hpp"
#include "core/measure/ortho_coordinates.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

// Faces of a piece are made by balls, or by the tetrahedron's own planes.
constexpr std::uint32_t kOwnFace = 0xffffffff;
constexpr std::size_t kGrain = 16;  // tetrahedra

struct Planes {
  VectorInt normal[4];  // opposite each ball, out
  double length[4];
  double volume;  // lattice units
  bool is_mirrored;
};

struct Clipped {
  double volume, free_volume, area;  // lattice units
};

// Cuts tetrahedra one after another, for one thread.
class Clipper {
 public:
  Clipper(const Triangulation& triangulation, const BallSet& balls,
          const LatticeAlpha& alpha_on_lattice, const std::vector<std::uint32_t>& tetrahedron_of)
      : triangulation_(triangulation),
        balls_(balls),
        alpha_(alpha_on_lattice),
        stars_(triangulation, tetrahedron_of) {}

  Clipped clip(std::uint32_t t) {
    for (int m = 0; m < 4; ++m) {
      index_[m] = triangulation_.tetrahedra[t][m];
      ball_[m] = ball(index_[m]);
    }
    planes_ = planes();
    sums_ = {};
    met_.assign(index_.begin(), index_.end());
    visit_cells(0);
    if (cells_ == 0) {
      // Cells that meet the tetrahedron are neighbours of one another, but none was a corner's.
      met_.push_back(cell_of_middle());
      visit_cells(4);
    }
    return {planes_.volume, planes_.volume - sums_.inside.value(), sums_.area.value()};
  }

 private:
  GrownBall ball(BallIndex i) const {
    return grown_ball(balls_.centres[i], balls_.radii[i], alpha_);
  }

  // Those met from this one on, and their neighbours in the tetrahedron.
  void visit_cells(std::size_t from) {
    cells_ = 0;
    for (std::size_t n = from; n < met_.size(); ++n) {
      if (!cut_out_cell(met_[n])) continue;
      ++cells_;
      const SharedMeasures shared = piece_.shared_with_ball(ball(met_[n]).grown_radius);
      sums_.inside.add(shared.volume);
      sums_.area.add(shared.area);
      piece_.for_faces([&](std::uint32_t made_by) {
        const bool is_known =
            made_by == kOwnFace || std::find(met_.begin(), met_.end(), made_by) != met_.end();
        if (!is_known) met_.push_back(made_by);
      });
    }
  }

  // Downhill: whoever has not the least power at a point has a neighbour with less.
  BallIndex cell_of_middle() {
    Vector3<double> middle = {0, 0, 0};
    for (const GrownBall& corner : ball_) {
      middle = {middle.x + 0.25 * corner.x, middle.y + 0.25 * corner.y, middle.z + 0.25 * corner.z};
    }
    const auto power = [&](BallIndex i) {
      const GrownBall at = ball(i);
      const Vector3<double> d = {middle.x - at.x, middle.y - at.y, middle.z - at.z};
      return dot(d, d) - static_cast<double>(balls_.weight(i));
    };
    BallIndex lowest = index_[0];
    double least = power(lowest);
    for (bool falls = true; falls;) {
      falls = false;
      for (const BallIndex j : stars_.neighbours(lowest)) {
        const double other = power(j);
        if (other >= least) continue;
        least = other;
        lowest = j;
        falls = true;
        break;
      }
    }
    return lowest;
  }

  Planes planes() const {
    const LiftedInt b = lifted_vector(ball_[0], ball_[1]), c = lifted_vector(ball_[0], ball_[2]);
    const LiftedInt d = lifted_vector(ball_[0], ball_[3]);
    VectorInt n[4] = {{}, cross(c, d), cross(d, b), cross(b, c)};
    n[0] = {-n[1].x - n[2].x - n[3].x, -n[1].y - n[2].y - n[3].y, -n[1].z - n[2].z - n[3].z};
    const double six_volumes = exact_sum(d.x, n[3].x, d.y, n[3].y, d.z, n[3].z);
    Planes of;
    of.is_mirrored = six_volumes < 0;
    of.volume = std::fabs(six_volumes) / 6;
    for (int m = 0; m < 4; ++m) {
      // Those of a tetrahedron that is not mirrored point in.
      of.normal[m] = of.is_mirrored ? n[m] : VectorInt{-n[m].x, -n[m].y, -n[m].z};
      const auto normal = as_doubles(n[m]);
      of.length[m] = std::sqrt(dot(normal, normal));
    }
    return of;
  }

  // The tetrahedron as seen from ball i.
  void start(const GrownBall& from) {
    Vector3<double> corner[4];
    PieceFace face[4];
    LiftedInt to[4];
    for (int m = 0; m < 4; ++m) {
      to[m] = lifted_vector(from, ball_[m]);
      corner[m] = {static_cast<double>(to[m].x), static_cast<double>(to[m].y),
                   static_cast<double>(to[m].z)};
    }
    for (int m = 0; m < 4; ++m) {
      const VectorInt& n = planes_.normal[m];
      const LiftedInt& on = to[m == 0 ? 1 : 0];
      const auto normal = as_doubles(n);
      const double scale = 1 / planes_.length[m];
      face[m] = {{normal.x * scale, normal.y * scale, normal.z * scale},
                 exact_sum(n.x, on.x, n.y, on.y, n.z, on.z) * scale,
                 kOwnFace};
    }
    piece_.start(corner, face, planes_.is_mirrored);
  }

  bool cut_out_cell(BallIndex i) {
    const GrownBall from = ball(i);
    start(from);
    const auto cut = [&](BallIndex j) {
      const LiftedInt v = lifted_vector(from, ball(j));
      return piece_.cut(
          {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)},
          0.5 * static_cast<double>(v.c), j);
    };
    for (const BallIndex j : stars_.neighbours(i)) {
      if (!cut(j)) return false;
    }
    return true;
  }

  const Triangulation& triangulation_;
  const BallSet& balls_;
  const LatticeAlpha alpha_;
  BallStars stars_;
  std::array<BallIndex, 4> index_ = {};
  GrownBall ball_[4] = {};
  Planes planes_ = {};
  ConvexPiece piece_;
  std::vector<BallIndex> met_;  // balls whose cells may meet the tetrahedron
  std::size_t cells_ = 0;       // that do
  struct {
    NeumaierSum inside, area;
  } sums_;
};

}  // namespace

ClippedTetrahedra clipped_outside(const Triangulation& triangulation, const BallSet& balls,
                                  const LatticeAlpha& alpha_on_lattice,
                                  std::span<const std::uint32_t> tetrahedra, int threads,
                                  const RunContext& context) {
  for (const std::uint32_t t : tetrahedra) {
    if (t >= triangulation.tetrahedra.size()) {
      throw std::invalid_argument("the triangulation has no tetrahedron " + std::to_string(t));
    }
  }
  ClippedTetrahedra of;
  of.volume_angstrom3.resize(tetrahedra.size());
  of.free_volume_angstrom3.resize(tetrahedra.size());
  of.area_angstrom2.resize(tetrahedra.size());
  if (tetrahedra.empty()) return of;
  const std::vector<std::uint32_t> tetrahedron_of =
      tetrahedron_of_balls(triangulation, balls.size());
  const double unit = balls.lattice.unit_angstrom();
  tbb::enumerable_thread_specific<Clipper> clippers(
      [&] { return Clipper(triangulation, balls, alpha_on_lattice, tetrahedron_of); });
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute([&] {
    parallel_ranges(0, tetrahedra.size(), kGrain, [&](std::size_t first, std::size_t end) {
      context.cancel.throw_if_cancelled();
      Clipper& clipper = clippers.local();
      for (std::size_t n = first; n < end; ++n) {
        const Clipped clipped = clipper.clip(tetrahedra[n]);
        of.volume_angstrom3[n] = clipped.volume * unit * unit * unit;
        of.free_volume_angstrom3[n] = clipped.free_volume * unit * unit * unit;
        of.area_angstrom2[n] = clipped.area * unit * unit;
      }
    });
  });
  return of;
}

}  // namespace alphascope
