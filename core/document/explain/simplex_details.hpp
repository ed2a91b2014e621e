// What there is around an atom or a simplex in the complex on screen, as a derived result: one pass
// over the lists of simplices.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/complex/face_class.hpp"
#include "core/document/store/derived.hpp"

namespace alphascope {

struct NeighbourBall {
  BallIndex ball = 0;
  double distance_angstrom = 0;  // between centres
};

struct SimplexDetails {
  std::vector<BallIndex> balls;  // 1 to 4, ascending
  // False also of a vertex, edge or triangle where only tetrahedra were computed, unless one of
  // them has it as a face.
  bool in_complex = false;
  std::optional<double> alpha_value_angstrom2;  // none: not in the complex, or not computed
  // In the dimension of all centres (core/complex/own_dimension.hpp).
  std::optional<SimplexClass> simplex_class;
  // How many simplices of the complex have it as a face, by their number of balls less one; those
  // of its own dimension are not counted.
  std::array<std::size_t, 4> cofaces{};
  // Of a vertex: the ends of its edges, nearest first. Where only tetrahedra were computed, their
  // edges count.
  std::vector<NeighbourBall> neighbours;
  // Of an edge or a triangle: the simplices with one ball more. Of a tetrahedron: those that share
  // a triangle with it. At most kMostListed.
  std::vector<std::vector<BallIndex>> beside;
  static constexpr std::size_t kMostListed = 1000;
};

// Throws Cancelled.
SimplexDetails find_details(const BallSet& balls, const AlphaComplex& complex,
                            const std::vector<BallIndex>& simplex, const RunContext& context = {});

Definition<SimplexDetails> simplex_details(const std::vector<BallIndex>& simplex);

}  // namespace alphascope
