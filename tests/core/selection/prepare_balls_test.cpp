// SPDX-License-Identifier: GPL-3.0-or-later
// Tests which atoms are kept, dropped, guessed and set by hand, and that the report counts all of
// them.
#include "core/selection/prepare_balls.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "core/geometry/lattice_point.hpp"
#include "core/selection/contents.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

constexpr const char* kFile =
    "ATOM      1  N   ALA A   1      27.340  24.430   2.614  1.00  9.67           N  \n"
    "ATOM      2  CA AALA A   1      26.266  25.413   2.842  0.40 10.38           C  \n"
    "ATOM      3  CA BALA A   1      26.366  25.413   2.842  0.60 10.38           C  \n"
    "ATOM      4  N   GLY B   2      20.266  25.413  -2.842  1.00 10.38           N  \n"
    "HETATM    5 FE   HEM B   3       1.266  25.413   8.842  1.00 10.38          FE  \n"
    "HETATM    6 FE   HEM A   4       9.266  25.413   8.842  1.00 10.38          FE  \n"
    "HETATM    7  QX  UNK A   5       2.266  25.413   8.842  1.00 10.38              \n"
    "HETATM    8  O   HOH A   6       3.266  25.413   8.842  1.00 10.38           O  \n"
    "HETATM    9  O   WAT B   7       4.266  25.413   8.842  1.00 10.38           O  \n"
    "HETATM   10  O   HOH B   8       5.266  25.413   8.842  1.00 10.38           O  \n";

const Molecule& molecule() {
  static const Molecule m = read_text("a.pdb", kFile);
  return m;
}

BallOptions bondi() {
  BallOptions options;
  options.radii = RadiiSet::bondi;
  return options;
}

TEST(PrepareBalls, ListsWhatWasDroppedByReasonAndResidue) {
  const SelectionReport report = prepare_balls(molecule(), bondi()).report;
  ASSERT_EQ(report.dropped.size(), 3u);
  EXPECT_EQ(report.dropped[0].reason, DropReason::water);
  EXPECT_EQ(report.dropped[0].residue, "HOH");
  EXPECT_EQ(report.dropped[0].count, 2u);
  EXPECT_EQ(report.dropped[1].residue, "WAT");
  EXPECT_EQ(report.dropped[2].reason, DropReason::altloc);
  EXPECT_EQ(report.dropped[2].residue, "ALA");
  const auto reasons = drop_reasons(report);
  ASSERT_EQ(reasons.size(), 2u);
  EXPECT_EQ(reasons[0].text, "3 waters");
  EXPECT_EQ(reasons[1].text, "1 alternative location");
  std::size_t dropped = 0;
  for (const CountedReason& reason : reasons) dropped += reason.count;
  EXPECT_EQ(dropped, report.total - report.used);
}

// Lines "reason residue name x". The coordinate tells copies in an assembly apart.
std::vector<std::string> left_out_texts(const Molecule& m, const PreparedBalls& prepared) {
  std::vector<std::string> texts;
  for (const LeftOutAtom& out : prepared.left_out) {
    const Atom& atom = m.atoms[out.atom];
    texts.push_back(std::to_string(static_cast<int>(out.reason)) + " " +
                    std::string(m.text(atom.residue_name)) + " " + std::string(m.text(atom.name)) +
                    " " + std::to_string(atom.position.x));
  }
  return texts;
}

std::string left_out_line(DropReason reason, const std::string& rest) {
  return std::to_string(static_cast<int>(reason)) + " " + rest;
}

