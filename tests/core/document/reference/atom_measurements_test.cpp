// SPDX-License-Identifier: GPL-3.0-or-later
// Tests measured distances and angles: in the order of selection, under other options, in words.
#include "core/document/reference/atom_measurements.hpp"

#include "core/document/reference/measurement_columns.hpp"
#include "core/document/reference/reference.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

constexpr const char* kFile =
    "ATOM      1  N   SER A   1       1.000   2.000   3.000  1.00  9.67           N  \n"
    "ATOM      2  CA  SER A   1       4.000   6.000   3.000  1.00  9.67           C  \n"
    "ATOM      3  CB  SER A   1       4.000   6.000   3.000  1.00  9.67           C  \n"
    "ATOM      4  O   SER A   1       1.000   2.000   8.000  1.00  9.67           O  \n";

BallReferences references() {
  auto molecule = std::make_shared<const Molecule>(read_text("a.pdb", kFile));
  return {molecule, std::make_shared<const PreparedBalls>(prepare_balls(*molecule, {}))};
}

constexpr AtomRef kN{0, 0}, kCa{1, 0}, kCb{2, 0}, kO{3, 0};

std::optional<double> value(const std::vector<AtomRef>& atoms) {
  const auto of = measured(references().molecule(), {atoms});
  EXPECT_TRUE(of);
  return of ? of->value : std::nullopt;
}

TEST(AtomMeasurements, AreInAngstromAndDegrees) {
  EXPECT_EQ(value({kN, kCa}), 5);
  EXPECT_EQ(value({kCa, kCb}), 0) << "two atoms in one place";
  EXPECT_EQ(value({kN, kN}), 0);
  EXPECT_DOUBLE_EQ(value({kCa, kN, kO}).value(), 90);
  EXPECT_DOUBLE_EQ(value({kN, kCa, kO}).value(), 45);
  EXPECT_EQ(value({kN, kCa, kCb}), std::nullopt);
  EXPECT_EQ(value({kN, kCa, kCb, kO}), std::nullopt);
  EXPECT_FALSE(measured(references().molecule(), {{kN, {0, 1}}})) << "there is no copy";
  EXPECT_FALSE(measured(references().molecule(), {{kN, {4, 0}}}));
}

TEST(AtomMeasurements, AreReadFromAddresses) {
  const auto read = [](const char* text) { return read_measurement(references(), text).atoms; };
  const auto told = [&](const char* text) -> std::string {
    try {
      read(text);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(read("A:SER 1:O; A:1:N"), (std::vector<AtomRef>{kO, kN})) << "in this order";
  EXPECT_EQ(read("index 4;#1 ; name CA ;"), (std::vector<AtomRef>{kO, kN, kCa}));
  EXPECT_EQ(told("A:SER 1:O"),
            "Two atoms have a distance, three an angle, and four a dihedral angle.");
  EXPECT_EQ(told("#1;#2;#3;#4;#1"), told("#1"));
  EXPECT_EQ(told("A:SER 1:O; A:9:N"), "The molecule has no atom \"A:9:N\".");
  EXPECT_EQ(told("#1; name C?"),
            "\"name C?\" names several atoms, such as A:SER 1:CA and A:SER 1:CB. Name one.");
  EXPECT_NE(told("#1; chain").find("column"), std::string::npos);
}

TEST(AtomMeasurements, FollowTheOrderOfSelection) {
  Selection selection;
  const auto add = [&](const Ref& ref) {
    selection.items = selection.items.toggled(ref);
    selection.note_order();
  };
  EXPECT_FALSE(selected_measurement(selection).why_not.empty());
  add(kO);
  EXPECT_FALSE(selected_measurement(selection).why_not.empty());
  add(kN);
  add(kCb);
  EXPECT_EQ(selected_measurement(selection).measurement->atoms,
            (std::vector<AtomRef>{kO, kN, kCb}));
  add(kO);  // removes it
  add(kO);
  EXPECT_EQ(selected_measurement(selection).measurement->atoms,
            (std::vector<AtomRef>{kN, kCb, kO}));
  selection.items = RefSet({kCa, kN});
  EXPECT_EQ(selected_measurement(selection).measurement->atoms, (std::vector<AtomRef>{kN, kCa}))
      << "also when nobody has noted the order";
  selection.items = RefSet({SimplexRef{kN, kO}});
  EXPECT_EQ(selected_measurement(selection).measurement->atoms, (std::vector<AtomRef>{kN, kO}));
  selection.items = RefSet({SimplexRef{kN, kCa, kO}});
  EXPECT_FALSE(selected_measurement(selection).measurement);
  selection.items = RefSet({SimplexRef{kN, kO}, kCa});
  EXPECT_FALSE(selected_measurement(selection).measurement);
  std::vector<Ref> many;
  for (std::uint32_t i = 0; i < 40; ++i) many.emplace_back(AtomRef{i, 0});
  selection.items = RefSet(many);
  selection.note_order();
  EXPECT_EQ(selection.atoms_in_order().size(), 40u);
  EXPECT_FALSE(selected_measurement(selection).measurement);
}

TEST(AtomMeasurements, AreATable) {
  EXPECT_EQ(
      measurements_csv(references().molecule(), {{{kN, kCa}}, {{kN, kCa, kCb}}, {{kN, {9, 0}}}}),
      "number,kind,value,unit,atom_1,atom_2,atom_3,atom_4\n"
      "1,distance,5,angstrom,A:SER 1:N,A:SER 1:CA,,\n"
      "2,angle,,degree,A:SER 1:N,A:SER 1:CA,A:SER 1:CB,\n"
      "3,distance,,angstrom,,,,\n");
}

}  // namespace
}  // namespace alphascope
