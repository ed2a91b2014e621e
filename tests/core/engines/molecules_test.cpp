// SPDX-License-Identifier: GPL-3.0-or-later
// Tests real molecules: known counts, and every engine against CGAL.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/complex/compare.hpp"
#include "tests/support/engines.hpp"
#include "tests/support/keeping_engine.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/sanitizer.hpp"

namespace alphascope {
namespace {

using testing::EngineFactory;

struct KnownCounts {
  const char* file;
  double solvent_angstrom, alpha_angstrom2;
  std::size_t edges, triangles, tetrahedra;
};

// Counts by CGAL's Fixed_alpha_shape_3 in an independent program.
constexpr KnownCounts kKnown[] = {
    {"ladder/1grm.crd", 0, 0, 576, 336, 20},
    {"ladder/1grm.crd", 0, 1, 812, 650, 136},
    {"ladder/1grm.crd", 0, 1.4, 906, 783, 185},
    {"ladder/1grm.crd", 1.4, 0, 1393, 1977, 846},
    {"thesis/1k4c.crd.gz", 0, 0, 37377, 23209, 2261},
    {"thesis/1k4c.crd.gz", 0, 1, 56633, 49175, 12657},
    {"thesis/1k4c.crd.gz", 0, 1.4, 63485, 59533, 16445},
    {"thesis/1k4c.crd.gz", 0, 3, 87304, 110972, 40809},
    {"thesis/1k4c.crd.gz", 1.4, 0, 105597, 166727, 76947},
};

class EveryEngine : public testing::EngineSuite {};
INSTANTIATE_TEST_SUITE_P(Engines, EveryEngine, ::testing::ValuesIn(testing::engines()),
                         testing::engine_name);

TEST_P(EveryEngine, FindsTheKnownCounts) {
  ALPHASCOPE_NEED_TEST_DATA();
  for (const KnownCounts& known : kKnown) {
    SCOPED_TRACE(std::string(known.file) + " alpha " + std::to_string(known.alpha_angstrom2));
    const auto balls = testing::molecule_balls(known.file, known.solvent_angstrom);
    if (testing::kAddressSanitizer && balls->size() > 1000 && known.alpha_angstrom2 != 1) continue;
    if (!GetParam().affords(*balls, known.alpha_angstrom2)) continue;
    const auto engine = GetParam().make(balls);
    const AlphaComplex complex = engine->compute({known.alpha_angstrom2}, {});
    EXPECT_EQ(complex.edges.size(), known.edges);
    EXPECT_EQ(complex.triangles.size(), known.triangles);
    EXPECT_EQ(complex.tetrahedra.size(), known.tetrahedra);
    const AlphaComplex only = engine->compute({known.alpha_angstrom2, true}, {});
    EXPECT_TRUE(compare(only, complex).identical());
    EXPECT_EQ(only.hash, tetrahedra_hash(complex));
  }
}

void expect_equals_cgal(const EngineFactory& factory, const std::string& name,
                        std::shared_ptr<const BallSet> balls) {
  const auto reference = testing::keeping(make_cgal_engine(balls, {1}));
  const auto engine = factory.make(balls);
  // The dual-edge engine is not meant for alphas at which every ball meets every other.
  const bool dual_edges = factory.name.starts_with("dual_edges");
  std::vector<double> alphas = {10.0, -1.0, 0.0, 0.5, 1.4, 3.0, 100.0};
  if (testing::kAddressSanitizer) alphas = {-1.0, 1.4, 100.0};
  for (const double alpha : alphas) {
    if ((dual_edges && alpha > 10 && balls->size() > 500) || !factory.affords(*balls, alpha))
      continue;
    const AlphaComplex expected = reference->compute({alpha}, {});
    const AlphaComplex found = engine->compute({alpha}, {});
    EXPECT_TRUE(compare(found, expected).identical()) << name << ", alpha " << alpha;
    EXPECT_EQ(found.hash, expected.hash);
  }
}

// Compares without the solvent radius and with it.
void expect_equals_cgal(const EngineFactory& factory, const std::string& file,
                        std::size_t most_balls = SIZE_MAX) {
  for (const double solvent : {0.0, 1.4}) {
    const auto balls = testing::molecule_balls(file, solvent);
    if (balls->size() > most_balls) return;
    expect_equals_cgal(factory, file + ", solvent " + std::to_string(solvent), balls);
  }
}

TEST_P(EveryEngine, EqualsCgalOnTheSamples) {
  expect_equals_cgal(GetParam(), "1crn", testing::sample_balls("1crn.pdb"));
  expect_equals_cgal(GetParam(), "1crn, solvent", testing::sample_balls("1crn.pdb", 1.4));
  expect_equals_cgal(GetParam(), "4hhb", testing::sample_balls("4hhb.pdb.gz"));
}

TEST_P(EveryEngine, EqualsCgalOnSmallMolecules) {
  ALPHASCOPE_NEED_TEST_DATA();
  for (const char* file : {"ladder/1grm.crd", "ladder/1crn.pdb", "ladder/1bna.pdb"}) {
    expect_equals_cgal(GetParam(), file);
  }
}

// Every file that can be opened and is not too large. Tests of readers cover the others.
void expect_equals_cgal_in(const EngineFactory& factory, const char* folder, std::size_t most_balls,
                           std::size_t expected_files) {
  std::vector<std::string> files;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(testing::test_data_folder() / folder)) {
    if (!entry.is_regular_file()) continue;
    files.push_back(entry.path().lexically_relative(testing::test_data_folder()).string());
  }
  std::sort(files.begin(), files.end());
  std::size_t compared = 0;
  for (const std::string& file : files) {
    try {
      testing::molecule_balls(file);
    } catch (const std::exception&) {
      continue;
    }
    ++compared;
    expect_equals_cgal(factory, file, most_balls);
  }
  EXPECT_GE(compared, expected_files);
}

TEST_P(EveryEngine, EqualsCgalOnTheThesisMoleculesLong) {
  ALPHASCOPE_NEED_TEST_DATA();
  expect_equals_cgal_in(GetParam(), "thesis", 60000, 6);
}

TEST_P(EveryEngine, EqualsCgalOnTheLadderLong) {
  ALPHASCOPE_NEED_TEST_DATA();
  expect_equals_cgal_in(GetParam(), "ladder", 100000, 20);
}

TEST_P(EveryEngine, EqualsCgalOnAwkwardMoleculesLong) {
  ALPHASCOPE_NEED_TEST_DATA();
  expect_equals_cgal_in(GetParam(), "awkward", 60000, 40);
}

}  // namespace
}  // namespace alphascope
