// SPDX-License-Identifier: GPL-3.0-or-later
// Tests which rows belong to a choice of cavities while they merge and part, and texts on their
// lining.
#include "core/document/cavities/selected_cavities.hpp"

#include <gtest/gtest.h>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/cavity_numbers.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/cavities/drawn_parts.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/settings/cavity_preset.hpp"
#include "core/document/store/inputs.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/core/document/store/store_fixture.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

// A box with an inner wall whose hole the solvent radius 2 closes. Its left half is a chain with
// the name ":".
std::shared_ptr<const Molecule> two_chambers() {
  std::string text;
  int serial = 0;
  for (int x = 0; x <= 10; ++x) {
    for (int y = 0; y <= 4; ++y) {
      for (int z = 0; z <= 4; ++z) {
        const bool shell = x == 0 || x == 10 || y == 0 || y == 4 || z == 0 || z == 4;
        const bool hole = y == 2 && z == 2;
        if (!shell && !(x == 4 && !hole)) continue;
        ++serial;
        char line[100];
        std::snprintf(line, sizeof line, "ATOM %d CA GLY %s %d %d.0 %d.0 %d.0 0.0 3.0\n", serial,
                      x < 4 ? ":" : "B", serial, 4 * x, 4 * y, 4 * z);
        text += line;
      }
    }
  }
  return std::make_shared<const Molecule>(read_text("box.pqr", text));
}

struct ChosenCavitiesTest : testing::StoreTest {
  std::shared_ptr<const Molecule> molecule = two_chambers();
  std::shared_ptr<const PreparedBalls> prepared = std::make_shared<const PreparedBalls>(
      prepare_balls(*molecule, cavity_body({}, molecule->has_file_radii)));
  std::shared_ptr<const BallReferences> atoms =
      std::make_shared<const BallReferences>(molecule, prepared);

  void SetUp() override { budget = 1'000'000'000; }
  Inputs inputs_with(double solvent) {
    Inputs in;
    in.atoms = atoms;
    in.balls = std::make_shared<const BallSet>(with_solvent(*prepared->balls, solvent));
    in.balls_key = static_cast<std::uint64_t>(solvent * 10) + 1;
    in.body_key = 1;
    in.solvent_radius_angstrom = solvent;
    return in;
  }
  std::shared_ptr<const CavityTable> table_with(double solvent) {
    const auto balls = inputs_with(solvent).balls;
    const auto ground = std::make_shared<const CavityGround>(make_cavity_ground(
        balls, std::make_shared<const Triangulation>(make_triangulation(*balls, 1))));
    return std::make_shared<const CavityTable>(make_cavity_table(ground, {0, solvent}));
  }
  CavityLines lines_of(const CavityNumbers& numbers) {
    CavityLines lines;
    lines.table = numbers.table;
    lines.atoms = atoms;
    lines.numbers = std::make_shared<const CavityNumbers>(numbers);
    return lines;
  }
};

using Rows = std::vector<std::size_t>;

TEST_F(ChosenCavitiesTest, AChoiceFollowsToWhatItsCavityMergesInto) {
  const auto closed = table_with(2), open = table_with(0);
  ASSERT_EQ(closed->size(), 2u);
  ASSERT_EQ(open->size(), 1u);
  const CavityNumbers two = first_numbers(closed), one = next_numbers(two, open);
  const RefSet small({cavity_sink(*atoms, *closed, 1)});
  EXPECT_EQ(rows_of_cavities(lines_of(two), small).rows, Rows{1});
  EXPECT_TRUE(rows_of_cavities(lines_of(two), small).merged_into.empty());
  EXPECT_EQ(rows_of_cavities(lines_of(one), small).rows, Rows{0});
  EXPECT_EQ(rows_of_cavities(lines_of(one), small).merged_into, Rows{0});
  const RefSet large({cavity_sink(*atoms, *closed, 0)});
  EXPECT_EQ(rows_of_cavities(lines_of(one), large).rows, Rows{0});
  EXPECT_TRUE(rows_of_cavities(lines_of(one), large).merged_into.empty());
  const RefSet both({cavity_sink(*atoms, *closed, 0), cavity_sink(*atoms, *closed, 1)});
  EXPECT_EQ(rows_of_cavities(lines_of(one), both).rows, Rows{0}) << "once";
  const CavityNumbers again = next_numbers(one, closed);
  EXPECT_EQ(rows_of_cavities(lines_of(again), small).rows, Rows{1});
  EXPECT_TRUE(rows_of_cavities(lines_of(again), small).merged_into.empty());
  // A cavity chosen while both are one stays with the larger part.
  const CavityNumbers whole = first_numbers(open), parted = next_numbers(whole, closed);
  const RefSet all({cavity_sink(*atoms, *open, 0)});
  EXPECT_EQ(rows_of_cavities(lines_of(parted), all).rows, Rows{0});
}

TEST_F(ChosenCavitiesTest, LiningIsListedByChainsWhateverTheyAreCalled) {
  const auto table = table_with(2);
  CavitySinks sinks{table->sink(0), table->sink(1)};
  std::sort(sinks.begin(), sinks.end());
  const auto chosen = settle(selected_cavities(sinks, {}, 1), inputs_with(2));
  ASSERT_TRUE(chosen.ready()) << chosen.why;
  ASSERT_EQ(chosen.value->of.size(), 2u);
  const std::vector<ChainLining>& chains = chosen.value->residues;
  ASSERT_EQ(chains.size(), 2u);
  EXPECT_EQ(chains[0].chain, ":");
  EXPECT_EQ(chains[1].chain, "B");
  EXPECT_EQ(chains[0].residues.substr(0, 4), "GLY ");
  EXPECT_EQ(chains[0].residues.find(':'), std::string::npos);
  EXPECT_GT(chains[0].count, 5u);
}

}  // namespace
}  // namespace alphascope
