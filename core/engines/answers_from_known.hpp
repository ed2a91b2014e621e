// SPDX-License-Identifier: GPL-3.0-or-later
// Answers from known results of the balls (core/engine/known_results.hpp), the same for every
// engine.
#pragma once

#include <cstdint>
#include <optional>

#include "core/engine/engine.hpp"

namespace alphascope {

std::uint64_t bytes_of(const ResultsForAllAlphas& of_all);
std::uint64_t bytes_of(const KnownResults& known);

// Throws std::invalid_argument when `known` belongs to other balls, or when the filtration of all
// balls does not cover every alpha.
void require_known_of(const BallSet& balls, const KnownResults& known);

// K_alpha as a threshold of the filtration of all balls, with its route. Nothing where there is no
// such filtration. Works in the caller's task arena. Throws Cancelled.
std::optional<AlphaComplex> threshold_of_filtration(const BallSet& balls,
                                                    const AlphaRequest& request,
                                                    KnownResults& known, const RunContext& context,
                                                    StageTimer& timer);

// K_alpha as a threshold of an earlier complex, if alpha is not above that complex's. The first
// answer makes a filtration of the complex, which counts as setup. Throws Cancelled and
// std::bad_alloc; `known` is then unchanged.
std::optional<AlphaComplex> threshold_of_complex(const BallSet& balls, const AlphaRequest& request,
                                                 KnownResults& known, const RunContext& context,
                                                 StageTimer& timer);

}  // namespace alphascope
