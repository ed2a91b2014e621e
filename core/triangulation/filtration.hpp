// The filtration of alpha complexes up to some alpha_max: computed once, after which the complex at
// any smaller alpha is a threshold. Triangulating and clipping are not done here.
#pragma once

#include <memory>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/complex/triangulation.hpp"
#include "core/run/cancel_token.hpp"
#include "core/triangulation/hash_steps.hpp"

namespace alphascope {

// For each simplex of one dimension, the alphas (square lattice units, rounded like the alpha
// values of which they are copies) from which on it is regular and interior. NaN when never, so
// that every comparison fails; an alpha value beyond all floats is infinite.
struct ClassLevels {
  std::vector<float> regular_from, interior_from;
};

struct ClassLevelsByDimension {
  ClassLevels vertices, edges, triangles;  // tetrahedra are always interior
};

class Filtration {
 public:
  // Of the triangulation of these balls: holds for every alpha; top() has no hash.
  // Works in the caller's task arena. Throws Cancelled.
  Filtration(std::shared_ptr<const BallSet> balls, const Triangulation& triangulation,
             const RunContext& context = {});
  // The same, but shares the triangulation's tetrahedra and so keeps all of it: a sixth less memory
  // for who keeps it anyway.
  Filtration(std::shared_ptr<const BallSet> balls,
             std::shared_ptr<const Triangulation> triangulation, const RunContext& context = {});

  // Of a whole complex (not tetrahedra-only: std::invalid_argument) of these balls, computed by any
  // engine: holds up to its alpha. Shares the complex instead of copying it. Throws Cancelled.
  Filtration(std::shared_ptr<const BallSet> balls, std::shared_ptr<const AlphaComplex> top,
             const RunContext& context = {});

  // Largest alpha answered, square lattice units.
  const LatticeAlpha& alpha_max_on_lattice() const { return top_->alpha_on_lattice; }
  // The complex at alpha_max: all simplices with their alpha values.
  const AlphaComplex& top() const { return *top_; }
  const ClassLevelsByDimension& levels() const { return levels_; }
  const HashStepsByDimension& hash_steps() const { return hash_steps_; }
  const BallSet& balls() const { return *balls_; }

  // Memory held beside top(), and by top() itself but for what is a triangulation's.
  std::size_t level_bytes() const;
  std::size_t top_bytes() const;

 private:
  void build(const Triangulation& triangulation, Simplices<4> tetrahedra,
             const RunContext& context);

  std::shared_ptr<const BallSet> balls_;
  std::shared_ptr<const AlphaComplex> top_;
  std::size_t shared_bytes_ = 0;  // of top_
  ClassLevelsByDimension levels_;
  HashStepsByDimension hash_steps_;
};

// K_alpha for alpha_on_lattice <= filtration.alpha_max_on_lattice() (else std::invalid_argument),
// exactly: where alpha rounds to the very float of an alpha value, integers decide. The hash is
// set, and whether it rests on CGAL; the rest of engine and timings is left to the caller.
AlphaComplex threshold(const Filtration& filtration, const LatticeAlpha& alpha_on_lattice,
                       bool tetrahedra_only);

// Sets the classes of a whole complex from its simplices alone, whatever they were before.
void classify(AlphaComplex& complex);

}  // namespace alphascope
