// SPDX-License-Identifier: GPL-3.0-or-later
// The key of a derived result: numbers that identify the inputs from which it is made.
#pragma once

#include <cstdint>

namespace alphascope {

// Identifies the inputs of a result. Equal keys have equal results.
struct Key {
  std::uint64_t balls = 0;  // Inputs::balls_key; 0: the inputs do not suffice
  std::uint64_t alpha = 0;  // differs between alphas; 0: the result has no alpha
  std::uint64_t more = 0;   // identifies other choices that the definition uses

  explicit operator bool() const { return balls != 0; }
  friend bool operator==(const Key&, const Key&) = default;

  std::uint64_t number() const;  // a hash; two keys share it with probability 2^-64
};

}  // namespace alphascope
