// Numbers with a point, as window and pictures write them. Pure text.
#pragma once

#include <string>

namespace alphascope {

// "−0.25"; from 10⁹ up with a power of ten: "10²⁴".
std::string number_text(double value, int decimals);
// "1.4", "0", "−0.25": as few decimals as say the value, at most `decimals`.
std::string short_number_text(double value, int decimals);
// A sentence with its numbers as above: "ρ = -2.9 Å²" with a true minus sign.
std::string with_minus_signs(const std::string& sentence);

}  // namespace alphascope
