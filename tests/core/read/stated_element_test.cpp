// SPDX-License-Identifier: GPL-3.0-or-later
// Tests columns of elements: symbols, charges, types of force fields.
#include "core/read/residues/stated_element.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/read/residues/autodock_types.hpp"

namespace alphascope {
namespace {

void expect_stated(const StatedElement& stated, ElementStatement what, const char* symbol,
                   const std::string& text) {
  EXPECT_EQ(stated.what, what) << text;
  EXPECT_EQ(stated.element, *symbol ? element_from_symbol(symbol) : kUnknownElement) << text;
}

TEST(StatedElement, SymbolsMayHaveACharge) {
  for (const auto& [text, symbol] :
       {std::pair("C", "C"), std::pair("zn", "ZN"), std::pair("ZN", "ZN"), std::pair("Zn2+", "ZN"),
        std::pair("O2-", "O"), std::pair("N1+", "N"), std::pair("Na+", "NA"),
        std::pair("Fe+3", "FE"), std::pair("Ca++", "CA"), std::pair("CL-", "CL")}) {
    expect_stated(stated_element(text), ElementStatement::element, symbol, text);
  }
}

TEST(StatedElement, WhatIsNoneIsTold) {
  expect_stated(stated_element(""), ElementStatement::none, "", "nothing");
  for (const char* text : {"X", "xx"}) {
    expect_stated(stated_element(text), ElementStatement::placeholder, "", text);
  }
  for (const char* text : {"EP", "epw", "LP", "VS", "DU", "Mw"}) {
    expect_stated(stated_element(text), ElementStatement::virtual_site, "", text);
  }
  for (const char* text :
       {"C12", "OA", "2+", "+", "Zn2+-", "Zn+2+", "Zn2", "Qq+", "C+1.5", "Zn222222+", "carbon"}) {
    expect_stated(stated_element(text), ElementStatement::other, "", text);
  }
}

TEST(StatedElement, OfAutoDocksTypes) {
  // AutoDock 4.2's table, where case matters.
  for (const auto& [type, symbol] :
       {std::pair("A", "C"),   std::pair("C", "C"),    std::pair("HD", "H"),  std::pair("HS", "H"),
        std::pair("H", "H"),   std::pair("N", "N"),    std::pair("NA", "N"),  std::pair("NS", "N"),
        std::pair("OA", "O"),  std::pair("OS", "O"),   std::pair("SA", "S"),  std::pair("S", "S"),
        std::pair("Na", "NA"), std::pair("Cl", "CL"),  std::pair("CL", "CL"), std::pair("Zn", "ZN"),
        std::pair("F", "F"),   std::pair("Fe", "FE"),  std::pair("P", "P"),   std::pair("I", "I"),
        std::pair("CG0", "C"), std::pair("CG12", "C"), std::pair("Q", "C")}) {
    expect_stated(autodock_element(type), ElementStatement::element, symbol, type);
  }
  for (const char* type : {"G0", "G12", "TZ", "W"}) {
    expect_stated(autodock_element(type), ElementStatement::virtual_site, "", type);
  }
  expect_stated(autodock_element(""), ElementStatement::none, "", "nothing");
  expect_stated(autodock_element("OX9"), ElementStatement::other, "", "OX9");
}

}  // namespace
}  // namespace alphascope
