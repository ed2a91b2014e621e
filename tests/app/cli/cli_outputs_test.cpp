// SPDX-License-Identifier: GPL-3.0-or-later
// Tests files, standard output, exit codes and signals of alphascope-cli.
#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/cli/cli_fixture.hpp"

namespace alphascope::testing {
namespace {

class CliOutputs : public Cli {
 protected:
  // Runs a command line by the shell. `cli` stands for the program.
  int shell(const std::string& script) const {
    const std::string command =
        "cd '" + folder_.string() + "'; cli() { '" + tested_cli() + "' \"$@\"; }; " + script;
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  }
  std::string text(const std::string& name) const { return contents(folder_ / name); }

  // Names of the files in the folder, hidden ones included.
  std::string files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : " ") + name;
    return all;
  }

  // Starts the program with its standard output in `pipe`. One signal is ignored; 0: none.
  pid_t start(std::vector<std::string> arguments, int pipe, int ignored) const {
    const pid_t child = ::fork();
    if (child != 0) return child;
    // The tests' own parent may ignore signals, as a shell does for background jobs.
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) {
      std::signal(signal, signal == ignored ? SIG_IGN : SIG_DFL);
    }
    ::dup2(pipe, STDOUT_FILENO);
    ::dup2(::open((folder_ / "err").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), STDERR_FILENO);
    if (::chdir(folder_.c_str()) != 0) ::_exit(98);
    ::alarm(300);  // ends a program that obeys no signal
    std::vector<char*> argv{const_cast<char*>(ALPHASCOPE_CLI)};
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    ::execv(ALPHASCOPE_CLI, argv.data());
    ::_exit(99);
  }
  static int code_of(pid_t child) {
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  }

  // Reads standard output up to `wait_for`, then sends the signals. Returns the exit code, or 1000
  // + the signal that killed the program.
  int code_after(const std::vector<std::string>& arguments, const std::string& wait_for,
                 const std::vector<int>& signals, int ignored = 0) const {
    int ends[2];
    EXPECT_EQ(::pipe2(ends, O_CLOEXEC), 0);
    const pid_t child = start(arguments, ends[1], ignored);
    ::close(ends[1]);
    std::string seen;
    char byte;
    while (!contains(seen, wait_for) && ::read(ends[0], &byte, 1) == 1) seen += byte;
    EXPECT_TRUE(contains(seen, wait_for)) << seen;
    for (const int signal : signals) ::kill(child, signal);
    const int code = code_of(child);
    ::close(ends[0]);
    return code;
  }
  // Standard output has no reader.
  int code_without_reader(const std::vector<std::string>& arguments, int ignored = 0) const {
    int ends[2];
    EXPECT_EQ(::pipe2(ends, O_CLOEXEC), 0);
    ::close(ends[0]);
    const int code = code_of(start(arguments, ends[1], ignored));
    ::close(ends[1]);
    return code;
  }
};

// Returns the arguments of a run that takes so long that a signal always arrives before its end.
std::vector<std::string> endless_bench() {
  const char* const haemoglobin = ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz";
  return {"bench", haemoglobin, "--alpha", "10", "--runs", "1000", "--csv", "times.csv"};
}

TEST_F(CliOutputs, NoOutputSaysInfAtTheLargestAlpha) {
  // Four nearly coplanar centres on the finest lattice. Their sphere has a radius of about 10^7 Å.
  const fs::path flat =
      write("flat.xyzr", "0 0 0 1\n500 0 0 1.000001\n0 500 0 1\n400 400 0.000001 1\n9 -9 0 0.5\n");
  const fs::path out = folder_ / "flat.alpha", table = folder_ / "flat.csv";
  for (const char* engine : {"cpu", "cgal", "tuples-cpu"}) {
    const Outcome outcome =
        run("compute '" + flat.string() + "' --alpha 1e24 --engine " + engine + " --out '" +
            out.string() + "' --csv '" + table.string() + "' --json -");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json result = json::parse(outcome.out);
    EXPECT_EQ(result["request"]["alpha_used_square_lattice_units"], 1e36);
    EXPECT_GT(result["counts"]["tetrahedra"], 0);
    for (const std::string& text : {outcome.out, contents(out), contents(table)}) {
      EXPECT_FALSE(contains(text, "inf")) << text;
      EXPECT_FALSE(contains(text, "nan")) << text;
    }
  }
  for (const char* alpha : {"1.1e24", "-1.1e24", "3.5e32", "1e308", "nan", "1e999"}) {
    for (const char* command : {"compute", "verify", "bench"}) {
      const Outcome outcome =
          run(std::string(command) + " '" + flat.string() + "' --alpha " + alpha);
      EXPECT_EQ(outcome.code, 2) << command << " " << alpha;
      EXPECT_TRUE(contains(outcome.err, "is not a number from -1e+24 to 1e+24")) << outcome.err;
    }
  }
}

