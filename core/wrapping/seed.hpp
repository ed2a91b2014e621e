// SPDX-License-Identifier: GPL-3.0-or-later
// Finds one tetrahedron of a regular triangulation, from which wrapping finds all others.
#pragma once

#include <array>
#include <optional>

#include "core/geometry/ball_index.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct BallSet;

// Ascending balls. Empty if all centres lie in a plane. Works in the caller's task arena. Throws
// Cancelled.
std::optional<std::array<BallIndex, 4>> seed_tetrahedron(const BallSet& balls,
                                                         const CancelToken& cancel);

}  // namespace alphascope
