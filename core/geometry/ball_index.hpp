// SPDX-License-Identifier: GPL-3.0-or-later
// The index of a ball.
#pragma once

#include <cstdint>

namespace alphascope {

// Index of a ball in its BallSet; simplices are tuples of these.
using BallIndex = std::uint32_t;

}  // namespace alphascope