TEST_F(CliOutputs, ACancellingSignalIsTheExitCodeAndNothingIsWritten) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    EXPECT_EQ(code_after(endless_bench(), "engine\n", {signal}), 128 + signal);
    EXPECT_EQ(files(), "cube.xyzr err");
    EXPECT_EQ(text("err"), "alphascope-cli: cancelled; nothing was written.\n");
  }
}

TEST_F(CliOutputs, ASecondSignalKillsAndNothingIsLeftBehind) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    // The program may have reacted to the first signal before the second arrives.
    const int code = code_after(endless_bench(), "engine\n", {signal, signal});
    EXPECT_TRUE(code == 1000 + signal || code == 128 + signal) << code;
    EXPECT_EQ(files(), "cube.xyzr err");
  }
}

TEST_F(CliOutputs, ACancelledProgramEndsSoonWhateverItIsDoing) {
  // Opening a pipe waits for its reader and cannot be cancelled.
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0666), 0);
  const pid_t child = start(
      {"compute", "cube.xyzr", "--alpha", "1", "--csv", "t", "--json", "pipe"}, STDOUT_FILENO, 0);
  while (!contains(files(), ".tmp")) ::usleep(1000);
  ::kill(child, SIGINT);
  EXPECT_EQ(code_of(child), 128 + SIGINT);
  EXPECT_EQ(files(), "cube.xyzr err pipe");
  EXPECT_EQ(text("err"), "alphascope-cli: cancelled.\n");
}

TEST_F(CliOutputs, ASignalThatWasIgnoredAtTheStartStaysIgnored) {
  EXPECT_EQ(code_after(endless_bench(), "engine\n", {SIGHUP, SIGTERM}, SIGHUP), 128 + SIGTERM);
  EXPECT_EQ(code_after(endless_bench(), "engine\n", {SIGINT, SIGHUP}, SIGINT), 128 + SIGHUP);
}

TEST_F(CliOutputs, AClosedPipeIsQuietNotZeroAndLeavesNothingBehind) {
  const std::vector<std::string> bench{"bench",  "cube.xyzr", "--alpha", "0",
                                       "--runs", "1",         "--csv",   "t.csv"};
  EXPECT_EQ(code_without_reader(bench), 1000 + SIGPIPE) << "a shell shows 141";
  EXPECT_EQ(text("err"), "");
  EXPECT_EQ(files(), "cube.xyzr err");
  // Where the signal is ignored, computed results are not lost.
  EXPECT_EQ(code_without_reader(bench, SIGPIPE), 128 + SIGPIPE);
  EXPECT_EQ(text("err"), "");
  EXPECT_EQ(files(), "cube.xyzr err t.csv");
  // The summary comes last, so `| head` loses no result.
  const std::vector<std::string> compute{"compute", "cube.xyzr", "--alpha", "0", "--out", "whole"};
  EXPECT_EQ(code_without_reader(compute), 1000 + SIGPIPE);
  EXPECT_EQ(files(), "cube.xyzr err t.csv whole");
}

