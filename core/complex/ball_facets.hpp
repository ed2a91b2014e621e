// All facets, or only the tetrahedra, of one ball on the CPU: filtered first, exact where the
// filter cannot decide. Owns the scratch memory of one thread. The kernel bodies are
// facet_polygon.hpp, facet_complex.hpp and triangle_tetrahedra.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/complex/facet_complex.hpp"
#include "core/complex/triangle_tetrahedra.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/uniform_grid.hpp"

namespace alphascope {

// Is ball i a vertex of K_alpha? unattached: yes, with value -w. attached: if it has an edge in
// K_alpha. absent: no.
enum class VertexState : std::uint8_t { absent, attached, unattached };

// Simplices of one dimension as the kernels report them.
template <int N>
struct SimplexBuffer {
  std::vector<std::array<BallIndex, N>> simplices;
  std::vector<float> values;          // empty when only tetrahedra are asked for
  std::vector<std::uint8_t> classes;  // empty for tetrahedra
  std::uint32_t size() const { return static_cast<std::uint32_t>(simplices.size()); }
  // All blocks wait for the last: what their vectors reserved beyond their content adds up.
  void shrink() {
    simplices.shrink_to_fit();
    values.shrink_to_fit();
    classes.shrink_to_fit();
  }
};

struct BlockOutput {
  SimplexBuffer<2> edges;
  SimplexBuffer<3> triangles;
  SimplexBuffer<4> tetrahedra;
};

class BallFacets {
 public:
  BallFacets(const BallSet& balls, const UniformGrid& grid, double alpha_on_lattice, bool whole)
      : balls_(balls), grid_(grid), alpha_(alpha_on_lattice), whole_(whole) {}

  // Appends the simplices whose lowest vertex is the ball in `slot`, in lexicographic order.
  // `list` holds the slots of its neighbours, ascending by ball index.
  VertexState process(std::uint32_t slot, std::span<const std::uint32_t> list, BlockOutput& out);

  std::size_t facets() const { return facets_; }
  std::size_t exact_facets() const { return exact_facets_; }
  double exact_milliseconds() const { return exact_milliseconds_; }

 private:
  // Storage of one polygon (facet_polygon.hpp); grows with the number of neighbours.
  template <class T>
  struct Polygon {
    struct Side {
      FacetLine<T> line;
      int id;
    };
    using Line = FacetLine<T>;
    int size = 0;
    std::vector<Side> sides;
    std::vector<FacetCorner<T>> corners;

    void reserve(std::size_t count) {
      if (sides.size() >= count) return;
      sides.resize(2 * count);
      corners.resize(2 * count);
    }
    int capacity() const { return static_cast<int>(sides.size()); }
    int id(int s) const { return sides[static_cast<std::size_t>(s)].id; }
    const Line& line(int s) const { return sides[static_cast<std::size_t>(s)].line; }
    const FacetCorner<T>& corner(int s) const { return corners[static_cast<std::size_t>(s)]; }
    void set_side(int s, int id, const Line& line) {
      sides[static_cast<std::size_t>(s)] = {line, id};
    }
    void meet(int s, const Line& k, const Line& l) {
      corners[static_cast<std::size_t>(s)].meet(k, l);
    }
    void move(int from, int to) {
      sides[static_cast<std::size_t>(to)] = sides[static_cast<std::size_t>(from)];
      corners[static_cast<std::size_t>(to)] = corners[static_cast<std::size_t>(from)];
    }
  };
  // The neighbours of ball i by slot in its list.
  struct Neighbours {
    std::vector<LiftedInt> vectors;
    std::vector<BallIndex> balls;
    const LiftedInt& lifted(int k) const { return vectors[static_cast<std::size_t>(k)]; }
    BallIndex ball(int k) const { return balls[static_cast<std::size_t>(k)]; }
  };

  void load(std::uint32_t slot, std::span<const std::uint32_t> list);
  // Of a tetrahedra-only request (ball_tetrahedra.cpp).
  void tetrahedra(BlockOutput& out);
  void fill_row(int j, int words, double radius_square, std::uint32_t* row);
  TriangleEnds exact_triangle(const TriangleRows& triangle, int words);
  void collect_common(int j);
  void facet(int j, BlockOutput& out);
  bool filtered_facet(const FacetInput<Neighbours>& input, int axis, bool negative,
                      float edge_value, BlockOutput& out);
  template <class Integer>
  void exact_facet(Polygon<Integer>& scratch, const FacetInput<Neighbours>& input, int axis,
                   bool negative, float edge_value, BlockOutput& out);
  template <class T>
  void report(const FacetInput<Neighbours>& input, const Polygon<T>& polygon, int axis,
              float edge_value, BlockOutput& out);

  const BallSet& balls_;
  const UniformGrid& grid_;
  const double alpha_;
  const bool whole_;

  // Of the current ball.
  BallIndex i_ = 0;
  std::int64_t weight_ = 0, ghost_reach_ = 0;
  std::int64_t largest_offset_ = 0;  // max |d_x| over the neighbours
  std::int64_t largest_power_ = 0;   // max |c| over the neighbours and ghosts
  double clip_bound_ = 0;
  Neighbours neighbours_;
  std::vector<float> dx_, dy_, dz_, reach_;
  std::vector<int> common_;                    // slots of the balls that can cut the current facet
  std::vector<LiftedVector<double>> doubles_;  // the vectors once more
  std::vector<std::uint32_t> rows_;            // of the later neighbours

  Polygon<double> filtered_;
  Polygon<Int128> exact128_;
  Polygon<WideInt<4>> exact256_;
  std::vector<signed char> corner_in_;
  std::vector<float> corner_value_;
  std::size_t facets_ = 0, exact_facets_ = 0;
  double exact_milliseconds_ = 0;
};

}  // namespace alphascope
