// Alpha in JSON: a number where a double says it (the shortest decimal that reads as that double is
// meant), else all its digits as text, since readers of JSON make doubles of numbers.
#pragma once

#include "core/geometry/alpha.hpp"

namespace alphascope {

// nlohmann's way to make any JSON of it.
template <class BasicJson>
void to_json(BasicJson& json, const Alpha& alpha) {
  if (alpha.is_shortest_of_double() || !alpha.is_decimal()) {
    json = alpha.nearest();
  } else {
    json = alpha.digits();
  }
}

}  // namespace alphascope
