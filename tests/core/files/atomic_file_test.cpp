// SPDX-License-Identifier: GPL-3.0-or-later
// Tests files that appear whole: links, modes, and the earlier content.
#include "core/files/atomic_file.hpp"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <string>

#include "core/files/regular_file.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

class AtomicFileTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::path(::testing::TempDir()) / "alphascope_file_XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  void TearDown() override { fs::remove_all(folder_); }

  static void put(const fs::path& path, const std::string& text) {
    AtomicFile file(path);
    file.write(text);
    file.commit();
  }
  static std::string contents(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }
  static mode_t mode(const fs::path& path) {
    struct stat status {};
    EXPECT_EQ(::stat(path.c_str(), &status), 0);
    return status.st_mode & 07777;
  }
  std::size_t files() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  fs::path folder_;
};

TEST_F(AtomicFileTest, ANewFileHasTheModeThatTheMaskLeaves) {
  const mode_t mask = ::umask(027);
  put(folder_ / "new", "text");
  ::umask(mask);
  EXPECT_EQ(mode(folder_ / "new"), 0640u);
  EXPECT_EQ(contents(folder_ / "new"), "text");
}

TEST_F(AtomicFileTest, AReplacedFileKeepsItsMode) {
  for (const mode_t kept : {0600, 0664, 0755}) {
    put(folder_ / "old", "before");
    ASSERT_EQ(::chmod((folder_ / "old").c_str(), kept), 0);
    put(folder_ / "old", "after");
    EXPECT_EQ(mode(folder_ / "old"), kept);
    EXPECT_EQ(contents(folder_ / "old"), "after");
  }
}

TEST_F(AtomicFileTest, RootKeepsOwnerAndGroup) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root gives a file away";
  put(folder_ / "old", "before");
  ASSERT_EQ(::chown((folder_ / "old").c_str(), 12345, 23456), 0);
  ASSERT_EQ(::chmod((folder_ / "old").c_str(), 0640), 0);
  put(folder_ / "old", "after");
  struct stat status {};
  ASSERT_EQ(::stat((folder_ / "old").c_str(), &status), 0);
  EXPECT_EQ(status.st_uid, 12345u);
  EXPECT_EQ(status.st_gid, 23456u);
  EXPECT_EQ(status.st_mode & 07777, 0640u);
}

TEST_F(AtomicFileTest, AReadOnlyFileIsNotReplaced) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everything";
  put(folder_ / "old", "before");
  ASSERT_EQ(::chmod((folder_ / "old").c_str(), 0444), 0);
  EXPECT_THROW(put(folder_ / "old", "after"), WriteError);
  EXPECT_EQ(contents(folder_ / "old"), "before");
}

TEST_F(AtomicFileTest, WhatCannotBeWrittenIsKnownBefore) {
  EXPECT_EQ(why_not_writable(folder_ / "new"), "");
  EXPECT_EQ(why_not_writable("/dev/null"), "");
  put(folder_ / "old", "before");
  EXPECT_EQ(why_not_writable(folder_ / "old"), "");
  EXPECT_NE(why_not_writable(folder_ / "none" / "new").find("There is no folder"),
            std::string::npos);
  fs::create_directory(folder_ / "sub");
  EXPECT_NE(why_not_writable(folder_ / "sub").find("is a folder"), std::string::npos);
  EXPECT_EQ(files(), 2u) << "nothing is made to find out";
  if (::geteuid() == 0) return;  // root may write all files
  ASSERT_EQ(::chmod((folder_ / "sub").c_str(), 0555), 0);
  EXPECT_NE(why_not_writable(folder_ / "sub" / "new").find("You may not write in the folder"),
            std::string::npos);
  ASSERT_EQ(::chmod((folder_ / "old").c_str(), 0444), 0);
  EXPECT_NE(why_not_writable(folder_ / "old").find("write-protected"), std::string::npos);
}

TEST_F(AtomicFileTest, ALinkIsFollowedToWhatIsThereAndToWhatIsNot) {
  fs::create_directory(folder_ / "sub");
  fs::create_symlink("sub/target", folder_ / "relative");
  fs::create_symlink(folder_ / "relative", folder_ / "chain");
  for (const char* text : {"first", "second"}) {
    put(folder_ / "chain", text);
    EXPECT_TRUE(fs::is_symlink(folder_ / "chain"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "relative"));
    EXPECT_EQ(contents(folder_ / "sub" / "target"), text);
  }
  fs::create_symlink("loop", folder_ / "loop");
  EXPECT_THROW(put(folder_ / "loop", "text"), WriteError);
  fs::create_symlink("nowhere/target", folder_ / "lost");
  EXPECT_THROW(put(folder_ / "lost", "text"), WriteError);
}

TEST_F(AtomicFileTest, WhatIsNotCommittedLeavesTheOldFileAndNothingElse) {
  put(folder_ / "file", "before");
  {
    AtomicFile file(folder_ / "file");
    file.write("half");
    EXPECT_EQ(files(), 2u);
  }
  EXPECT_EQ(contents(folder_ / "file"), "before");
  EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFileTest, ASignalHandlerCanRemoveTheTemporaryFiles) {
  AtomicFile one(folder_ / "one"), two(folder_ / "two");
  EXPECT_EQ(files(), 2u);
  remove_temporary_files();
  EXPECT_EQ(files(), 0u);
}

