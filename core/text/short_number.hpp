// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers with at most six digits, for sentences: "1.4", "0.333333".
#pragma once

#include <cstdio>
#include <string>

namespace alphascope {

inline std::string short_number(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", number == 0 ? 0 : number);
  return text;
}

}  // namespace alphascope
