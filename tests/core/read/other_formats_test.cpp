// SPDX-License-Identifier: GPL-3.0-or-later
// Tests PQR, the three kinds of XYZ, CHARMM cards, and the recognition of formats.
#include <cstdio>
#include <string>
#include <utility>

#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

TEST(ReadPqr, FieldsAndColumns) {
  const Molecule m =
      read_text("a.pqr",
                "REMARK   1 PQR file\n"
                "ATOM      1  N    ILE    16       5.007   -9.234   18.432 -0.3000 1.8500\n"
                "ATOM      2  CA  ALA A   1    1999.3232998.770-900.490  0.1414 1.8240\n"
                "HETATM    3  C1  LIG A1001B   1999.323 2998.770 -900.490  0.1414 0\n");
  ASSERT_EQ(m.atoms.size(), 3u);
  EXPECT_EQ(m.lattice.digits, 3);
  EXPECT_EQ(m.atoms[0].position, (LatticePoint{5007, -9234, 18432}));
  EXPECT_EQ(m.atoms[0].file_radius, 1850);
  EXPECT_EQ(m.atoms[1].position, (LatticePoint{1999323, 2998770, -900490}));
  EXPECT_EQ(m.text(m.atoms[1].chain), "A");
  EXPECT_EQ(m.atoms[2].residue_number, 1001);
  EXPECT_EQ(m.atoms[2].insertion_code, 'B');
  EXPECT_EQ(m.atoms[2].file_radius, 0);
  EXPECT_EQ(prepare_balls(m).report.dropped_zero_radius, 1u);
}

TEST(ReadPqr, RefusesWithTheLine) {
  const std::string good = "ATOM 1 N ILE 16 5.0 -9.2 18.4 -0.3 1.85\n";
  EXPECT_EQ(refusal("a.pqr", good + "ATOM 1 N ILE 16 5.0 -9.2 18.4 -0.3 -1\n").line(), 2u);
  EXPECT_EQ(refusal("a.pqr", good + "ATOM 1 N ILE 16 5.0 -9.2 18.4 -0.3\n").line(), 2u);
  EXPECT_EQ(refusal("a.pqr", good + "ATOM 1 N ILE 16 nan -9.2 18.4 -0.3 1\n").line(), 2u);
  EXPECT_EQ(refusal("a.pqr", good + "ATOM 1 N ILE X 5.0 -9.2 18.4 -0.3 1\n").line(), 2u);
}

TEST(ReadXyz, FramesSymbolsAndNumbers) {
  const Molecule m =
      read_text("a.xyz", "2\nfirst\nC 1 2 3\nCl1 4 5 6 0.3\n\n1\n\n8 1.5 2 -3\n\n\n");
  ASSERT_EQ(m.models.size(), 2u);
  EXPECT_EQ(m.title, "first");
  EXPECT_EQ(m.atoms[1].element, 17);
  EXPECT_EQ(m.atoms[2].element, 8);
  EXPECT_EQ(m.atoms[2].position, (LatticePoint{1500, 2000, -3000}));
}

TEST(ReadXyz, ExtendedColumns) {
  const Molecule m = read_text(
      "a.xyz", "1\nProperties=id:I:1:pos:R:3:radius:R:1:species:S:1 energy=3\n7 1 2 3 1.25 Zn\n");
  EXPECT_EQ(m.atoms[0].element, 30);
  EXPECT_EQ(m.atoms[0].position.x, 1000);
  EXPECT_EQ(m.atoms[0].file_radius, 1250);
  EXPECT_EQ(refusal("a.xyz", "1\nProperties=species:S:1:pos:R:3:q:R:1\nC 1 2 3\n").line(), 3u);
  EXPECT_EQ(refusal("a.xyz", "1\nProperties=species:S\nC 1 2 3\n").line(), 2u);
}

TEST(ReadXyz, Tinker) {
  const Molecule m =
      read_text("a.xyz", "    2 water\n 90 90 90 90 90 90\n 1 OW 1 2 3 221 2\n 2 HW 2 2 3 222 1\n");
  EXPECT_EQ(m.format, "Tinker XYZ");
  ASSERT_EQ(m.atoms.size(), 2u);
  EXPECT_EQ(m.atoms[0].element, 8);
  EXPECT_EQ(m.atoms[1].element, 1);
}

