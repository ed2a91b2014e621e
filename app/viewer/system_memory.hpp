// How much memory the program has and the machine could still give.
#pragma once

#include <cstdint>

namespace alphascope {

std::uint64_t resident_bytes();   // of this process; 0 where /proc is missing
std::uint64_t available_bytes();  // without swapping; 0 where /proc is missing

}  // namespace alphascope