TEST_F(CliOutputs, LostStandardOutputIsCode5AndSaysSo) {
  const struct {
    const char *arguments, *redirection, *said;
  } cases[] = {
      {"compute cube.xyzr --alpha 1", ">/dev/full", "standard output: No space left on device."},
      {"compute cube.xyzr --alpha 1 --json -", ">/dev/full", "standard output: No space left"},
      {"compute cube.xyzr --alpha 1 --out -", ">/dev/full", "standard output: No space left"},
      {"info cube.xyzr", ">/dev/full", "standard output: No space left on device."},
      {"verify cube.xyzr --alpha 1", ">/dev/full", "standard output: No space left on device."},
      {"--help", ">/dev/full", "standard output: No space left on device."},
      {"info cube.xyzr", ">&-", "standard output: it is closed."},
      {"compute cube.xyzr --alpha 1 --csv -", ">&-", "standard output: it is closed."}};
  for (const auto& c : cases) {
    EXPECT_EQ(shell(std::string("cli ") + c.arguments + " 2>err " + c.redirection), 5)
        << c.arguments << c.redirection;
    EXPECT_TRUE(contains(text("err"), c.said)) << text("err");
    EXPECT_TRUE(contains(text("err"), "alphascope-cli: ")) << text("err");
  }
}

TEST_F(CliOutputs, ClosedDescriptorsNeverBecomeAnOutputFile) {
  for (const char* closed : {">&-", "<&- >&-", "2>&-", "<&- >&- 2>&-", "<&-"}) {
    const std::string redirections = closed;
    const int code =
        shell("cli compute cube.xyzr --alpha 1 --out whole --json j >out " + redirections);
    EXPECT_EQ(code, contains(redirections, " >&-") || redirections == ">&-" ? 5 : 0) << closed;
    EXPECT_TRUE(text("whole").starts_with("alphascope-complex 1\n")) << text("whole");
    EXPECT_TRUE(text("whole").ends_with("\nend\n")) << text("whole");
    EXPECT_FALSE(contains(text("whole"), "sha256      ")) << "the summary's line";
    EXPECT_TRUE(json::accept(text("j"))) << text("j");
    fs::remove(folder_ / "whole");
    fs::remove(folder_ / "j");
  }
}

TEST_F(CliOutputs, AnOutputNeverReplacesAnInput) {
  fs::create_symlink("cube.xyzr", folder_ / "link");
  fs::create_hard_link(folder_ / "cube.xyzr", folder_ / "hard");
  fs::create_directory(folder_ / "sub");
  const std::string radii = "C 1.7\nX 1.5\n", cube = text("cube.xyzr");
  write("table.radii", radii);
  for (const char* arguments :
       {"compute cube.xyzr --alpha 1 --out cube.xyzr", "compute cube.xyzr --alpha 1 --json link",
        "compute cube.xyzr --alpha 1 --csv hard", "compute link --alpha 1 --out ./sub/../cube.xyzr",
        "compute cube.xyzr --radii table.radii --alpha 1 --out table.radii",
        "info cube.xyzr --json cube.xyzr", "verify hard --alpha 1 --json cube.xyzr",
        "bench link cube.xyzr --alpha 1 --csv hard", "bench cube.xyzr --suite thesis --csv hard"}) {
    EXPECT_EQ(shell(std::string("cli ") + arguments + " >out 2>err"), 2) << arguments;
    EXPECT_TRUE(contains(text("err"), ", which is read.")) << text("err");
    EXPECT_TRUE(contains(text("err"), " would replace ")) << text("err");
    EXPECT_EQ(text("out"), "") << "found before anything is measured";
  }
  EXPECT_EQ(text("cube.xyzr"), cube);
  EXPECT_EQ(text("table.radii"), radii);
  EXPECT_EQ(shell("cli compute cube.xyzr --alpha 1 --out out >out 2>err"), 2);
  EXPECT_TRUE(contains(text("err"), "also where standard output goes")) << text("err");
}

