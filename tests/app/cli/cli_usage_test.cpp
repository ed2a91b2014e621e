// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that wrong input is refused with a remedy, and that the guide's command lines work.
#include <algorithm>
#include <regex>
#include <set>

#include "tests/app/cli/cli_fixture.hpp"

namespace alphascope::testing {
namespace {

const std::string kCrambin = ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb";

const std::string kHaemoglobin = ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz";

class CliUsage : public Cli {
 protected:
  std::string cube() const { return "'" + cube_.string() + "' "; }
  std::vector<std::string> commands() const {
    std::vector<std::string> names;
    const std::string help = run("--help").out;
    const std::size_t begin = help.find("Commands"), end = help.find("\n\n", begin);
    const std::string list = help.substr(begin, end - begin);
    const std::regex line("\n  ([a-z]+)");
    for (std::sregex_iterator m(list.begin(), list.end(), line), last; m != last; ++m) {
      names.push_back((*m)[1]);
    }
    EXPECT_GE(names.size(), 13u) << help;
    return names;
  }
  // Options such as "--alpha" and "-o" of a command, or of the program for "". Those that take a
  // value, or all.
  std::set<std::string> options(const std::string& command, bool with_value) const {
    std::set<std::string> names;
    const std::string help = run(command + " --help").out;
    const std::regex line("\n  (?:(-[a-zA-Z]), )?(--[a-z-]+)( [A-Za-z0-9])?");
    for (std::sregex_iterator m(help.begin(), help.end(), line), last; m != last; ++m) {
      if (with_value && !(*m)[3].matched) continue;
      names.insert((*m)[2]);
      if ((*m)[1].matched) names.insert((*m)[1]);
    }
    return names;
  }
};

TEST_F(CliUsage, AnEmptyValueIsRefusedWithItsOption) {
  std::set<std::string> tried;
  for (const std::string& command : commands()) {
    for (const std::string& option : options(command, true)) {
      // The chain without a name is "".
      if (option == "--chain" || option == "--without-chain") continue;
      if (!tried.insert(option).second) continue;
      const Outcome outcome = run(command + " " + cube() + option + " ''");
      EXPECT_EQ(outcome.code, 2) << command << " " << option;
      EXPECT_TRUE(contains(outcome.err, "the value is empty; give ")) << outcome.err;
      EXPECT_EQ(outcome.out, "") << command << " " << option;
    }
  }
  EXPECT_GT(tried.size(), 60u);
  const Outcome file = run("info ''");
  EXPECT_EQ(file.code, 2);
  EXPECT_TRUE(contains(file.err, "FILE: the name is empty")) << file.err;
  const Outcome comma = run("verify " + cube() + "--alpha 1,,2");
  EXPECT_TRUE(contains(comma.err, "nothing between two commas")) << comma.err;
}

TEST_F(CliUsage, NothingBehindTheEqualsSignTakesNoFile) {
  const std::string before = contents(cube_);
  for (const char* option : {"--json=", "--csv=", "--select="}) {
    const Outcome outcome = run("info '" + kCrambin + "' " + option + " " + cube());
    EXPECT_EQ(outcome.code, 2) << option;
    EXPECT_TRUE(contains(outcome.err, "the value is empty")) << outcome.err;
  }
  EXPECT_EQ(contents(cube_), before);
  EXPECT_TRUE(contains(run("info --waters= " + cube()).err, "--waters takes no value"));
  EXPECT_EQ(run("info --without-chain '' " + cube()).code, 2) << "all atoms are of that chain";
  EXPECT_EQ(run("info --chain '' " + cube()).code, 0);
}

TEST_F(CliUsage, ListsOfTheOtherKindAreRefusedWithTheRemedy) {
  using namespace std::string_literals;
  const std::string names = cube_.string() + "\0"s + kCrambin + "\0"s;
  const fs::path nul = write("nul", names), one = write("one", cube_.string() + "\0"s);
  const fs::path lines = write("lines", cube_.string() + "\n" + kCrambin + "\n");
  for (const fs::path& list : {nul, one}) {
    const Outcome outcome = run("info --files-from '" + list.string() + "'");
    EXPECT_EQ(outcome.code, 2) << list;
    EXPECT_TRUE(contains(outcome.err, "Add --null.")) << outcome.err;
    EXPECT_EQ(run("info --files-from - ", list).code, 2);
    EXPECT_EQ(run("info --null --files-from '" + list.string() + "'").code, 0);
  }
  const Outcome other = run("info --null --files-from '" + lines.string() + "'");
  EXPECT_EQ(other.code, 2);
  EXPECT_TRUE(contains(other.err, "Leave out --null.")) << other.err;
  EXPECT_EQ(run("info --files-from '" + lines.string() + "'").code, 0);
  const fs::path marked = write("marked", "\xEF\xBB\xBF" + cube_.string() + "\n");
  EXPECT_EQ(run("info --files-from '" + marked.string() + "'").code, 0) << "as Windows writes it";
}

TEST_F(CliUsage, TheFirstFileThatFailsSaysTheExitCode) {
  const fs::path bad = write("bad.xyzr", "0 0 banana 1.5\n");
  const fs::path water = write("water.pdb",
                               "HETATM    1  O   HOH A   1       0.000   0.000   0.000  1.00  9.67 "
                               "          O  \n");
  const std::string unreadable = "'" + bad.string() + "' ", empty = "'" + water.string() + "' ";
  for (const char* command : {"info ", "compute --alpha 1 ", "measure ", "cavities "}) {
    EXPECT_EQ(run(command + unreadable + empty + cube()).code, 3) << command;
    EXPECT_EQ(run(command + empty + unreadable + cube()).code, 2) << command;
    EXPECT_EQ(run(command + cube() + empty + unreadable).code, 2) << command;
  }
}

TEST_F(CliUsage, HelpAndVersionAreThereInEveryCommonWay) {
  EXPECT_EQ(run("help").out, run("--help").out);
  EXPECT_EQ(run("-V").out, run("--version").out);
  for (const std::string& command : commands()) {
    EXPECT_EQ(run("help " + command).out, run(command + " --help").out) << command;
    const Outcome version = run(command + " --version");
    EXPECT_EQ(version.code, 0) << command;
    EXPECT_EQ(version.out, run("--version").out) << command;
    EXPECT_EQ(run(command + " -V").out, version.out) << command;
  }
  const Outcome wrong = run("help comptue");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_TRUE(contains(wrong.err, "Did you mean \"compute\"?")) << wrong.err;
}

TEST_F(CliUsage, SentencesAreWholeAndRemediesExist) {
  // A channel that begins inside a ball.
  const Outcome covered = run("channel " + cube() + "--point 0,0,0");
  EXPECT_TRUE(contains(covered.err, "outside all balls. That ball is the atom")) << covered.err;
  fs::create_symlink("loop", folder_ / "loop");
  fs::create_symlink("nowhere", folder_ / "link");
  const Outcome loop = run("info '" + (folder_ / "loop").string() + "'");
  EXPECT_EQ(loop.code, 3);
  EXPECT_TRUE(contains(loop.err, "Too many levels of symbolic links")) << loop.err;
  const Outcome link = run("info '" + (folder_ / "link").string() + "'");
  EXPECT_TRUE(contains(link.err, "a link to a file that does not exist")) << link.err;
  const Outcome list = run("info --files-from '" + (folder_ / "loop").string() + "'");
  EXPECT_TRUE(contains(list.err, "Too many levels of symbolic links")) << list.err;
  const Outcome radii = run("info --radii '" + (folder_ / "loop").string() + "' " + cube());
  EXPECT_EQ(radii.code, 3);
  EXPECT_TRUE(contains(radii.err, "Too many levels of symbolic links")) << radii.err;
  // Cavities drop ligands unless --ligands is given.
  const fs::path ligand = write("ligand.pdb",
                                "HETATM    1  C1  XYZ A   1       0.000   0.000   0.000  1.00  "
                                "9.67           C  \n");
  const std::string file = "'" + ligand.string() + "'";
  EXPECT_TRUE(contains(run("cavities " + file).err, "Add --ligands."));
  EXPECT_TRUE(contains(run("info --no-ligands " + file).err, "Leave out --no-ligands."));
}

// Progress is erased with blanks. A terminal that cannot rewrite a line gets none.
TEST_F(CliUsage, NoTerminalGetsEscapeSequences) {
  if (std::system("script --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "needs script";
  const auto shown = [&](const std::string& environment) {
    const fs::path out = folder_ / "shown";
    const std::string work =
        "\"" ALPHASCOPE_CLI "\" compute --engine tuples-cpu --alpha 6 \"" + kHaemoglobin + "\"";
    EXPECT_EQ(std::system((environment + " script -qec '" + work + "' /dev/null >'" + out.string() +
                           "' </dev/null 2>&1")
                              .c_str()),
              0);
    return contents(out);
  };
  for (const char* environment : {"TERM=xterm", "TERM=xterm NO_COLOR=1", "TERM=dumb"}) {
    const std::string text = shown(environment);
    EXPECT_FALSE(contains(text, "\x1b")) << text;
    const bool rewritten = std::regex_search(text, std::regex("\r[^\r\n]+ +[0-9]+ %"));
    EXPECT_EQ(rewritten, !contains(environment, "dumb")) << environment << "\n" << text;
  }
}

// Every word in the sources that looks like an option is an option of a program.
TEST_F(CliUsage, MessagesNameOptionsThatExist) {
  std::set<std::string> known{"--script", "--shot",     "--session",        "--lesson",
                              "--record", "--light",    "--script-help",    "--no-compare",
                              "--size",   "--no-times", "--record-seconds", "--display-help"};
  for (const std::string& command : commands()) known.merge(options(command, false));
  known.merge(options("", false));
  const std::regex option("(^|[ (\"])(--[a-z][a-z-]*[a-z])");
  const std::regex literal("\"(?:[^\"\\\\]|\\\\.)*\"");
  int seen = 0;
  for (const char* layer : {"core", "app/cli", "app/session", "gpu"}) {
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(ALPHASCOPE_SOURCE_DIR) / layer)) {
      if (entry.path().extension() != ".cpp") continue;
      std::istringstream lines(contents(entry.path()));
      for (std::string line; std::getline(lines, line);) {
        if (line.find("//") < line.find('"')) continue;
        for (std::sregex_iterator s(line.begin(), line.end(), literal), last; s != last; ++s) {
          const std::string text = s->str();
          for (std::sregex_iterator m(text.begin(), text.end(), option); m != last; ++m) {
            EXPECT_TRUE(known.contains((*m)[2])) << entry.path() << ": " << line;
            ++seen;
          }
        }
      }
    }
  }
  EXPECT_GT(seen, 100);
}

// --- command lines of the guide

// Command lines of alphascope-cli in a text. They are lines that begin with four blanks and their
// deeper continuation lines, the lines of the help, and texts between backquotes.
std::vector<std::string> command_lines(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find_first_not_of(' ');
    if (first == line.npos) continue;
    const bool begins = first >= 2 && first <= 4 && line.find("alphascope-cli ") != line.npos;
    if (begins) {
      const std::size_t at = line.find("alphascope-cli ");
      const bool piped = at > first && line.find("| alphascope-cli") != line.npos;
      if (at == first || piped) found.push_back(line.substr(at + 15));
    } else if (first > 4 && line[first] == '[' && !found.empty()) {
      found.back() += " " + line.substr(first);
    }
  }
  const std::regex quoted("`alphascope-cli ([a-z]+ [^`]*)`");
  std::string flat = text;
  std::replace(flat.begin(), flat.end(), '\n', ' ');
  for (std::sregex_iterator m(flat.begin(), flat.end(), quoted), last; m != last; ++m) {
    found.push_back((*m)[1]);
  }
  for (std::string& line : found) {
    line = line.substr(0, std::min(line.find("  "), line.find(" && ")));
    line = line.substr(0, line.find(" #"));
  }
  return found;
}

// The line as it can be typed: without optional parts, with the first of each choice, and with
// values for names.
std::string typed(std::string line) {
  const auto all = [&](const char* pattern, const char* with) {
    line = std::regex_replace(line, std::regex(pattern), with);
  };
  for (int nested = 0; nested < 3; ++nested) all(" ?\\[[^\\[\\]]*\\]", "");
  all("\\(([^|()]*) \\|[^()]*\\)", "$1");
  all("\\b(auto|figure|atom)(\\|[a-z]+)+", "$1");
  all("FILE(\\.\\.\\.)?", "none.pdb");
  all(" A,B,\\.\\.\\.", " 1,2");
  all("--alpha (A|ALPHA)\\b", "--alpha 1");
  all("--ball ATOM\\b", "--ball 0");
  all("I,J,K,L", "0,1");
  all("X,Y,Z", "1,2,3");
  all("FROM:TO:FRAMES", "0:1:2");
  all("DEGREES:FRAMES", "90:2");
  all("OUT\\.EXT", "out.stl");
  all("--output -( |$)", "--output out.stl$1");
  return line;
}

TEST_F(CliUsage, CommandLinesOfTheGuideAreUnderstood) {
  std::vector<std::string> lines = command_lines(run("--help").out);
  EXPECT_GT(lines.size(), 15u);
  const fs::path source = ALPHASCOPE_SOURCE_DIR;
  std::vector<fs::path> texts{source / "README.md"};
  for (const auto& entry : fs::recursive_directory_iterator(source / "docs")) {
    if (entry.path().extension() == ".md") texts.push_back(entry.path());
  }
  for (const fs::path& text : texts) {
    for (std::string& line : command_lines(contents(text))) lines.push_back(std::move(line));
  }
  EXPECT_GT(lines.size(), 60u);
  const std::vector<std::string> names = commands();
  const std::set<std::string> known(names.begin(), names.end());
  for (const std::string& line : lines) {
    const std::string command = line.substr(0, line.find(' '));
    if (command.starts_with("-")) continue;
    ASSERT_TRUE(known.contains(command)) << line;
    const std::set<std::string> of_command = options(command, false);
    const std::regex option("[ \\[(](-[a-zA-Z]|--[a-z][a-z-]*[a-z])(?=[ =\\])]|$)");
    for (std::sregex_iterator m(line.begin(), line.end(), option), last; m != last; ++m) {
      EXPECT_TRUE(of_command.contains((*m)[1])) << (*m)[1] << " in: " << line;
    }
    // A sentence never contains a complete command line.
    if (line.find("FILE") == line.npos && line.find('.') == line.npos) continue;
    if (!kDrawsPictures && (command == "screenshot" || command == "frames")) continue;
    const std::string words = typed(line);
    // A list of files whose only molecule does not exist.
    const bool null_separated = line.find("--null") != line.npos;
    const Outcome outcome =
        run(words, write("list", null_separated ? std::string("none.pdb", 9) : "none.pdb\n"));
    // The molecules of the examples are missing here, so reading fails, but parsing must not.
    EXPECT_NE(outcome.code, 2) << words << "\n" << outcome.err;
  }
}

TEST_F(CliUsage, TheGuideHasTheTableOfExitCodes) {
  const std::string help = run("--help").out;
  const std::string guide =
      contents(fs::path(ALPHASCOPE_SOURCE_DIR) / "docs/guide/command-line.md");
  const std::size_t begin = help.find("\nExit codes:\n");
  ASSERT_NE(begin, help.npos);
  const std::regex row("\n  ([0-9]+) +([a-z])");
  int rows = 0;
  const std::string table = help.substr(begin);
  for (std::sregex_iterator m(table.begin(), table.end(), row), last; m != last; ++m, ++rows) {
    EXPECT_TRUE(std::regex_search(guide, std::regex("\n\\| " + (*m)[1].str() + "[ ,]"))) << (*m)[1];
  }
  EXPECT_EQ(rows, 8);
}

}  // namespace
}  // namespace alphascope::testing
