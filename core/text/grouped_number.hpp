// SPDX-License-Identifier: GPL-3.0-or-later
// Whole numbers with commas between thousands, as in all text for people: "16,445".
#pragma once

#include <cstdint>
#include <string>

namespace alphascope {

inline std::string grouped_digits(std::string digits) {
  for (std::size_t k = digits.size(); k > 3; k -= 3) digits.insert(k - 3, ",");
  return digits;
}

inline std::string grouped(std::uint64_t number) {
  return grouped_digits(std::to_string(number));
}

// "1 atom", "2,340 atoms".
inline std::string counted(std::uint64_t count, const char* one, const char* many) {
  return grouped(count) + ' ' + (count == 1 ? one : many);
}

}  // namespace alphascope
