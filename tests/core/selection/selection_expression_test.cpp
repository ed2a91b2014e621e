// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the selection language.
#include "core/selection/selection_expression.hpp"

#include <gtest/gtest.h>

#include <bitset>
#include <iterator>
#include <random>

#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

constexpr const char* kFile =
    "ATOM      1  N   MET A  -1      27.340  24.430   2.614  1.00  9.67           N  \n"
    "ATOM      2  CA AMET A   1A     26.266  25.413   2.842  0.40 10.38           C  \n"
    "ATOM      3  C5'  DA B  12      26.266  25.413  -2.842  0.60 10.38           C  \n"
    "HETATM    4 ZN    ZN B  13       1.266  25.413   8.842  1.00 10.38          ZN  \n"
    "HETATM    5  C1  LIG C  14       2.266  25.413   8.842  1.00 10.38           C  \n"
    "HETATM    6  O   HOH C  15       3.266  25.413   8.842  1.00 10.38           O  \n"
    "ATOM      7  H   GLY D  16       3.266  25.413   9.842  1.00 10.38           H  \n";

std::string picked(const std::string& expression) {
  static const Molecule m = read_text("a.pdb", kFile);
  const auto bound = SelectionExpression::parse(expression).bind(m);
  std::string result;
  for (std::size_t i = 0; i < m.atoms.size(); ++i) {
    if (bound(m.atoms[i])) result += static_cast<char>('1' + i);
  }
  return result;
}

TEST(Selection, PicksWhatItSays) {
  const struct {
    const char *expression, *atoms;
  } cases[] = {{"", "1234567"},
               {"all", "1234567"},
               {"none", ""},
               {"chain A", "12"},
               {"chain A,B", "1234"},
               {"chain A, B", "1234"},
               {"CHAIN a", ""},
               {"resi 1", "2"},
               {"resi 1A", "2"},
               {"resi 1B", ""},
               {"resi -5-1", "12"},
               {"resi -5--1", "1"},
               {"resi 12-13,16", "347"},
               {"resn MET,LIG", "125"},
               {"resn *", "1234567"},
               {"resn M?T", "12"},
               {"name C5'", "3"},
               {"name \"C5'\"", "3"},
               {"name C*", "235"},
               {"element c", "235"},
               {"element Zn,O", "46"},
               {"altloc A", "2"},
               {"hetero", "456"},
               {"water or ion", "46"},
               {"ligand", "5"},
               {"hydrogen", "7"},
               {"polymer and not chain D", "123"},
               {"not chain A and not chain B", "567"},
               {"!(chain A | chain B)", "567"},
               {"chain A or chain B and element Zn", "124"},
               {"(chain A or chain B) && element Zn", "4"},
               {"residue MET,16", "127"},
               {"index 2-4,7", "2347"},
               {"copy 1", "1234567"},
               {"copy 2", ""},
               {"b > 9.67", "234567"},
               {"b<=9.67", "1"},
               {"b = 10.38 and occupancy < 1", "23"},
               {"occupancy >= 0.6", "134567"},
               {"protein", "127"},
               {"nucleic", "3"},
               {"backbone", "1237"},
               {"sidechain", ""},
               {"within 1 of index 5", "456"},
               {"within 0.999 of index 5", "5"},
               {"not within 5.7 of index 2", "4567"},
               {"within 0 of ligand or water", "56"},
               {"within 2 of (ligand or index 7) and not hydrogen", "456"},
               {"byres element C and chain A,B", "23"},
               {"bychain resi 13", "34"},
               {"within 3 of none", ""},
               {"within 1000 of chain D", "1234567"}};
  for (const auto& c : cases) EXPECT_EQ(picked(c.expression), c.atoms) << c.expression;
}

// A residue of unknown name is protein with both N and CA, and nucleic with C1'. One of N and CA is
// not enough.
TEST(Selection, APolymerOfUnknownNameIsKnownByItsAtoms) {
  Molecule m = read_text(
      "a.pdb",
      "ATOM      1  N   QZ1 A   1       1.000   2.000   3.000  1.00  0.00           N  \n"
      "ATOM      2  CA  QZ1 A   1       2.000   2.000   3.000  1.00  0.00           C  \n"
      "ATOM      3  CA  QZ2 A   2       4.000   2.000   3.000  1.00  0.00           C  \n"
      "ATOM      4  CB  QZ2 A   2       5.000   2.000   3.000  1.00  0.00           C  \n"
      "ATOM      5  N   QZ3 A   3       7.000   2.000   3.000  1.00  0.00           N  \n"
      "ATOM      6  CB  QZ3 A   3       8.000   2.000   3.000  1.00  0.00           C  \n"
      "ATOM      7  C1' QZ4 A   4      10.000   2.000   3.000  1.00  0.00           C  \n");
  for (Atom& atom : m.atoms) atom.kind = ResidueKind::polymer;
  const auto picked = [&](const char* text) {
    const auto bound = SelectionExpression::parse(text).bind(m);
    std::string atoms;
    for (const Atom& atom : m.atoms) {
      if (bound(atom)) atoms += std::to_string(atom.serial);
    }
    return atoms;
  };
  EXPECT_EQ(picked("protein"), "12");
  EXPECT_EQ(picked("nucleic"), "7");
}

