// SPDX-License-Identifier: GPL-3.0-or-later
// Tests labels of atoms: text and place, one for each residue, and only on drawn atoms.
#include "core/document/reference/atom_labels.hpp"
#include "core/document/reference/reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/radii/radii_choice.hpp"
#include "core/radii/radii_set.hpp"
#include "core/selection/ball_options.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

constexpr const char* kFile =
    "ATOM      1  N   SER A   1       1.000   2.000   3.000  1.00  9.67           N  \n"
    "ATOM      2  CA  SER A   1       2.000   2.000   3.000  1.00 -1.25           C  \n"
    "ATOM      3  CB  SER A   1       3.000   2.000   6.000  1.00  9.67           C  \n"
    "ATOM      4  N   GLY A   2      11.000   2.000   3.000  1.00  0.00           N  \n"
    "HETATM    5  O   HOH B   3      15.000   2.000   3.000  1.00  9.67           O  \n";

BallReferences references() {
  auto molecule = std::make_shared<const Molecule>(read_text("a.pdb", kFile));
  BallOptions options;
  options.radii = RadiiSet::bondi;
  return {molecule, std::make_shared<const PreparedBalls>(prepare_balls(*molecule, options))};
}

bool all(std::size_t) {
  return true;
}

std::vector<std::string> texts(const LabelGroups& labels) {
  std::vector<std::string> found;
  for (const PlacedText& label : placed_labels(references(), labels, all)) {
    found.push_back(label.text);
  }
  return found;
}

TEST(AtomLabels, OfAnAtomWithoutABFactorSayNone) {
  const auto molecule = std::make_shared<const Molecule>(read_text(
      "a.pdb",
      "ATOM      1  N   SER A   1       1.000   2.000   3.000  1.00  0.00           N  \n"
      "ATOM      2  CA  SER A   1       2.000   2.000   3.000                       C  \n"));
  const BallReferences atoms{molecule,
                             std::make_shared<const PreparedBalls>(prepare_balls(*molecule, {}))};
  const auto labels = placed_labels(atoms, {{LabelText::b_factor, AtomSet({{0, 0, 1}})}}, all);
  std::vector<std::string> found;
  for (const PlacedText& label : labels) found.push_back(label.text);
  EXPECT_EQ(std::count(found.begin(), found.end(), "0.0 Å²"), 1);
}

TEST(AtomLabels, SayWhatTheyAreAskedFor) {
  const AtomSet atoms({{0, 1, 3}});
  using Texts = std::vector<std::string>;
  EXPECT_EQ(texts({{LabelText::name, atoms}}), (Texts{"CA", "CB", "N"}));
  EXPECT_EQ(texts({{LabelText::address, atoms}}), (Texts{"A:SER 1:CA", "A:SER 1:CB", "A:GLY 2:N"}));
  EXPECT_EQ(texts({{LabelText::element, atoms}}), (Texts{"C", "C", "N"}));
  EXPECT_EQ(texts({{LabelText::radius, atoms}}), (Texts{"1.70 Å", "1.70 Å", "1.55 Å"}));
  EXPECT_EQ(texts({{LabelText::b_factor, atoms}}), (Texts{"−1.2 Å²", "9.7 Å²", "0.0 Å²"}));
  EXPECT_EQ(texts({{LabelText::radius, AtomSet({{0, 4, 4}})}}), Texts{}) << "water is no ball";
  EXPECT_EQ(texts({{LabelText::name, AtomSet({{0, 4, 4}})}}), Texts{"O"});
  EXPECT_EQ(texts({{LabelText::name, AtomSet({{1, 0, 4}, {0, 4, 4000000000}})}}), Texts{"O"})
      << "there is no copy, and there are five atoms";
}

TEST(AtomLabels, OfAThingHaveTheTextsOfItsAtoms) {
  const BallReferences atoms = references();
  const Ref one = AtomRef{1, 0}, edge = SimplexRef{{1, 0}, {2, 0}},
            between = SimplexRef{{2, 0}, {3, 0}};
  EXPECT_EQ(label_text(atoms, one, LabelText::address), "A:SER 1:CA");
  EXPECT_EQ(label_text(atoms, one, LabelText::b_factor), "−1.2 Å²");
  EXPECT_EQ(label_text(atoms, edge, LabelText::name), "CA, CB");
  EXPECT_EQ(label_text(atoms, edge, LabelText::residue), "SER 1") << "both are of it";
  EXPECT_EQ(label_text(atoms, between, LabelText::residue), "SER 1, GLY 2");
  EXPECT_EQ(label_text(atoms, AtomRef{4, 0}, LabelText::radius), "") << "water is no ball";
  EXPECT_EQ(label_text(atoms, AtomRef{99, 0}, LabelText::name), "") << "there is no such atom";
}

TEST(AtomLabels, OneForEachResidueInTheMiddleOfWhatIsDrawn) {
  const LabelGroups labels{{LabelText::residue, AtomSet({{0, 0, 4}})}};
  EXPECT_EQ(label_count(references().molecule(), labels), 3u);
  EXPECT_EQ(label_count(references().molecule(), labels, 1), 2u) << "no more are counted";
  auto placed = placed_labels(references(), labels, all);
  ASSERT_EQ(placed.size(), 3u);
  EXPECT_EQ(placed[0].text, "SER 1");
  EXPECT_EQ(placed[1].text, "GLY 2");
  EXPECT_EQ(placed[2].text, "HOH 3");
  EXPECT_NEAR(placed[0].at_angstrom.x, 2, 1e-12);
  EXPECT_NEAR(placed[0].at_angstrom.z, 4, 1e-12);
  placed = placed_labels(references(), labels, [](std::size_t atom) { return atom == 2; });
  ASSERT_EQ(placed.size(), 1u);
  EXPECT_EQ(placed[0].at_angstrom, (RealPoint{3, 2, 6}));
}

TEST(AtomLabels, AnAtomHasOneLabel) {
  LabelGroups labels;
  set_labels(labels, AtomSet({{0, 0, 9}}), LabelText::name);
  set_labels(labels, AtomSet({{0, 5, 5}}), LabelText::address);
  ASSERT_EQ(labels.size(), 2u);
  EXPECT_EQ(labels[0].atoms, AtomSet({{0, 0, 4}, {0, 6, 9}}));
  EXPECT_EQ(labels[1].atoms, AtomSet({{0, 5, 5}}));
  set_labels(labels, AtomSet({{0, 5, 5}}), LabelText::name);
  EXPECT_EQ(labels, (LabelGroups{{LabelText::name, AtomSet({{0, 0, 9}})}}));
  set_labels(labels, AtomSet({{0, 0, 99}}), std::nullopt);
  EXPECT_TRUE(labels.empty());
}

}  // namespace
}  // namespace alphascope
