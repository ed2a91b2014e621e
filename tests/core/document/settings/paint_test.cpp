// SPDX-License-Identifier: GPL-3.0-or-later
// Tests values of paints for balls, their colours, and paints as text.
#include "core/document/settings/paint.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>

#include "core/chart/chart.hpp"
#include "core/document/measures/paint_balls.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/residue_class.hpp"
#include "core/molecule/rgb8.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

std::string atom_line(const char* text, const char* b_factor) {
  char line[128];
  std::snprintf(line, sizeof line, "%-54s  1.00%6s\n", text, b_factor);
  return line;
}

std::vector<std::uint32_t> all_indices(const Molecule& molecule) {
  std::vector<std::uint32_t> atoms(molecule.atoms.size());
  std::iota(atoms.begin(), atoms.end(), 0);
  return atoms;
}

// Two chains, and a ligand and a water with a chain's name.
Molecule small_molecule() {
  return read_text(
      "a.pdb", atom_line("ATOM      1  N   GLY A   1       1.000   2.000   3.000", "-2.50") +
                   atom_line("ATOM      2  CA  GLY A   1       3.000   2.000   3.000", "10.00") +
                   atom_line("ATOM      3  CA  ASP A   2       6.000   2.000   3.000", "10.00") +
                   atom_line("ATOM      4  CA  LYS A   3       9.000   2.000   3.000", "61.00") +
                   atom_line("ATOM      5  CA  TRP B   7      15.000   2.000   3.000", "") +
                   atom_line("HETATM    6 FE   HEM A 154      18.000   2.000   3.000", "30.00") +
                   atom_line("HETATM    7  O   HOH A 155      21.000   2.000   3.000", "20.00"));
}

struct Balls {
  Molecule molecule = small_molecule();
  std::vector<std::uint32_t> atoms = all_indices(molecule);
  PaintedMolecule of() const { return {molecule, atoms}; }
  BallValues values(ColourBy by) const { return ball_values(of(), by); }
  PaintedBalls painted(const Paint& paint) const { return paint_balls(of(), paint); }
};

std::vector<std::string> names(const PaintedBalls& balls) {
  std::vector<std::string> names;
  for (const PaintCategory& c : balls.key->categories) names.push_back(c.name);
  return names;
}
using Names = std::vector<std::string>;

TEST(PaintBalls, BFactorsAreThoseOfTheFileAndNoneIsGuessed) {
  const Balls balls;
  const BallValues values = balls.values(ColourBy::b_factor);
  ASSERT_EQ(values.numbers.size(), 7u);
  EXPECT_FLOAT_EQ(values.numbers[0], -2.5f);
  EXPECT_FLOAT_EQ(values.numbers[3], 61);
  EXPECT_TRUE(std::isnan(values.numbers[4])) << "blank in the file";
  EXPECT_EQ(values.lacks, "");
  const PaintedBalls painted = balls.painted({.by = ColourBy::b_factor});
  EXPECT_EQ(painted.key->title, "B factor (Å²)");
  EXPECT_EQ(painted.key->scale->map, ColourMap::blue_white_red);
  EXPECT_EQ(painted.key->scale->range, (ColourRange{-20, 80}));
  EXPECT_EQ(painted.colours[4], kNoValueColour);
  EXPECT_EQ(names(painted), Names{"no B factor in the file"});
  EXPECT_EQ(painted.colours[1], painted.colours[2]) << "a tie";
  EXPECT_NE(painted.colours[0], painted.colours[1]);
  EXPECT_EQ(painted.colours[0], mapped_colour(ColourMap::blue_white_red, 17.5 / 100));
}

TEST(PaintBalls, AChosenRangeHoldsAndBeyondItAreItsEnds) {
  const Balls balls;
  const PaintedBalls painted =
      balls.painted({ColourBy::b_factor, ColourMap::cividis, ColourRange{10, 30}, {}});
  EXPECT_EQ(painted.colours[0], mapped_colour(ColourMap::cividis, 0));
  EXPECT_EQ(painted.colours[3], mapped_colour(ColourMap::cividis, 1));
  EXPECT_EQ(painted.colours[6], mapped_colour(ColourMap::cividis, 0.5));
  EXPECT_EQ(painted.key->scale->range, (ColourRange{10, 30}));
}

