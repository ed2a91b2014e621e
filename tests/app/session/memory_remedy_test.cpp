// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that messages on short memory name options of their command.
#include <gtest/gtest.h>

#include <algorithm>
#include <new>
#include <regex>
#include <string>
#include <vector>

#include "app/cli/command_table.hpp"
#include "app/cli/failure.hpp"

namespace alphascope::cli {
namespace {

Failure out_of_memory(const OptionCommand& command) {
  set_memory_remedy(command);
  try {
    throw std::bad_alloc();
  } catch (...) {
    return current_failure();
  }
}

std::vector<std::string> options_in(const std::string& sentence) {
  static const std::regex kOption("--[a-z-]+");
  return {std::sregex_token_iterator(sentence.begin(), sentence.end(), kOption),
          std::sregex_token_iterator()};
}

TEST(MemoryRemedy, NamesOptionsThatTheCommandHas) {
  CommandOptions options;
  const OptionProgram program = command_table(options);
  std::size_t with_options = 0;
  for (const OptionCommand& command : program.commands) {
    const Failure failure = out_of_memory(command);
    EXPECT_EQ(failure.code, ExitCode::computing_failed) << command.name;
    EXPECT_TRUE(failure.message.starts_with("Not enough memory. ")) << command.name;
    EXPECT_TRUE(failure.message.ends_with(".")) << command.name;
    const std::vector<std::string> known = dashed_names(command.options);
    for (const std::string& name : options_in(failure.message)) {
      EXPECT_NE(std::find(known.begin(), known.end(), name), known.end())
          << command.name << " has no " << name;
      ++with_options;
    }
  }
  EXPECT_GE(with_options, program.commands.size() - 2)
      << "help and bench have nothing to leave out";
}

TEST(MemoryRemedy, IsWhatHelpsTheCommand) {
  CommandOptions options;
  const OptionProgram program = command_table(options);
  const auto said = [&](const char* command) {
    return out_of_memory(*program.find(command)).message;
  };
  EXPECT_EQ(said("info"), "Not enough memory. Keep fewer atoms with --select.");
  EXPECT_EQ(
      said("compute"),
      "Not enough memory. Use a smaller alpha or solvent radius, or add --tetrahedra-only, or "
      "keep fewer atoms with --select.");
  // Each command has its own remedy.
  EXPECT_EQ(out_of_memory({"none", "", {}}).message, "Not enough memory. Close other programs.");
}

}  // namespace
}  // namespace alphascope::cli
