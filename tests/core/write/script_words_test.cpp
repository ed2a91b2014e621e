// SPDX-License-Identifier: GPL-3.0-or-later
// Tests names, colours and comments in other programs' languages. Hostile names stay names.
#include "core/write/script_words.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace alphascope {
namespace {

TEST(ScriptWords, CommentsStayInTheirLines) {
  EXPECT_EQ(script_comments({{"file", "a.pdb"}, {"title", "one\ntwo"}}).find("\ntwo"),
            std::string::npos);
  EXPECT_EQ(script_comments({{"file", "a.pdb"}}), "# file a.pdb\n");
  // A backslash at the end of a line would turn the next one into a comment.
  EXPECT_EQ(script_comments({{"file", "a\\"}, {"b", "c"}}), "# file a\\ \n# b c\n");
}

TEST(ScriptWords, ColoursHaveTwoDigitsEach) {
  EXPECT_EQ(hex_colour({255, 128, 0}, "#"), "#ff8000");
  EXPECT_EQ(hex_colour({1, 2, 15}, "0x"), "0x01020f");
}

TEST(ScriptWords, ChimeraxNamesAreQuotedOrRefused) {
  EXPECT_EQ(chimerax_name("a b.ply"), "'a b.ply'");
  EXPECT_EQ(chimerax_name("it's.ply"), "\"it's.ply\"");
  EXPECT_EQ(chimerax_name("say \"a\".ply"), "'say \"a\".ply'");
  for (const char* name : {"a'b\"c", "a\\b", "a\nb", "a\x7f"}) {
    EXPECT_THROW(chimerax_name(name), std::invalid_argument) << name;
  }
}

TEST(ScriptWords, PythonNamesAreBytes) {
  EXPECT_EQ(python_name("a b.ply"), "os.fsdecode(b'a b.ply')");
  EXPECT_EQ(python_name("'\\\n\xc3\xa4"), "os.fsdecode(b'\\x27\\x5c\\x0a\\xc3\\xa4')");
  EXPECT_EQ(pymol_load("a.pdb", "molecule"), "cmd.load(os.fsdecode(b'a.pdb'), 'molecule')\n");
}

TEST(ScriptWords, TclNamesSubstituteNothing) {
  EXPECT_EQ(tcl_name("/a/b_c-1.obj"), "\"/a/b_c-1.obj\"");
  EXPECT_EQ(tcl_name("[exit] $a\"\\"), "\"\\133exit\\135\\040\\044a\\042\\134\"");
  EXPECT_EQ(tcl_name("\xc3\xa4"), "\"\xc3\xa4\"");
}

}  // namespace
}  // namespace alphascope