TEST(PrepareBalls, ListsTheAtomsThatAreThereButNotInTheBody) {
  const Molecule m = read_text(
      "a.pdb",
      "ATOM      1  N   ALA A   1      27.340  24.430   2.614  1.00  9.67           N  \n"
      "ATOM      2  CA AALA A   1      26.266  25.413   2.842  0.40 10.38           C  \n"
      "ATOM      3  CA BALA A   1      26.366  25.413   2.842  0.60 10.38           C  \n"
      "ATOM      4  H   ALA A   1      26.466  25.413   2.842  1.00 10.38           H  \n"
      "ATOM      5  N   GLY B   2      20.266  25.413  -2.842  1.00 10.38           N  \n"
      "HETATM    6 ZN    ZN A   3       9.266  25.413   8.842  1.00 10.38          ZN  \n"
      "HETATM    7  C1 ALIG A   5       2.266  25.413   8.842  0.30 10.38           C  \n"
      "HETATM    8  C1 BLIG A   5       2.366  25.413   8.842  0.70 10.38           C  \n"
      "HETATM    9  H1  LIG A   5       2.466  25.413   8.842  1.00 10.38           H  \n"
      "HETATM   10  O   HOH A   6       3.266  25.413   8.842  1.00 10.38           O  \n"
      "HETATM   11  H1  HOH A   6       4.266  25.413   8.842  1.00 10.38           H  \n"
      "HETATM   12  O   HOH B   8       5.266  25.413   8.842  1.00 10.38           O  \n");
  BallOptions options = bondi();
  options.ligands = options.ions = false;
  options.hydrogens = HydrogenRule::drop;
  options.without_chains = {"B"};
  EXPECT_EQ(left_out_texts(m, prepare_balls(m, options)),
            (std::vector<std::string>{left_out_line(DropReason::hydrogen, "ALA H 26466"),
                                      left_out_line(DropReason::ion, "ZN ZN 9266"),
                                      left_out_line(DropReason::ligand, "LIG C1 2366"),
                                      left_out_line(DropReason::ligand, "LIG H1 2466"),
                                      left_out_line(DropReason::water, "HOH O 3266"),
                                      left_out_line(DropReason::water, "HOH H1 4266")}));
  options.ligands = options.ions = options.waters = true;
  options.hydrogens = HydrogenRule::keep;
  EXPECT_TRUE(prepare_balls(m, options).left_out.empty());
}

TEST(PrepareBalls, ListsLeftOutAtomsOfEveryCopyOfAnAssemblyWhereItIs) {
  std::string text;
  for (int k = 0; k < 2; ++k) {
    const char* shift[] = {"0.00000", "10.00000"};
    for (int row = 1; row <= 3; ++row) {
      char line[96];
      std::snprintf(line, sizeof line, "REMARK 350   BIOMT%d  %2d %9.6f %9.6f %9.6f %14s\n", row,
                    k + 1, row == 1 ? 1.0 : 0.0, row == 2 ? 1.0 : 0.0, row == 3 ? 1.0 : 0.0,
                    row == 1 ? shift[k] : "0.00000");
      text += line;
    }
  }
  const Molecule m = read_text("a.pdb",
                               "REMARK 350 BIOMOLECULE: 1\n"
                               "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A, B\n" +
                                   text + kFile);
  const Molecule copies = expand_assembly(m, "1");
  std::vector<std::string> waters;
  for (const std::string& line : left_out_texts(copies, prepare_balls(copies, bondi()))) {
    waters.push_back(line.substr(line.rfind(' ') + 1));
  }
  EXPECT_EQ(waters, (std::vector<std::string>{"3266", "4266", "5266", "13266", "14266", "15266"}));
}

TEST(PrepareBalls, ChainsCanBeSwitchedOff) {
  BallOptions options = bondi();
  options.without_chains = {"B", "no such chain"};
  const SelectionReport report = prepare_balls(molecule(), options).report;
  EXPECT_EQ(report.dropped_chains, 4u);
  EXPECT_EQ(report.used, 4u);
  options.chains = {"B"};
  EXPECT_EQ(prepare_balls(molecule(), options).report.used, 0u);
  options.without_chains = {"A", "B"};
  options.chains.clear();
  EXPECT_EQ(prepare_balls(molecule(), options).report.dropped_chains, 10u);
}

