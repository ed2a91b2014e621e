// What long drawing says of itself: which step of how many, and how long the rest will take.
#pragma once

#include <string>

namespace alphascope {

// "sample 3 of 16, 1 min 5 s left", counted from 0; without the time before the first is finished.
// `seconds` went into those before.
std::string step_text(const char* what, int step, int of, double seconds);

}  // namespace alphascope