TEST(Selection, AnAtomWithoutABFactorFitsNone) {
  const Molecule m =
      read_text("a.pdb",
                "ATOM      1  N   SER A   1       1.000   2.000   3.000  1.00  0.00           N  \n"
                "ATOM      2  CA  SER A   1       2.000   2.000   3.000\n");
  for (const char* text : {"b = 0", "b < 10", "b <= 0", "b >= 0"}) {
    const auto bound = SelectionExpression::parse(text).bind(m);
    EXPECT_TRUE(bound(m.atoms[0])) << text;
    EXPECT_FALSE(bound(m.atoms[1])) << text;
  }
}

TEST(Selection, ZonesAreExactAndAsThoughEveryPairWasTried) {
  std::mt19937 random(7);
  std::uniform_int_distribution<std::int32_t> place(-15000, 15000);
  Molecule m;
  m.lattice.digits = 3;
  for (int i = 0; i < 3000; ++i) {
    Atom atom;
    atom.position = {place(random), place(random), place(random) / 4};
    atom.b_factor = static_cast<float>(i % 50);
    atom.has_b_factor = true;
    m.atoms.push_back(atom);
  }
  m.models = {{1, 0, 2000}, {2, 2000, 3000}};
  // One pair at exactly 3 Å (1, 2 and 2), and one a lattice unit farther.
  m.atoms[50].position = {0, 0, 90000};
  m.atoms[1].position = {1000, 2000, 92000};
  m.atoms[100].position = {0, 0, -90000};
  m.atoms[2].position = {1000, 2000, -92001};
  for (const auto& [text, angstrom] : {std::pair{"within 3 of b = 0", 3.0},
                                       {"within 0.1 of b = 0", 0.1},
                                       {"within 20 of b = 0", 20.0}}) {
    const auto bound = SelectionExpression::parse(text).bind(m);
    for (const ModelRange& model : m.models) {
      for (std::size_t i = model.begin; i < model.end; ++i) {
        bool near = false;
        for (std::size_t k = (model.begin + 49) / 50 * 50; k < model.end && !near; k += 50) {
          const LatticePoint a = m.atoms[i].position, b = m.atoms[k].position;
          const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
          near = x * x + y * y + z * z <= angstrom * angstrom * 1e6;
        }
        ASSERT_EQ(bound(m.atoms[i]), near) << text << " " << i;
      }
    }
  }
  const auto exact = SelectionExpression::parse("within 3 of b = 0").bind(m);
  EXPECT_TRUE(exact(m.atoms[1]));
  EXPECT_FALSE(exact(m.atoms[2]));
}

TEST(Selection, WordsOfThePictureNeedOne) {
  const Molecule m = read_text("a.pdb", kFile);
  const auto fault = fault_of_selection("chain A or within 3 of selected");
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->column(), 24u);
  const SelectionExpression expression = SelectionExpression::parse("selected or hidden");
  EXPECT_THROW(static_cast<void>(expression.bind(m)), SelectionError);
  std::vector<bool> selected(7), hidden(7);
  selected[3] = hidden[5] = true;
  const auto bound = expression.bind(m, {&selected, &hidden});
  for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(bound(m.atoms[i]), i == 3 || i == 5);
}

// A random expression, and the atoms that it picks by set operations.
struct RandomExpression {
  std::mt19937 random;