TEST(PrepareBalls, RadiiSetByHandGoBeforeTheSetAndAreCounted) {
  BallOptions options = bondi();
  const PreparedBalls before = prepare_balls(molecule(), options);
  EXPECT_EQ(before.report.guessed_atoms, 3u);  // iron is not in Bondi's set
  ASSERT_EQ(before.report.guessed.size(), 2u);
  EXPECT_EQ(before.report.guessed[0].group.residue, "HEM");
  EXPECT_EQ(before.report.guessed[0].group.atom, "FE");
  EXPECT_EQ(element_symbol(before.report.guessed[0].group.element), "Fe");

  options.overrides = {{"HEM", "FE", element_from_symbol("Fe"), 1234567}};
  const PreparedBalls after = prepare_balls(molecule(), options);
  EXPECT_EQ(after.report.overridden_atoms, 2u);
  ASSERT_EQ(after.report.overridden.size(), 1u);
  EXPECT_EQ(after.report.overridden[0].count, 2u);
  EXPECT_DOUBLE_EQ(after.report.overridden[0].radius_angstrom, 1.234567);
  EXPECT_EQ(after.report.guessed_atoms, 1u) << "what is set by hand is no guess";
  EXPECT_EQ(std::count(after.balls->radii.begin(), after.balls->radii.end(), 1234567), 2)
      << "on a finer lattice than the file's";
  EXPECT_EQ(after.report.radius_rounding_angstrom, 0);
  EXPECT_NE(summary(after.report).find("; 1 guessed; 2 set by hand"), std::string::npos)
      << summary(after.report);
}

// Balls at 0 and `far` Å, one of them with a radius from a table.
PreparedBalls typed_radius(const std::string& far, std::int32_t microangstrom) {
  BallOptions options = bondi();
  options.overrides = {{"", "C", 6, microangstrom}};
  return prepare_balls(read_text("a.xyz", "2\n\nC 0 0 0.5\nN " + far + " 0 0\n"), options);
}

TEST(PrepareBalls, TypedRadiiGetALatticeThatHoldsThem) {
  const PreparedBalls four = typed_radius("400", 1234500);
  EXPECT_EQ(four.balls->lattice.digits, 4);
  EXPECT_EQ(four.balls->radii, (std::vector<std::int32_t>{12345, 15500}));
  EXPECT_EQ(four.balls->centres[0], (LatticePoint{0, 0, 5000}));
  EXPECT_EQ(four.balls->centres[1], (LatticePoint{4000000, 0, 0}));
  EXPECT_EQ(four.report.rounded_radii, 0u);
  EXPECT_EQ(four.report.lattice, four.balls->lattice);
  ASSERT_EQ(four.report.sizes.size(), 2u);
  EXPECT_EQ(four.report.sizes[0].radius, 12345);
  // Three digits hold this radius, and the lattice stays.
  const PreparedBalls three = typed_radius("400", 1234000);
  EXPECT_EQ(three.balls->lattice.digits, 3);
  EXPECT_EQ(three.balls->radii[0], 1234);
}

TEST(PrepareBalls, WhatNoLatticeHoldsIsRoundedAndSaid) {
  // 5,368 Å leave room for five digits, 60,000 Å for three, 536,000,000 Å for none.
  const PreparedBalls five = typed_radius("5000", 1234567);
  EXPECT_EQ(five.balls->lattice.digits, 5);
  EXPECT_EQ(five.balls->radii[0], 123457);
  EXPECT_EQ(five.report.rounded_radii, 1u);
  EXPECT_NEAR(five.report.radius_rounding_angstrom, 3e-6, 1e-12);
  EXPECT_EQ(typed_radius("400000", 1234567).balls->radii[0], 1235);
  const PreparedBalls whole = typed_radius("500000000", 1234567);
  EXPECT_EQ(whole.balls->radii, (std::vector<std::int32_t>{1, 2}));
  EXPECT_EQ(whole.report.rounded_radii, 2u);
  EXPECT_NE(summary(whole.report).find("; 2 radii rounded by up to 0.45 Å"), std::string::npos)
      << summary(whole.report);
}

