// SPDX-License-Identifier: GPL-3.0-or-later
// Tests small texts read at once, and the limits of large ones.
#include "core/text_files/small_text.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>
#include <thread>

#include "core/files/files_read.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/text_files/text_limits.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

constexpr std::uint64_t kMost = std::uint64_t{1} << 20;
constexpr SmallTextRule kRule{"the list", kMost, "Name a list of files"};

std::string fault_of(const std::filesystem::path& path) {
  try {
    read_small_text(path, kRule);
  } catch (const ReadError& error) {
    return error.reason() + "|" + error.remedy();
  }
  return "none";
}

TEST(SmallText, IsReadAsItIs) {
  // Longer than one read, with a zero byte, and without a line end at its end.
  std::string text(200000, 'a');
  text[70000] = '\0';
  text += "\r\nlast";
  const TemporaryFile file("list.txt", text);
  EXPECT_EQ(read_small_text(file.path(), kRule), text);
  EXPECT_EQ(read_small_text(TemporaryFile("empty.txt", "").path(), kRule), "");
}

TEST(SmallText, AsManyBytesAsThereMayBeAndNoMore) {
  const TemporaryFile full("full.txt", std::string(kMost, 'x'));
  EXPECT_EQ(read_small_text(full.path(), kRule).size(), kMost);
  const TemporaryFile more("more.txt", std::string(kMost + 1, 'x'));
  EXPECT_EQ(fault_of(more.path()), "the list is larger than 1 MiB|Name a list of files");
}

TEST(SmallText, WhatIsReadIsNotedAsRead) {
  const TemporaryFile file("list.txt", "a");
  EXPECT_FALSE(input_replaced_by(file.path()).has_value());
  read_small_text(file.path(), kRule);
  EXPECT_EQ(input_replaced_by(file.path()), file.path().string());
}

// No more than the limit is read from an endless stream.
TEST(SmallText, AStreamHasTheSameLimit) {
  const TemporaryFile beside("a", "");
  const std::filesystem::path pipe = beside.path().parent_path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] {
    const int to = ::open(pipe.c_str(), O_WRONLY);
    EXPECT_EQ(::write(to, "one\ntwo", 7), 7);
    ::close(to);
  });
  EXPECT_EQ(read_small_text(pipe, kRule), "one\ntwo");
  writer.join();
  EXPECT_EQ(fault_of("/dev/zero"), "the list is larger than 1 MiB|Name a list of files");
}

TEST(SmallText, WhatCannotBeReadIsCalledByItsName) {
  const TemporaryFile beside("a", "");
  const std::filesystem::path folder = beside.path().parent_path();
  EXPECT_EQ(fault_of(folder),
            "the list cannot be read: this is a folder, not a file|Choose a file inside it");
  EXPECT_EQ(fault_of(folder / "none"),
            "the list cannot be read: there is no such file|Check the name and the folder");
}

std::string fault_beyond(std::uint64_t limit) {
  try {
    refuse_text_beyond("a", limit);
  } catch (const ReadError& error) {
    return error.reason() + "|" + error.remedy();
  }
}

TEST(TextLimits, AreSaidInTheirUnit) {
  constexpr const char* kSmall =
      "|No file of this kind is so large; check that this is the one that you mean";
  constexpr const char* kLarge = "|Keep only the atoms that you need, in a file of their own";
  const std::string limit = "the text is larger than the limit of ";
  EXPECT_EQ(fault_beyond(1), limit + "1 byte" + kSmall);
  EXPECT_EQ(fault_beyond(1023), limit + "1023 bytes" + kSmall);
  EXPECT_EQ(fault_beyond(1024), limit + "1 KiB" + kSmall);
  EXPECT_EQ(fault_beyond(64 << 20), limit + "64 MiB" + kSmall);
  EXPECT_EQ(fault_beyond(std::uint64_t{8} << 30), limit + "8192 MiB" + kLarge);
}

// The lengths of lines are checked while a text is being read. Here the third line is too long.
TEST(TextLimits, ALineIsTooLongWhereverItIsCut) {
  const std::filesystem::path path = "a.pdb";
  LineLengths lengths(path);
  std::string text = "one\ntwo\n" + std::string(kLongestLine / 2, 'x');
  lengths.check(text);
  text += std::string(kLongestLine - kLongestLine / 2, 'x');
  lengths.check(text);
  try {
    lengths.check(text + "x");
    ADD_FAILURE() << "one byte more";
  } catch (const ReadError& error) {
    EXPECT_EQ(error.line(), 3u);
    EXPECT_EQ(error.reason(), "this line is longer than 16 MiB");
  }
  LineLengths old_mac(path);
  text += "\r" + text.substr(8);
  EXPECT_NO_THROW(old_mac.check(text)) << "a carriage return ends a line too";
}

}  // namespace
}  // namespace alphascope
