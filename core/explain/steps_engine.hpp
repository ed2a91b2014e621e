// The engines whose steps can be shown.
#pragma once

#include <cstdint>

namespace alphascope {

enum class StepsEngine : std::uint8_t { tuples, dual_edges };

}  // namespace alphascope
