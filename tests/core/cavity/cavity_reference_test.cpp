// SPDX-License-Identifier: GPL-3.0-or-later
// Compares cavities and their numbers with the tables of an independent program, and with CASTp's
// own.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_measures.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "core/triangulation/membership.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/reference/cavity_reference.hpp"

namespace alphascope {
namespace {

using testing::CavityReference;
using testing::TableRow;

struct Answer {
  CavityGround ground;
  Cavities cavities;
  std::vector<CavityMeasures> measures;
};

Answer answer(const std::shared_ptr<const BallSet>& balls, double solvent_angstrom) {
  Answer found;
  found.ground = make_cavity_ground(
      balls, std::make_shared<const Triangulation>(make_triangulation(*balls, 1)));
  const auto& [set, triangulation, incidence, flow] = found.ground;
  if (triangulation->dimension < 3) return found;
  const Membership in = membership(*set, *triangulation, incidence, flow, 0);
  found.cavities = find_cavities(found.ground, in);
  found.measures = measure_cavities(found.ground, in, found.cavities,
                                    {0, balls->lattice.nearest_units(solvent_angstrom)});
  return found;
}

std::string all_differences(const CavityReference& reference) {
  std::string all;
  for (const TableRow& run : reference.runs()) {
    const Answer found = answer(reference.balls(run), std::stod(run.at("solvent")));
    for (const std::string& difference :
         reference.differences(run, found.ground, found.cavities, found.measures)) {
      all += difference + "\n";
    }
  }
  return all;
}

TEST(CavityReference, AgreesForSmallMoleculesAndTraps) {
  const CavityReference reference(ALPHASCOPE_SOURCE_DIR "/tests/data/cavities");
  EXPECT_EQ(reference.runs().size(), 25u);
  EXPECT_EQ(all_differences(reference), "");
}

TEST(CavityReference, AgreesForAllMolecules) {
  ALPHASCOPE_NEED_TEST_DATA();
  const CavityReference reference(testing::test_data_folder() / "cavities" / "reference");
  EXPECT_GT(reference.runs().size(), 70u);
  EXPECT_EQ(all_differences(reference), "");
}

// Formats a number such as "521.316".
std::string three_digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", value);
  return text;
}

// CASTp's tables have three decimals.
TEST(CavityReference, IsCastpsOutputFor1Hiv) {
  ALPHASCOPE_NEED_TEST_DATA();
  const auto folder = testing::test_data_folder() / "cavities";
  const CavityReference reference(folder / "reference");
  std::size_t compared = 0;
  for (const TableRow& run : reference.runs()) {
    if (run.at("input") != "castp_1hiv" || run.at("solvent") != "1.4") continue;
    const Answer found = answer(reference.balls(run), 1.4);
    std::ifstream table(folder / "castp" / "1hiv.pocInfo");
    std::string line, expected, ours;
    std::getline(table, line);
    std::size_t rows = 0;
    for (const std::uint32_t c : by_falling_volume(found.ground, found.cavities, found.measures)) {
      ASSERT_TRUE(std::getline(table, line));
      std::istringstream fields(line);
      std::string poc, name, id, field;
      fields >> poc >> name >> id;
      while (fields >> field) expected += field + " ";
      expected += "\n";
      const CavityMeasures& m = found.measures[c];
      ours += std::to_string(found.cavities.cavities[c].mouths.size()) + " ";
      for (const double value : {m.area_sa_angstrom2, m.area_ms_angstrom2, m.volume_sa_angstrom3,
                                 m.volume_ms_angstrom3, m.arc_length_angstrom}) {
        ours += three_digits(value) + " ";
      }
      ours += std::to_string(m.corners) + " \n";
      ++rows;
    }
    EXPECT_EQ(ours, expected);
    EXPECT_EQ(rows, 17u);
    ++compared;
  }
  EXPECT_EQ(compared, 1u) << "1hiv at 1.4 Å is not among the runs";
}

}  // namespace
}  // namespace alphascope
