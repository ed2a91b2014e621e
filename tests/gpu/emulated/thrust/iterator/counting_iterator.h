// SPDX-License-Identifier: GPL-3.0-or-later
// A stand-in for Thrust's counting_iterator (see cuda_runtime.h).
#pragma once

#include <cstdint>

namespace thrust {

template <class Number>
struct counting_iterator {
  Number first;
  Number operator[](std::uint64_t i) const { return first + static_cast<Number>(i); }
};
template <class Number>
counting_iterator<Number> make_counting_iterator(Number first) {
  return {first};
}

}  // namespace thrust
