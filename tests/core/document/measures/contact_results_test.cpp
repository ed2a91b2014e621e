// SPDX-License-Identifier: GPL-3.0-or-later
// Tests contacts between chains as a derived result.
#include "core/document/measures/contact_results.hpp"

#include "core/document/reference/reference.hpp"
#include "core/document/store/answer.hpp"
#include "core/document/store/inputs.hpp"
#include "core/engine/engine.hpp"
#include "core/radii/radii_choice.hpp"
#include "core/selection/ball_options.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/document/store/store_fixture.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

// Chains A and B touch by two edges, B and C by one; A and C are apart.
constexpr const char* kFile =
    "ATOM      1  CA  HIS A  87       0.000   0.000   0.000  1.00  9.67           C  \n"
    "ATOM      2  CA  GLY A  88       0.000   2.000   0.000  1.00 10.38           C  \n"
    "ATOM      3  CA  ALA B   9       2.500   1.000   0.000  1.00 10.38           C  \n"
    "ATOM      4  CA  ALA C   9       5.500   1.000   0.000  1.00 10.38           C  \n";

struct ContactsTest : testing::StoreTest {
  Inputs in;
  std::shared_ptr<Answer> answer = std::make_shared<Answer>();

  void compute(bool tetrahedra_only = false) {
    budget = 1'000'000'000;
    const auto molecule = std::make_shared<const Molecule>(read_text("a.pdb", kFile));
    BallOptions options;
    options.radii = RadiiSet::bondi;  // C 1.70
    const auto prepared = std::make_shared<const PreparedBalls>(prepare_balls(*molecule, options));
    answer->complex = make_cpu_engine(prepared->balls)->compute({0, tetrahedra_only}, {});
    in.balls = prepared->balls;
    in.balls_key = 1;
    in.atoms = std::make_shared<const BallReferences>(molecule, prepared);
    in.complex = {answer, &answer->complex};
  }
};

TEST_F(ContactsTest, AreTheEdgesBetweenChains) {
  compute();
  const auto found = settle(chain_contacts(), in);
  ASSERT_TRUE(found.ready()) << found.why;
  const auto& pairs = found.value->pairs;
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].first + pairs[0].second, "AB");
  EXPECT_EQ(pairs[0].edges, 2u);
  EXPECT_EQ(pairs[0].of_first, (std::vector<BallIndex>{0, 1}));
  EXPECT_EQ(pairs[0].of_second, (std::vector<BallIndex>{2}));
  EXPECT_EQ(pairs[1].first + pairs[1].second, "BC");
  EXPECT_EQ(pairs[1].edges, 1u);
}

TEST_F(ContactsTest, NeedEdges) {
  compute(true);
  EXPECT_FALSE(chain_contacts().key(in));
  compute();
  EXPECT_TRUE(chain_contacts().key(in));
  in.atoms = nullptr;
  EXPECT_FALSE(chain_contacts().key(in));
}

}  // namespace
}  // namespace alphascope