TEST_F(AtomicFileTest, WhatWasReadIsNotReplacedUnderAnyName) {
  put(folder_ / "read", "before");
  { const RegularFile read(folder_ / "read"); }
  fs::create_symlink("read", folder_ / "link");
  fs::create_hard_link(folder_ / "read", folder_ / "hard");
  fs::create_directory(folder_ / "sub");
  for (const char* name : {"read", "link", "hard", "sub/../read"}) {
    EXPECT_THROW(put(folder_ / name, "after"), ReplacesInput) << name;
  }
  // A moved input is still an input, and a new file with its name is not ours either.
  fs::remove(folder_ / "hard");
  fs::rename(folder_ / "read", folder_ / "moved");
  EXPECT_THROW(put(folder_ / "moved", "after"), ReplacesInput);
  EXPECT_EQ(contents(folder_ / "moved"), "before");
  std::ofstream(folder_ / "read") << "another";
  EXPECT_THROW(put(folder_ / "read", "after"), ReplacesInput);
  fs::remove(folder_ / "read");
  put(folder_ / "read", "new");
  EXPECT_EQ(contents(folder_ / "read"), "new") << "nothing was there to be lost";
}

TEST_F(AtomicFileTest, WhatIsReadAfterItWasOpenedIsNotReplacedEither) {
  put(folder_ / "read", "before");
  AtomicFile file(folder_ / "read");
  file.write("after");
  { const RegularFile read(folder_ / "read"); }
  EXPECT_THROW(file.commit(), ReplacesInput);
  EXPECT_EQ(contents(folder_ / "read"), "before");
}

TEST_F(AtomicFileTest, OnlyASessionReplacesASession) {
  put(folder_ / "session", "before");
  { const RegularFile read(folder_ / "session", FileKind::session); }
  EXPECT_THROW(put(folder_ / "session", "picture"), ReplacesInput);
  AtomicFile file(folder_ / "session", FileKind::session);
  file.write("after");
  file.commit();
  EXPECT_EQ(contents(folder_ / "session"), "after");
  { const RegularFile read(folder_ / "session"); }  // as a molecule is read
  EXPECT_THROW(AtomicFile(folder_ / "session", FileKind::session), ReplacesInput);
}

TEST_F(AtomicFileTest, FilesOfASetGetTheirNamesTogetherOrNot) {
  put(folder_ / "a", "old a");
  put(folder_ / "c", "old c");
  for (const bool fails : {true, false}) {
    AtomicFile a(folder_ / "a"), b(folder_ / "b"), c(folder_ / "c"), d(folder_ / "d");
    AtomicFile* const all[] = {&a, &b, &c, &d};
    for (AtomicFile* const file : all) file->write("new");
    if (fails) {
      fs::create_directory(folder_ / "d");  // no file can have that name
      EXPECT_THROW(commit_together(all), WriteError);
      fs::remove(folder_ / "d");
    } else {
      commit_together(all);
    }
    EXPECT_EQ(contents(folder_ / "a"), fails ? "old a" : "new");
    EXPECT_EQ(contents(folder_ / "c"), fails ? "old c" : "new");
    EXPECT_EQ(fs::exists(folder_ / "b"), !fails);
    EXPECT_EQ(fs::exists(folder_ / "d"), !fails);
  }
  EXPECT_EQ(files(), 4u) << "no temporary file";
}

TEST_F(AtomicFileTest, ANameThatIsTooLongShowsBeforeAnythingIsWritten) {
  EXPECT_THROW(AtomicFile(folder_ / std::string(256, 'x')), WriteError);
  EXPECT_EQ(files(), 0u);
}

TEST_F(AtomicFileTest, ANameMayBeAsLongAsTheSystemAllows) {
  const fs::path path = folder_ / std::string(255, 'x');
  put(path, "text");
  EXPECT_EQ(contents(path), "text");
}

TEST_F(AtomicFileTest, AFileWithoutANameIsWrittenDirectly) {
  const int descriptor = ::memfd_create("memory", 0);
  const std::string path = "/proc/self/fd/" + std::to_string(descriptor);
  put(path, "text");
  EXPECT_EQ(contents(path), "text");
  ::close(descriptor);
}

TEST_F(AtomicFileTest, APipeAndADescriptorAreWrittenDirectly) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  put("/proc/self/fd/" + std::to_string(ends[1]), "by name ");
  {
    AtomicFile file(ends[1], "the pipe");
    file.write("by number");
    file.commit();
  }
  ::close(ends[1]);
  char text[32] = {};
  EXPECT_EQ(::read(ends[0], text, sizeof text), 17);
  EXPECT_STREQ(text, "by name by number");
  try {
    AtomicFile backwards(ends[0], "the pipe");
    ADD_FAILURE() << "opened the end for reading";
  } catch (const WriteError& error) {
    EXPECT_STREQ(error.what(), "Cannot write the pipe: it is closed.");
  }
  ::close(ends[0]);
}

}  // namespace
}  // namespace alphascope
