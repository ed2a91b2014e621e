// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the list of residues in the molecule panel. A choice in it becomes a treatment.
#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/selection/residue_groups.hpp"
#include "tests/ui/panels/panels_fixture.hpp"
#include "ui/panels/whole_state.hpp"

namespace alphascope {
namespace {

using testing::loaded_state;
using testing::Panels;
using testing::Size;

// A group as from a file, as far as the panel shows it.
ResidueGroup residues(const char* name, ResidueKind kind, ResidueReason why, std::size_t count) {
  ResidueGroup group;
  group.name = name;
  group.kind = group.file_kind = kind;
  group.why = group.file_why = why;
  group.residues = group.atoms = count;
  group.called = {name};
  return group;
}

std::shared_ptr<const ResidueGroups> in_list(std::vector<ResidueGroup> groups) {
  ResidueGroups list;
  for (const ResidueGroup& group : groups) {
    list.kinds[static_cast<std::size_t>(group.kind)] += group.residues;
    if (is_guess(group.why)) list.guessed += group.residues;
    if (group.why == ResidueReason::by_hand) list.by_hand += group.residues;
  }
  list.of = std::move(groups);
  return std::make_shared<const ResidueGroups>(list);
}

const ResidueGroup kHaems = residues("HEM", ResidueKind::ligand, ResidueReason::after_ter, 4);
const ResidueGroup kWaters = residues("HOH", ResidueKind::water, ResidueReason::water_name, 221);
const ResidueGroup kGuessed = residues("QQ1", ResidueKind::ligand, ResidueReason::no_polymer, 2);

WholeState state_with_residues() {
  WholeState s = loaded_state();
  s.molecule.sha256 = std::string(64, 'a');
  s.molecule.residues = in_list({kHaems, kWaters});
  return s;
}

class ResiduesPanel : public ::testing::Test {
 protected:
  ResiduesPanel() : p({1280, 1200, 1}) {
    p.state = state_with_residues();
    p.frame(3);
  }
  std::vector<std::string>& treated() { return p.state.settings.open.balls.treated; }
  Panels p;
};

TEST_F(ResiduesPanel, ResiduesAreTreatedOtherwiseAndTakenBack) {
  EXPECT_FALSE(p.rects.contains("residue.HOH")) << "closed where nothing was guessed";
  p.click("molecule.residues");
  p.click("residue.HOH");
  p.click("residue.as.ligand");
  EXPECT_EQ(treated(), std::vector<std::string>{"HOH=ligand"});
  EXPECT_FALSE(p.rects.contains("residue.as.ligand")) << "a choice closes the list";
  ResidueGroup waters = kWaters;
  waters.kind = ResidueKind::ligand;
  waters.why = ResidueReason::by_hand;
  waters.treated = {"HOH=ligand"};
  p.state.molecule.residues = in_list({kHaems, waters});
  p.frame(2);
  p.click("residue.HOH");
  p.click("residue.as.ion");
  EXPECT_EQ(treated(), std::vector<std::string>{"HOH=ion"});
  waters.treated = {"HOH=ion"};
  p.state.molecule.residues = in_list({kHaems, waters});
  p.frame(2);
  p.click("residue.HOH");
  p.click("residue.as.file");
  EXPECT_TRUE(treated().empty());
}

TEST_F(ResiduesPanel, OneOfSharedNamesIsTreatedByItsAddress) {
  ResidueGroup more = kHaems;
  more.nth = 2;
  more.called = {"A:HEM 142", "B:HEM 148"};
  p.state.molecule.residues = in_list({kHaems, more});
  p.click("molecule.residues");
  p.click("residue.HEM.2");
  p.click("residue.as.polymer");
  EXPECT_EQ(treated(), (std::vector<std::string>{"A:HEM 142=polymer", "B:HEM 148=polymer"}));
}

TEST_F(ResiduesPanel, WhatCannotBeNamedOffersNoChoice) {
  ResidueGroup unnamed = kWaters;
  unnamed.called.clear();
  p.state.molecule.residues = in_list({unnamed});
  p.click("molecule.residues");
  p.click("residue.HOH");
  EXPECT_FALSE(p.rects.contains("residue.as.ligand"));
}

TEST_F(ResiduesPanel, TheListIsOpenWhereResiduesWereGuessed) {
  p.state.molecule.residues = in_list({kGuessed, kHaems});
  p.state.molecule.sha256 = std::string(64, 'b');
  p.frame(2);
  EXPECT_TRUE(p.rects.contains("residue.QQ1"));
  p.click("molecule.residues");
  EXPECT_FALSE(p.rects.contains("residue.QQ1")) << "as the user leaves it";
  p.state.molecule.residues = in_list({kHaems});
  p.state.molecule.sha256 = std::string(64, 'c');
  p.frame(2);
  EXPECT_FALSE(p.rects.contains("residue.HEM"));
}

TEST_F(ResiduesPanel, OfAHundredThousandLinesOnlyThoseInSightAreDrawn) {
  std::vector<ResidueGroup> many;
  for (std::size_t k = 1; k <= 100'000; ++k) {
    many.push_back(kHaems);
    many.back().nth = k;
  }
  p.state.molecule.residues = in_list(std::move(many));
  p.click("molecule.residues");
  const auto drawn = std::count_if(p.rects.begin(), p.rects.end(), [](const auto& rect) {
    return rect.first.starts_with("residue.why.");
  });
  EXPECT_GE(drawn, 4);
  EXPECT_LT(drawn, 20);
}

TEST_F(ResiduesPanel, FilesWithoutResiduesSayThatThereAreNone) {
  const float below = p.rects["molecule.radii"].y0;
  p.state.molecule.residues = in_list({});
  p.frame(2);
  EXPECT_FALSE(p.rects.contains("molecule.residues"));
  EXPECT_EQ(p.rects["molecule.radii"].y0, below) << "nothing moves";
}

class ResiduesPanelAtEverySize : public ::testing::TestWithParam<Size> {};

TEST_P(ResiduesPanelAtEverySize, ItsLinesFitIntoThePanel) {
  Panels p(GetParam());
  p.state = state_with_residues();
  ResidueGroup treated = residues("A1B2C", ResidueKind::polymer, ResidueReason::by_hand, 1234567);
  treated.file_kind = ResidueKind::ligand;
  treated.file_why = ResidueReason::no_polymer;
  p.state.molecule.residues = in_list({kGuessed, kHaems, treated, kWaters});
  p.frame(3);
  for (const char* name : {"QQ1", "HEM", "A1B2C", "HOH"}) {
    ASSERT_TRUE(p.rects.contains(std::string("residue.") + name)) << name;
    const WidgetRect text = p.rects[std::string("residue.name.") + name],
                     choice = p.rects[std::string("residue.") + name],
                     why = p.rects[std::string("residue.why.") + name];
    EXPECT_LT(text.x1, choice.x0) << name;
    EXPECT_LE(choice.x1, p.rects["view"].x0) << name;
    EXPECT_GE(why.y0, choice.y1) << name;
    EXPECT_LE(why.x1, p.rects["view"].x0) << name;
  }
  EXPECT_LE(p.rects["residue.why.HOH"].y1, p.rects["molecule.radii"].y0);
}

INSTANTIATE_TEST_SUITE_P(Sizes, ResiduesPanelAtEverySize,
                         ::testing::Values(Size{1100, 700, 1}, Size{1280, 800, 1},
                                           Size{1920, 1080, 1}, Size{1280, 800, 2}));

}  // namespace
}  // namespace alphascope
