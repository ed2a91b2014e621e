// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that texts from files become printable.
#include "core/text/printable.hpp"

#include <gtest/gtest.h>

#include "core/geometry/lattice_alpha.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/selection/provenance.hpp"
#include "core/selection/selection_expression.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

using std::string_literals::operator""s;

TEST(Printable, WhatCannotBeSeenIsSpelt) {
  const std::pair<std::string, std::string> cases[] = {
      {"plain \\ \"text\"", "plain \\ \"text\""},
      {"α-hæmoglobin Å 蛋白 🧬", "α-hæmoglobin Å 蛋白 🧬"},
      {"\x1b[31mred\x1b]0;title\a", "\\x1B[31mred\\x1B]0;title\\x07"},
      {"a\tb", "a b"},
      {"a\rb\nc\x7f\0d"s, "a\\x0Db\\x0Ac\\x7F\\x00d"},
      {"\xc2\x9b"
       "31m",
       "\\u009B31m"},
      {"\x9b"
       "31m",
       "\\x9B31m"},
      {"abc\u202egnp.exe\u202c", "abc\\u202Egnp.exe\\u202C"},
      {"a\u2028b\u2066c\u200bd\ufeff", "a\\u2028b\\u2066c\\u200Bd\\uFEFF"},
      {"\U000e0041", "\\uE0041"},
      {"caf\xe9", "caf\\xE9"},
      {"\xc3", "\\xC3"},
      {"\xc0\xaf\xe0\x80\xaf", "\\xC0\\xAF\\xE0\\x80\\xAF"},  // overlong encodings
      {"\xed\xa0\x80", "\\xED\\xA0\\x80"},                    // half of a surrogate pair
      {"\xf4\x90\x80\x80", "\\xF4\\x90\\x80\\x80"},           // beyond Unicode
      {"\xf0\x9f\xa7", "\\xF0\\x9F\\xA7"},                    // cut
  };
  for (const auto& [text, shown] : cases) {
    EXPECT_EQ(printable(text), shown);
    EXPECT_EQ(is_printable(text), text == shown) << shown;
    EXPECT_TRUE(is_printable(printable(text))) << shown;
  }
}

TEST(Printable, EveryByteComesOutPrintable) {
  for (int a = 0; a < 256; ++a) {
    for (int b = 0; b < 256; ++b) {
      const std::string text = {static_cast<char>(a), static_cast<char>(b)};
      EXPECT_TRUE(is_printable(printable(text))) << a << ' ' << b;
    }
  }
}

TEST(Printable, JsonKeepsItsLinesAndItsMeaning) {
  EXPECT_EQ(printable_json("{\n  \"é\": \"\u009b\u202e\U000e0041\"\n}\n"),
            "{\n  \"é\": \"\\u009b\\u202e\\udb40\\udc41\"\n}\n");
}

constexpr const char* kEvil = "\x1b]0;x\a\xc2\x9b\xff\u202e";

void expect_printable(const Molecule& m) {
  EXPECT_TRUE(is_printable(m.title)) << m.title;
  for (const std::string& note : m.notes) EXPECT_TRUE(is_printable(note)) << note;
  for (NameId id = 0; id < m.names.size(); ++id) EXPECT_TRUE(is_printable(m.text(id)));
  for (std::size_t i = 0; i < m.atoms.size(); ++i) EXPECT_TRUE(is_printable(atom_label(m, i)));
  for (const AssemblyInfo& a : list_assemblies(m)) EXPECT_TRUE(is_printable(a.id + a.details));
  BallOptions options;
  options.selection = "not name \"\x1b\"";
  const PreparedBalls prepared = prepare_balls(m, options);
  for (const auto& [key, value] : provenance(m, options, prepared.report)) {
    EXPECT_TRUE(is_printable(value)) << key;
  }
  for (const GuessedRadius& g : prepared.report.guessed) EXPECT_TRUE(is_printable(g.atoms));
  for (const DroppedAtoms& d : prepared.report.dropped) EXPECT_TRUE(is_printable(d.residue));
}

TEST(Printable, NamesAndTitlesOfFilesAreSo) {
  const std::string evil = kEvil;
  Molecule m = read_text(
      "\x1b\a\u202e.pdb",
      "TITLE     " + evil +
          "\nREMARK 350 BIOMOLECULE: \x1b[1m\nREMARK 350 AUTHOR DETERMINED BIOLOGICAL UNIT: \a"
          "\nREMARK 350 APPLY THE FOLLOWING TO CHAINS: \x1b\n"
          "REMARK 350   BIOMT1   1  1 0 0 0\nREMARK 350   BIOMT2   1  0 1 0 0\n"
          "REMARK 350   BIOMT3   1  0 0 1 0\n"
          "HETATM    1  C\x1b\x9b\x07L\xffG \x1b   1\r     27.340  24.430   2.614  1.00  9.67\n"
          "HETATM    2  C\x1b\x9b\x08L\xffG \x1b   1\r     28.340  24.430   2.614  1.00  9.67\n");
  expect_printable(m);
  EXPECT_EQ(m.text(m.atoms[0].chain), "\\x1B");
  EXPECT_EQ(m.atoms[0].insertion_code, '?');
  EXPECT_EQ(m.atoms[0].altloc, '?');
  EXPECT_EQ(expand_assembly(m, "\\x1B[1m").atoms.size(), 2u) << "chains are still found";
  BallOptions options;
  options.chains = {"\x1b"};
  EXPECT_EQ(prepare_balls(m, options).report.dropped_chains, 0u);

  // CIF does not allow such characters: see the messages below.
  expect_printable(read_text("a.xyz", "1\n" + evil + "\nC\x1b 1 2 3\n"));
  expect_printable(read_text("a.xyzr", "1 2 3 1.5 " + evil + "\n"));
  expect_printable(read_text("a.pqr", "ATOM 1 C\x1b L\xffG A\a 1 1.0 2.0 3.0 0.5 1.5\n"));
}

TEST(Printable, NamesThatDifferStayDifferent) {
  NameTable names;
  EXPECT_NE(names.intern("\x01"), names.intern("\x02"));
  EXPECT_EQ(names.intern("\x01"), names.find("\x01"));
  EXPECT_EQ(names.text(names.intern("\xff")), "\\xFF");
}

TEST(Printable, MessagesAreSo) {
  const std::string evil = kEvil;
  for (const std::string& text :
       {evil, "ATOM      1  N   MET A   1      " + evil + "\n", "2\n\nC 1 2 " + evil + "\n",
        "1 2 3 " + evil + "\n1 2 3 4\n", "data_x\nloop_\n_atom_site.x\n" + evil + "\n"}) {
    for (const char* name : {"\x1b\u202e.pdb", "\x07.xyz", "\xff.xyzr", "a.cif", "a"}) {
      const TemporaryFile file(name, text);
      try {
        read_molecule(file.path());
      } catch (const ReadError& error) {
        EXPECT_TRUE(is_printable(error.what())) << error.what();
        EXPECT_TRUE(is_printable(error.reason())) << error.reason();
      }
    }
  }
  for (const std::string& selection :
       {evil, "resi " + evil, "element " + evil, "chain A " + evil}) {
    try {
      SelectionExpression::parse(selection);
      ADD_FAILURE() << selection;
    } catch (const SelectionError& error) {
      EXPECT_TRUE(is_printable(error.what())) << error.what();
    }
  }
}

}  // namespace
}  // namespace alphascope
