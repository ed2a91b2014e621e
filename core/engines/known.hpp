// Answers from what is known of the balls (core/engine/known_of_balls.hpp), alike in every engine.
#pragma once

#include <cstdint>
#include <optional>

#include "core/engine/engine.hpp"

namespace alphascope {

std::uint64_t bytes_of(const OfAllBalls& of_all);
std::uint64_t bytes_of(const KnownOfBalls& known);

// Throws std::invalid_argument when it is known of other balls, or when the filtration of all
// balls does not hold for every alpha.
void require_known_of(const BallSet& balls, const KnownOfBalls& known);

// K_alpha by threshold of the filtration of all balls, with its route; nothing where there is none.
// Works in the caller's task arena. Throws Cancelled.
std::optional<AlphaComplex> threshold_of_all(const BallSet& balls, const AlphaRequest& request,
                                             KnownOfBalls& known, const RunContext& context,
                                             StageTimer& timer);

// The same of an earlier complex, if alpha is not above that of the complex. The first answer makes
// a filtration of it, which is setup. Throws Cancelled, and std::bad_alloc; both leave `known` as
// it was.
std::optional<AlphaComplex> threshold_of_complex(const BallSet& balls, const AlphaRequest& request,
                                                 KnownOfBalls& known, const RunContext& context,
                                                 StageTimer& timer);

}  // namespace alphascope