TEST(ReadXyz, RefusesWithTheLine) {
  EXPECT_EQ(refusal("a.xyz", "2\n\nC 1 2 3\n").reason(),
            "the atoms end after 1 of the 2 that line 1 announces");
  EXPECT_EQ(refusal("a.xyz", "1\n\nC 1 2 3\nC 1 2 4\n").line(), 4u);
  EXPECT_EQ(refusal("a.xyz", "1\n\nC 1 2 inf\n").line(), 3u);
  EXPECT_EQ(refusal("a.xyz", "99999999999999999999\n\nC 1 2 3\n").line(), 1u);
  EXPECT_EQ(refusal("a.xyz", "9999999999999999\n\nC 1 2 3\n").line(), 3u)
      << "no memory for a wrong count";
}

TEST(ReadCharmmCard, NarrowAndWide) {
  const Molecule narrow =
      read_text("a.crd",
                "* TITLE\n*\n    2\n"
                "    1    1 LYS  N    -14.05410-114.28359  43.57444 G    1      0.00000\n"
                "    2    2 ZN2  ZN     1.00000   2.00000   3.00000 HET  12A    0.00000\n");
  ASSERT_EQ(narrow.atoms.size(), 2u);
  EXPECT_EQ(narrow.format, "CHARMM CRD");
  EXPECT_EQ(narrow.lattice.digits, 5);
  EXPECT_EQ(narrow.atoms[0].position, (LatticePoint{-1405410, -11428359, 4357444}));
  EXPECT_EQ(narrow.atoms[1].residue_number, 12);
  EXPECT_EQ(narrow.atoms[1].insertion_code, 'A');
  EXPECT_EQ(narrow.atoms[1].element, 30);
  EXPECT_EQ(narrow.atoms[1].kind, ResidueKind::ion);
  const Molecule wide =
      read_text("a.crd",
                "* TITLE\n         1  EXT\n"
                "         1         1  LYS       N             -14.0541000000       14.2835900000"
                "       43.5744400000  PROA      1               0.0000000000\n");
  EXPECT_EQ(wide.atoms[0].position, (LatticePoint{-1405410, 1428359, 4357444}));
  EXPECT_EQ(wide.text(wide.atoms[0].chain), "PROA");
  EXPECT_EQ(
      refusal("a.crd", "* T\n    2\n    1    1 LYS  N    -14.05410  14.28359  43.57444 G    1\n")
          .line(),
      2u);
}

// A card with so many atoms, without EXT, in the columns for that number.
std::string card_of(int atoms) {
  const char* const format = atoms < 100000
                                 ? "%5d%5d LYS  N   %10.5f%10.5f%10.5f PROA 1      0.00000\n"
                                 : "%10d%10d  LYS       N       %20.10f%20.10f%20.10f  PROA      1"
                                   "               0.0000000000\n";
  std::string text = "* TITLE\n*\n" + std::to_string(atoms) + "\n";
  for (int n = 1; n <= atoms; ++n) {
    char line[200];
    const int size = std::snprintf(line, sizeof line, format, n, n % 1000, n % 9973 / 16.0,
                                   n % 9967 / 16.0, n % 9949 / 16.0);
    text.append(line, static_cast<std::size_t>(size));
  }
  return text;
}

// From 100,000 atoms on CHARMM writes wide lines. Older versions do not write EXT then.
TEST(ReadCharmmCard, From100000AtomsOnLinesAreWide) {
  for (const int atoms : {99'999, 100'000}) {
    const Molecule m = read_text("a.crd", card_of(atoms));
    ASSERT_EQ(m.atoms.size(), static_cast<std::size_t>(atoms));
    EXPECT_EQ(m.lattice.digits, 4);  // sixteenths
    EXPECT_EQ(m.atoms.back().position,
              (LatticePoint{atoms % 9973 * 625, atoms % 9967 * 625, atoms % 9949 * 625}));
    EXPECT_EQ(m.text(m.atoms.back().residue_name), "LYS");
    EXPECT_EQ(m.text(m.atoms.back().chain), "PROA");
  }
}

