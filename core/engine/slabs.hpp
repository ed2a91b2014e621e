// K_alpha of a set of balls slab by slab, for executors that cannot hold the whole set at once.
// Exact: the result is that of the whole set, in the same order.
#pragma once

#include <functional>

#include "core/engine/engine.hpp"

namespace alphascope {

// Computes the whole request for a part of the balls, in their order.
using ComputePart = std::function<AlphaComplex(std::shared_ptr<const BallSet> part)>;

// Cuts the set across its longest side into `slabs` (>= 1) of about as many balls, each with a halo
// of all balls that may meet one of its own at this alpha, and keeps of each part the simplices
// whose lowest vertex is its own. Timings are sums; `engine` is that of the last part, and rests on
// CGAL if that of any part does. Throws Cancelled and what `compute` throws.
AlphaComplex compute_in_slabs(const BallSet& balls, const AlphaRequest& request, std::size_t slabs,
                              const RunContext& context, const ComputePart& compute);

}  // namespace alphascope
