// SPDX-License-Identifier: GPL-3.0-or-later
// Tests which engine settings the options set.
#include <gtest/gtest.h>

#include "app/cli/option_groups.hpp"
#include "app/options/parse_arguments.hpp"

namespace alphascope::cli {
namespace {

Request request_of(std::vector<const char*> words) {
  Request request;
  OptionProgram program;
  program.name = "prog";
  program.options = engine(request, true);
  words.insert(words.begin(), "prog");
  const ParsedArguments parsed =
      parse_arguments(program, static_cast<int>(words.size()), words.data());
  EXPECT_FALSE(parsed.ended) << parsed.text;
  return request;
}

// Tests the settings themselves. From outside, only speed and memory would show those of a GPU
// engine.
TEST(EngineOptions, EachSetsItsOwn) {
  const TupleOptions as_built = request_of({}).tuples;
  EXPECT_TRUE(as_built.pinned);
  EXPECT_TRUE(as_built.texture);
  EXPECT_EQ(as_built.tuples_per_batch, 0);

  const TupleOptions pageable = request_of({"--pageable"}).tuples;
  EXPECT_FALSE(pageable.pinned);
  EXPECT_TRUE(pageable.texture);

  const TupleOptions plain = request_of({"--no-texture"}).tuples;
  EXPECT_TRUE(plain.pinned);
  EXPECT_FALSE(plain.texture);

  const TupleOptions work = request_of({"--streams", "3", "--tuples-per-batch", "4096"}).tuples;
  EXPECT_EQ(work.streams, 3);
  EXPECT_EQ(work.tuples_per_batch, 4096);
}

TEST(EngineOptions, RadiusEngineAndThreadsAreThoseOfTheRequest) {
  const Request request =
      request_of({"--solvent", "1.25", "--engine", "tuples-cpu", "--threads", "3"});
  EXPECT_EQ(request.solvent_radius_angstrom, 1.25);
  EXPECT_EQ(request.engine, EngineChoice::tuples_cpu);
  EXPECT_EQ(request.threads, 3);
}

}  // namespace
}  // namespace alphascope::cli
