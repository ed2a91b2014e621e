// SPDX-License-Identifier: GPL-3.0-or-later
// Tests programs that are fed: their input, output and exit status, and that none outlives its
// owner.
#include "core/run/child_program.hpp"
#include "core/run/cancel_token.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string>
#include <thread>

namespace alphascope {
namespace {

std::vector<std::string> shell(const std::string& script) {
  return {"-c", script};
}

std::vector<std::uint8_t> bytes(std::size_t count) {
  return std::vector<std::uint8_t>(count, 'x');
}

TEST(ChildProgram, IsFedAndAnswersWithItsStatus) {
  // More data than any buffer between the two programs holds.
  ChildProgram child("/bin/sh", shell("test $(wc -c) -eq 3000000 && echo enough >&2 && exit 7"));
  EXPECT_TRUE(child.write(bytes(1000000), {}));
  EXPECT_TRUE(child.write(bytes(2000000), {}));
  EXPECT_EQ(child.finish({}), 7);
  EXPECT_EQ(child.error_output(), "enough\n");
}

TEST(ChildProgram, ThatEndsEarlyTakesNoMore) {
  ChildProgram child("/bin/sh", shell("echo no space left >&2; exit 3"));
  bool taken = true;
  for (int k = 0; k < 1000 && taken; ++k) taken = child.write(bytes(100000), {});
  EXPECT_FALSE(taken) << "and no signal ended this program";
  EXPECT_EQ(child.finish({}), 3);
  EXPECT_EQ(child.error_output(3), "ft\n") << "the end of it";
}

TEST(ChildProgram, ThatTakesNothingCanBeCancelledAndIsEnded) {
  const auto begun = std::chrono::steady_clock::now();
  const CancelToken token;
  std::thread later([&token] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    token.cancel();
  });
  {
    ChildProgram child("/bin/sh", shell("sleep 100"));
    EXPECT_THROW(
        {
          for (;;) child.write(bytes(100000), token);
        },
        Cancelled);
  }
  later.join();
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(20));
}

TEST(ChildProgram, ThatHangsAtItsEndCanBeCancelled) {
  const CancelToken token;
  token.cancel();
  ChildProgram child("/bin/sh", shell("sleep 100"));
  EXPECT_THROW(child.finish(token), Cancelled);
}

TEST(ChildProgram, ThatDiesOfASignalSaysWhich) {
  ChildProgram child("/bin/sh", shell("kill -9 $$"));
  EXPECT_EQ(child.finish({}), 128 + SIGKILL);
}

TEST(ChildProgram, ThatIsNotThereIsNamed) {
  try {
    ChildProgram child("/no/such/program", {});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/no/such/program"), std::string::npos);
  }
  EXPECT_TRUE(find_program("sh"));
  EXPECT_FALSE(find_program("no-such-program-of-alphascope"));
}

}  // namespace
}  // namespace alphascope
