// SPDX-License-Identifier: GPL-3.0-or-later
// Tests areas and volumes as derived results, and as rows of a table.
#include "core/document/measures/measure_rows.hpp"

#include "core/document/export/record_source.hpp"
#include "core/document/measures/measure_columns.hpp"
#include "core/document/measures/measure_tables.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/answer.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/tables/column.hpp"
#include "core/engine/engine.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/document/store/store_fixture.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Two residues of one chain with overlapping balls, and a distant chain.
constexpr const char* kFile =
    "ATOM      1  CA  HIS A  87       0.000   0.000   0.000  1.00  9.67           C  \n"
    "ATOM      2  CA  GLY A  88       2.000   0.000   0.000  1.00 10.38           C  \n"
    "ATOM      3  CA  ALA B   9      50.000   0.000   0.000  1.00 10.38           C  \n";

struct MeasureRowsTest : testing::StoreTest {
  std::shared_ptr<const Answer> answer;
  Inputs in;

  MeasureRowsTest() {
    budget = 1'000'000'000;
    const auto molecule = std::make_shared<const Molecule>(read_text("a.pdb", kFile));
    BallOptions options;
    options.radii = RadiiSet::bondi;  // C 1.70
    auto prepared = std::make_shared<const PreparedBalls>(prepare_balls(*molecule, options));
    auto computed = std::make_shared<Answer>();
    computed->balls = prepared->balls;
    computed->complex = make_cpu_engine(computed->balls)->compute({0}, {});
    computed->molecule = molecule;
    computed->prepared = prepared;
    answer = computed;
    in.balls = answer->balls;
    in.balls_key = 1;
    in.complex = {answer, &answer->complex};
  }
  MeasureRows rows(const MeasureQuery& query) {
    const auto found = settle(measure_rows(query, answer), in);
    EXPECT_TRUE(found.ready()) << found.why;
    return found.ready() ? *found.value : MeasureRows{};
  }
  static std::string names(const MeasureRows& rows) {
    std::string text;
    for (const MeasureRow& row : rows.rows) text += (text.empty() ? "" : " ") + row.name;
    return text;
  }
};

double value_of(const MeasureRows& rows, std::size_t row, const char* column) {
  return std::get<double>(column_of(measure_columns(), column).value({rows, rows.rows.at(row)}));
}

constexpr double kCap = 2 * kPi * 1.7 * 0.7, kSphere = 4 * kPi * 1.7 * 1.7;  // Å²

TEST_F(MeasureRowsTest, AddUpByAtomResidueChainAndComponent) {
  const double whole = 3 * kSphere - 2 * kCap;
  for (const MeasureGrouping per :
       {MeasureGrouping::all, MeasureGrouping::atom, MeasureGrouping::residue,
        MeasureGrouping::chain, MeasureGrouping::component}) {
    double area = 0, shares = 0;
    for (const MeasureRow& row : rows({.per = per}).rows) {
      area += row.of[MeasuredQuantity::area];
      shares += row.share_of_volume;
    }
    EXPECT_NEAR(area, whole, 1e-10);
    EXPECT_NEAR(shares, 1, 1e-14);
  }
  const MeasureRows chains = rows({.per = MeasureGrouping::chain});
  EXPECT_EQ(names(chains), "A B");
  EXPECT_EQ(chains.rows[0].atoms, 2u);
  EXPECT_NEAR(chains.rows[0].exposed_share, 1 - kCap / kSphere, 1e-14);
  EXPECT_EQ(names(rows({.per = MeasureGrouping::component})), "A:HIS 87:CA B:ALA 9:CA");
}

TEST_F(MeasureRowsTest, SortAndFilter) {
  MeasureQuery query{.per = MeasureGrouping::residue};
  EXPECT_EQ(names(rows(query)), "A:HIS 87 A:GLY 88 B:ALA 9");
  query.column = "name";
  EXPECT_EQ(names(rows(query)), "A:GLY 88 A:HIS 87 B:ALA 9");
  query.column = "area_angstrom2";
  query.descending = true;
  EXPECT_EQ(names(rows(query)), "B:ALA 9 A:HIS 87 A:GLY 88") << "equal ones as in the molecule";
  query.filter = "a:";
  const MeasureRows of_a = rows(query);
  EXPECT_EQ(names(of_a), "A:HIS 87 A:GLY 88");
  EXPECT_EQ(of_a.all, 3u);
  query.filter = "nothing";
  EXPECT_TRUE(rows(query).rows.empty());
}

