// SPDX-License-Identifier: GPL-3.0-or-later
// Tests lives of cavities as bars: the longest ones, their descriptions, and their table.
#include "core/document/cavities/cavity_bars.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_lives.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/reference/reference.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/read/read_molecule.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/triangulation/make_triangulation.hpp"

namespace alphascope {
namespace {

constexpr float kEver = -std::numeric_limits<float>::infinity();

const Lattice kUnits{0};  // the unit is 1 Å

std::vector<std::uint32_t> sinks_of(const CavityBars& bars) {
  std::vector<std::uint32_t> sinks;
  for (const CavityBar& bar : bars.longest) sinks.push_back(bar.sink);
  return sinks;
}

TEST(CavityBars, TheLongestComeFirstAndWhatIsBeforeCountsForNothing) {
  const CavityLives lives{{2, 3, 5, 7, 11, 13},
                          {{kEver, 1, 2},   // 5 from -3 on
                           {-10, 4, 1},     // 4
                           {0, 0, 9},       // 9
                           {1, 2, 5},       // 4, after the equal one
                           {6, 6, 6},       // never there
                           {-20, -9, -8}},  // before
                          {0, 1, 2, 3, 4, 5}};
  using Sinks = std::vector<std::uint32_t>;
  const CavityBars bars = longest_bars(lives, kUnits, -3, 10);
  EXPECT_EQ(sinks_of(bars), (Sinks{5, 2, 3, 7}));
  EXPECT_EQ(bars.all, 5u);
  EXPECT_EQ(sinks_of(longest_bars(lives, kUnits, -3, 2)), (Sinks{5, 2}));
  EXPECT_EQ(sinks_of(longest_bars(lives, kUnits, -30, 1)), (Sinks{2}));
  EXPECT_TRUE(longest_bars({}, kUnits, -3, 10).longest.empty());
}

TEST(CavityBars, AnAlphaWithinIsWithinHoweverShortTheBar) {
  EXPECT_EQ(alpha_within({0, -10, 0, 4}, -3), 0.5);
  EXPECT_EQ(alpha_within({0, 1, 1, 1.5}, -3), 1.25);
  for (const double length : {1e-3, 1e-5, 1e-9}) {
    const CavityBar bar{0, 1.2345678, 1.2345678, 1.2345678 + length};
    EXPECT_TRUE(bar.is_at(alpha_within(bar, -3))) << length;
    EXPECT_TRUE(bar.is_at(alpha_within(bar, 1.2345678 + length / 2))) << length;
  }
}

TEST(CavityBars, TheSentenceSaysWhatItIsAndWhen) {
  EXPECT_EQ(bar_text({0, -0.52, 1.2, 4.85}),
            "a pocket from −0.52 Å², a void from 1.20 Å², filled at 4.85 Å²");
  EXPECT_EQ(bar_text({0, 0.5, 9, 4.85}), "a pocket from 0.50 Å², filled at 4.85 Å²");
  EXPECT_EQ(bar_text({0, 2, 2, 3}), "a void from 2.00 Å², filled at 3.00 Å²");
  EXPECT_EQ(bar_text({0, kEver, 1, 3}),
            "a pocket at every smaller alpha, a void from 1.00 Å², filled at 3.00 Å²");
}

// The cavities at an alpha are those whose bar is there, and the table lists all of them.
TEST(CavityBars, OfAProteinAreItsCavities) {
  const auto molecule = std::make_shared<const Molecule>(
      read_molecule(ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb"));
  const auto prepared = std::make_shared<const PreparedBalls>(prepare_balls(*molecule, {}));
  const BallReferences atoms(molecule, prepared);
  const auto ground = std::make_shared<const CavityGround>(make_cavity_ground(
      prepared->balls,
      std::make_shared<const Triangulation>(make_triangulation(*prepared->balls, 1))));
  const CavityBars bars =
      longest_bars(cavity_lives(*ground), prepared->balls->lattice, -100, 1'000'000);
  ASSERT_GT(bars.all, 10u);
  EXPECT_EQ(bars.longest.size(), bars.all);
  std::size_t cavities = 0;
  for (const double alpha : {-1.0, 0.0, 0.5, 1.4, 3.0}) {
    const CavityTable table = make_cavity_table(ground, {alpha, 0});
    std::size_t there = 0;
    for (const CavityBar& bar : bars.longest) there += bar.is_at(alpha);
    EXPECT_EQ(there, table.size()) << alpha;
    for (std::size_t row = 0; row < table.size(); ++row) {
      const auto at = std::find_if(
          bars.longest.begin(), bars.longest.end(),
          [&](const CavityBar& b) { return b.sink == table.cavity(row).deepest_sink; });
      ASSERT_NE(at, bars.longest.end());
      EXPECT_TRUE(at->is_at(alpha));
      EXPECT_EQ(at->closed_angstrom2 <= alpha, table.cavity(row).is_void());
      EXPECT_EQ(sink_name(atoms, ground->triangulation->tetrahedra[at->sink]),
                cavity_name(atoms, table, row));
      ++cavities;
    }
  }
  EXPECT_GT(cavities, 20u);
  const std::string csv = bars_csv({bars.longest.front()}, *ground->triangulation, atoms, {"one"});
  EXPECT_EQ(
      csv.find("# one\nborn_alpha_angstrom2,closed_alpha_angstrom2,gone_alpha_angstrom2,name\n"),
      0u)
      << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  EXPECT_NE(
      csv.find(sink_name(atoms, ground->triangulation->tetrahedra[bars.longest.front().sink])),
      std::string::npos);
}

}  // namespace
}  // namespace alphascope
