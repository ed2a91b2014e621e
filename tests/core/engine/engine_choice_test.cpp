// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the table of engines: every enumerator has one entry, and lists follow from the table.
#include "core/engine/engine_choice.hpp"

#include <gtest/gtest.h>

#include <set>

namespace alphascope {
namespace {

TEST(EngineTable, EveryEngineHasOneEntry) {
  const EngineChoice all[] = {EngineChoice::automatic,  EngineChoice::gpu,
                              EngineChoice::cpu,        EngineChoice::tuples_gpu,
                              EngineChoice::tuples_cpu, EngineChoice::cgal};
  ASSERT_EQ(engine_table().size(), std::size(all));
  std::set<std::string_view> ids, titles, helps;
  for (const EngineChoice choice : all) {
    const EngineEntry& entry = engine_entry(choice);
    EXPECT_EQ(entry.choice, choice);
    EXPECT_EQ(engine_from_id(engine_id(choice)), choice);
    ids.insert(entry.id);
    titles.insert(entry.title);
    helps.insert(entry.help);
  }
  EXPECT_EQ(ids.size(), std::size(all));
  EXPECT_EQ(titles.size(), std::size(all));
  EXPECT_EQ(helps.size(), std::size(all));
  EXPECT_EQ(engine_from_id("warp"), std::nullopt);
}

TEST(EngineTable, SaysWhatAnEngineNeedsAndHas) {
  EXPECT_TRUE(needs_gpu(EngineChoice::gpu));
  EXPECT_TRUE(needs_gpu(EngineChoice::tuples_gpu));
  EXPECT_FALSE(needs_gpu(EngineChoice::automatic));
  EXPECT_FALSE(needs_gpu(EngineChoice::cgal));
  EXPECT_TRUE(is_tuple_engine(EngineChoice::tuples_cpu));
  EXPECT_TRUE(is_tuple_engine(EngineChoice::tuples_gpu));
  EXPECT_FALSE(is_tuple_engine(EngineChoice::gpu));
}

TEST(EngineTable, ListsFollowFromIt) {
  EXPECT_EQ(engine_ids(EngineGroup::all, "|"), "auto|gpu|cpu|tuples-gpu|tuples-cpu|cgal");
  EXPECT_EQ(engine_ids(EngineGroup::tuples, " or "), "tuples-gpu or tuples-cpu");
  EXPECT_EQ(engine_ids(EngineGroup::suite, ", "), "gpu, cpu, tuples-gpu, tuples-cpu");
  const std::vector<EngineChoice> suite{EngineChoice::tuples_gpu, EngineChoice::gpu,
                                        EngineChoice::tuples_cpu, EngineChoice::cpu};
  EXPECT_EQ(suite_engines(), suite) << "in the order of the thesis' table";
}

}  // namespace
}  // namespace alphascope
