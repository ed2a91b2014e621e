// SPDX-License-Identifier: GPL-3.0-or-later
// Parses decimal, hybrid-36 and hexadecimal numbers of PDB files.
#include "core/read/pdb/pdb_numbers.hpp"

#include <charconv>

#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/name_table.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

bool is_decimal_digit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace

bool parse_pdb_integer(std::string_view text, std::int32_t& value) {
  text = trimmed(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && !text.empty() && end == text.data() + text.size();
}

std::int32_t parse_pdb_number(std::string_view text, std::size_t width) {
  std::int32_t value = 0;
  if (parse_pdb_integer(text, value)) return value;
  text = trimmed(text);
  if (text.size() == width && text.front() >= 'A') {
    const bool lower = text.front() >= 'a';
    std::int64_t number = 0;
    for (const char c : text) {
      const int digit = is_decimal_digit(c) ? c - '0' : (lower ? c - 'a' : c - 'A') + 10;
      if (digit < 0 || digit > 35) return 0;
      number = number * 36 + digit;
    }
    // Numbers with a letter start at A00…, which stands for 100…. Lower case follows upper case.
    std::int64_t power = 1, decimal = 1;
    for (std::size_t k = 1; k < width; ++k) power *= 36, decimal *= 10;
    number += decimal * 10 - 10 * power;
    if (lower) number += 26 * power;
    return number <= INT32_MAX ? static_cast<std::int32_t>(number) : 0;
  }
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  return error == std::errc() && end == text.data() + text.size() ? value : 0;
}

std::int32_t PdbResidueNumbers::next(std::string_view text, std::size_t line) {
  constexpr std::int32_t kLast = 9999;
  constexpr std::string_view kNext = "2710";  // hexadecimal for 10000
  const std::string_view digits = trimmed(text);
  if (last_ == kLast && digits == kNext) hexadecimal_ = true;
  std::int32_t number = 0;
  if (hexadecimal_) {
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), number, 16);
    const bool whole = error == std::errc() && end == digits.data() + digits.size();
    hexadecimal_ = whole && number > kLast;
  }
  last_ = hexadecimal_ ? number : parse_pdb_number(text, 4);
  if (last_ == 0 && digits.find_first_not_of("+-0") != digits.npos) no_numbers_.add(line);
  return last_;
}

}  // namespace alphascope
