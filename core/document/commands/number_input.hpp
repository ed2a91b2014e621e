// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that users type, in the window and on the command line: one reader and one place for the
// bounds. Pure text.
#pragma once

#include <optional>
#include <string>

#include "core/geometry/alpha.hpp"

namespace alphascope {

struct NumberRule {
  const char* name;  // the beginning of a sentence: "Alpha"
  double least, most;
  const char* unit = "";  // may be typed after the number: "Å", "Å²", "%"
  bool whole = false;
};

inline constexpr NumberRule kAlphaRule{"Alpha", -kMaxAlphaAngstrom2, kMaxAlphaAngstrom2, "Å²"};
inline constexpr NumberRule kSolventRule{"The solvent radius", 0, 100, "Å"};
inline constexpr NumberRule kBallRadiusRule{"A radius", 0.001, 60, "Å"};
inline constexpr NumberRule kPictureSizeRule{"Width and height", 16, 16384, "", true};
inline constexpr NumberRule kDpiRule{"The resolution", 30, 2400, "dpi", true};
inline constexpr NumberRule kLettersRule{"The size of letters", 0.5, 4};
inline constexpr NumberRule kControlScaleRule{"The scale", 0.5, 4};
inline constexpr NumberRule kModelSpeedRule{"The speed", 0.5, 30, "/ s"};
inline constexpr NumberRule kPlaySpeedRule{"The speed", 0.1, 20};
inline constexpr NumberRule kRunsRule{"The number of runs", 1, 1000, "", true};
inline constexpr NumberRule kRowSecondsRule{"The time for a row", 1, 86400, "s", true};

struct NumberInput {
  std::optional<double> value;  // within the rule
  std::string error;            // a sentence with the remedy; empty when there is a value
};

// Reads "1.4", "1,4" (a decimal comma), "-2e3", " 1.4 Å " or "−3". Any other text is refused; no
// character is dropped silently.
NumberInput read_number(const std::string& text, const NumberRule& rule);

struct AlphaInput {
  std::optional<Alpha> value;
  std::string error;  // as above
};

// Reads alpha by kAlphaRule, with all digits. More than 18 digits after the point are refused.
AlphaInput read_alpha(const std::string& text);

}  // namespace alphascope