  using Atoms = std::bitset<7>;
  struct Part {
    std::string text;
    Atoms atoms;
  };
  int any(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random); }

  Part test() {
    static const struct {
      const char *text, *atoms;
    } kTests[] = {{"chain A", "12"},  {"hetero", "456"},        {"element C", "235"},
                  {"resi 1A", "2"},   {"polymer", "1237"},      {"resn MET,LIG", "125"},
                  {"name C5'", "3"},  {"resi 12-13,16", "347"}, {"none", ""},
                  {"all", "1234567"}, {"hydrogen", "7"},        {"water", "6"}};
    const auto& chosen = kTests[any(std::size(kTests))];
    Part part{chosen.text, {}};
    for (const char* atom = chosen.atoms; *atom != 0; ++atom) part.atoms.set(*atom - '1');
    return part;
  }
  Part factor(int depth) {
    const int kind = depth == 0 ? 0 : any(4);
    if (kind <= 1) return test();
    const Part inner = kind == 2 ? factor(depth - 1) : sum(depth - 1);
    return kind == 2 ? Part{"not " + inner.text, ~inner.atoms}
                     : Part{"(" + inner.text + ")", inner.atoms};
  }
  Part product(int depth) {
    Part part = factor(depth);
    for (int more = any(3); more > 0; --more) {
      const Part next = factor(depth);
      part = {part.text + " and " + next.text, part.atoms & next.atoms};
    }
    return part;
  }
  Part sum(int depth) {
    Part part = product(depth);
    for (int more = any(3); more > 0; --more) {
      const Part next = product(depth);
      part = {part.text + " or " + next.text, part.atoms | next.atoms};
    }
    return part;
  }
};

TEST(Selection, AndOrNotAreIntersectionUnionAndComplement) {
  RandomExpression make{std::mt19937(1)};
  for (int n = 0; n < 3000; ++n) {
    const auto [expression, atoms] = make.sum(4);
    std::string expected;
    for (std::size_t i = 0; i < atoms.size(); ++i) {
      if (atoms[i]) expected += static_cast<char>('1' + i);
    }
    ASSERT_EQ(picked(expression), expected) << expression;
  }
}

TEST(Selection, NestingHasALimitThatIsSaid) {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '(') + "water" + std::string(depth, ')');
  };
  EXPECT_EQ(picked(nested(199)), "6");
  EXPECT_EQ(picked(std::string(198, '!') + "water"), "6");
  for (const std::string& deep : {nested(25000), std::string(25000, '!') + "water"}) {
    try {
      SelectionExpression::parse(deep);
      ADD_FAILURE() << "parsed";
    } catch (const SelectionError& error) {
      EXPECT_EQ(error.column(), 201u);
      EXPECT_NE(std::string(error.what()).find("more than 200"), std::string::npos) << error.what();
    }
  }
}

TEST(Selection, ErrorsPointAtTheColumn) {
  const struct {
    const char* expression;
    std::size_t column;
    const char* reason;
  } cases[] = {{"chain", 6, "expected a chain name after \"chain\""},
               {"chain A and", 12, "the expression ends"},
               {"chain A resn B", 9, "expected \"and\", \"or\" or the end before \"resn\""},
               {"chian A", 1, "\"chian\" is not a selection"},
               {"(chain A", 1, "this ( has no closing )"},
               {"chain A)", 8, "this ) has no opening ("},
               {"resi x", 6, "is not a residue number"},
               {"resi 20-10", 6, "runs backwards"},
               {"resi 1-", 6, "is not a residue number"},
               {"resi 99999999999", 6, "is not a residue number"},
               {"element Q", 9, "is not an element"},
               {"name \"CA", 6, "has no closing"},
               {"chain A,", 9, "expected a chain name"},
               {"and", 1, "is not a selection"},
               {"chain A within 5 of chain B", 9, "write X and within 5 of Y"},
               {"within of chain A", 8, "expected a distance from 0 to 1000 Å"},
               {"within 2000 of all", 8, "expected a distance from 0 to 1000 Å"},
               {"within 5 chain A", 10, "expected \"of\""},
               {"within 0.1234567 of all", 8, "at most six decimals"},
               {"within 5 of", 12, "the expression ends"},
               {"b 40", 3, "as in b > 40"},
               {"b > x", 5, "expected a number"},
               {"index 0", 7, "is not a number from 1 on"},
               {"copy B", 6, "is not a number from 1 on"}};
  for (const auto& c : cases) {
    try {
      SelectionExpression::parse(c.expression);
      ADD_FAILURE() << c.expression;
    } catch (const SelectionError& error) {
      EXPECT_EQ(error.column(), c.column) << c.expression;
      EXPECT_NE(std::string(error.what()).find(c.reason), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW(SelectionExpression::parse(std::string(100000, '(')), SelectionError);
  EXPECT_THROW(SelectionExpression::parse(std::string(100000, '!')), SelectionError);
}

TEST(Selection, IsCountedInTheReport) {
  const Molecule m = read_text("a.pdb", kFile);
  BallOptions options;
  options.selection = "chain A or ion";
  options.radii = RadiiSet::bondi;
  EXPECT_EQ(summary(prepare_balls(m, options).report),
            "used 3 of 7 atoms; dropped 4 atoms not selected; radii Bondi");
  options.selection = "chain";
  EXPECT_THROW(prepare_balls(m, options), SelectionError);
}

}  // namespace
}  // namespace alphascope
