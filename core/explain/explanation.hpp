// SPDX-License-Identifier: GPL-3.0-or-later
// Facts that explain why a simplex is in the alpha complex or not.
// core/document/explain/explanation_text.hpp makes sentences of them. Only the neighbourhood of the
// simplex is computed.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/complex/face_class.hpp"
#include "core/explain/recorded_steps.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/real_point.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct BallSet;

// The position of a ball relative to the simplex' orthosphere.
struct BallMargin {
  BallIndex ball = 0;
  double power_angstrom2 = 0;  // power distance at the orthocentre
  // Power minus rho: negative inside, positive outside, 0 on a tie.
  double margin_angstrom2 = 0;
  int sign = 0;  // exact sign of the margin
  std::vector<ArithmeticStep> steps;
};

// The reason why a simplex is in no alpha complex.
enum class AbsenceReason : std::uint8_t {
  none,       // it is in the regular triangulation, so in the complex from some alpha on
  hidden,     // ball `absent_face` is hidden by `culprits`: one of the same centre, or others
  dependent,  // two equal centres, three on a line or four in a plane: no orthosphere
  face,       // `absent_face` is not in the triangulation
  cut_away    // `culprits` cover all of the space that its balls would share
};

// An alpha from which on something holds: the ortho-radius of the simplex `from`.
struct AlphaLevel {
  double angstrom2 = 0;
  float on_lattice = 0;  // the float in a filtration, square lattice units
  std::vector<BallIndex> from;
};

struct AtAlpha {
  LatticeAlpha alpha_on_lattice;
  bool in_complex = false;
  SimplexClass simplex_class = SimplexClass::singular;  // valid if it is in the complex
  // The comparison of the ortho-radius with alpha. The sign is that of rho - alpha.
  std::vector<ArithmeticStep> steps;
};

struct Explanation {
  std::vector<BallIndex> simplex;  // 1 to 4 balls, ascending
  Lattice lattice;

  // The orthosphere; empty if the balls are affinely dependent.
  struct Sphere {
    RealPoint centre_angstrom;
    double rho_angstrom2 = 0;  // negative: the sphere is imaginary
    int rho_sign = 0;          // exact sign
  };
  std::optional<Sphere> orthosphere;
  std::vector<BallMargin> nearest;  // other balls, by margin

  AbsenceReason absence = AbsenceReason::none;
  std::vector<BallIndex> absent_face, culprits;

  int dimension = -1;  // dimension of the triangulation, to which the classes refer

  // The members below are set only for a simplex of the regular triangulation.
  bool largest = false;   // no larger simplex contains it
  bool attached = false;  // a ball, nearest.front(), is inside the orthosphere
  bool on_hull = false;   // part of its surroundings is never filled
  AlphaLevel appears;     // the alpha value
  // The edges of the simplex' dual face, the part of space that its balls share. In space they join
  // orthocentres of tetrahedra: those on both sides of each triangle that contains the simplex or
  // equals it. In a plane they join those of triangles on both sides of edges. On a line they join
  // those of edges beside vertices. Edges to infinity are left out.
  std::vector<std::array<RealPoint, 2>> dual_edges_angstrom;
  std::optional<AlphaLevel> regular, interior;  // empty: never
  std::optional<AtAlpha> at_alpha;              // set if an alpha was given
};

// `simplex` holds 1 to 4 different balls, in any order. Throws std::invalid_argument otherwise and
// if alpha is NaN. Works in the caller's task arena. Throws Cancelled.
Explanation explain(const BallSet& balls, std::span<const BallIndex> simplex,
                    std::optional<LatticeAlpha> alpha_on_lattice, const RunContext& context = {});

}  // namespace alphascope
