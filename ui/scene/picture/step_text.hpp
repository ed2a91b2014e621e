// SPDX-License-Identifier: GPL-3.0-or-later
// Progress of a long drawing: the present step, the number of steps, and the time left.
#pragma once

#include <string>

namespace alphascope {

// A text such as "sample 3 of 16, 1 min 5 s left"; `step` counts from 0. `seconds` is the time that
// the earlier steps took. For the first step there is no time.
std::string step_text(const char* what, int step, int of, double seconds);

}  // namespace alphascope
