// Whole numbers with commas between thousands, as every text for people writes them: "16,445".
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

}  // namespace alphascope
