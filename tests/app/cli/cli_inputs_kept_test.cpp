// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that inputs are never overwritten, and that an output's name must have its format's ending.
#include <unistd.h>

#include "tests/app/cli/cli_fixture.hpp"

namespace alphascope::testing {
namespace {

class CliInputsKept : public Cli {
 protected:
  // Runs a script in the folder by the shell. Standard error goes to the file err.
  int shell(const std::string& script) const {
    const std::string command = "cd '" + folder_.string() +
                                "'; cli() { '" ALPHASCOPE_CLI "' \"$@\"; }; { " + script +
                                "; } >out 2>err";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  }
  std::string text(const std::string& name) const { return contents(folder_ / name); }
  int temporaries() const {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      count += entry.path().filename().string().starts_with(".alphascope");
    }
    return count;
  }
  // Writes a session for a molecule of this name.
  void write_session(const std::string& name, const std::string& molecule) const {
    const std::string path = (folder_ / molecule).string();
    ASSERT_EQ(shell("sha256sum " + molecule + " | cut -c1-64 >sum"), 0);
    std::string sum = text("out").empty() ? text("sum") : text("out");
    if (sum.ends_with('\n')) sum.pop_back();
    const json session = {{"alphascope_session", 1},
                          {"molecule", {{"path", molecule}, {"sha256", sum}}}};
    write(name, session.dump(2) + "\n");
  }
};

TEST_F(CliInputsKept, WhateverTheInputIsAndWhateverItIsCalled) {
  const std::string cube = text("cube.xyzr");
  fs::copy(cube_, folder_ / "cube.json");  // recognised by content, not by name
  fs::copy(cube_, folder_ / "cube.txt");
  fs::create_symlink("cube.txt", folder_ / "link.csv");
  fs::create_hard_link(folder_ / "cube.txt", folder_ / "hard.csv");
  fs::create_directory(folder_ / "sub");
  write("list.txt", "cube.txt\n");
  const std::string list = text("list.txt");
  for (const char* line : {"cli compute cube.json --format xyzr --alpha 1 --json cube.json",
                           "cli compute cube.txt --format xyzr --alpha 1 --csv link.csv",
                           "cli compute cube.txt --format xyzr --alpha 1 --csv hard.csv",
                           "cli compute link.csv --format xyzr --alpha 1 --out sub/../cube.txt",
                           "cli compute - --format xyzr --alpha 1 --csv hard.csv < cube.txt",
                           "cli export - --format xyzr --alpha 0 -o cube.xyzr < cube.xyzr",
                           "cli export cube.xyzr --alpha 0 -o cube.xyzr",
                           "cli info --files-from list.txt --format xyzr --csv list.txt",
                           "cli info --files-from - --format xyzr --csv list.txt < list.txt",
                           "cli info --files-from list.txt --format xyzr --csv hard.csv",
                           "cli cavities cube.txt --format xyzr --solvent 0.1 --lives cube.txt",
                           "cli bench cube.txt --format xyzr --alpha 1 --csv hard.csv"}) {
    EXPECT_EQ(shell(line), 2) << line;
    EXPECT_TRUE(contains(text("err"), ", which is read. Give the output another name."))
        << line << text("err");
    EXPECT_EQ(text("cube.txt"), cube) << line;
    EXPECT_EQ(text("cube.json"), cube) << line;
    EXPECT_EQ(text("cube.xyzr"), cube) << line;
    EXPECT_EQ(text("list.txt"), list) << line;
    EXPECT_EQ(temporaries(), 0) << line;
  }
}

TEST_F(CliInputsKept, NorDoesStandardOutputReplaceOrFollowIt) {
  const std::string cube = text("cube.xyzr"), cli = "'" ALPHASCOPE_CLI "' ";
  const std::string to = " >>'" + cube_.string() + "' 2>err2";
  const auto code = [&](const std::string& line) {
    const int status = std::system(("cd '" + folder_.string() + "'; " + line).c_str());
    return WEXITSTATUS(status);
  };
  EXPECT_EQ(code(cli + "info cube.xyzr" + to), 2);
  EXPECT_EQ(code(cli + "info - --format xyzr <cube.xyzr" + to), 2);
  EXPECT_EQ(code(cli + "compute cube.xyzr --alpha 1 --json -" + to), 2);
  EXPECT_TRUE(contains(text("err2"), "Standard output goes to cube.xyzr, which is an input file."))
      << text("err2");
  EXPECT_EQ(text("cube.xyzr"), cube);
}

TEST_F(CliInputsKept, TheMoleculeOfASession) {
  if (!kDrawsPictures) GTEST_SKIP() << "built without the renderer";
  fs::copy(cube_, folder_ / "cube-1.png");
  fs::rename(cube_, folder_ / "cube.png");
  for (const char* name : {"cube.png", "cube-1.png"}) {
    write_session("s.json", name);
    const std::string molecule = text(name), session = text("s.json");
    for (const std::string& line :
         {"cli screenshot --session s.json --size 64x64 -o " + std::string(name),
          std::string("cli frames --session s.json --size 64x64 --turntable 90:2 -o cube-%d.png"),
          std::string("cli screenshot --session s.json --size 64x64 -o s.json")}) {
      if (contains(line, "frames") && std::string(name) == "cube.png") continue;
      EXPECT_EQ(shell(line), 2) << line << text("err");
      EXPECT_TRUE(contains(text("err"), "which is read")) << line << text("err");
      EXPECT_EQ(text(name), molecule) << line;
      EXPECT_EQ(text("s.json"), session) << line;
      EXPECT_EQ(temporaries(), 0) << line;
    }
  }
}

TEST_F(CliInputsKept, AnEndingThatIsNotTheFormatsIsRefused) {
  const struct {
    const char *arguments, *name, *endings;
  } wrong[] = {{"compute cube.xyzr --alpha 1 --json", "a.csv", ".json or .txt, not .csv"},
               {"compute cube.xyzr --alpha 1 --csv", "a.json", ".csv or .txt, not .json"},
               {"compute cube.xyzr --alpha 1 --csv", "a.csv.gz", ".csv or .txt, not .gz"},
               {"compute cube.xyzr --alpha 1 --out", "a.PDB", ".alpha or .txt, not .pdb"},
               {"info cube.xyzr --csv", "a.tsv", ".csv or .txt, not .tsv"},
               {"cavities cube.xyzr --lives", "a.svg", ".csv or .txt, not .svg"},
               {"cavities cube.xyzr --spheres", "a.pdb", ".pqr, not .pdb"},
               {"cavities cube.xyzr --surface", "a.stl", "end in .ply or .glb"},
               {"cavities cube.xyzr --script", "a.py", "end in .cxc or .pml"},
               {"export cube.xyzr --alpha 1 --as off -o", "a.stl", ".off, not .stl"},
               {"verify cube.xyzr --alpha 1 --json", "a.log", ".json or .txt, not .log"}};
  for (const auto& w : wrong) {
    EXPECT_EQ(shell(std::string("cli ") + w.arguments + " " + w.name), 2) << w.arguments;
    EXPECT_TRUE(contains(text("err"), w.endings)) << text("err");
    EXPECT_FALSE(fs::exists(folder_ / w.name)) << w.name;
  }
  if (kDrawsPictures) {
    EXPECT_EQ(shell("cli screenshot cube.xyzr --alpha 1 --size 64x64 -o a.jpg"), 2);
    EXPECT_TRUE(contains(text("err"), "must end in .png, not .jpg")) << text("err");
    EXPECT_FALSE(fs::exists(folder_ / "a.jpg"));
  }
  // A name without an ending is accepted. So are a number, another case and a device.
  for (const char* name : {"a", "areas_1.4", "A.CSV", "/dev/null"}) {
    EXPECT_EQ(shell(std::string("cli compute cube.xyzr --alpha 1 --csv ") + name), 0)
        << text("err");
  }
}

TEST_F(CliInputsKept, ANameThatIsTooLongShowsBeforeComputing) {
  const std::string longest(251, 'x'), longer(252, 'x');
  EXPECT_EQ(shell("cli compute cube.xyzr --alpha 1 --csv " + longest + ".csv"), 0) << text("err");
  EXPECT_EQ(shell("cli compute cube.xyzr --alpha 1 --csv " + longer + ".csv"), 5);
  EXPECT_TRUE(contains(text("err"), "File name too long. Give it a shorter name.")) << text("err");
  EXPECT_EQ(text("out"), "") << "found before anything is computed";
  EXPECT_EQ(temporaries(), 0);
}

TEST_F(CliInputsKept, ListsOfFilesHaveLimits) {
  // A sparse file has its full size, and none of it needs to be read.
  std::ofstream(folder_ / "sparse").close();
  fs::resize_file(folder_ / "sparse", std::uintmax_t{8} << 30);
#ifdef ALPHASCOPE_FAULTY_CALLS
  const std::string limit = "ulimit -v 4000000; ";
#else
  const std::string limit;  // none: a sanitizer needs more address space than any limit leaves
#endif
  EXPECT_EQ(shell(limit + "cli info --files-from sparse"), 3);
  EXPECT_TRUE(contains(text("err"), "the list of files is larger than 64 MiB")) << text("err");
  EXPECT_EQ(shell(limit + "cli info --files-from - < sparse"), 3);
  EXPECT_TRUE(contains(text("err"), "the list of files is larger than 64 MiB")) << text("err");
  write("line", "cube.xyzr\n" + std::string(5000, 'x') + "\n");
  EXPECT_EQ(shell("cli info --files-from line"), 3);
  EXPECT_TRUE(contains(text("err"), "line, line 2: this line is longer than any file name can be"))
      << text("err");
  EXPECT_EQ(shell("cli info --files-from ."), 3);
}

TEST_F(CliInputsKept, TemporaryFilesOfTheDeadAreRemoved) {
  const pid_t dead = ::fork();
  if (dead == 0) ::_exit(0);
  ASSERT_EQ(::waitpid(dead, nullptr, 0), dead);
  const std::string left = ".alphascope-" + std::to_string(dead) + "-0.tmp";
  const std::string alive = ".alphascope-" + std::to_string(::getpid()) + "-0.tmp";
  for (const std::string& name : {left, alive, std::string(".alphascope-x-0.tmp")}) write(name, "");
  ASSERT_EQ(shell("cli info cube.xyzr --csv a.csv"), 0);
  EXPECT_FALSE(fs::exists(folder_ / left));
  EXPECT_TRUE(fs::exists(folder_ / alive));
  EXPECT_TRUE(fs::exists(folder_ / ".alphascope-x-0.tmp")) << "none of ours";
}

}  // namespace
}  // namespace alphascope::testing
