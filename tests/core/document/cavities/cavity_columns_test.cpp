// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the columns of cavities: their values and texts, and those of results that are not known.
#include "core/document/cavities/cavity_columns.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/cavity/cavities.hpp"
#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_lives.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/channel/bottlenecks.hpp"
#include "core/document/cavities/cavity_bottlenecks.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/cavities/known_cavities.hpp"
#include "core/document/export/program_name.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/settings/cavity_preset.hpp"
#include "core/document/tables/cell_value.hpp"
#include "core/document/tables/column.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/read/read_molecule.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/triangulation/make_triangulation.hpp"

namespace alphascope {
namespace {

// Cavities of haemoglobin with CASTp's choices. No result beyond the table is known.
const KnownCavities& haemoglobin() {
  static const KnownCavities known = [] {
    const auto molecule = std::make_shared<const Molecule>(
        read_molecule(ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz"));
    const auto prepared = std::make_shared<const PreparedBalls>(
        prepare_balls(*molecule, cavity_body({}, molecule->has_file_radii)));
    const auto balls = std::make_shared<const BallSet>(with_solvent(*prepared->balls, 1.4));
    const auto ground = std::make_shared<const CavityGround>(make_cavity_ground(
        balls, std::make_shared<const Triangulation>(make_triangulation(*balls, 1))));
    KnownCavities made;
    made.atoms = std::make_shared<const BallReferences>(molecule, prepared);
    made.all = std::make_shared<const CavityTable>(make_cavity_table(ground, {0, 1.4}));
    return made;
  }();
  return known;
}

std::string text(const KnownCavities& of, const char* id, std::size_t row) {
  return column_of(cavity_columns(), id).shown_text({of, row});
}
CellValue value(const KnownCavities& of, const char* id, std::size_t row) {
  return column_of(cavity_columns(), id).value({of, row});
}

std::size_t first(bool is_void) {
  std::size_t row = 0;
  while (haemoglobin().table().cavity(row).is_void() != is_void) ++row;
  return row;
}

TEST(CavityColumns, ValuesAreThoseOfTheTable) {
  const KnownCavities& of = haemoglobin();
  ASSERT_EQ(of.size(), 86u);
  EXPECT_EQ(value(of, "id", 3), CellValue(std::uint64_t{4}));
  EXPECT_EQ(value(of, "name", 3),
            CellValue(std::string("A:PHE 43:CZ A:HIS 87:NE2 A:VAL 93:CG2 A:LEU 101:CD2")));
  EXPECT_EQ(value(of, "volume_sa_angstrom3", 3),
            CellValue(of.table().measure(3).volume_sa_angstrom3));
  EXPECT_EQ(value(of, "kind", first(true)), CellValue(std::string("void")));
  EXPECT_EQ(value(of, "kind", first(false)), CellValue(std::string("pocket")));
  EXPECT_EQ(value(of, "lining_residues", 3),
            CellValue(std::uint64_t{lining_residues(*of.atoms, of.table(), 3).size()}));
}

TEST(CavityColumns, PolarLiningCountsNitrogenAndOxygenButNoHydrogen) {
  KnownCavities of = haemoglobin();
  Molecule molecule = of.atoms->molecule();
  const std::vector<std::uint32_t>& atom_of_ball = of.atoms->prepared().atom_of_ball;
  std::size_t polar = 0;
  const std::vector<BallIndex>& lining = of.table().measure(3).lining;
  for (const BallIndex ball : lining) {
    const char first = molecule.text(molecule.atoms[atom_of_ball[ball]].name)[0];
    polar += first == 'N' || first == 'O';  // names of atoms of proteins begin with the element
  }
  ASSERT_GT(polar, 2u);
  const auto percent = [](std::size_t part, std::size_t whole) {
    return CellValue(100.0 * static_cast<double>(part) / static_cast<double>(whole));
  };
  EXPECT_EQ(value(of, "polar_lining_percent", 3), percent(polar, lining.size()));
  const auto with_element = [&](Element element) {
    molecule.atoms[atom_of_ball[lining.front()]].element = element;
    of.atoms = std::make_shared<const BallReferences>(
        std::make_shared<const Molecule>(molecule),
        std::make_shared<const PreparedBalls>(of.atoms->prepared()));
  };
  const Element before = molecule.atoms[atom_of_ball[lining.front()]].element;
  const bool was_polar = before == 7 || before == 8;
  with_element(kHydrogen);
  EXPECT_EQ(value(of, "polar_lining_percent", 3),
            percent(polar - (was_polar ? 1 : 0), lining.size() - 1));
  with_element(kUnknownElement);
  EXPECT_EQ(value(of, "polar_lining_percent", 3), CellValue());
  EXPECT_EQ(text(of, "polar_lining_percent", 3), "–");
}

TEST(CavityColumns, ResultsThatAreNotKnownHaveNoValue) {
  const KnownCavities& of = haemoglobin();
  for (const char* id :
       {"volume_sa_clipped_angstrom3", "doubtful", "depth_angstrom", "born_alpha_angstrom2",
        "closed_alpha_angstrom2", "gone_alpha_angstrom2", "bottleneck_angstrom", "holds"}) {
    EXPECT_EQ(value(of, id, 0), CellValue()) << id;
    EXPECT_EQ(text(of, id, 0), "…") << id;
  }
}

TEST(CavityColumns, TextsOfTheWindow) {
  KnownCavities of = haemoglobin();
  const std::size_t pocket = first(false), closed = first(true);
  const auto exact = std::make_shared<ExactVolumes>();
  exact->of.assign(of.size(), {0.5, 1});
  exact->of[of.table().order[pocket]] = {of.table().measure(pocket).volume_sa_angstrom3, 1};
  of.exact = exact;
  EXPECT_EQ(text(of, "volume_sa_clipped_angstrom3", closed), "0.50 *") << "below 1 Å³";
  EXPECT_TRUE(text(of, "volume_sa_clipped_angstrom3", pocket).ends_with("  "));
  const auto depths = std::make_shared<CavityDepths>();
  depths->of_angstrom.assign(of.size(), 4.25);
  of.depths = depths;
  EXPECT_EQ(text(of, "depth_angstrom", pocket), "4.25");
  EXPECT_EQ(text(of, "depth_angstrom", closed), "–");
  EXPECT_EQ(text(of, "mouth_area_angstrom2", closed), "–");
  const auto bottlenecks = std::make_shared<CavityBottlenecks>();
  bottlenecks->rows.resize(3);
  bottlenecks->rows[0] = {Bottleneck::Kind::passage, 1.2, 1.3, 1.25, {}, {}};
  bottlenecks->rows[1].kind = Bottleneck::Kind::closed;
  of.bottlenecks = bottlenecks;
  EXPECT_EQ(text(of, "bottleneck_angstrom", 0), "1.25");
  EXPECT_EQ(text(of, "bottleneck_angstrom", 1), "closed");
  EXPECT_EQ(text(of, "bottleneck_angstrom", 2), "–") << "in a ball";
  EXPECT_EQ(text(of, "bottleneck_angstrom", 3), "–") << "not among the largest";
}

TEST(CavityColumns, AVoidThatIsThereAtEveryAlphaIsBornAtMinusInfinity) {
  KnownCavities of = haemoglobin();
  const auto lives = std::make_shared<CavityLives>(cavity_lives(*of.table().ground));
  for (CavityLife& life : lives->lives) life.born = -std::numeric_limits<float>::infinity();
  of.lives = lives;
  EXPECT_EQ(text(of, "born_alpha_angstrom2", 0), "−∞");
  EXPECT_EQ(csv_cell(value(of, "born_alpha_angstrom2", 0)), "");
  EXPECT_NE(text(of, "gone_alpha_angstrom2", 0), "…");
}

TEST(CavityColumns, EachHasHelp) {
  ASSERT_GT(cavity_columns().size(), 30u);
  for (const Column<CavityRow>& column : cavity_columns()) {
    EXPECT_STRNE(column.help, "") << column.id;
  }
}

}  // namespace
}  // namespace alphascope
