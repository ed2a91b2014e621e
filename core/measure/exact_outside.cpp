// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts tetrahedra into the power cells of the balls that reach into them, and subtracts each ball's
// part.
#include "core/measure/exact_outside.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/measure/ball_geometry.hpp"
#include "core/measure/ball_stars.hpp"
#include "core/measure/convex_piece.hpp"
#include "core/measure/exact_sum.hpp"
#include "core/measure/ortho_coordinates.hpp"
#include "core/measure/triangle_distance.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

// Marks a face of a piece that is a face of the tetrahedron; other faces are named by their balls.
constexpr std::uint32_t kOwnFace = 0xffffffff;
constexpr std::size_t kGrain = 16;  // tetrahedra

struct Planes {
  VectorInt normal[4];  // outward, of the face opposite each ball
  double length[4];
  double volume;  // lattice units
  bool is_mirrored;
};

struct Clipped {
  double volume, free_volume, area;  // lattice units
};

// A wall of a ball's cell: the radical plane to a neighbour, as the ball sees it.
struct Wall {
  Vector3<double> normal;  // not of unit length
  double offset, length;   // along the normal; length of the normal
  double distance;  // of the plane from the ball's centre, negative if the centre is beyond it
  BallIndex ball;
};

// The walls of requested cells, the nearest wall first. Equally near walls are ordered by the
// centres of their balls, so that the order in the file has no influence. For one thread; results
// are kept for later calls.
class CellWalls {
 public:
  CellWalls(const Triangulation& triangulation, const BallSet& balls,
            const std::vector<std::uint32_t>& tetrahedron_of)
      : balls_(balls), stars_(triangulation, tetrahedron_of) {}

  // The walls of ball i. Valid until the next call.
  std::span<const Wall> of(BallIndex i) {
    const auto [at, is_new] = range_of_.try_emplace(i);
    if (is_new) at->second = make(i);
    return {walls_.data() + at->second.first, at->second.second};
  }

 private:
  std::pair<std::size_t, std::size_t> make(BallIndex i) {
    const std::size_t first = walls_.size();
    for (const BallIndex j : stars_.neighbours(i)) {
      const LiftedInt v =
          lifted_vector(balls_.centres[i], balls_.radii[i], balls_.centres[j], balls_.radii[j]);
      Wall wall{{static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)},
                0.5 * static_cast<double>(v.c),
                0,
                0,
                j};
      wall.length = std::sqrt(dot(wall.normal, wall.normal));
      wall.distance = wall.offset / wall.length;
      walls_.push_back(wall);
    }
    std::sort(walls_.begin() + static_cast<std::ptrdiff_t>(first), walls_.end(),
              [&](const Wall& a, const Wall& b) {
                return a.distance != b.distance ? a.distance < b.distance
                                                : balls_.centres[a.ball] < balls_.centres[b.ball];
              });
    return {first, walls_.size() - first};
  }

  const BallSet& balls_;
  BallStars stars_;
  std::unordered_map<BallIndex, std::pair<std::size_t, std::size_t>> range_of_;  // first, count
  std::vector<Wall> walls_;
};

// A ball and a tetrahedron that it may reach into.
struct Meeting {
  std::uint32_t tetrahedron;
  BallIndex ball;
};

// Finds the tetrahedra that a ball reaches into. A ball is convex, so these are connected through
// faces that it reaches, beginning with a tetrahedron of which it is a corner. For one thread.
class BallReach {
 public:
  BallReach(const Triangulation& triangulation, const BallSet& balls, const LatticeAlpha& alpha,
            const std::vector<std::uint32_t>& tetrahedron_of, const std::vector<bool>& asked)
      : triangulation_(triangulation),
        balls_(balls),
        alpha_(alpha),
        tetrahedron_of_(tetrahedron_of),
        asked_(asked),
        met_by_(triangulation.tetrahedra.size(), 0) {}

