// SPDX-License-Identifier: GPL-3.0-or-later
// Reads numbers and their units, and writes error messages with remedies.
#include "core/document/commands/number_input.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include "core/chart/readable_number.hpp"
#include "core/geometry/shortest_number.hpp"

namespace alphascope {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

void trim(std::string& text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && blank(text.back())) text.pop_back();
  text.erase(text.begin(), std::find_if_not(text.begin(), text.end(), blank));
}

// Spellings of the unit, also on keyboards without its letters.
std::vector<std::string_view> spellings(std::string_view unit) {
  if (unit == "Å") return {unit, "A"};
  if (unit == "Å²") return {unit, "Å2", "Å^2", "A²", "A2", "A^2"};
  if (unit == "Å³") return {unit, "Å3", "Å^3", "A³", "A3", "A^3"};
  return {unit};
}

// An error message if the text ends with a unit of another dimension, such as "Å" for an area.
// Empty if it does not.
std::string unit_error(const std::string& typed, const std::string& text, const NumberRule& rule) {
  struct Size {
    std::string_view unit, name;
  };
  static constexpr Size kSizes[] = {{"Å", "a length"}, {"Å²", "an area"}, {"Å³", "a volume"}};
  const auto own = std::find_if(std::begin(kSizes), std::end(kSizes),
                                [&](const Size& size) { return size.unit == rule.unit; });
  if (own == std::end(kSizes)) return {};
  for (const Size& size : kSizes) {
    if (&size == own) continue;
    for (const std::string_view other : spellings(size.unit)) {
      if (!text.ends_with(other)) continue;
      return "“" + typed + "” has another unit. " + rule.name + " is " + std::string(own->name) +
             ", in " + rule.unit + ". Write a number such as 1.4 " + rule.unit + ".";
    }
  }
  return {};
}

void drop_unit(std::string& text, const NumberRule& rule) {
  for (const std::string_view unit : spellings(rule.unit)) {
    if (unit.empty() || !text.ends_with(unit)) continue;
    text.resize(text.size() - unit.size());
    trim(text);
    return;
  }
}

void use_plain_marks(std::string& text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.erase(0, 1);
  std::replace(text.begin(), text.end(), ',', '.');
}

// Reads digits with at most one decimal point and perhaps an exponent. Other text of from_chars,
// such as "inf", is refused.
std::optional<double> number_in(const std::string& text) {
  const bool digits = std::any_of(text.begin(), text.end(), is_digit);
  const bool known = text.find_first_not_of("0123456789.eE+-") == std::string::npos;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (!digits || !known || end != text.data() + text.size()) return std::nullopt;
  // Beyond the range of double: an infinity, which every rule refuses, or 0.
  if (error == std::errc::result_out_of_range) {
    return text.find("e-") == std::string::npos && text.find("E-") == std::string::npos
               ? std::optional(text.front() == '-' ? -HUGE_VAL : HUGE_VAL)
               : std::optional(0.0);
  }
  return error == std::errc() ? std::optional(value) : std::nullopt;
}

std::string with_unit(const std::string& number, const NumberRule& rule) {
  return rule.unit[0] == '\0' ? number : number + " " + rule.unit;
}

std::string range_text(const NumberRule& rule) {
  return std::string(rule.name) + " must lie between " +
         readable_number(shortest_number(rule.least)) + " and " +
         with_unit(readable_number(shortest_number(rule.most)), rule);
}

std::string syntax_error(const std::string& typed, const NumberRule& rule) {
  const auto marks =
      std::count_if(typed.begin(), typed.end(), [](char c) { return c == ',' || c == '.'; });
  const std::string quoted = "“" + typed + "” ";
  if (marks > 1) return quoted + "has more than one decimal mark. Write a number such as 1234.5.";
  const char* example = rule.whole ? "20" : "1.4";
  const std::string unit = rule.unit[0] == '\0' ? "" : std::string(", in ") + rule.unit;
  return quoted + "is not a number. Write a number such as " + example + unit + ".";
}

// The text without surrounding blanks and unit, and with an ASCII minus sign.
std::string number_part(const std::string& typed, const NumberRule& rule) {
  std::string text = typed;
  trim(text);
  constexpr std::string_view kMinus = "−";
  if (text.starts_with(kMinus)) text.replace(0, kMinus.size(), "-");
  drop_unit(text, rule);
  return text;
}

}  // namespace

NumberInput read_number(const std::string& typed, const NumberRule& rule) {
  if (typed.find_first_not_of(" \t") == std::string::npos) {
    return {{}, "Write a number. " + range_text(rule) + "."};
  }
  const std::string text = number_part(typed, rule);
  std::string plain = text;
  use_plain_marks(plain);
  const auto value = number_in(plain);
  if (const std::string wrong = unit_error(typed, text, rule); !value && !wrong.empty()) {
    return {{}, wrong};
  }
  if (!value) return {{}, syntax_error(typed, rule)};
  if (!(*value >= rule.least && *value <= rule.most)) {
    return {{}, range_text(rule) + "; “" + typed + "” does not."};
  }
  if (rule.whole && *value != std::round(*value)) {
    return {{}, "“" + typed + "” is not a whole number. Write digits only, such as 20."};
  }
  return {*value == 0 ? 0 : *value, {}};  // not minus zero
}

AlphaInput read_alpha(const std::string& typed) {
  const NumberInput near = read_number(typed, kAlphaRule);
  if (!near.value) return {{}, near.error};
  std::string text = number_part(typed, kAlphaRule);
  use_plain_marks(text);
  Alpha alpha;
  switch (Alpha::read(text, alpha)) {
    case Alpha::Reading::ok:
      return {alpha, {}};
    case Alpha::Reading::too_fine:
      return {{},
              "“" + typed + "” has more than " + std::to_string(Alpha::kMostDigits) +
                  " digits behind the decimal point. Alpha is used exactly as it is written, with "
                  "at most that many. Leave some out."};
    case Alpha::Reading::too_large:
      return {{}, range_text(kAlphaRule) + "; “" + typed + "” does not."};
    case Alpha::Reading::malformed:
      break;
  }
  return {{}, syntax_error(typed, kAlphaRule)};
}

}  // namespace alphascope