TEST(PrepareBalls, AnOverrideNeedsResidueNameAndElement) {
  for (const RadiusOverride& other : {RadiusOverride{"HEN", "FE", element_from_symbol("Fe"), 1},
                                      RadiusOverride{"HEM", "FF", element_from_symbol("Fe"), 1},
                                      RadiusOverride{"HEM", "FE", element_from_symbol("C"), 1},
                                      RadiusOverride{"", "", element_from_symbol("Fe"), 1}}) {
    BallOptions options = bondi();
    options.overrides = {other};
    EXPECT_EQ(prepare_balls(molecule(), options).report.overridden_atoms, 0u);
  }
}

TEST(PrepareBalls, AtomsWithoutRadiusAreListedAndCanGetOne) {
  const Molecule m = read_text("a.pqr",
                               "ATOM 1 N ALA 1 0.0 0.0 0.0 0.5 1.5\n"
                               "ATOM 2 HN ALA 1 1.0 0.0 0.0 0.5 0.0\n"
                               "ATOM 3 HN ALA 2 2.0 0.0 0.0 0.5 0.0\n");
  BallOptions options;
  options.radii = RadiiSet::file;
  const SelectionReport before = prepare_balls(m, options).report;
  EXPECT_EQ(before.dropped_zero_radius, 2u);
  ASSERT_EQ(before.unsized.size(), 1u);
  EXPECT_EQ(before.unsized[0].atoms, "HN in ALA");
  EXPECT_EQ(before.unsized[0].count, 2u);
  options.overrides = {{"ALA", "HN", before.unsized[0].group.element, 600000}};
  const PreparedBalls after = prepare_balls(m, options);
  EXPECT_EQ(after.balls->size(), 3u);
  EXPECT_TRUE(after.report.unsized.empty());
  EXPECT_EQ(after.report.dropped_zero_radius, 0u);
}

TEST(PrepareBalls, SizesCountEveryBall) {
  const PreparedBalls prepared = prepare_balls(molecule(), bondi());
  const auto& sizes = prepared.report.sizes;
  const std::size_t sum =
      std::accumulate(sizes.begin(), sizes.end(), std::size_t{0},
                      [](std::size_t n, const BallSize& size) { return n + size.count; });
  EXPECT_EQ(sum, prepared.balls->size());
  EXPECT_GE(sizes.front().count, sizes.back().count);
  EXPECT_EQ(sizes.size(), 4u);  // N, C, Fe, unknown
  const auto names = [&](const char* element) {
    const auto found = std::find_if(sizes.begin(), sizes.end(), [&](const BallSize& s) {
      return s.element == element_from_symbol(element);
    });
    return found == sizes.end() ? "none" : found->atoms;
  };
  EXPECT_EQ(names("Fe"), "FE");
}

TEST(PrepareBalls, NoticesThatItIsCancelled) {
  RunContext context;
  context.cancel.cancel();
  EXPECT_THROW(prepare_balls(molecule(), bondi(), context), Cancelled);
}

TEST(Contents, CountsChainsAndKinds) {
  const MoleculeContents c = contents_of(molecule());
  ASSERT_EQ(c.chains.size(), 2u);
  EXPECT_EQ(c.chains[0].name, "A");
  EXPECT_EQ(c.chains[0].atoms, 6u);
  EXPECT_EQ(c.chains[1].kinds[static_cast<std::size_t>(ResidueKind::water)], 2u);
  EXPECT_EQ(c.kinds[static_cast<std::size_t>(ResidueKind::water)], 3u);
  EXPECT_EQ(c.kinds[static_cast<std::size_t>(ResidueKind::ligand)], 3u)
      << "UNK without a backbone's atoms is none, as HETATM";
  EXPECT_EQ(c.with_altloc, 2u);
  EXPECT_EQ(c.hydrogens, 0u);
}

}  // namespace
}  // namespace alphascope