  void add(BallIndex i, std::vector<Meeting>& meetings) {
    const auto& first = triangulation_.tetrahedra[tetrahedron_of_[i]];
    // Hidden, so it has no cell.
    if (std::find(first.begin(), first.end(), i) == first.end()) return;
    const GrownBall ball = grown_ball(balls_.centres[i], balls_.radii[i], alpha_);
    if (ball.grown_radius == 0) return;
    // A little more than the radius, for roundings. A tetrahedron too many does no harm: the ball
    // takes no part of it.
    const double reach = ball.square_radius * (1 + 1e-9);
    ++balls_met_;
    open_.clear();
    meet(tetrahedron_of_[i]);
    for (std::size_t n = 0; n < open_.size(); ++n) {
      const std::uint32_t t = open_[n];
      if (asked_[t]) meetings.push_back({t, i});
      for (int k = 0; k < 4; ++k) {
        const Neighbour across = triangulation_.neighbours[t][k];
        if (across.is_hull() || met_by_[across.index()] == balls_met_) continue;
        if (!(square_from_face(i, t, k) > reach)) meet(across.index());
      }
    }
  }

 private:
  void meet(std::uint32_t t) {
    met_by_[t] = balls_met_;
    open_.push_back(t);
  }
  double square_from_face(BallIndex i, std::uint32_t t, int k) const {
    const auto& corners = triangulation_.tetrahedra[t];
    Vector3<double> to[3];
    for (int m = 0, n = 0; m < 4; ++m) {
      if (m == k) continue;
      if (corners[m] == i) return 0;
      const LatticePoint &p = balls_.centres[corners[m]], &from = balls_.centres[i];
      to[n++] = {static_cast<double>(p.x) - from.x, static_cast<double>(p.y) - from.y,
                 static_cast<double>(p.z) - from.z};
    }
    return square_from_triangle(to[0], to[1], to[2]);
  }

  const Triangulation& triangulation_;
  const BallSet& balls_;
  const LatticeAlpha alpha_;
  const std::vector<std::uint32_t>& tetrahedron_of_;
  const std::vector<bool>& asked_;
  std::vector<std::uint32_t> met_by_;  // per tetrahedron: count of the last ball that met it
  std::uint32_t balls_met_ = 0;
  std::vector<std::uint32_t> open_;
};

// Cuts tetrahedra one after another, for one thread.
class Clipper {
 public:
  Clipper(const Triangulation& triangulation, const BallSet& balls,
          const LatticeAlpha& alpha_on_lattice, const std::vector<std::uint32_t>& tetrahedron_of)
      : triangulation_(triangulation),
        balls_(balls),
        alpha_(alpha_on_lattice),
        walls_(triangulation, balls, tetrahedron_of) {}

  // `meetings` are those of all balls that reach into the tetrahedron.
  Clipped clip(std::uint32_t t, std::span<const Meeting> meetings) {
    index_ = triangulation_.tetrahedra[t];
    std::sort(index_.begin(), index_.end(),
              [&](BallIndex a, BallIndex b) { return balls_.centres[a] < balls_.centres[b]; });
    for (int m = 0; m < 4; ++m) ball_[m] = ball(index_[m]);
    planes_ = planes();
    NeumaierSum inside, area;
    for (const Meeting& meeting : meetings) {
      const GrownBall from = ball(meeting.ball);
      if (!cut_out_cell(meeting.ball, from)) continue;
      const SharedMeasures shared = piece_.shared_with_ball(from.grown_radius);
      inside.add(shared.volume);
      area.add(shared.area);
    }
    return {planes_.volume, planes_.volume - inside.value(), area.value()};
  }