TEST(PaintBalls, AFileWithoutBFactorsSaysSo) {
  const Molecule molecule = read_text("a.xyz", "2\n\nC 0 0 0\nO 1.2 0 0\n");
  const std::vector<std::uint32_t> atoms = all_indices(molecule);
  const PaintedBalls painted = paint_balls({molecule, atoms}, {.by = ColourBy::b_factor});
  EXPECT_EQ(painted.lacks, "The file gives no B factors, so all balls are grey.");
  EXPECT_FALSE(painted.key);
  EXPECT_EQ(painted.colours, (std::vector<Rgb8>(2, kNoValueColour)));
  for (const ColourBy by : {ColourBy::residue_class, ColourBy::residue_index}) {
    EXPECT_EQ(paint_balls({molecule, atoms}, {.by = by}).lacks,
              "The file names no residues, so all balls are grey.");
  }
}

TEST(PaintBalls, BFactorsOfMmcifToo) {
  const Molecule molecule = read_text(
      "a.cif",
      "data_A\nloop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n"
      "_atom_site.label_atom_id\n_atom_site.label_comp_id\n_atom_site.label_asym_id\n"
      "_atom_site.label_seq_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
      "_atom_site.B_iso_or_equiv\nATOM 1 C CA GLY A 1 1.0 2.0 3.0 0.00\n"
      "ATOM 2 C CA ALA A 2 4.0 2.0 3.0 ?\n");
  const std::vector<std::uint32_t> atoms = all_indices(molecule);
  const BallValues values = ball_values({molecule, atoms}, ColourBy::b_factor);
  EXPECT_EQ(values.numbers[0], 0) << "given, and zero";
  EXPECT_TRUE(std::isnan(values.numbers[1]));
}

TEST(PaintBalls, OneBallHasARangeToo) {
  const Molecule molecule = read_text(
      "a.pdb", atom_line("ATOM      1  CA  GLY A   1       1.000   2.000   3.000", "12.50"));
  const std::vector<std::uint32_t> atoms = all_indices(molecule);
  const PaintedBalls b = paint_balls({molecule, atoms}, {.by = ColourBy::b_factor});
  EXPECT_LT(b.key->scale->range.low, 12.5);
  EXPECT_GT(b.key->scale->range.high, 12.5);
  EXPECT_EQ(b.colours[0], mapped_colour(ColourMap::blue_white_red, 0.5));
  const PaintedBalls place = paint_balls({molecule, atoms}, {.by = ColourBy::residue_index});
  EXPECT_EQ(place.colours[0], mapped_colour(ColourMap::rainbow, 0));
  EXPECT_TRUE(paint_balls({molecule, {}}, {.by = ColourBy::b_factor}).colours.empty());
}

TEST(PaintBalls, PlacesAreCountedAlongEachChainWithoutLigandsAndWater) {
  const Balls balls;
  const BallValues values = balls.values(ColourBy::residue_index);
  EXPECT_EQ(std::vector<float>(values.numbers.begin(), values.numbers.begin() + 5),
            (std::vector<float>{0, 0, 50, 100, 0}));
  EXPECT_TRUE(std::isnan(values.numbers[5]) && std::isnan(values.numbers[6]));
  // The number depends on the residues in the file, whichever atoms are balls.
  const std::vector<std::uint32_t> middle{2};
  EXPECT_EQ(ball_values({balls.molecule, middle}, ColourBy::residue_index).numbers[0], 50);
}

