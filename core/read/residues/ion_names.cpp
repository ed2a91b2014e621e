// SPDX-License-Identifier: GPL-3.0-or-later
// Tables and patterns of ion names.
#include "core/read/residues/ion_names.hpp"

#include <algorithm>
#include <iterator>
#include <string>

#include "core/text/letter_case.hpp"

namespace alphascope {
namespace {

// Names that are not a symbol with a charge or number. CIO and IB are AMBER's sodium; IB has six
// waters around it. BS3 to ZTM are from the dictionary, the others are CHARMM's.
constexpr struct {
  std::string_view name;
  Element element;
} kIonNames[] = {{"SOD", 11}, {"POT", 19}, {"CLA", 17}, {"CAL", 20}, {"CES", 55}, {"LIT", 3},
                 {"RUB", 37}, {"BAR", 56}, {"CAD", 48}, {"CIO", 11}, {"IB", 11},  {"IB+", 11},
                 {"IOD", 53}, {"IDO", 53}, {"BRO", 35}, {"CLO", 17}, {"FLO", 9},  {"NIO", 28},
                 {"BS3", 83}, {"YT3", 39}, {"ZCM", 96}, {"ZTM", 69}};

bool is_sign(char c) {
  return c == '+' || c == '-';
}

bool is_number_or_sign(char c) {
  return (c >= '0' && c <= '9') || is_sign(c);
}

Element ion_of_name(std::string_view name) {
  // The longest names are such as "MG+2", so longer ones need not be copied.
  if (name.empty() || name.size() > 5) return kUnknownElement;
  const std::string text = upper_case(name);
  const auto* found = std::find_if(std::begin(kIonNames), std::end(kIonNames),
                                   [&](const auto& ion) { return ion.name == text; });
  if (found != std::end(kIonNames)) return found->element;
  std::string_view symbol = text;
  while (!symbol.empty() && is_number_or_sign(symbol.back())) symbol.remove_suffix(1);
  while (!symbol.empty() && is_number_or_sign(symbol.front())) symbol.remove_prefix(1);
  const Element element = element_from_symbol(symbol);
  return is_metal(element) || is_halogen(element) ? element : kUnknownElement;
}

}  // namespace

Element ion_of_residue(std::string_view residue_name) {
  return ion_of_name(residue_name);
}

bool is_any_ion(std::string_view residue_name) {
  return upper_case(residue_name) == "ION";
}

Element ion_element(std::string_view residue_name, std::string_view atom_name) {
  const Element atom = ion_of_name(atom_name);
  const bool agree = is_any_ion(residue_name) || ion_of_residue(residue_name) == atom;
  return agree ? atom : kUnknownElement;
}

Element charged_ion(std::string_view atom_name) {
  const bool charged = std::any_of(atom_name.begin(), atom_name.end(), is_sign);
  return charged ? ion_of_name(atom_name) : kUnknownElement;
}

}  // namespace alphascope