 private:
  GrownBall ball(BallIndex i) const {
    return grown_ball(balls_.centres[i], balls_.radii[i], alpha_);
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
      // The normals of a tetrahedron that is not mirrored point inwards.
      of.normal[m] = of.is_mirrored ? n[m] : VectorInt{-n[m].x, -n[m].y, -n[m].z};
      const auto normal = as_doubles(n[m]);
      of.length[m] = std::sqrt(dot(normal, normal));
    }
    return of;
  }

  // Starts the piece as the whole tetrahedron, with ball i at the origin.
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

  // Cuts the piece to the ball's cell, as far as the ball reaches. False if nothing is left.
  bool cut_out_cell(BallIndex i, const GrownBall& from) {
    start(from);
    for (const Wall& wall : walls_.of(i)) {
      // All later walls are farther.
      if (wall.distance > std::min(piece_.reach(), from.grown_radius)) break;
      if (!piece_.cut(wall.normal, wall.offset, wall.length, wall.ball)) return false;
    }
    return true;
  }

  const Triangulation& triangulation_;
  const BallSet& balls_;
  const LatticeAlpha alpha_;
  CellWalls walls_;
  std::array<BallIndex, 4> index_ = {};
  GrownBall ball_[4] = {};
  Planes planes_ = {};
  ConvexPiece piece_;
};

// All meetings, ordered by tetrahedron and then by the centres of the balls.
std::vector<Meeting> all_meetings(const Triangulation& triangulation, const BallSet& balls,
                                  const LatticeAlpha& alpha,
                                  const std::vector<std::uint32_t>& tetrahedron_of,
                                  std::span<const std::uint32_t> tetrahedra,
                                  const CancelToken& cancel) {
  std::vector<bool> asked(triangulation.tetrahedra.size(), false);
  for (const std::uint32_t t : tetrahedra) asked[t] = true;
  struct Worker {
    BallReach reach;
    std::vector<Meeting> meetings;
  };
  tbb::enumerable_thread_specific<Worker> workers([&] {
    return Worker{BallReach(triangulation, balls, alpha, tetrahedron_of, asked), {}};
  });
  parallel_ranges(0, balls.size(), kGrain, [&](std::size_t first, std::size_t end) {
    if (cancel.cancelled()) return;
    Worker& worker = workers.local();
    for (std::size_t i = first; i < end; ++i) {
      worker.reach.add(static_cast<BallIndex>(i), worker.meetings);
    }
  });
  cancel.throw_if_cancelled();
  std::vector<Meeting> all;
  for (const Worker& worker : workers) {
    all.insert(all.end(), worker.meetings.begin(), worker.meetings.end());
  }
  tbb::parallel_sort(all.begin(), all.end(), [&](const Meeting& a, const Meeting& b) {
    return a.tetrahedron != b.tetrahedron ? a.tetrahedron < b.tetrahedron
                                          : balls.centres[a.ball] < balls.centres[b.ball];
  });
  return all;
}

}  // namespace

ExactTetrahedra exact_outside(const Triangulation& triangulation, const BallSet& balls,
                              const LatticeAlpha& alpha_on_lattice,
                              std::span<const std::uint32_t> tetrahedra, int threads,
                              const RunContext& context) {
  for (const std::uint32_t t : tetrahedra) {
    if (t >= triangulation.tetrahedra.size()) {
      throw std::invalid_argument("the triangulation has no tetrahedron " + std::to_string(t));
    }
  }
  ExactTetrahedra of;
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
    const std::vector<Meeting> meetings = all_meetings(triangulation, balls, alpha_on_lattice,
                                                       tetrahedron_of, tetrahedra, context.cancel);
    const auto first_of = [&](std::size_t t) {
      return std::lower_bound(meetings.begin(), meetings.end(), t,
                              [](const Meeting& m, std::size_t n) { return m.tetrahedron < n; });
    };
    parallel_ranges(0, tetrahedra.size(), kGrain, [&](std::size_t first, std::size_t end) {
      context.cancel.throw_if_cancelled();
      Clipper& clipper = clippers.local();
      for (std::size_t n = first; n < end; ++n) {
        const std::uint32_t t = tetrahedra[n];
        const Clipped clipped = clipper.clip(t, {first_of(t), first_of(std::size_t{t} + 1)});
        of.volume_angstrom3[n] = clipped.volume * unit * unit * unit;
        of.free_volume_angstrom3[n] = clipped.free_volume * unit * unit * unit;
        of.area_angstrom2[n] = clipped.area * unit * unit;
      }
    });
  });
  return of;
}

}  // namespace alphascope
