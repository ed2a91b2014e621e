// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that alphascope-cli follows conventions of command lines: help, typing errors, manual,
// completion.
#include <pty.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <regex>
#include <set>

#include "tests/app/cli/cli_fixture.hpp"

namespace alphascope::testing {
namespace {

const std::string kCrambin = ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb";
constexpr const char* kCommands[] = {"info", "compute", "verify", "bench", "screenshot", "frames"};

class CliConventions : public Cli {
 protected:
  // Returns the options in the help of a command, such as "--alpha" and "-o". For "" these are the
  // program's own.
  std::set<std::string> options(const std::string& command) const {
    std::set<std::string> names;
    const std::string help = run(command + " --help").out;
    const std::regex line("\n  (-[a-zA-Z], )?(--[a-z-]+)");
    for (std::sregex_iterator match(help.begin(), help.end(), line), end; match != end; ++match) {
      names.insert((*match)[2]);
      if ((*match)[1].matched) names.insert((*match)[1].str().substr(0, 2));
    }
    EXPECT_GE(names.size(), 4u) << command;
    return names;
  }

  // Proposals of bash for the last word.
  std::string completed(const std::string& words, int count) const {
    const fs::path script = folder_ / "completion", out = folder_ / "proposed";
    if (!fs::exists(script)) write("completion", run("--completion bash").out);
    const std::string command = "bash -c 'source \"" + script.string() + "\"; COMP_WORDS=(" +
                                words + "); COMP_CWORD=" + std::to_string(count - 1) +
                                "; _alphascope_cli; echo \"${COMPREPLY[*]}\"' >'" + out.string() +
                                "' 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return contents(out);
  }
};

TEST_F(CliConventions, HelpShowsDefaultsWithUnits) {
  const std::string help = run("compute --help").out;
  for (const char* part :
       {"(default: 0 Å)", "(default: 0 = all)", "(default: best)", "(default: 1)", "(required)",
        "auto|gpu|cpu|tuples-gpu|tuples-cpu|cgal", "Usage: alphascope-cli compute --alpha A"}) {
    EXPECT_TRUE(contains(help, part)) << part << "\n" << help;
  }
  EXPECT_TRUE(contains(run("bench --help").out, "(default: 20 s)"));
  EXPECT_TRUE(contains(run("screenshot --help").out, "(default: 1280x800, or the preset's)"));
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) EXPECT_LT(line.size(), 112u) << line;
}

TEST_F(CliConventions, NoOptionSwallowsTheFile) {
  const std::string file = " '" + kCrambin + "' ";
  for (const std::string& arguments :
       {"compute --alpha 1 --chain A" + file, "compute --alpha 1 --chain A --chain A" + file,
        "compute --alpha 1 --without-chain ''" + file, "verify --alpha 0,1" + file,
        "verify --alpha 0 --alpha 1" + file, "bench --alpha 0 --runs 1 --threads 1" + file,
        "bench --runs 1 --threads 1,2 --alpha 0" + file, "info --chain A" + file,
        "bench --suite thesis --runs 1 --alpha 0 --no-ablation --engines cpu '" + cube_.string() +
            "'"}) {
    const Outcome outcome = run(arguments);
    EXPECT_NE(outcome.code, 3) << arguments << "\n" << outcome.err;
    EXPECT_FALSE(contains(outcome.err, "FILE")) << arguments << "\n" << outcome.err;
  }
  EXPECT_EQ(compute_json("--chain A,A" + file + "--alpha 1")["input"]["balls"], 327);
  const json twice = json::parse(run("verify --alpha 0 --alpha 1" + file + "--json -").out);
  EXPECT_EQ(twice["results"].size(), 2u);
}

TEST_F(CliConventions, TypingErrorsGetAProposal) {
  const std::string compute = "compute '" + cube_.string() + "' --alpha 1 ";
  const struct {
    std::string arguments, said;
  } cases[] = {
      {"comptue x", "there is no command \"comptue\". Did you mean \"compute\"?"},
      {compute + "--solvnt 1.4", "there is no option --solvnt. Did you mean \"--solvent\"?"},
      {compute + "--solvnt=1.4", "there is no option --solvnt. Did you mean \"--solvent\"?"},
      {compute + "--tetra", "Did you mean \"--tetrahedra-only\"?"},
      {compute + "--engine cgla", "--engine: \"cgla\" is not one of auto, gpu, cpu"},
      {compute + "--engine cgla", "Did you mean \"cgal\"?"},
      {compute + "--radii Bondy", "Did you mean \"bondi\"?"},
      {compute + "--altlocs bets", "Did you mean \"best\"?"},
      {"screenshot x --alpha 1 -o y.png --colours elemnt", "Did you mean \"element\"?"},
      {"bench x --suite tesis", "Did you mean \"thesis\"?"},
      {"verify --aplha 1", "Did you mean \"--alpha\"?"}};
  for (const auto& c : cases) {
    const Outcome outcome = run(c.arguments);
    EXPECT_EQ(outcome.code, 2) << c.arguments;
    EXPECT_TRUE(outcome.err.starts_with("alphascope-cli: ")) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, c.said)) << c.arguments << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_FALSE(contains(run("xyzzyplugh").err, "Did you mean"));
}

