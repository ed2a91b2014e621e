// SPDX-License-Identifier: GPL-3.0-or-later
// A stand-in for Thrust's transform_iterator (see cuda_runtime.h).
#pragma once

#include <cstdint>

namespace thrust {

template <class Iterator, class Function>
struct transform_iterator {
  Iterator from;
  Function function;
  auto operator[](std::uint64_t i) const { return function(from[i]); }
};
template <class Iterator, class Function>
transform_iterator<Iterator, Function> make_transform_iterator(Iterator from, Function function) {
  return {from, function};
}

}  // namespace thrust
