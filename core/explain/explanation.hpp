// Why is a simplex in the alpha complex, or not? The facts, as numbers; sentences are made of them
// by core/document/explain/explanation_text.hpp. Only the neighbourhood of the simplex is computed.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/complex/face_class.hpp"
#include "core/explain/recorded_steps.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// A ball against the orthosphere of the simplex.
struct BallMargin {
  BallIndex ball = 0;
  double power_angstrom2 = 0;   // its power distance at the orthocentre
  double margin_angstrom2 = 0;  // that minus rho: negative inside, positive outside, 0 a tie
  int sign = 0;                 // of the margin, exact
  std::vector<ArithmeticStep> steps;
};

// Why a simplex is in the alpha complex at no alpha.
enum class Absence : std::uint8_t {
  none,       // it is in the regular triangulation, and so in the complex from some alpha on
  hidden,     // `culprits` leave the ball `absent_face` no place: one of the same centre, or others
  dependent,  // two equal centres, three on a line, four in a plane: there is no orthosphere
  face,       // `absent_face` is not in the triangulation
  cut_away    // `culprits` leave nothing of the part of space that its balls would share
};

// An alpha from which on something holds, and the simplex of which it is the ortho-radius.
struct AlphaLevel {
  double angstrom2 = 0;
  float on_lattice = 0;  // the float that a filtration has, square lattice units
  std::vector<BallIndex> from;
};

struct AtAlpha {
  LatticeAlpha alpha_on_lattice;
  bool in_complex = false;
  SimplexClass simplex_class = SimplexClass::singular;  // if it is in the complex
  // The ortho-radius that alpha was compared with; the sign is that of rho - alpha.
  std::vector<ArithmeticStep> steps;
};

struct Explanation {
  std::vector<BallIndex> simplex;  // 1 to 4, ascending
  Lattice lattice;

  // Of affinely independent balls.
  struct Sphere {
    RealPoint centre_angstrom;
    double rho_angstrom2 = 0;  // negative: the sphere is imaginary
    int rho_sign = 0;          // exact
  };
  std::optional<Sphere> orthosphere;
  std::vector<BallMargin> nearest;  // other balls, by margin

  Absence absence = Absence::none;
  std::vector<BallIndex> absent_face, culprits;

  int dimension = -1;  // of the triangulation; classes are those of this dimension

  // What follows is of a simplex of the regular triangulation.
  bool largest = false;   // nothing in the triangulation contains it
  bool attached = false;  // nearest.front() is inside the orthosphere
  bool on_hull = false;   // a part of its surroundings is never filled
  AlphaLevel appears;     // the alpha value
  // The edges of its dual face, the part of space that its balls share: between the orthocentres of
  // the tetrahedra on both sides of each triangle that contains it, or that it is. In a plane
  // those of the triangles on both sides of edges, on a line of the edges beside vertices. Not
  // those that leave for infinity.
  std::vector<std::array<RealPoint, 2>> dual_edges_angstrom;
  std::optional<AlphaLevel> regular, interior;  // nothing: never
  std::optional<AtAlpha> at_alpha;              // if an alpha was asked for
};

// `simplex`: 1 to 4 different balls, in any order; else std::invalid_argument, as for an alpha that
// is NaN. Works in the caller's task arena. Throws Cancelled.
Explanation explain(const BallSet& balls, std::span<const BallIndex> simplex,
                    std::optional<LatticeAlpha> alpha_on_lattice, const RunContext& context = {});

}  // namespace alphascope
