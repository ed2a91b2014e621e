// SPDX-License-Identifier: GPL-3.0-or-later
// Round numbers on an axis or a legend: their distance, their places and their text.
#pragma once

#include <string>
#include <vector>

namespace alphascope {

// The distance is 1, 2 or 5 times a power of ten. At most `most` of them cover `span`, which is
// positive.
double nice_step(double span, int most);

// The multiples of `step` from `low` to `high`, ends included. Empty if there are 1,000 or more.
std::vector<double> round_values(double low, double high, double step);

// A multiple of `step`, with as many decimals as the step has: "0.50", "12,500", "1.20·10¹²".
std::string tick_text(double value, double step);

}  // namespace alphascope
