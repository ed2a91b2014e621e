// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers with a decimal point, as in window and pictures. Pure text.
#pragma once

#include <string>

namespace alphascope {

// "−0.25"; from 10⁹ on with a power of ten: "10²⁴".
std::string number_text(double value, int decimals);
// "1.4", "0", "−0.25": without zeros at the end, with at most `decimals` decimals.
std::string short_number_text(double value, int decimals);
// Replaces the minus signs of numbers in a sentence by true ones: "ρ = -2.9 Å²" becomes "ρ = −2.9
// Å²".
std::string with_minus_signs(const std::string& sentence);

}  // namespace alphascope
