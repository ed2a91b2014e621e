// SPDX-License-Identifier: GPL-3.0-or-later
// The filtration of alpha complexes up to some alpha_max. It is computed once; then the complex at
// any smaller alpha is a threshold. Engines and CGAL are elsewhere.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/complex/simplices.hpp"
#include "core/run/cancel_token.hpp"
#include "core/triangulation/hash_steps.hpp"

namespace alphascope {

struct AlphaComplex;
struct BallSet;
struct LatticeAlpha;
struct Triangulation;
class TriangulationMaker;

// For each simplex of one dimension, the alphas from which on it is regular and interior. They are
// copies of alpha values: square lattice units, rounded to float. NaN stands for never, so that
// every comparison fails. An alpha value beyond all floats is infinite.
struct ClassLevels {
  ResultArray<float> regular_from, interior_from;
};

struct ClassLevelsByDimension {
  ClassLevels vertices, edges, triangles;  // tetrahedra are always interior
};

class Filtration {
 public:
  // Makes the filtration of the triangulation of these balls, which holds for every alpha. top()
  // has no hash. Works in the caller's task arena. Throws Cancelled.
  Filtration(std::shared_ptr<const BallSet> balls, const Triangulation& triangulation,
             const RunContext& context = {});
  // Makes the same filtration, but shares the triangulation's tetrahedra and so keeps the whole
  // triangulation. This saves a sixth of the memory if the caller keeps it anyway. `maker`: whose
  // device makes it, if there is one.
  Filtration(std::shared_ptr<const BallSet> balls,
             std::shared_ptr<const Triangulation> triangulation, const RunContext& context = {},
             TriangulationMaker* maker = nullptr);

  // Makes the filtration of a complex of these balls by any engine, which holds up to that complex'
  // alpha. A complex of tetrahedra only is std::invalid_argument. The complex is shared and not
  // copied. Throws Cancelled.
  Filtration(std::shared_ptr<const BallSet> balls, std::shared_ptr<const AlphaComplex> top,
             const RunContext& context = {});

  // The largest alpha of the filtration, square lattice units.
  const LatticeAlpha& alpha_max_on_lattice() const;
  // The complex at alpha_max: all simplices with their alpha values.
  const AlphaComplex& top() const { return *top_; }
  const ClassLevelsByDimension& levels() const { return levels_; }
  const HashStepsByDimension& hash_steps() const { return hash_steps_; }
  const BallSet& balls() const { return *balls_; }
  // The device that made it; empty: the CPU.
  const std::string& device() const { return device_; }

  // Memory of the levels and of top(), bytes. Tetrahedra that are shared with a triangulation do
  // not count.
  std::size_t level_bytes() const;
  std::size_t top_bytes() const;

 private:
  void build(const Triangulation& triangulation, Simplices<4> tetrahedra, const RunContext& context,
             TriangulationMaker* maker);
  bool fill_by_device(const Triangulation& triangulation, Simplices<4>& tetrahedra,
                      const RunContext& context, TriangulationMaker& maker, AlphaComplex& top);
  // For a triangulation below dimension 3.
  void fill_flat(const Triangulation& triangulation, const RunContext& context, AlphaComplex& top);

  std::shared_ptr<const BallSet> balls_;
  std::shared_ptr<const AlphaComplex> top_;
  std::size_t shared_bytes_ = 0;  // part of top_ that a triangulation shares
  ClassLevelsByDimension levels_;
  HashStepsByDimension hash_steps_;
  std::string device_;
};

// K_alpha for alpha_on_lattice <= filtration.alpha_max_on_lattice() (else std::invalid_argument).
// The answer is exact: where alpha and an alpha value round to the same float, integers decide.
// Sets the hash, of_whole and rests_on_cgal; the caller sets the rest of engine and timings.
AlphaComplex threshold(const Filtration& filtration, const LatticeAlpha& alpha_on_lattice,
                       bool tetrahedra_only);

// Sets the classes of a whole complex from its simplices alone; previous classes are ignored.
void classify(AlphaComplex& complex);

}  // namespace alphascope
