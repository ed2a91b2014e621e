// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which balls are inserted. It has rounds, each of which spreads over all space. After
// a round there are eight times as many balls as before it. In a round the balls follow a Hilbert
// curve, so each is near the one before (N. Amenta, S. Choi, G. Rote, Incremental constructions con
// BRIO, SoCG 2003).
#pragma once

#include <cstddef>
#include <vector>

#include "core/complex/simplices.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct InsertionOrder {
  ResultArray<BallIndex> balls;     // each one once
  std::vector<std::size_t> rounds;  // the end of each round
};

// The order of the balls that are not marked in `left_out`, which may be empty. It depends on
// nothing but the balls. Works in the caller's task arena. Throws Cancelled.
InsertionOrder insertion_order(const BallSet& balls, const std::vector<bool>& left_out,
                               const CancelToken& cancel = {});

}  // namespace alphascope