TEST_F(CliConventions, UsageErrorsSayWhatIsMissing) {
  const std::string file = "'" + cube_.string() + "' ";
  const struct {
    std::string arguments, said;
  } cases[] = {
      {"",
       "alphascope-cli: name a command: info, compute, cavities, channel, measure, "
       "export, explain, steps, fetch, formats, verify, bench, screenshot, frames, columns, "
       "help."},
      {"compute " + file, "alphascope-cli: --alpha is required."},
      {"compute " + file + "--alpha", "--alpha needs a value."},
      {"compute " + file + "--alpha 1 --alpha 2", "--alpha can be given only once."},
      {"compute " + file + "--alpha 1 --waters=no", "--waters takes no value."},
      {"verify " + file + file + "--alpha 1", "too many arguments: "},
      {"verify --alpha 1", "FILE is required."},
      {"compute " + file + "--alpha 1 --threads 1.5",
       "--threads: \"1.5\" is not a whole number from 0 to 1024."},
      {"compute " + file + "--alpha 1 --solvent 1,4",
       "--solvent: \"1,4\" is not a number from 0 to 100 Å."}};
  for (const auto& c : cases) {
    const Outcome outcome = run(c.arguments);
    EXPECT_EQ(outcome.code, 2) << c.arguments;
    EXPECT_TRUE(contains(outcome.err, c.said)) << c.arguments << "\n" << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "\nUsage: alphascope-cli ")) << outcome.err;
  }
}

TEST_F(CliConventions, QuietIsResultsOnlyAndVerboseSaysMore) {
  // The last line has no line end, which the reader notes.
  const fs::path noted = write("noted.xyzr", "0 0 0 1\n1 0 0 1");
  const std::string compute = "compute '" + noted.string() + "' --alpha 1 ";
  const Outcome normal = run(compute), quiet = run(compute + "-q"), loud = run(compute + "-v");
  EXPECT_TRUE(contains(normal.out, "note: "));
  EXPECT_TRUE(contains(normal.out, "\ntime "));
  EXPECT_FALSE(contains(normal.out, "\nmemory "));
  EXPECT_FALSE(contains(quiet.out, "note: ") || contains(quiet.out, "\nnote "));
  EXPECT_FALSE(contains(quiet.out, "\ntime "));
  EXPECT_TRUE(contains(quiet.out, "\nhash ")) << quiet.out;
  EXPECT_EQ(quiet.err, "");
  EXPECT_TRUE(contains(loud.out, "\nmemory ") && contains(loud.out, "\nopened in "));
  EXPECT_TRUE(contains(loud.err, "alphascope-cli: selection and radii\n")) << loud.err;
  const std::string two = compute + "'" + cube_.string() + "' ";
  EXPECT_TRUE(contains(run(two).err, noted.string() + ": note: "));
  EXPECT_EQ(run(two + "--quiet").err, "");
  EXPECT_EQ(run(compute + "--quiet --json -").err, "");
  const Outcome failed = run("compute /nonexistent --alpha 1 -q");
  EXPECT_EQ(failed.code, 3);
  EXPECT_TRUE(contains(failed.err, "there is no such file")) << "errors stay";
}

