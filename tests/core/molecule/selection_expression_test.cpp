#include "core/molecule/selection_expression.hpp"

#include <gtest/gtest.h>

#include <bitset>
#include <iterator>
#include <random>

#include "core/molecule/prepare_balls.hpp"
#include "tests/core/io/temporary_file.hpp"

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
               {"(chain A or chain B) && element Zn", "4"}};
  for (const auto& c : cases) EXPECT_EQ(picked(c.expression), c.atoms) << c.expression;
}

// An expression at random, and the atoms it picks by set operations.
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
               {"and", 1, "is not a selection"}};
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