TEST_F(CliOutputs, TwoOutputsNeverShareAFile) {
  fs::create_symlink("new", folder_ / "dangling");
  write("old", "old");
  fs::create_hard_link(folder_ / "old", folder_ / "older");
  for (const char* arguments : {"--out x --json x", "--out x --csv ./x", "--json old --csv older",
                                "--out dangling --csv new", "--json dangling --csv dangling"}) {
    EXPECT_EQ(shell(std::string("cli compute cube.xyzr --alpha 1 2>err >out ") + arguments), 2)
        << arguments;
    EXPECT_TRUE(contains(text("err"), "both name ")) << text("err");
  }
  EXPECT_EQ(shell("cli compute cube.xyzr --alpha 1 --out - --csv - 2>err >out"), 2);
  EXPECT_TRUE(contains(text("err"), "Only one of --out and --csv can be -")) << text("err");
  EXPECT_EQ(files(), "cube.xyzr dangling err old older out");
  EXPECT_EQ(shell("cli compute cube.xyzr --alpha 1 --out /dev/null --csv /dev/null >out"), 0);
}

TEST_F(CliOutputs, ADashIsStandardOutputAndTheSummaryGoesToStandardError) {
  for (const char* option : {"--out", "--json", "--csv", "--filtration"}) {
    ASSERT_EQ(shell(std::string("cli compute cube.xyzr --alpha 1 >plain 2>err ") + option + " f"),
              0);
    ASSERT_EQ(
        shell(std::string("cli compute cube.xyzr --alpha 1 >data 2>summary ") + option + " -"), 0);
    const std::string data = text("data"), file = text("f");
    EXPECT_TRUE(contains(text("summary"), "hash        ")) << option << text("summary");
    EXPECT_FALSE(contains(data, "hash        ")) << option;
    EXPECT_EQ(data.substr(0, 20), file.substr(0, 20)) << option;
    EXPECT_EQ(std::count(data.begin(), data.end(), '\n'),
              std::count(file.begin(), file.end(), '\n'))
        << option;
    EXPECT_FALSE(fs::exists(folder_ / "-"));
  }
  ASSERT_EQ(shell("cli bench cube.xyzr --alpha 1 --runs 1 --csv - >data 2>summary"), 0);
  EXPECT_EQ(csv_rows(text("data")).size(), 1u);
  EXPECT_TRUE(contains(text("summary"), "medians of 1 runs"));
}

TEST_F(CliOutputs, NotesAreNeverLost) {
  // Numbers with more digits than the lattice are rounded, and a note says so.
  write("fine.xyzr", "0 0 0 1.5\n1.23456789 0 0 1.5\n");
  for (const char* option : {"--out", "--json", "--csv", "--filtration"}) {
    ASSERT_EQ(
        shell(std::string("cli compute fine.xyzr --alpha 1 >data 2>summary ") + option + " -"), 0);
    EXPECT_TRUE(contains(text("summary"), "note: Numbers have more digits")) << text("summary");
  }
  ASSERT_EQ(shell("cli compute fine.xyzr --alpha 1.4 --out f >out"), 0);
  EXPECT_TRUE(contains(text("f"), "\nnote Numbers have more digits than the lattice of 1e-06 Å"))
      << text("f");
  EXPECT_TRUE(contains(text("f"), "\nalpha_used_square_lattice_units 1400000000000\n"))
      << text("f");
}

TEST_F(CliOutputs, EverythingIsCheckedBeforeAnythingIsMeasured) {
  write("good.xyzr", "0 0 0 1.5\n");
  const struct {
    const char* arguments;
    int code;
    const char* said;
  } cases[] = {
      {"bench good.xyzr cube.xyzr nofile --alpha 1 --csv t.csv", 3,
       "nofile: there is no such file"},
      {"bench good.xyzr . --alpha 1 --csv t.csv", 3, ".: this is a folder"},
      {"bench good.xyzr --alpha 1 --csv nodir/t.csv", 5, "Cannot open nodir/t.csv: No such file"},
      {"bench good.xyzr nofile --suite thesis --csv t.csv", 3, "nofile: there is no such file"},
      {"bench good.xyzr --suite thesis --json nodir/t.json", 5, "Cannot open nodir/t.json"},
      {"bench good.xyzr --suite thesis --charts good.xyzr", 5, "Cannot make the folder good.xyzr"},
      {"compute good.xyzr --alpha 1 --json nodir/x", 5, "Cannot open nodir/x"},
      {"compute good.xyzr --alpha 1 --csv nodir/x", 5, "Cannot open nodir/x"},
      {"compute good.xyzr --alpha 1 --out nodir/x", 5, "Cannot open nodir/x"},
      {"verify good.xyzr --alpha 1 --json nodir/x", 5, "Cannot open nodir/x"},
      {"info good.xyzr --json nodir/x", 5, "Cannot open nodir/x"}};
  for (const auto& c : cases) {
    EXPECT_EQ(shell(std::string("cli ") + c.arguments + " >out 2>err"), c.code) << c.arguments;
    EXPECT_TRUE(contains(text("err"), c.said)) << text("err");
    EXPECT_EQ(text("out"), "") << c.arguments;
    EXPECT_EQ(files(), "cube.xyzr err good.xyzr out") << c.arguments;
  }
}

