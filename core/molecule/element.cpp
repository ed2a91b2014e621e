// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols of the elements and their look-up.
#include "core/molecule/element.hpp"

#include <array>

namespace alphascope {
namespace {

constexpr std::array<std::string_view, kHeaviestElement + 1> kSymbols = {
    "X",  "H",  "He", "Li", "Be", "B",  "C",  "N",  "O",  "F",  "Ne", "Na", "Mg", "Al", "Si",
    "P",  "S",  "Cl", "Ar", "K",  "Ca", "Sc", "Ti", "V",  "Cr", "Mn", "Fe", "Co", "Ni", "Cu",
    "Zn", "Ga", "Ge", "As", "Se", "Br", "Kr", "Rb", "Sr", "Y",  "Zr", "Nb", "Mo", "Tc", "Ru",
    "Rh", "Pd", "Ag", "Cd", "In", "Sn", "Sb", "Te", "I",  "Xe", "Cs", "Ba", "La", "Ce", "Pr",
    "Nd", "Pm", "Sm", "Eu", "Gd", "Tb", "Dy", "Ho", "Er", "Tm", "Yb", "Lu", "Hf", "Ta", "W",
    "Re", "Os", "Ir", "Pt", "Au", "Hg", "Tl", "Pb", "Bi", "Po", "At", "Rn", "Fr", "Ra", "Ac",
    "Th", "Pa", "U",  "Np", "Pu", "Am", "Cm", "Bk", "Cf", "Es", "Fm", "Md", "No", "Lr", "Rf",
    "Db", "Sg", "Bh", "Hs", "Mt", "Ds", "Rg", "Cn", "Nh", "Fl", "Mc", "Lv", "Ts", "Og"};

// 0 to 25 for a letter of either case, 31 for any other character.
constexpr unsigned letter(char c) {
  if (c >= 'a' && c <= 'z') return static_cast<unsigned>(c - 'a');
  if (c >= 'A' && c <= 'Z') return static_cast<unsigned>(c - 'A');
  return 31;
}

// Indexed by both letters of a symbol, because millions of atoms are looked up. Index 26: no second
// letter.
constexpr auto make_lookup() {
  std::array<std::array<Element, 27>, 26> table{};
  for (unsigned z = 1; z <= kHeaviestElement; ++z) {
    const std::string_view s = kSymbols[z];
    table[letter(s[0])][s.size() > 1 ? letter(s[1]) : 26] = static_cast<Element>(z);
  }
  table[letter('D')][26] = kHydrogen;
  table[letter('T')][26] = kHydrogen;
  return table;
}

constexpr auto kLookup = make_lookup();

}  // namespace

std::string_view element_symbol(Element element) {
  return element <= kHeaviestElement ? kSymbols[element] : kSymbols[0];
}

Element element_from_symbol(std::string_view symbol) {
  if (symbol.empty() || symbol.size() > 2) return kUnknownElement;
  const unsigned first = letter(symbol[0]);
  const unsigned second = symbol.size() == 2 ? letter(symbol[1]) : 26;
  return first < 26 && second <= 26 ? kLookup[first][second] : kUnknownElement;
}

bool is_metal(Element z) {
  const auto within = [z](int low, int high) { return z >= low && z <= high; };
  return within(3, 4) || within(11, 13) || within(19, 31) || within(37, 50) || within(55, 84) ||
         within(87, 116);
}

bool is_halogen(Element z) {
  return z == 9 || z == 17 || z == 35 || z == 53;
}

}  // namespace alphascope
