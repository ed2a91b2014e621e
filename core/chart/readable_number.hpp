// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in the form that people read, made from the output of printf().
#pragma once

#include <string>

namespace alphascope {

// Has a minus sign instead of a hyphen, and powers of ten: "−2.5", "10²⁴", "−1.2·10⁻⁵".
std::string readable_number(const std::string& printed);
// The same with commas between thousands: "−12,345.6".
std::string separated_number(const std::string& printed);

// Three significant digits, or all before the point: "0.0457", "12.3", "5,568", "1.2·10⁻⁵".
std::string chart_number(double value);

}  // namespace alphascope
