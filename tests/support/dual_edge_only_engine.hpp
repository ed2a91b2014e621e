// SPDX-License-Identifier: GPL-3.0-or-later
// Clips dual edges at every alpha, even where the CPU engine would choose a faster route.
#pragma once

#include <tbb/task_arena.h>

#include <cmath>
#include <stdexcept>

#include "core/dual_edge/cpu_dual_edges.hpp"
#include "core/engine/engine.hpp"
#include "core/engines/route.hpp"
#include "core/neighbours/coincident.hpp"

namespace alphascope::testing {

class DualEdgeOnlyEngine : public Engine {
 public:
  DualEdgeOnlyEngine(std::shared_ptr<const BallSet> balls, int threads)
      : balls_(std::move(balls)), arena_(threads) {}

  using Engine::compute;
  AlphaComplex compute(const AlphaRequest& request, KnownResults&,
                       const RunContext& context) override {
    if (std::isnan(request.alpha_angstrom2)) throw std::invalid_argument("alpha is not a number");
    AlphaComplex complex;
    complex.lattice = balls_->lattice;
    complex.alpha_on_lattice = balls_->lattice.alpha_on_lattice(request.alpha_angstrom2);
    complex.tetrahedra_only = request.tetrahedra_only;
    const UniformGrid grid =
        make_uniform_grid(*balls_, complex.alpha_on_lattice, coincident_hidden(*balls_));
    if (!within_clipping_reach(grid)) {
      return make_cgal_engine(balls_, {1})->compute(request, context);
    }
    arena_.execute([&] {
      StageTimer timer(complex.timings);
      compute_by_dual_edges(*balls_, grid, context, timer, complex);
    });
    complex.hash = complex_hash(complex);
    return complex;
  }

 private:
  std::shared_ptr<const BallSet> balls_;
  tbb::task_arena arena_;
};

}  // namespace alphascope::testing