// The first code block of docs/output-files.md without its remarks. "..." stands for lines that are
// not shown.
// Compares the first example below a heading of docs/output-files.md with what was written: line by
// line, where ... stands for any lines. Returns the number of lines that were compared.
int compare_with_example(const std::string& heading, std::istream& written) {
  std::ifstream document(ALPHASCOPE_SOURCE_DIR "/docs/output-files.md");
  std::string line, found;
  while (std::getline(document, line) && line != heading) {
  }
  bool skip = false;
  int compared = 0;
  while (std::getline(document, line)) {
    if (!line.starts_with("    ")) {
      if (compared > 0 && !line.empty()) break;
      continue;
    }
    std::string expected = line.substr(4);
    expected.erase(std::min(expected.find("  "), expected.size()));
    if (expected == "...") {
      skip = true;
      continue;
    }
    // Version and commit are those of this build.
    const bool program = expected.starts_with("program ");
    if (program) expected = "program alphascope-cli ";
    bool same = false;
    do {
      if (!std::getline(written, found)) break;
      same = program ? found.starts_with(expected) : found == expected;
    } while (skip && !same);
    EXPECT_TRUE(same) << "documented: " << expected << "\nwritten:    " << found;
    skip = false;
    ++compared;
  }
  EXPECT_FALSE(std::getline(written, found)) << "after the documented end: " << found;
  return compared;
}

TEST_F(CliOutputs, ExamplesOfTheDocumentationAreWhatTheProgramWrites) {
  fs::copy(ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb", folder_ / "1crn.pdb");
  ASSERT_EQ(shell("cli compute 1crn.pdb --alpha 1.4 --out 1crn.alpha >out"), 0);
  ASSERT_EQ(shell("cli compute 1crn.pdb --alpha 1e9 --filtration 1crn-filtration.txt >out"), 0);
  std::istringstream complex(text("1crn.alpha")), filtration(text("1crn-filtration.txt"));
  EXPECT_EQ(compare_with_example("## The complex as text (`compute --out`)", complex), 17);
  EXPECT_EQ(compare_with_example("## The filtration as text (`compute --filtration`)", filtration),
            6);
}

// Faces come before cofaces. All simplices fill a convex body, whose Euler number is 1.
TEST_F(CliOutputs, AFiltrationHasEachSimplexInTheOrderOfAlpha) {
  ASSERT_EQ(shell("cli compute cube.xyzr --alpha 1e9 --filtration f --out whole >out"), 0);
  std::istringstream lines(text("f"));
  std::string line;
  std::size_t count = 0;
  int euler = 0;
  while (std::getline(lines, line) && !line.starts_with("simplices ")) {
  }
  const std::size_t announced = std::stoul(line.substr(line.find(' ')));
  double last = -HUGE_VAL;
  std::set<std::vector<int>> before;
  for (; std::getline(lines, line) && line != "end"; ++count) {
    std::istringstream words(line);
    std::size_t dimension = 0;
    ASSERT_TRUE(words >> dimension) << line;
    std::vector<int> balls(dimension + 1);
    for (int& ball : balls) words >> ball;
    double value = 0;
    std::string regular, interior, more;
    ASSERT_TRUE(words >> value >> regular >> interior && !(words >> more)) << line;
    EXPECT_GE(value, last) << line;
    last = value;
    for (std::size_t k = 0; k < balls.size() && dimension > 0; ++k) {
      std::vector<int> face = balls;
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(k));
      EXPECT_TRUE(before.contains(face)) << line;
    }
    EXPECT_TRUE(before.insert(balls).second) << line;
    euler += dimension % 2 == 0 ? 1 : -1;
  }
  EXPECT_EQ(line, "end");
  EXPECT_EQ(count, announced);
  EXPECT_GT(count, 50u);
  EXPECT_EQ(euler, 1);
  EXPECT_EQ(shell("cli compute cube.xyzr --alpha 1 --tetrahedra-only --filtration g 2>err >out"),
            2);
  EXPECT_TRUE(contains(text("err"), "--filtration needs all simplices")) << text("err");
  EXPECT_FALSE(fs::exists(folder_ / "g"));
}