TEST(PaintBalls, ClassesOfResidues) {
  const Balls balls;
  const PaintedBalls painted = balls.painted({.by = ColourBy::residue_class});
  EXPECT_EQ(names(painted),
            (Names{"small non-polar", "hydrophobic", "negative", "positive", "ligand", "water"}));
  EXPECT_EQ(painted.colours[0], painted.colours[1]);
  EXPECT_EQ(painted.key->title, "class of residue (Lesk)");
}

TEST(PaintBalls, ElementsAndChainsAreListedAsFarAsThereAreBalls) {
  const Balls balls;
  EXPECT_EQ(names(balls.painted({.by = ColourBy::element})), (Names{"N", "C", "Fe", "O"}));
  EXPECT_EQ(names(balls.painted({.by = ColourBy::chain})), (Names{"A", "B", "ligand", "water"}));
  const std::vector<std::uint32_t> only_b{4};
  const PaintedBalls b = paint_balls({balls.molecule, only_b}, {.by = ColourBy::chain});
  EXPECT_EQ(names(b), Names{"B"});
  EXPECT_EQ(b.colours[0], balls.painted({.by = ColourBy::chain}).colours[4])
      << "it keeps its colour";
}

TEST(PaintBalls, CopiesOfAnAssemblyAreChainsOfTheirOwnWithTheSamePlaces) {
  Balls balls;
  Molecule& m = balls.molecule;
  const std::size_t deposited = m.atoms.size();
  for (std::size_t i = 0; i < deposited; ++i) {
    Atom copy = m.atoms[i];
    copy.chain = m.names.intern(std::string(m.text(copy.chain)) + "-2");
    m.atoms.push_back(copy);
  }
  m.models[0].end = m.atoms.size();
  balls.atoms = all_indices(m);
  EXPECT_EQ(names(balls.painted({.by = ColourBy::chain})),
            (Names{"A", "B", "ligand", "water", "A-2", "B-2"}));
  for (const ColourBy by : {ColourBy::residue_index, ColourBy::b_factor}) {
    const std::vector<Rgb8> colours = balls.painted({.by = by}).colours;
    for (std::size_t i = 0; i < deposited; ++i) EXPECT_EQ(colours[i], colours[deposited + i]);
  }
}

// Balls 0 to 6: two pairs, two single ones, and one outside the complex.
TEST(PaintBalls, ComponentsComeByTheirSizeAndTiesByTheirLowestBall) {
  const Balls balls;
  AlphaComplex complex;
  for (const BallIndex v : {0u, 1u, 2u, 3u, 4u, 6u}) complex.vertices.simplices.push_back({v});
  complex.edges.simplices.push_back({0, 4});
  complex.edges.simplices.push_back({1, 3});
  PaintedMolecule of = balls.of();
  of.complex = &complex;
  const PaintedBalls painted = paint_balls(of, {.by = ColourBy::component});
  EXPECT_EQ(names(painted),
            (Names{"1: 2 balls", "2: 2 balls", "one ball alone", "not in the complex"}));
  EXPECT_EQ(painted.colours[0], chart_colour(0));
  EXPECT_EQ(painted.colours[4], chart_colour(0));
  EXPECT_EQ(painted.colours[1], chart_colour(1));
  EXPECT_EQ(painted.colours[2], painted.colours[6]);
  EXPECT_NE(painted.colours[2], painted.colours[5]);
  complex.tetrahedra_only = true;
  const PaintedBalls none = paint_balls(of, {.by = ColourBy::component});
  EXPECT_FALSE(none.key);
  EXPECT_NE(none.lacks.find("Tetrahedra only"), std::string::npos);
}

TEST(PaintBalls, OneColourIsTheUsualOrOnesOwn) {
  const Balls balls;
  const PaintedBalls usual = balls.painted({.by = ColourBy::single});
  EXPECT_EQ(usual.colours, std::vector<Rgb8>(7, element_colour(6)));
  EXPECT_FALSE(usual.key);
  const Rgb8 own{1, 2, 3};
  EXPECT_EQ(balls.painted({ColourBy::single, {}, {}, own}).colours, std::vector<Rgb8>(7, own));
}

