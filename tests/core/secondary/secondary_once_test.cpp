// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the secondary structure of a molecule is found once.
#include "core/secondary/secondary_once.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <memory>
#include <thread>

#include "core/read/read_molecule.hpp"

namespace alphascope {
namespace {

Molecule sample() {
  return read_molecule(std::filesystem::path(ALPHASCOPE_SOURCE_DIR) /
                       "resources/molecules/4hhb.pdb.gz");
}

TEST(SecondaryOnce, IsFoundOnceForAllThreads) {
  const Molecule molecule = sample();
  const ModelRange models = molecule.models.front();
  SecondaryOnce secondary;
  EXPECT_FALSE(secondary.known());
  std::array<std::shared_ptr<const SecondaryModel>, 4> found;
  std::array<std::thread, 4> threads;
  for (std::size_t k = 0; k < threads.size(); ++k) {
    threads[k] = std::thread([&, k] { found[k] = secondary.of(molecule, models); });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_TRUE(secondary.known());
  ASSERT_TRUE(found[0]);
  for (const auto& other : found) EXPECT_EQ(other, found[0]);
  EXPECT_EQ(found[0]->kinds, find_secondary_of_models(molecule, models).kinds);
}

TEST(SecondaryOnce, OtherModelsHaveTheirOwn) {
  const Molecule molecule = sample();
  ModelRange models = molecule.models.front();
  SecondaryOnce secondary;
  const auto all = secondary.of(molecule, models);
  models.end = models.begin;
  EXPECT_TRUE(secondary.of(molecule, models)->residues.empty());
  EXPECT_FALSE(all->residues.empty());
}

TEST(SecondaryOnce, StopsWhenCancelledAndIsFoundLater) {
  const Molecule molecule = sample();
  SecondaryOnce secondary;
  RunContext context;
  context.cancel.cancel();
  EXPECT_THROW(secondary.of(molecule, molecule.models.front(), context), Cancelled);
  EXPECT_FALSE(secondary.known());
  EXPECT_TRUE(secondary.of(molecule, molecule.models.front()));
}

}  // namespace
}  // namespace alphascope