TEST_F(CliOutputs, ASelectionOfAnyLengthNeedsNoDeepStack) {
  std::string any = "water", all = "all", deep;
  for (int n = 1; n < 25000; ++n) {
    any += "|ion";
    all += "&all";
    deep += "(";
  }
  write("any", any + "|all");
  write("all", all);
  write("deep", deep + "all");
  for (const char* file : {"any", "all"}) {
    EXPECT_EQ(shell("ulimit -s 1024; cli info cube.xyzr --select \"$(cat " + std::string(file) +
                    ")\" >out 2>err"),
              0);
    EXPECT_TRUE(contains(text("out"), "used 8 of 8 atoms")) << text("out");
  }
  EXPECT_EQ(shell("ulimit -s 1024; cli info cube.xyzr --select \"$(cat deep)\" >out 2>err"), 2);
  EXPECT_TRUE(contains(text("err"), "more than 200 parentheses")) << text("err").substr(0, 300);
}

TEST_F(CliOutputs, APictureIsAnOutputLikeAnyOther) {
  const std::string screenshot = "cli screenshot cube.xyzr --alpha 1 --size 64x64 2>err >out -o ";
  if (!kDrawsPictures) GTEST_SKIP() << "built without the viewer";
  ASSERT_EQ(shell(screenshot + "cube.png"), 0) << text("err");
  const std::string picture = text("cube.png");
  EXPECT_TRUE(picture.starts_with("\x89PNG"));
  EXPECT_EQ(shell(screenshot + "-"), 0);
  EXPECT_TRUE(text("out") == picture) << "the same bytes";
  EXPECT_TRUE(contains(text("err"), "hash        ")) << text("err");
  EXPECT_FALSE(fs::exists(folder_ / "-"));
  const std::string cube = text("cube.xyzr");
  EXPECT_EQ(shell(screenshot + "cube.xyzr"), 2);
  EXPECT_TRUE(contains(text("err"), "would replace cube.xyzr")) << text("err");
  EXPECT_EQ(text("cube.xyzr"), cube);
  EXPECT_EQ(shell(screenshot + "nodir/cube.png"), 5);
  EXPECT_EQ(files(), "cube.png cube.xyzr err out");
}

TEST_F(CliOutputs, AFullDiskLeavesTheOldFile) {
  write("old", "the old one");
  // The shell's limit on file sizes stands for a full disk. A write beyond it fails, and a signal
  // comes with it.
  const std::string big = "'" ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb'";
  EXPECT_EQ(shell("ulimit -f 8; cli compute " + big +
                  " --alpha 1 --out old 2>&1 >/dev/null | cat "
                  ">err; test \"$(cat old)\" = 'the old one'"),
            0);
  EXPECT_TRUE(contains(text("err"), "Cannot write old: File too large.")) << text("err");
  EXPECT_EQ(shell("ulimit -f 8; cli compute " + big + " --alpha 1 --out old >out 2>err"), 5);
  EXPECT_EQ(text("old"), "the old one");
  EXPECT_EQ(files(), "cube.xyzr err old out");
}

}  // namespace
}  // namespace alphascope::testing
