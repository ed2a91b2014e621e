// SPDX-License-Identifier: GPL-3.0-or-later
// Finds all simplices, or only the tetrahedra, of one ball on the CPU: by filters first, and
// exactly where a filter cannot decide. One object is the scratch memory of one thread. The kernel
// bodies are dual_edge.hpp, facet_disc.hpp and triangle_faces.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/complex/face_class.hpp"
#include "core/dual_edge/ball_simplices_sink.hpp"
#include "core/dual_edge/cut_sieve.hpp"
#include "core/dual_edge/facet_disc.hpp"
#include "core/dual_edge/triangle_faces.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/neighbours/meeting_slots.hpp"
#include "core/neighbours/uniform_grid.hpp"

namespace alphascope {

// The state of ball i as a vertex of K_alpha. unattached: a vertex, with alpha value -w_i.
// attached: a vertex iff it has an edge in K_alpha. absent: no vertex.
enum class VertexState : std::uint8_t { absent, attached, unattached };

// Simplices of one dimension as the kernels report them.
template <int N>
struct SimplexBuffer {
  std::vector<std::array<BallIndex, N>> simplices;
  // Alpha values, square lattice units; empty when only tetrahedra are requested.
  std::vector<float> values;
  std::vector<std::uint8_t> states;  // edges: flags; triangles: class; tetrahedra: empty
  std::uint32_t size() const { return static_cast<std::uint32_t>(simplices.size()); }
  // Releases reserved but unused memory: all blocks are kept until the last one is done.
  void shrink() {
    simplices.shrink_to_fit();
    values.shrink_to_fit();
    states.shrink_to_fit();
  }
};

struct BlockOutput {
  // Every edge that may be in K_alpha, with the least alpha value known so far: its own if it is
  // unattached, else that of the triangles whose first or second edge it is. HUGE_VALF: none known
  // yet.
  SimplexBuffer<2> edges;
  SimplexBuffer<3> triangles;
  SimplexBuffer<4> tetrahedra;
};

class BallSimplices {
 public:
  BallSimplices(const BallSet& balls, const UniformGrid& grid, const LatticeAlpha& alpha_on_lattice,
                bool whole)
      : balls_(balls), grid_(grid), alpha_(alpha_on_lattice), whole_(whole) {}

  // Appends the simplices whose lowest vertex is the ball in this slot of the grid, in
  // lexicographic order. `list` holds the grid's slots of its neighbours, ascending by ball index.
  VertexState process(std::uint32_t slot, std::span<const std::uint32_t> list, BlockOutput& out);
  // The same, and reports each step to `sink`.
  VertexState process(std::uint32_t slot, std::span<const std::uint32_t> list, BlockOutput& out,
                      const BallSimplicesSink& sink);

  std::size_t dual_edges() const { return dual_edges_; }
  std::size_t exact_dual_edges() const { return exact_dual_edges_; }
  double exact_milliseconds() const { return exact_milliseconds_; }

 private:
  // The neighbours of ball i. Decisions name a neighbour by its index in these lists, which they
  // call a slot, too.
  struct Neighbours {
    LatticePoint centre;  // of ball i
    std::int32_t radius = 0;
    // Lattice units. Centres and reaches are longer by kVectorRoom (meeting_slots.hpp).
    std::vector<std::int32_t> x, y, z, radii;
    std::vector<float> reach;  // as UniformGrid::reach
    std::vector<BallIndex> balls;

    std::size_t size() const { return balls.size(); }
    void resize(std::size_t count);
    void move(std::size_t from, std::size_t to);
    BallColumns columns() const { return {x.data(), y.data(), z.data(), reach.data()}; }
    LiftedInt lifted(int k) const {
      const auto n = static_cast<std::size_t>(k);
      return lifted_vector(centre, radius, LatticePoint{x[n], y[n], z[n]}, radii[n]);
    }
    BallIndex ball(int k) const { return balls[static_cast<std::size_t>(k)]; }
  };

