// The nearest of the words that exist, for whoever mistyped one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace alphascope {

// " Did you mean "compute"?", or nothing when no known word is near. Upper and lower case count as
// equal; one letter in three may be wrong, missing, too many or swapped with its neighbour.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

}  // namespace alphascope
