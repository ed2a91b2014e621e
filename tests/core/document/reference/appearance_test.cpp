// SPDX-License-Identifier: GPL-3.0-or-later
// Tests sets of atoms against the plain definition, and hidden atoms and own colours as values of
// balls.
#include "core/document/reference/appearance.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <stdexcept>

#include "core/document/reference/ref_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

using Plain = std::set<std::pair<std::uint32_t, std::uint32_t>>;  // copy, atom

Plain plain(const AtomSet& set) {
  Plain atoms;
  for (const AtomSet::Run& run : set.runs()) {
    for (std::uint32_t atom = run.first; atom <= run.last; ++atom) atoms.insert({run.copy, atom});
  }
  return atoms;
}

TEST(AtomSet, AgreesWithPlainSets) {
  std::mt19937 random(1);
  const auto number = [&](std::uint32_t below) {
    return static_cast<std::uint32_t>(random() % below);
  };
  const auto some = [&] {
    std::vector<AtomSet::Run> runs(number(6));
    for (AtomSet::Run& run : runs) {
      run = {number(3), number(20), 0};
      run.last = run.first + number(5);
    }
    return AtomSet(runs);
  };
  for (int round = 0; round < 2000; ++round) {
    const AtomSet a = some(), b = some();
    const Plain pa = plain(a), pb = plain(b);
    Plain both = pa, left = pa;
    both.insert(pb.begin(), pb.end());
    for (const auto& atom : pb) left.erase(atom);
    ASSERT_EQ(plain(a.with(b)), both);
    ASSERT_EQ(plain(a.without(b)), left);
    ASSERT_EQ(a.size(), pa.size());
    ASSERT_EQ(a == b, pa == pb);
    for (std::uint32_t copy = 0; copy < 3; ++copy) {
      for (std::uint32_t atom = 0; atom < 26; ++atom) {
        ASSERT_EQ(a.contains({atom, copy}), pa.contains({copy, atom}));
      }
    }
    for (std::size_t i = 1; i < a.runs().size(); ++i) {  // as few runs as possible
      const AtomSet::Run &p = a.runs()[i - 1], &q = a.runs()[i];
      ASSERT_TRUE(p.copy < q.copy || p.last + 1 < q.first);
    }
  }
}

TEST(AtomSet, ReachesTheLargestNumber) {
  const AtomSet all({{0, 0, UINT32_MAX}}), end({{0, UINT32_MAX, UINT32_MAX}});
  EXPECT_EQ(all.size(), std::uint64_t{1} << 32);
  EXPECT_EQ(all.without(end).runs(), (std::vector<AtomSet::Run>{{0, 0, UINT32_MAX - 1}}));
  EXPECT_TRUE(end.without(all).empty());
}

constexpr const char* kFile =
    "ATOM      1  N   SER A   1       1.000   2.000   3.000  1.00  9.67           N  \n"
    "ATOM      2  CA  SER A   1       3.000   2.000   3.000  1.00  9.67           C  \n"
    "ATOM      3  CA  GLY B   2      11.000   2.000   3.000  1.00  9.67           C  \n"
    "HETATM    4  O   HOH B   3      15.000   2.000   3.000  1.00  9.67           O  \n";

TEST(Appearance, WordsBecomeHiddenBallsAndColours) {
  const Molecule molecule = read_text("a.pdb", kFile);
  const std::vector<std::uint32_t> atom_of_ball{0, 1, 2};  // the water is no ball
  const Appearance of =
      read_appearance(molecule, {"name N", "chain A", " chain A = #ff8800 ;name CA=#123"});
  EXPECT_EQ(plain(of.hidden), (Plain{{0, 0}, {0, 2}, {0, 3}}));
  const BallAppearance balls = ball_appearance(molecule, atom_of_ball, of);
  EXPECT_EQ(balls.hidden, (std::vector<bool>{true, false, true}));
  EXPECT_EQ(balls.hidden_balls, 2u);
  std::vector<Rgb8> colours(3, Rgb8{1, 2, 3});
  balls.paint(colours);
  EXPECT_EQ(colours, (std::vector<Rgb8>{{255, 136, 0}, {17, 34, 51}, {17, 34, 51}}))
      << "the last that names an atom colours it";
  EXPECT_EQ(shown_radii({5, 6, 7}, &balls), (std::vector<float>{0, 6, 0}));
  EXPECT_TRUE(balls.hides_some(std::array<BallIndex, 2>{1, 2}));
  EXPECT_FALSE(balls.hides_some(std::array<BallIndex, 1>{1}));
}

TEST(Appearance, WhatCannotBeReadIsSaid) {
  const Molecule molecule = read_text("a.pdb", kFile);
  const auto error_of = [&](const AppearanceWords& words) -> std::string {
    try {
      read_appearance(molecule, words);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(error_of({"chain Z", "", ""}), "no atom matches \"chain Z\"");
  EXPECT_NE(error_of({"", "chian A", ""}).find("column 1"), std::string::npos);
  for (const char* wrong : {"resn SER", "resn SER=", "resn SER=red", "=#123456", ";"}) {
    EXPECT_NE(error_of({"", "", wrong}), "") << wrong;
  }
}

TEST(Appearance, AnAtomHasOneColour) {
  Appearance of;
  const AtomSet some({{0, 0, 9}}), other({{0, 5, 14}});
  set_colour(of, some, Rgb8{1, 1, 1});
  set_colour(of, other, Rgb8{2, 2, 2});
  ASSERT_EQ(of.colours.size(), 2u);
  EXPECT_EQ(of.colours[0].atoms, AtomSet({{0, 0, 4}}));
  set_colour(of, other, Rgb8{1, 1, 1});
  ASSERT_EQ(of.colours.size(), 1u);
  EXPECT_EQ(of.colours[0].atoms, AtomSet({{0, 0, 14}}));
  set_colour(of, AtomSet({{0, 0, 100}}), std::nullopt);
  EXPECT_TRUE(of.plain());
}

}  // namespace
}  // namespace alphascope
