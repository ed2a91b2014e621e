// SPDX-License-Identifier: GPL-3.0-or-later
// Proposes the nearest existing word for a mistyped one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace alphascope {

// " Did you mean "compute"?", or nothing if no known word is near. Case is ignored. A third of the
// letters, but at least one, may be wrong, missing, added or swapped with a neighbour.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

}  // namespace alphascope