// Runs a command with standard output and standard error on a terminal. Returns the lines that are
// left on it; the terminal has unlimited width.
std::vector<std::string> lines_on_a_terminal(const std::string& command, bool& progress) {
  int terminal = -1;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    ::setenv("TERM", "xterm", 1);
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(127);
  }
  std::vector<std::string> lines(1);
  std::size_t column = 0;
  progress = false;
  char last = ' ', bytes[4096];
  for (ssize_t got = 0; (got = ::read(terminal, bytes, sizeof bytes)) > 0;) {
    for (ssize_t k = 0; k < got; last = bytes[k++]) {
      progress |= last == '\r' && std::isalpha(static_cast<unsigned char>(bytes[k])) != 0;
      if (bytes[k] == '\r') {
        column = 0;
      } else if (bytes[k] == '\n') {
        lines.back().erase(lines.back().find_last_not_of(' ') + 1);
        lines.emplace_back();
      } else {
        lines.back().resize(std::max(lines.back().size(), column + 1), ' ');
        lines.back()[column++] = bytes[k];
      }
    }
  }
  ::close(terminal);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0) << command;
  return lines;
}

// Results replace the line of progress, of which nothing is left.
TEST_F(CliConventions, ResultsStandOnAClearLine) {
  if (::access("/dev/ptmx", R_OK | W_OK) != 0) GTEST_SKIP() << "there are no terminals here";
  const std::string file = "'" ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz'";
  std::string many;  // so many files that the work outlasts the delay of the progress line, on any
                     // machine
  for (int n = 0; n < 30; ++n) many += file + " ";
  for (const std::string& command : std::vector<std::string>{
           "cavities " + many, "compute " + many + "--alpha 1 --engine cpu", "measure " + many}) {
    const Outcome plain = run(command + " --no-times");
    ASSERT_EQ(plain.code, 0) << plain.err;
    std::string out;
    bool progress = false;
    for (const std::string& line :
         lines_on_a_terminal("'" + tested_cli() + "' " + command + " --no-times", progress)) {
      out += (out.empty() ? "" : "\n") + line;
    }
    EXPECT_TRUE(progress) << command;
    EXPECT_EQ(out, plain.out) << command;
  }
}

TEST_F(CliConventions, ManualAndCompletionsHoldEveryOption) {
  const std::string page = run("--man-page").out, bash = run("--completion bash").out,
                    zsh = run("--completion zsh").out, fish = run("--completion fish").out;
  EXPECT_TRUE(page.starts_with(".\\\" -*- coding: utf-8 -*-\n.TH ALPHASCOPE\\-CLI 1"));
  for (const char* command : kCommands) {
    const std::size_t begin = page.find(".SS alphascope\\-cli " + std::string(command) + "\n");
    ASSERT_NE(begin, page.npos) << command;
    const std::string section = page.substr(begin, page.find("\n.S", begin + 1) - begin);
    for (const std::string& name : options(command)) {
      const std::string escaped = std::regex_replace(name, std::regex("-"), "\\-");
      EXPECT_TRUE(contains(section, "\\fB" + escaped + "\\fR")) << command << " " << name;
      EXPECT_TRUE(contains(zsh, name + "[")) << name;
      const std::string flag = name.size() == 2 ? " -s " + name.substr(1) : " -l " + name.substr(2);
      EXPECT_TRUE(contains(fish, flag)) << name;
    }
    const std::string all = completed("alphascope-cli " + std::string(command) + " -", 3);
    std::istringstream words(all);
    const std::set<std::string> offered{std::istream_iterator<std::string>(words), {}};
    EXPECT_EQ(offered, options(command)) << command;
  }
}