// WCAG 2.1 requires 3 : 1 for graphics, here on white and on the window's dark background.
TEST(PaintBalls, CarbonReadsOnWhiteAndOnDark) {
  const auto luminance = [](const Rgb8& c) {
    const auto linear = [](double v) {
      v /= 255;
      return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
  };
  const double carbon = luminance(element_colour(6)) + 0.05;
  EXPECT_GT(1.05 / carbon, 3);
  EXPECT_GT(carbon / (luminance({0x11, 0x15, 0x1b}) + 0.05), 3);
}

// Lesk's classes have colours of M. Okabe and K. Ito; atoms of no residue have muted ones.
TEST(PaintBalls, KindsOfResiduesHaveTheirColours) {
  const struct {
    ResidueClass kind;
    const char* name;
    Rgb8 colour;
  } kinds[] = {{ResidueClass::small_nonpolar, "small non-polar", {230, 159, 0}},
               {ResidueClass::hydrophobic, "hydrophobic", {0, 158, 115}},
               {ResidueClass::polar, "polar", {204, 121, 167}},
               {ResidueClass::negative, "negative", {213, 94, 0}},
               {ResidueClass::positive, "positive", {0, 114, 178}},
               {ResidueClass::nucleotide, "nucleotide", {86, 180, 233}},
               {ResidueClass::other, "other residue", {148, 148, 148}},
               {ResidueClass::ligand, "ligand", {190, 170, 50}},
               {ResidueClass::ion, "ion", {118, 92, 168}},
               {ResidueClass::water, "water", {150, 190, 200}},
               {ResidueClass::dummy, "dummy", {110, 116, 124}}};
  EXPECT_EQ(std::size(kinds), static_cast<std::size_t>(kResidueClasses));
  for (const auto& k : kinds) {
    EXPECT_STREQ(residue_class_name(k.kind), k.name);
    EXPECT_EQ(residue_class_colour(k.kind), k.colour) << k.name;
  }
}

// The classes of the twenty amino acids are from A. Lesk, Introduction to Bioinformatics.
TEST(PaintBalls, EveryAminoAcidHasItsClass) {
  const std::pair<ResidueClass, const char*> classes[] = {
      {ResidueClass::small_nonpolar, "GLY ALA SER THR"},
      {ResidueClass::hydrophobic, "CYS VAL ILE LEU PRO PHE TYR MET TRP SEC MSE"},
      {ResidueClass::polar, "ASN GLN HIS"},
      {ResidueClass::negative, "ASP GLU"},
      {ResidueClass::positive, "LYS ARG"},
      {ResidueClass::nucleotide, "A C G U I DA DC DG DT"},
      {ResidueClass::other, "XYZ"}};
  for (const auto& [kind, residues] : classes) {
    std::istringstream words(residues);
    for (std::string name; words >> name;) {
      Molecule m;
      Atom atom;
      atom.residue_name = m.names.intern(name);
      atom.kind = ResidueKind::polymer;
      EXPECT_EQ(residue_class(m, atom), kind) << name;
    }
  }
}

// Orange, sky blue and blue of M. Okabe and K. Ito can be told apart with any colour vision.
TEST(PaintBalls, ClassesHaveTheirColoursAndTheLegendHasTheSame) {
  const std::pair<SimplexClass, Rgb8> kColours[] = {{SimplexClass::singular, {230, 159, 0}},
                                                    {SimplexClass::regular, {86, 180, 233}},
                                                    {SimplexClass::interior, {0, 114, 178}}};
  for (const auto& [of, colour] : kColours) EXPECT_EQ(class_colour(of), colour);
  const ColourMeaning legend{
      "class",
      {},
      {{"singular", {230, 159, 0}}, {"regular", {86, 180, 233}}, {"interior", {0, 114, 178}}}};
  EXPECT_TRUE(class_colour_meaning() == legend);
}

TEST(PaintWords, EveryPaintComesBack) {
  for (const PaintTarget what : {PaintTarget::balls, PaintTarget::simplices}) {
    for (const SchemeInfo& scheme : all_schemes()) {
      if (!can_paint(scheme, what)) continue;
      Paint paint{.by = scheme.by};
      EXPECT_EQ(read_paint(paint_text(paint), what).paint, paint);
      if (scheme.quantity) {
        paint.map = ColourMap::cividis;
        paint.range = ColourRange{0.1 + 0.2, 61};
        EXPECT_EQ(read_paint(paint_text(paint), what).paint, paint) << paint_text(paint);
      }
    }
  }
  const Paint own{ColourBy::single, {}, {}, Rgb8{1, 2, 250}};
  EXPECT_EQ(paint_text(own), "#0102fa");
  EXPECT_EQ(read_paint("#0102fa", PaintTarget::simplices).paint, own);
  EXPECT_EQ(read_paint(" b_factor , 0 : 60 Å² , cividis ", PaintTarget::balls).paint,
            (Paint{ColourBy::b_factor, ColourMap::cividis, ColourRange{0, 60}, {}}));
  EXPECT_EQ(read_paint("b_factor,−5:10", PaintTarget::balls).paint.range, (ColourRange{-5, 10}));
}

TEST(PaintWords, AFormerSchemeIsReadAndTold) {
  for (const PaintTarget what : {PaintTarget::balls, PaintTarget::simplices}) {
    const PaintWords words = read_paint("residue_kind", what);
    EXPECT_EQ(words.error, "");
    EXPECT_EQ(words.paint, (Paint{.by = ColourBy::residue_class}));
    EXPECT_EQ(words.note,
              "\"residue_kind\" is called \"residue_class\" now. The older name is still read in "
              "this version.");
    EXPECT_EQ(paint_text(words.paint), "residue_class");
    EXPECT_EQ(read_paint("residue_class", what).note, "");
  }
}

TEST(PaintWords, WhatIsWrongIsNamedWithTheRemedy) {
  const auto error = [](const char* text, PaintTarget what = PaintTarget::balls) {
    const PaintWords words = read_paint(text, what);
    EXPECT_EQ(words.paint, Paint()) << text;
    return words.error;
  };
  EXPECT_EQ(error("green").find("\"green\" is not a colour scheme of balls. Write element, "
                                "chain, "),
            0u);
  EXPECT_NE(error("alpha").find("a colour scheme of balls"), std::string::npos);
  EXPECT_NE(error("b_factor", PaintTarget::simplices).find("a colour scheme of simplices"),
            std::string::npos);
  EXPECT_NE(error("").find("Write element"), std::string::npos);
  EXPECT_NE(error("#12345").find("such as #5aa9e6"), std::string::npos);
  EXPECT_EQ(error("chain,viridis"), "\"viridis\": chain has neither map nor range. Leave it out.");
  EXPECT_NE(error("b_factor,jet").find("viridis, cividis, blue_white_red or rainbow"),
            std::string::npos);
  EXPECT_NE(error("b_factor,60:0").find("is empty"), std::string::npos);
  EXPECT_NE(error("b_factor,5:5").find("is empty"), std::string::npos);
  EXPECT_NE(error("b_factor,0:").find("Write a number"), std::string::npos);
  EXPECT_NE(error("exposed,0:101").find("between 0 and 100 %"), std::string::npos);
}

TEST(PaintWords, AnotherSchemeForgetsTheRangeAndKeepsTheMap) {
  const Paint b{ColourBy::b_factor, ColourMap::cividis, ColourRange{0, 60}, {}};
  EXPECT_EQ(with_scheme(b, ColourBy::exposed),
            (Paint{ColourBy::exposed, ColourMap::cividis, {}, {}}));
  EXPECT_EQ(with_scheme(b, ColourBy::chain), (Paint{.by = ColourBy::chain}));
  EXPECT_EQ(with_scheme(b, ColourBy::b_factor), b);
}

}  // namespace
}  // namespace alphascope
