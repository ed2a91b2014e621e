// SPDX-License-Identifier: GPL-3.0-or-later
// K_alpha of a set of balls, computed slab by slab for executors that cannot hold the whole set at
// once. The result is exactly that of the whole set, in the same order.
#pragma once

#include <functional>

#include "core/engine/engine.hpp"

namespace alphascope {

// Computes the whole request for some of the balls, which keep their order.
using ComputePart = std::function<AlphaComplex(std::shared_ptr<const BallSet> part)>;

// Cuts the set across its longest side into `slabs` (>= 1) with about the same number of balls
// each: the slab's own balls. A part consists of these and a halo of all balls that may meet one of
// them at this alpha. From each part the result keeps the simplices whose lowest vertex is an own
// ball. Timings are sums. `engine` is that of the last part, but it rests on CGAL if any part does.
// Throws Cancelled and the exceptions of `compute`.
AlphaComplex compute_in_slabs(const BallSet& balls, const AlphaRequest& request, std::size_t slabs,
                              const RunContext& context, const ComputePart& compute);

}  // namespace alphascope
