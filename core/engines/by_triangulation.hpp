// SPDX-License-Identifier: GPL-3.0-or-later
// K_alpha as a threshold of the whole triangulation, which every alpha is. Engines take this way
// where no faster one is open to them.
#pragma once

#include <memory>

#include "core/engine/engine.hpp"

namespace alphascope {

struct TriangulatingEngine {
  std::shared_ptr<const BallSet> balls;
  std::shared_ptr<TriangulationMaker> maker;  // null: the CPU
  int threads = 0;                            // as in make_triangulation()
  bool by_cgal = false;                       // in any case
};

// The complex, its route, and whether it rests on CGAL. Makes what `known` lacks, which counts as
// setup. Works in the caller's task arena. Throws as Engine::compute() does; `known` then keeps
// what was finished.
AlphaComplex compute_by_triangulation(const TriangulatingEngine& engine,
                                      const AlphaRequest& request, KnownResults& known,
                                      const RunContext& context, StageTimer& timer);

}  // namespace alphascope