TEST_F(CliConventions, BashCompletes) {
  EXPECT_EQ(completed("alphascope-cli comp", 2), "compute\n");
  EXPECT_EQ(completed("alphascope-cli \"\"", 2),
            "info compute cavities channel measure export explain steps fetch formats verify bench "
            "screenshot frames columns help\n");
  EXPECT_EQ(completed("alphascope-cli help comp", 3), "compute\n");
  EXPECT_EQ(completed("alphascope-cli --vers", 2), "--version\n");
  EXPECT_EQ(completed("alphascope-cli compute --eng", 3), "--engine\n");
  EXPECT_EQ(completed("alphascope-cli compute --engine tup", 4), "tuples-gpu tuples-cpu\n");
  EXPECT_EQ(completed("alphascope-cli compute --engine = cg", 5), "cgal\n");
  EXPECT_EQ(completed("alphascope-cli bench --engines cpu,gp", 4), "cpu,gpu\n");
  EXPECT_EQ(completed("alphascope-cli compute --alpha \"\"", 4), "\n") << "a number";
  const std::string file = folder_.string() + "/cu";
  EXPECT_EQ(completed("alphascope-cli compute " + file, 3), cube_.string() + "\n");
  EXPECT_EQ(completed("alphascope-cli compute --alpha 1 --json " + file, 6), cube_.string() + "\n");
}

TEST_F(CliConventions, ManualIsWellFormed) {
  if (std::system("groff --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "needs groff";
  const fs::path page = write("page.1", run("--man-page").out), out = folder_ / "printed";
  ASSERT_EQ(std::system(("groff -man -Tutf8 -Kutf8 -ww '" + page.string() + "' >'" + out.string() +
                         "' 2>&1")
                            .c_str()),
            0);
  const std::string printed = contents(out);
  EXPECT_FALSE(contains(printed, "warning")) << printed;
  EXPECT_TRUE(contains(printed, "Solvent radius in Å"));
}

TEST_F(CliConventions, LibrariesOfPicturesAreLoadedForPicturesOnly) {
  const fs::path out = folder_ / "libraries";
  ASSERT_EQ(std::system(("ldd '" ALPHASCOPE_CLI "' >'" + out.string() + "'").c_str()), 0);
  const std::string libraries = contents(out);
  EXPECT_FALSE(contains(libraries, "libvtk"));
  EXPECT_FALSE(contains(libraries, "libGL"));
  EXPECT_FALSE(contains(libraries, "libEGL"));
}

TEST_F(CliConventions, ThePictureProgramIsFoundWhereItIsInstalled) {
  const fs::path here = fs::path(ALPHASCOPE_CLI).parent_path() / "alphascope-cli-draw";
  if (!kDrawsPictures) GTEST_SKIP() << "built without the viewer";
  fs::create_directories(folder_ / "usr/bin");
  fs::create_directories(folder_ / "usr/libexec/alphascope");
  const fs::path program = folder_ / "usr/bin/alphascope-cli";
  fs::copy_file(ALPHASCOPE_CLI, program);
  const std::string arguments =
      " screenshot '" + cube_.string() + "' --alpha 1 --size 64x64 -o x.png >log 2>&1";
  const std::string command = "cd '" + folder_.string() + "' && ";
  // The program has another name, through a link.
  fs::create_symlink(program, folder_ / "link");
  EXPECT_EQ(WEXITSTATUS(std::system((command + "./link" + arguments).c_str())), 4);
  EXPECT_TRUE(contains(contents(folder_ / "log"),
                       "alphascope-cli: The program that draws cannot be started"));
  fs::copy_file(here, folder_ / "usr/libexec/alphascope/alphascope-cli-draw");
  EXPECT_EQ(WEXITSTATUS(std::system((command + "./link" + arguments).c_str())), 0)
      << contents(folder_ / "log");
  EXPECT_TRUE(contents(folder_ / "x.png").starts_with("\x89PNG"));
}

}  // namespace
}  // namespace alphascope::testing
