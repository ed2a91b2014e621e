// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the choice to split networks, and where a network falls apart, as results of the store.
#include "core/document/channels/network_results.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/store/inputs.hpp"
#include "tests/core/cavity/chambers.hpp"
#include "tests/core/document/store/store_fixture.hpp"

namespace alphascope {
namespace {

struct NetworkResultsTest : testing::StoreTest {
  Inputs in;

  void SetUp() override {
    budget = 1'000'000'000;
    in.balls =
        std::make_shared<const BallSet>(with_solvent(testing::chambers_in_a_row({32, 31}), 0.2));
    in.balls_key = 1;
    in.solvent_radius_angstrom = 0.2;
  }
};

TEST_F(NetworkResultsTest, AnotherChoiceIsAnotherTable) {
  EXPECT_EQ(settle(cavity_table(), in).value->size(), 1u);
  in.split_networks = true;
  const auto split = settle(cavity_table(), in).value;
  EXPECT_EQ(split->size(), 3u);
  EXPECT_TRUE(split->question.split_networks);
  EXPECT_EQ(settle(cavity_depths(), in).value->of_angstrom.size(), 3u);
  in.split_networks = false;
  EXPECT_EQ(settle(cavity_depths(), in).value->of_angstrom.size(), 1u);
}

TEST_F(NetworkResultsTest, ANetworkFallsApartAtARadiusWithoutThatOfTheInputs) {
  const auto table = settle(cavity_table(), in).value;
  const auto found = settle(network_end(table->sink(0)), in);
  ASSERT_TRUE(found.ready()) << found.why;
  EXPECT_EQ(found.value->sink, table->sink(0));
  EXPECT_EQ(found.value->end.radius_angstrom, 0.9);
  EXPECT_EQ(found.value->end.cavities, 3u);
  in.split_networks = true;
  const auto part = settle(network_end(table->sink(0)), in);
  EXPECT_EQ(part.state, DerivedState::failed) << "it is no network then";
}

}  // namespace
}  // namespace alphascope