TEST_F(MeasureRowsTest, DerivativesOfAtomsWhenAsked) {
  const MeasureRows without = rows({.per = MeasureGrouping::atom});
  EXPECT_FALSE(without.derivatives);
  MeasureQuery query{.per = MeasureGrouping::atom, .derivatives = true};
  query.column = "volume_by_shift_angstrom2";
  const MeasureRows with = rows(query);
  ASSERT_TRUE(with.derivatives);
  EXPECT_EQ(names(with), "B:ALA 9:CA A:HIS 87:CA A:GLY 88:CA") << "a ball alone has none";
  const double disc = kPi * (1.7 * 1.7 - 1);
  EXPECT_NEAR(value_of(with, 1, "volume_by_shift_angstrom2"), disc, 1e-12);
  EXPECT_NEAR(value_of(with, 0, "volume_by_radius_angstrom2"), kSphere, 1e-12);
}

TEST_F(MeasureRowsTest, CsvSaysWhereItComesFrom) {
  const RecordSource source{answer->molecule, answer->prepared, {}, {"prog", "1.2", "abc"}};
  const auto csv = settle(measure_csv({.per = MeasureGrouping::chain}, source, answer), in);
  ASSERT_TRUE(csv.ready()) << csv.why;
  EXPECT_EQ(csv.value->find("model,group,atoms,area_angstrom2,volume_angstrom3,exposed_share"), 0u);
  EXPECT_NE(csv.value->find("\n1,A,2,"), std::string::npos) << *csv.value;
  EXPECT_NE(csv.value->find("prog 1.2 (abc)\n"), std::string::npos) << *csv.value;
  const auto json = settle(measure_json({.per = MeasureGrouping::chain}, source, answer), in);
  ASSERT_TRUE(json.ready()) << json.why;
  EXPECT_NE(json.value->find("\"chains\": ["), std::string::npos) << *json.value;
  EXPECT_NE(csv.value->find("van der Waals surface"), std::string::npos);
  EXPECT_NE(csv.value->find(hash_text(answer->complex.hash)), std::string::npos);
}

TEST_F(MeasureRowsTest, WhatADeviceMeasuredIsTaken) {
  MeasuredUnion by;
  by.measures = measure_union(*in.balls, *in.complex);
  by.device = "a device";
  in.measures = std::make_shared<const MeasuredUnion>(by);
  const auto measured = settle(union_measures(), in);
  ASSERT_TRUE(measured.ready());
  EXPECT_EQ(measured.value->by, in.measures);
  EXPECT_EQ(measured.value->components.count, 2u);
}

TEST_F(MeasureRowsTest, TetrahedraAloneHaveNone) {
  auto alone = std::make_shared<AlphaComplex>(answer->complex);
  alone->tetrahedra_only = true;
  in.complex = alone;
  const auto measured = settle(union_measures(), in);
  EXPECT_EQ(measured.state, DerivedState::failed);
  EXPECT_NE(measured.why.find("tetrahedra alone"), std::string::npos) << measured.why;
}

TEST_F(MeasureRowsTest, ExposedSharesOfAtomsAndResidues) {
  const UnionMeasures m = measure_union(*in.balls, *in.complex);
  const double alpha = in.complex->alpha_on_lattice.nearest();
  const std::vector<float> atoms = exposed_shares(m, *in.balls, alpha);
  ASSERT_EQ(atoms.size(), 3u);
  EXPECT_NEAR(atoms[0], 1 - kCap / kSphere, 1e-6);
  EXPECT_NEAR(atoms[2], 1, 1e-6);
  EXPECT_EQ(atoms, exposed_shares_of_residues(m, *in.balls, alpha, *answer->molecule,
                                              answer->prepared->atom_of_ball));
}

TEST(SurfaceName, SaysWhatIsMeasured) {
  Request request;
  EXPECT_EQ(surface_name(request), "van der Waals surface");
  request.solvent_radius_angstrom = 1.4;
  EXPECT_EQ(surface_name(request), "solvent-accessible surface, probe of 1.4 Å");
  request.alpha_angstrom2 = -2.5;
  EXPECT_EQ(surface_name(request), "surface of balls with radii sqrt((r + 1.4)² - 2.5)");
  request.solvent_radius_angstrom = 0;
  EXPECT_EQ(surface_name(request), "surface of balls with radii sqrt(r² - 2.5)");
}

}  // namespace
}  // namespace alphascope
