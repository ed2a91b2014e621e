// SPDX-License-Identifier: GPL-3.0-or-later
// Tests contents of cavities: molecules with known sites, and a cage with atoms at chosen places.
#include "core/document/cavities/cavity_contents.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/cavity_identity.hpp"
#include "core/cavity_identity/cavity_numbers.hpp"
#include "core/cavity_identity/cavity_trace.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/settings/cavity_preset.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/radii/radii_set.hpp"
#include "core/read/read_molecule.hpp"
#include "core/selection/atom_address.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/core/document/store/store_fixture.hpp"
#include "tests/core/files/temporary_file.hpp"
#include "tests/support/molecules.hpp"

namespace alphascope {
namespace {

struct Body {
  std::shared_ptr<const BallReferences> atoms;
  Inputs inputs;
  std::shared_ptr<const CavityTable> table;
};

Body body_of(Molecule molecule, double solvent) {
  const auto shared = std::make_shared<const Molecule>(std::move(molecule));
  const auto prepared = std::make_shared<const PreparedBalls>(
      prepare_balls(*shared, cavity_body({}, shared->has_file_radii)));
  Body body;
  body.atoms = std::make_shared<const BallReferences>(shared, prepared);
  body.inputs.atoms = body.atoms;
  body.inputs.balls = std::make_shared<const BallSet>(with_solvent(*prepared->balls, solvent));
  body.inputs.balls_key = body.inputs.body_key = 1;
  body.inputs.solvent_radius_angstrom = solvent;
  const auto ground = std::make_shared<const CavityGround>(make_cavity_ground(
      body.inputs.balls,
      std::make_shared<const Triangulation>(make_triangulation(*body.inputs.balls, 1))));
  body.table = std::make_shared<const CavityTable>(make_cavity_table(ground, {0, solvent}));
  return body;
}

Body haemoglobin() {
  return body_of(read_molecule(ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz"), 1.4);
}

std::vector<std::string> lining(const Body& body, std::uint32_t cavity) {
  std::vector<std::string> addresses;
  for (std::size_t row = 0; row < body.table->size(); ++row) {
    if (body.table->order[row] != cavity) continue;
    for (const LiningResidue& residue : lining_residues(*body.atoms, *body.table, row)) {
      addresses.push_back(residue.address);
    }
  }
  return addresses;
}

TEST(CavityContents, EachHaemIsInThePocketOfItsProximalHistidine) {
  const Body body = haemoglobin();
  const CavityContents contents = find_contents(*body.atoms, *body.table);
  const std::map<std::string, std::string> histidine = {{"A:HEM 142", "A:HIS 87"},
                                                        {"B:HEM 148", "B:HIS 92"},
                                                        {"C:HEM 142", "C:HIS 87"},
                                                        {"D:HEM 148", "D:HIS 92"}};
  std::vector<std::uint32_t> cavities;
  std::size_t waters = 0;
  for (const ContainedResidue& residue : contents.residues) {
    waters += residue.kind == DropReason::water;
    const auto site = histidine.find(residue_address(body.atoms->molecule(), residue.atom));
    if (site == histidine.end()) continue;
    EXPECT_EQ(residue.kind, DropReason::ligand);
    EXPECT_EQ(residue.atoms, 43u);
    EXPECT_GT(residue.inside, 25u) << "most of its atoms, not those that look out of the pocket";
    const auto residues = lining(body, residue.cavity);
    EXPECT_NE(std::find(residues.begin(), residues.end(), site->second), residues.end());
    cavities.push_back(residue.cavity);
  }
  ASSERT_EQ(cavities.size(), 4u);
  std::sort(cavities.begin(), cavities.end());
  EXPECT_EQ(std::adjacent_find(cavities.begin(), cavities.end()), cavities.end());
  EXPECT_EQ(waters, 221u);
  EXPECT_EQ(contents_text(body.atoms->molecule(), contents, body.table->order[3]),
            "A:HEM 142 (32 of 43 atoms), 1 water");
}

TEST(CavityContents, EveryAtomIsInTheCavityOfTheTetrahedronThatHoldsIt) {
  const Body body = haemoglobin();
  const CavityContents contents = find_contents(*body.atoms, *body.table);
  std::size_t listed = 0;
  for (std::uint32_t c = 0; c < contents.of.size(); ++c) {
    int last = 0;
    for (const std::uint32_t n : contents.of[c]) {
      EXPECT_EQ(contents.residues[n].cavity, c);
      EXPECT_GE(contents.residues[n].inside, 1u);
      const int kind = contents.residues[n].kind == DropReason::water ? 1 : 0;
      EXPECT_GE(kind, last) << "waters come last";
      last = kind;
      ++listed;
    }
  }
  std::size_t none = 0;
  for (const ContainedResidue& residue : contents.residues)
    none += residue.cavity == Cavities::kNone;
  EXPECT_EQ(listed + none, contents.residues.size());
  EXPECT_GT(listed, 60u);
  EXPECT_GT(none, 60u);
}

TEST(CavityContents, ProteinKinaseHoldsItsAtpAndIons) {
  ALPHASCOPE_NEED_TEST_DATA();
  const Body body =
      body_of(read_molecule(testing::test_data_folder() / "cavities/fpocket/1atp.pdb.gz"), 1.4);
  const CavityContents contents = find_contents(*body.atoms, *body.table);
  EXPECT_EQ(contents_text(body.atoms->molecule(), contents, body.table->order[0]),
            "E:ATP 355, E:MN 351, E:MN 352, 11 waters");
  EXPECT_EQ(contents_text(body.atoms->molecule(), contents, body.table->order[0], 1),
            "E:ATP 355, 2 more, 11 waters");
}

// Six carbon atoms of radius 1.88 Å. Grown by 3.02 to 4.12 Å they close a void.
std::string cage(double x, int first) {
  std::string text;
  const double at[6][3] = {{-6, 0, 0}, {6, 0, 0}, {0, -6, 0}, {0, 6, 0}, {0, 0, -6}, {0, 0, 6}};
  for (int k = 0; k < 6; ++k) {
    char line[96];
    std::snprintf(line, sizeof line,
                  "ATOM  %5d  CB  ALA A%4d    %8.3f%8.3f%8.3f  1.00  0.00           C  \n",
                  first + k, first + k, x + at[k][0], at[k][1], at[k][2]);
    text += line;
  }
  return text;
}
std::string hetero(int serial, const char* name, const char* residue, int number, double x,
                   double y = 0.1) {
  char line[96];
  std::snprintf(line, sizeof line,
                "HETATM%5d  %-3s %3s B%4d    %8.3f%8.3f%8.3f  1.00  0.00           %c  \n", serial,
                name, residue, number, x, y, 0.2, name[0]);
  return line;
}

TEST(CavityContents, AtomsAreCountedByResidueAndTiesGoToTheLargerCavity) {
  // The second void is larger.
  std::string text = cage(0, 1) + cage(40, 11);
  text.replace(text.find(" 46.000"), 7, " 46.300");
  text += hetero(21, "C1", "LIG", 1, 0.5) + hetero(22, "C2", "LIG", 1, 40.5) +
          hetero(23, "C1", "LIG", 2, 0.5) + hetero(24, "C2", "LIG", 2, 0.7) +
          hetero(25, "C3", "LIG", 2, 40.5) + hetero(26, "C4", "LIG", 2, 300) +
          hetero(27, "C1", "LIG", 3, 300) + hetero(28, "O", "HOH", 4, 0.3) +
          hetero(29, "O", "HOH", 4, 40.3) + hetero(30, "O", "HOH", 4, 20, 50);
  const Body body = body_of(read_text("a.pdb", text), 3.3);
  ASSERT_EQ(body.table->voids, 2u);
  const CavityContents contents = find_contents(*body.atoms, *body.table);
  const std::uint32_t larger = body.table->order[0], smaller = body.table->order[1];
  using R = ContainedResidue;
  const auto ligand = DropReason::ligand, water = DropReason::water;
  EXPECT_EQ(contents.residues, (std::vector<R>{{12, ligand, larger, 2, 1},
                                               {14, ligand, smaller, 4, 2},
                                               {18, ligand, Cavities::kNone, 1, 0},
                                               {19, water, smaller, 1, 1},
                                               {20, water, larger, 1, 1},
                                               {21, water, Cavities::kNone, 1, 0}}))
      << "waters of one number are told apart";
  EXPECT_EQ(contents_text(body.atoms->molecule(), contents, smaller),
            "B:LIG 2 (2 of 4 atoms), 1 water");
}

struct CavityContentsResult : testing::StoreTest {};

TEST_F(CavityContentsResult, FollowsTheTableAndNumbersGoOn) {
  budget = 1'000'000'000;
  const Body body = haemoglobin();
  const auto contents = settle(cavity_contents(), body.inputs).value;
  ASSERT_TRUE(contents);
  EXPECT_EQ(contents->residues, find_contents(*body.atoms, *body.table).residues);
  const std::uint64_t held_before = store.held_bytes();
  const auto lines = settle(cavity_lines(nullptr), body.inputs).value;
  ASSERT_TRUE(lines);
  EXPECT_TRUE(lines->is_of(body.inputs));
  ASSERT_EQ(lines->of.size(), body.table->size());
  EXPECT_EQ(lines->of[3].lining.residues, lining_residues(*body.atoms, *body.table, 3).size());
  EXPECT_EQ(lines->of[3].lining.chains, 2u) << "HIS 87 of chain A has ARG 40 of chain D beside it";
  EXPECT_EQ(lines->of[3].lining.of_second, 1u);
  EXPECT_FALSE(lines->of[3].lining.at_interface()) << "one residue is no side";
  std::size_t interfaces = 0;
  for (std::size_t row = 0; row < lines->of.size(); ++row) {
    std::map<char, std::size_t> by_chain;
    for (const LiningResidue& residue : lining_residues(*body.atoms, *body.table, row)) {
      ++by_chain[residue.address[0]];
    }
    const LiningCounts& counts = lines->of[row].lining;
    EXPECT_EQ(counts.chains, by_chain.size());
    if (by_chain.size() != 2) continue;
    EXPECT_EQ(counts.of_second, std::min(by_chain.begin()->second, by_chain.rbegin()->second));
    interfaces += counts.at_interface();
  }
  EXPECT_GT(interfaces, 0u);
  EXPECT_EQ(lines->of[3].bodies, 1u);
  // Memory of a line: itself, 60 bytes for its number, and its cavity in the trace. A megabyte is
  // added.
  EXPECT_EQ(store.held_bytes() - held_before,
            1'000'000 + body.table->size() * (sizeof(CavityLine) + 60 + sizeof(TracedCavity)));
  const auto first = lines->numbers;
  Inputs higher = body.inputs;
  higher.alpha_angstrom2 = 0.3;
  const auto later = settle(cavity_lines(lines), higher).value;
  ASSERT_TRUE(later);
  EXPECT_FALSE(later->is_of(body.inputs));
  const auto next = later->numbers;
  ASSERT_EQ(next->table->question.alpha_angstrom2, 0.3);
  std::size_t kept = 0;
  for (const std::uint32_t number : next->of) kept += number < first->used;
  EXPECT_GT(kept, 30u);
  EXPECT_LT(kept, next->of.size()) << "some have split";
  std::size_t parted = 0;
  for (std::uint32_t c = 0; c < next->of.size(); ++c) {
    parted += next->parted_from[c] != CavityMatch::kNone;
    EXPECT_TRUE(next->parted_from[c] == CavityMatch::kNone || next->of[c] >= first->used);
    EXPECT_EQ(next->merged[c], 0u) << "as alpha grows, cavities never join";
  }
  EXPECT_EQ(parted + kept, next->of.size());
  Inputs unknown = body.inputs;
  unknown.atoms = nullptr;
  EXPECT_EQ(settle(cavity_contents(), unknown).state, DerivedState::none);
  EXPECT_EQ(settle(cavity_lines(nullptr), unknown).state, DerivedState::none);
}

}  // namespace
}  // namespace alphascope
