// SPDX-License-Identifier: GPL-3.0-or-later
// Tests temporary files of processes that have ended.
#include "core/files/temporary_names.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

std::string dead_process() {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  return std::to_string(child);
}

TEST(LeftBehind, NamesAreShortAndBesideTheirTarget) {
  const std::string own = std::to_string(::getpid());
  EXPECT_EQ(temporary_name("/a/b/" + std::string(250, 'x'), 7),
            "/a/b/.alphascope-" + own + "-7.tmp");
  EXPECT_EQ(temporary_name("x.csv", 0), ".alphascope-" + own + "-0.tmp");
}

TEST(LeftBehind, OnlyThoseOfDeadProcessesAreRemoved) {
  const TemporaryFile beside("a", "");
  const fs::path folder = beside.path().parent_path();
  const std::string dead = dead_process(), own = std::to_string(::getpid());
  const auto put = [&](const std::string& name) {
    std::ofstream(folder / name) << "x";
    return folder / name;
  };
  const fs::path gone = put(".alphascope-" + dead + "-0.tmp");
  const fs::path gone_too = put(".alphascope-" + dead + "-12.tmp");
  const fs::path kept[] = {
      put(".alphascope-" + own + "-0.tmp"),  // of a running process
      put(".alphascope-" + dead + ".tmp"),   // not our names
      put(".alphascope-" + dead + "-x.tmp"), put(".alphascope-" + dead + "-1.tmp.txt"),
      put("alphascope-" + dead + "-1.tmp"),  put(".alphascope-0-1.tmp")};
  const fs::path in_use = put(".alphascope-" + dead + "-3.tmp");
  const int descriptor = ::open(in_use.c_str(), O_RDONLY | O_CLOEXEC);
  mark_as_in_use(descriptor);
  fs::create_directory(folder / (".alphascope-" + dead + "-4.tmp"));
  fs::create_symlink(beside.path(), folder / (".alphascope-" + dead + "-5.tmp"));

  remove_left_behind(folder);
  EXPECT_FALSE(fs::exists(gone));
  EXPECT_FALSE(fs::exists(gone_too));
  for (const fs::path& file : kept) EXPECT_TRUE(fs::exists(file)) << file;
  EXPECT_TRUE(fs::exists(in_use)) << "another computer's, or a container's";
  EXPECT_TRUE(fs::is_directory(folder / (".alphascope-" + dead + "-4.tmp")));
  EXPECT_TRUE(fs::is_symlink(folder / (".alphascope-" + dead + "-5.tmp")));
  EXPECT_TRUE(fs::exists(beside.path()));
  ::close(descriptor);
}

}  // namespace
}  // namespace alphascope
