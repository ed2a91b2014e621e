// Answers from what an engine was lent (core/engine/engine.hpp), the same in every engine.
#pragma once

#include <cstdint>
#include <optional>

#include "core/engine/engine.hpp"

namespace alphascope {

// Memory of both.
std::uint64_t bytes_of(const Lent& lent);

// Throws std::invalid_argument when what was lent is of other balls, or does not hold for every
// alpha.
void require_lent_of(const BallSet& balls, const Lent& lent);

// K_alpha by threshold of the filtration that was lent, with its route; nothing when none was.
// Works in the caller's task arena. Throws Cancelled.
std::optional<AlphaComplex> threshold_of_lent(const BallSet& balls, const AlphaRequest& request,
                                              const RunContext& context, StageTimer& timer);

}  // namespace alphascope
