// SPDX-License-Identifier: GPL-3.0-or-later
// The engines whose work on one ball can be shown step by step.
#pragma once

#include <cstdint>

namespace alphascope {

enum class StepsEngine : std::uint8_t { tuples, dual_edges };

}  // namespace alphascope