  bool has_three_later(std::uint32_t slot, std::span<const std::uint32_t> list) const;
  void load(std::uint32_t slot, std::span<const std::uint32_t> list);
  void take(std::uint32_t slot, std::span<const std::uint32_t> list);
  void lift();
  void find_nearest();
  void cull();
  void keep(std::size_t from, std::size_t to);
  void fill_row(int j);
  template <class Sink>
  VertexState process_with(std::uint32_t slot, std::span<const std::uint32_t> list,
                           BlockOutput& out, const Sink& sink);
  template <class Sink>
  bool edge_is_attached(int j, const FacetDisc<double>& disc, const Sink& sink);
  template <class Sink>
  void add_edge(int j, BlockOutput& out, const Sink& sink);
  template <class Sink>
  void triangles_of(int j, BlockOutput& out, const Sink& sink);
  template <class Sink>
  void triangle(const NearFirstRows& rows, BlockOutput& out, const Sink& sink);
  void tetrahedra(const NearFirstRows& rows, BlockOutput& out);
  // Kernel II for one triangle. `body` calls filtered_face() or filtered_ends()
  // (triangle_faces.hpp).
  template <class Sink, class Body>
  auto filtered(const NearFirstRows& rows, const Body& body);
  template <class Sink = NoSink>
  TriangleFace exactly(const TriangleRows& rows, const Sink& sink = {});
  void note_coface(int j, float value, SimplexClass coface, BlockOutput& out);
  VertexState vertex_state() const;

  Neighbourhood<Neighbours> surroundings() const {
    return {neighbours_, weight_, &alpha_, ghost_reach_, filter_};
  }
  std::uint32_t* row(int j) {
    return rows_.data() + static_cast<std::ptrdiff_t>(j - first_) * words_;
  }
  LiftedVector<double> vector(int k) const { return doubles_[static_cast<std::size_t>(k)]; }

  // Culling pays for lists of at least kLongList neighbours; it tries the kCoverers neighbours
  // whose planes are nearest as covers. Only the time depends on these numbers.
  static constexpr std::size_t kLongList = 20, kCoverers = 16;

  const BallSet& balls_;
  const UniformGrid& grid_;
  const LatticeAlpha alpha_;
  const bool whole_;

  // Data of the current ball.
  BallIndex i_ = 0;
  std::int64_t weight_ = 0, ghost_reach_ = 0;
  std::int64_t largest_offset_ = 0;  // max |d_x| over the neighbours, lattice units
  double largest_power_ = 0;         // at least max |c| over the neighbours and ghosts
  double radius_square_ = 0;         // w_i + alpha, square lattice units
  bool filter_ = false;              // double precision is certified
  int first_ = 0;                    // first neighbour with a higher index than i
  int words_ = 0;                    // words of 32 bits in a row
  bool attached_ = false;            // p_i may be outside the power cell of i
  bool culled_ = false;              // cull() was run: a long list and a certified filter
  Neighbours neighbours_;
  LiftedColumns doubles_;              // the lifted vectors as doubles
  std::vector<std::uint32_t> sieved_;  // a row of bits, for one triangle at a time
  std::vector<std::uint32_t> rows_;    // a row of bits for each later neighbour
  std::vector<char> dead_;             // for neighbour j: edge ij is not in K_alpha
  // For a culled list: a number for each radical plane that grows with its distance, and the
  // neighbours whose planes are nearest.
  std::vector<std::pair<double, std::size_t>> planes_;
  std::vector<FacetDisc<double>::Coverer> coverers_;
  std::vector<char> is_near_;
  std::vector<std::uint32_t> near_;  // is_near_ as a row of bits
  std::vector<std::uint32_t> edge_;  // per later neighbour: its edge in the block's output

  std::size_t dual_edges_ = 0, exact_dual_edges_ = 0;
  double exact_milliseconds_ = 0;
};

}  // namespace alphascope
