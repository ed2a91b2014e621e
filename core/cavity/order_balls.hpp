// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which the balls of a simplex enter a computation. Host and device.
#pragma once

#include "core/geometry/host_device.hpp"

namespace alphascope {

// The order of a simplex' balls by their centres. Computations in this order give the same bits
// whatever the indices of the balls are. comes_first(a, b): whether ball a does.
template <unsigned N, class ComesFirst>
ALPHASCOPE_INLINE void order_balls(unsigned (&order)[N], const ComesFirst& comes_first) {
  for (unsigned n = 0; n < N; ++n) order[n] = n;
  for (unsigned n = 1; n < N; ++n) {
    for (unsigned m = n; m > 0 && comes_first(order[m], order[m - 1]); --m) {
      const unsigned kept = order[m];
      order[m] = order[m - 1];
      order[m - 1] = kept;
    }
  }
}

}  // namespace alphascope
