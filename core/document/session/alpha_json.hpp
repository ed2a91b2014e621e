// SPDX-License-Identifier: GPL-3.0-or-later
// Alpha in JSON. It is a number if the shortest decimal of a double is exactly alpha. Otherwise it
// is a text with all digits, because JSON readers convert numbers to double.
#pragma once

#include "core/geometry/alpha.hpp"

namespace alphascope {

// Makes any kind of JSON, by nlohmann's convention.
template <class BasicJson>
void to_json(BasicJson& json, const Alpha& alpha) {
  if (alpha.is_shortest_of_double() || !alpha.is_decimal()) {
    json = alpha.nearest();
  } else {
    json = alpha.digits();
  }
}

}  // namespace alphascope
