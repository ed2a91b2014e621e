// SPDX-License-Identifier: GPL-3.0-or-later
// Tests addresses of atoms: written, read back, and refused.
#include "core/selection/atom_address.hpp"

#include <gtest/gtest.h>

#include "core/geometry/lattice_alpha.hpp"
#include "core/selection/selection_error.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

constexpr const char* kFile =
    "ATOM      1  N   HIS A  87      27.340  24.430   2.614  1.00  9.67           N  \n"
    "ATOM      2  NE2AHIS A  87A     26.266  25.413   2.842  0.40 10.38           N  \n"
    "ATOM      3  O5\"  DA B  12      26.266  25.413  -2.842  0.60 10.38           O  \n"
    "HETATM    4 ZN    ZN B  -3       1.266  25.413   8.842  1.00 10.38          ZN  \n"
    "HETATM    5  C1  12A C  12       2.266  25.413   8.842  1.00 10.38           C  \n"
    "HETATM    6  C1  2HP C  14       2.266  29.413   8.842  1.00 10.38           C  \n";

const Molecule& molecule() {
  static const Molecule m = read_text("a.pdb", kFile);
  return m;
}

std::string picked(const std::string& text) {
  const auto is_named = atoms_named(molecule(), text);
  std::string result;
  for (std::size_t i = 0; i < molecule().atoms.size(); ++i) {
    if (is_named(i)) result += static_cast<char>('1' + i);
  }
  return result;
}

std::string refusal(const std::string& text) {
  try {
    atoms_named(molecule(), text);
  } catch (const SelectionError& error) {
    return error.what();
  }
  return "";
}

TEST(AtomAddress, WhatIsSaidOfAnAtomFindsIt) {
  const char* expected[] = {"A:HIS 87:N", "A:HIS 87A:NE2:A", "B:DA 12:O5\"",
                            "B:ZN -3:ZN", "C:12A 12:C1",     "C:2HP 14:C1"};
  ASSERT_EQ(molecule().atoms.size(), std::size(expected));
  for (std::size_t i = 0; i < molecule().atoms.size(); ++i) {
    const std::string address = atom_address(molecule(), i);
    EXPECT_EQ(address, expected[i]);
    EXPECT_EQ(picked(address), std::string(1, static_cast<char>('1' + i))) << address;
  }
}

TEST(AtomAddress, PartsThatAreLeftOutMeanAny) {
  const struct {
    const char *text, *atoms;
  } cases[] = {{"A:", "12"},
               {"A:HIS", "12"},
               {":HIS 87", "12"},  // a number without letter: all its insertion codes
               {"A:87A", "2"},
               {":12", "35"},
               {":12A 12", "5"},
               {":10-20", "356"},
               {"::C1", "56"},
               {"*:*:C1", "56"},
               {":::A", "2"},
               {" A : HIS  87 : N ", "1"},
               {"A:HIS 87:N, B:-3 ,C:2HP", "146"},
               {"#4", "4"},
               {"#1,B:", "134"},
               {"chain B and element Zn", "4"},
               {"name \"C#\",C?", "56"},
               {"X:", ""}};
  for (const auto& c : cases) EXPECT_EQ(picked(c.text), c.atoms) << c.text;
}

TEST(AtomAddress, SaysWhyAndWhere) {
  EXPECT_NE(refusal("A:, 87").find("column 4: \"87\" has no colon; write CHAIN:RESIDUE:ATOM"),
            std::string::npos)
      << refusal("A:, 87");
  EXPECT_NE(refusal("A:HIS x87:N").find("\"x87\" is not a residue number"), std::string::npos);
  EXPECT_NE(refusal("A:1:B:C:D").find("more than four parts"), std::string::npos);
  EXPECT_NE(refusal("A:,,B:").find("column 4: there is no address here"), std::string::npos)
      << refusal("A:,,B:");
  for (const char* bad : {"#0", "#", "#x", "#1x", "#99999999999999999999999"}) {
    EXPECT_NE(refusal(bad).find("is not an atom of a file"), std::string::npos) << bad;
  }
  EXPECT_NE(refusal("chian A").find("is not a selection"), std::string::npos);
}

}  // namespace
}  // namespace alphascope