TEST(SniffFormat, ContentGoesBeforeTheExtension) {
  EXPECT_EQ(read_text("a.txt", "2\nwater\nO 0 0 0\nH 0 0 1\n").format, "XYZ");
  EXPECT_EQ(read_text("a.pdb", "1 2 3 1.5\n").format, "XYZR");
  EXPECT_EQ(read_text("a.xyzr", "ATOM      1  N   MET A   1      27.340  24.430   2.614\n").format,
            "PDB");
  EXPECT_EQ(read_text("a", "REMARK 1 PQR file\nATOM 1 N ILE 16 5.0 -9.2 18.4 -0.3 1.85\n").format,
            "PQR");
  EXPECT_EQ(read_text("A.CRD", "1\n\n1 2 3 1.5\n").format, "CRD");
}

TEST(SniffFormat, WordsOfATitleAreNoMarks) {
  // The word is at the byte where density maps, tar archives and DCD files have their marks.
  for (const auto& [at, word] : {std::pair{208, "MAP "}, {257, "ustar"}}) {
    std::string text;
    for (int k = 0; k < 4; ++k) text += "REMARK   1" + std::string(70, ' ') + "\n";
    text.replace(static_cast<std::size_t>(at), std::string(word).size(), word);
    text += "ATOM      1  N   MET A   1      27.340  24.430   2.614\n";
    EXPECT_EQ(read_text("a.pdb", text).format, "PDB") << word;
  }
  EXPECT_EQ(read_text("a.xyz", "1\n  CORD of a spine\nC 1 2 3\n").atoms.size(), 1u);
}

TEST(SniffFormat, UnknownFilesAreDescribed) {
  using namespace std::string_view_literals;
  const struct {
    std::string_view text, what, remedy;
  } cases[] = {
      {"Dear reader,\nhello\n", "a text that begins with \"Dear reader,\"",
       "Formats that can be opened"},
      {"\x7f"
       "ELF\0\1"sv,
       "a binary file", "Formats that can be opened"},
      {"<!DOCTYPE html>\n<p>404</p>", "a web page", "browser"},
      {"\n<HTML>", "a web page", "browser"},
      {"<?xml version='1.0'?>", "XML", "mmCIF"},
      {"{\"a\": 1}", "JSON", "Formats that can be opened"},
      {">1CRN\nTTCC\n", "a sequence", "coordinates"},
      {"BZh91AY&SY", "bzip2", "Unpack"},
      {"\xfd"
       "7zXZ\0\0"sv,
       "xz", "Unpack"},
      {"PK\3\4\0\0"sv, "zip", "inside"},
      {"%PDF-1.4\n", "PDF", "mmCIF"},
      {"\xff\xfe"
       "A\0T\0"sv,
       "UTF-16", "UTF-8"},
      {"\n  RDKit\n\n  3  2  0  0  0  0  0  0  0  0999 V2000\n", "molfile", "Open Babel"},
      {"Water\n    1\n    1SOL     OW    1   0.126   1.624    none\n",
       "a text that begins with \"Water\"", "Formats that can be opened"},
      {"\x83\xa7"
       "encoder\xaa"
       "dataBlocks\x91",
       "BinaryCIF", "mmCIF"},
      {"1.0,2.0,3.0,1.5\n", "a table of numbers with \",\"", "XYZR"},
      {"OFF\n3 1 0\n0 0 0\n", "surface mesh", "coordinates"},
      {"\x54\0\0\0CORD\0\0"sv, "DCD", "frames"},
  };
  // The name does not matter. A page that says "not found" may be saved under a molecule's name.
  for (const char* name : {"a.dat", "a.pdb", "a.cif.gz", "a.xyzr"}) {
    for (const auto& c : cases) {
      if (std::string_view(name) != "a.dat" && c.remedy.starts_with("Formats")) continue;
      const ReadError error = refusal(name, c.text);
      EXPECT_NE(error.reason().find(c.what), std::string::npos) << name << ": " << error.what();
      EXPECT_NE(error.remedy().find(c.remedy), std::string::npos) << name << ": " << error.what();
    }
  }
  EXPECT_NE(refusal("a.pdb", "Dear reader,\n").reason().find("Dear reader"), std::string::npos);
  EXPECT_EQ(refusal("a.dat", "").reason(), "the file is empty: it holds no atoms");
  EXPECT_EQ(refusal("a.pdb", " \n\r\n").reason(),
            "the file has nothing but blanks: it holds no atoms");
}

}  // namespace
}  // namespace alphascope
