// SPDX-License-Identifier: GPL-3.0-or-later
// Tests endings of outputs: unknown ones, unfitting ones, and their messages.
#include "core/files/output_ending.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

TEST(OutputEnding, IsInSmallLettersWithThePoint) {
  EXPECT_EQ(output_ending("a.png"), ".png");
  EXPECT_EQ(output_ending("folder.d/A.B.PnG"), ".png");
  EXPECT_EQ(output_ending("a.3mf"), ".3mf") << "not all of it is a number";
  EXPECT_EQ(output_ending("a.7z"), ".7z");
}

TEST(OutputEnding, NumbersAndHiddenFilesHaveNone) {
  for (const char* name : {"a", "a.", "areas_at_1.4", "a.007", ".png", "folder.png/a", "", "-"}) {
    EXPECT_EQ(output_ending(name), "") << name;
  }
}

TEST(OutputEnding, OneOfTheFormatsOrNoneIsRight) {
  for (const char* name : {"a.ply", "a.GLB", "a", "a_1.4", "-"}) {
    EXPECT_EQ(fault_of_ending(name, {".ply", ".glb"}), "") << name;
  }
}

TEST(OutputEnding, AnotherIsSaidWithThoseThatMayBe) {
  EXPECT_EQ(fault_of_ending("a.jpg", {".png"}), "the name must end in .png, not .jpg");
  EXPECT_EQ(fault_of_ending("a.JPG", {".ply", ".glb"}),
            "the name must end in .ply or .glb, not .jpg");
  EXPECT_EQ(fault_of_ending("a.p", {".ply", ".glb", ".stl"}),
            "the name must end in .ply, .glb or .stl, not .p");
  EXPECT_EQ(fault_of_ending("a.j\x1b[2J", {".png"}).find('\x1b'), std::string::npos);
}

TEST(OutputEnding, APipeMayHaveAnyAndAFileThatIsThereMayNot) {
  const TemporaryFile file("there.jpg", "x");
  EXPECT_NE(fault_of_ending(file.path(), {".png"}), "");
  const std::filesystem::path pipe = file.path().parent_path() / "pipe.jpg";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(fault_of_ending(pipe, {".png"}), "");
}

}  // namespace
}  // namespace alphascope
