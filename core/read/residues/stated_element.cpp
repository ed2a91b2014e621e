// SPDX-License-Identifier: GPL-3.0-or-later
// Parses the element column of a file.
#include "core/read/residues/stated_element.hpp"

#include <algorithm>
#include <iterator>
#include <string>

#include "core/text/letter_case.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kLongest = 6;  // "Zn2+" and the like; longer texts are no element

// Texts of programs for points of a force field, which have no element.
constexpr std::string_view kVirtualSites[] = {"EP", "EPW", "LP", "VS", "DU", "DUM", "MW"};

bool is_digit_of_charge(char c) {
  return c >= '0' && c <= '9';
}

bool is_charge_sign(char c) {
  return c == '+' || c == '-';
}

}  // namespace

Element charged_symbol(std::string_view text) {
  if (text.size() < 2 || text.size() > kLongest) return kUnknownElement;
  std::size_t letters = 0;
  while (letters < text.size() && !is_digit_of_charge(text[letters]) &&
         !is_charge_sign(text[letters])) {
    ++letters;
  }
  const std::string_view charge = text.substr(letters);
  const auto signs = std::count_if(charge.begin(), charge.end(), is_charge_sign);
  const bool at_an_end =
      !charge.empty() && (is_charge_sign(charge.front()) || is_charge_sign(charge.back()));
  const bool all_digits = std::all_of(charge.begin(), charge.end(), [](char c) {
    return is_charge_sign(c) || is_digit_of_charge(c);
  });
  // Accepts "Cl-", "Zn2+" and "Fe+3", and "Ca++", which some programs write.
  const bool good = signs > 0 && at_an_end && all_digits &&
                    (signs == 1 || signs == static_cast<std::ptrdiff_t>(charge.size()));
  return good ? element_from_symbol(text.substr(0, letters)) : kUnknownElement;
}

StatedElement stated_element(std::string_view text) {
  if (text.empty()) return {};
  const Element plain = element_from_symbol(text);
  if (plain != kUnknownElement) return {ElementStatement::element, plain};
  const Element charged = charged_symbol(text);
  if (charged != kUnknownElement) return {ElementStatement::element, charged};
  if (text.size() > kLongest) return {ElementStatement::other, kUnknownElement};
  const std::string upper = upper_case(text);
  if (upper == "X" || upper == "XX") return {ElementStatement::placeholder, kUnknownElement};
  const bool site = std::find(std::begin(kVirtualSites), std::end(kVirtualSites), upper) !=
                    std::end(kVirtualSites);
  return {site ? ElementStatement::virtual_site : ElementStatement::other, kUnknownElement};
}

}  // namespace alphascope
