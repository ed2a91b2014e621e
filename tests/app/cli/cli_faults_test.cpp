// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the files of alphascope-cli when a system call fails or a signal arrives. All outputs of a
// command must be complete, or all unchanged. The input must be unchanged, and no temporary file
// may be left. ALPHASCOPE_ALL_FAULTS=1 tries every call of every command, instead of a sample.
#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <map>

#include "tests/app/cli/cli_fixture.hpp"

extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace alphascope::testing {
namespace {

bool all_faults() {
  return std::getenv("ALPHASCOPE_ALL_FAULTS") != nullptr;
}

struct Command {
  std::vector<std::string> arguments;
  std::vector<std::string> outputs;  // names of files in the folder
  bool draws = false;
};

// The quickest command for each kind of output, or all that write files.
std::vector<Command> commands() {
  std::vector<Command> all{{{"compute", "cube.xyzr", "--alpha", "1", "--out", "o.alpha", "--csv",
                             "o.csv", "--json", "o.json", "--filtration", "o.txt"},
                            {"o.alpha", "o.csv", "o.json", "o.txt"}},
                           {{"export", "cube.xyzr", "--alpha", "1", "-o", "o.pml"},
                            {"o.pml", "o-balls.pqr", "o-boundary.obj"}}};
  if (!all_faults()) return all;
  const std::vector<Command> others{
      {{"info", "cube.xyzr", "--csv", "o.csv", "--json", "o.json"}, {"o.csv", "o.json"}},
      {{"measure", "cube.xyzr", "--alpha", "1", "--csv", "o.csv", "--json", "o.json"},
       {"o.csv", "o.json"}},
      {{"cavities", "cube.xyzr", "--solvent", "0.1", "--csv", "o.csv", "--json", "o.json",
        "--lives", "l.csv", "--spheres", "o.pqr", "--surface", "o.ply"},
       {"o.csv", "o.json", "l.csv", "o.pqr", "o.ply"}},
      {{"channel", "cube.xyzr", "--point", "1,1,1", "--along", "0,0,1", "--csv", "o.csv", "--json",
        "o.json", "--spheres", "o.pqr", "--surface", "o.ply"},
       {"o.csv", "o.json", "o.pqr", "o.ply"}},
      {{"explain", "cube.xyzr", "--alpha", "1", "--simplex", "0,1", "--json", "o.json"},
       {"o.json"}},
      {{"steps", "cube.xyzr", "--alpha", "1", "--ball", "0", "--json", "o.json"}, {"o.json"}},
      {{"verify", "cube.xyzr", "--alpha", "1", "--json", "o.json"}, {"o.json"}},
      {{"bench", "cube.xyzr", "--alpha", "1", "--runs", "1", "--csv", "o.csv"}, {"o.csv"}},
      {{"export", "cube.xyzr", "--alpha", "1", "-o", "o.vtu"}, {"o.vtu"}},
      {{"export", "cube.xyzr", "--alpha", "1", "-o", "o.xyzr"}, {"o.xyzr"}},
      {{"screenshot", "cube.xyzr", "--alpha", "1", "--size", "64x64", "-o", "o.png"},
       {"o.png"},
       true}};
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

class CliFaults : public Cli {
 protected:
  // The exit code, or 1000 + the signal that killed the program.
  int run_with(const std::string& fault, const Command& command) const {
    std::vector<std::string> words = command.arguments;
    if (words[0] != "bench") words.insert(words.begin() + 1, "--no-times");
    std::vector<char*> argv{const_cast<char*>(ALPHASCOPE_CLI)};
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    std::vector<std::string> settings{"LD_PRELOAD=" ALPHASCOPE_FAULTY_CALLS,
                                      "ALPHASCOPE_FAULT=" + fault,
                                      "ALPHASCOPE_FAULT_MARK=" + mark().string()};
    std::vector<char*> environment;
    for (char** one = environ; *one != nullptr; ++one) environment.push_back(*one);
    for (std::string& setting : settings) environment.push_back(setting.data());
    environment.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
      for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
      const int nowhere = ::open("/dev/null", O_WRONLY);
      ::dup2(nowhere, STDOUT_FILENO);
      ::dup2(nowhere, STDERR_FILENO);
      if (::chdir(work().c_str()) != 0) ::_exit(98);
      ::alarm(60);
      ::execve(ALPHASCOPE_CLI, argv.data(), environment.data());
      ::_exit(99);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  }
  fs::path work() const { return folder_ / "work"; }
  fs::path mark() const { return folder_ / "mark"; }

  void set_out(const Command& command, bool older) const {
    fs::remove_all(work());
    fs::create_directory(work());
    fs::copy(cube_, work() / "cube.xyzr");
    if (!older) return;
    for (const std::string& name : command.outputs) std::ofstream(work() / name) << "older";
  }

  static bool is_whole(const std::string& name, const std::string& text) {
    if (name.ends_with(".json")) return json::accept(text);
    if (name.ends_with(".alpha")) return text.ends_with("\nend\n");
    if (name.ends_with(".pml")) return text.ends_with("python end\n");
    if (name.ends_with(".vtu")) return text.ends_with("</VTKFile>\n");
    if (name.ends_with(".png")) return text.find("IEND") + 8 == text.size();
    return text.size() > 6 && (text.ends_with("\n") || name.ends_with(".ply"));
  }

  void check(const Command& command, bool older, int code, const std::string& what) const {
    std::size_t fresh = 0, there = 0;
    for (const std::string& name : command.outputs) {
      if (!fs::exists(work() / name)) continue;
      ++there;
      const std::string text = contents(work() / name);
      if (older && text == "older") continue;
      EXPECT_TRUE(is_whole(name, text)) << what << ": half of " << name;
      ++fresh;
    }
    EXPECT_TRUE(fresh == 0 || fresh == command.outputs.size()) << what << ": some of a set";
    EXPECT_TRUE(!older || there == command.outputs.size()) << what << ": an older file is gone";
    EXPECT_TRUE(code != 0 || fresh == command.outputs.size()) << what << ": 0, but not written";
    EXPECT_EQ(contents(work() / "cube.xyzr"), contents(cube_)) << what;
    std::string left;
    for (const auto& entry : fs::directory_iterator(work())) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with(".alphascope")) left += name + " ";
    }
    EXPECT_EQ(left, "") << what;
    EXPECT_NE(code, 1000 + SIGALRM) << what << " did not end";
    EXPECT_NE(code, 1000 + SIGABRT) << what;
    EXPECT_NE(code, 1000 + SIGSEGV) << what;
  }

  // Fails every `stride`-th call of this kind, from the first on, until there are no more. Returns
  // the number of faults.
  int sweep(const Command& command, const std::string& kind, int action, double stride = 1) const {
    int tried = 0;
    set_out(command, false);
    EXPECT_EQ(run_with("none 0 0", command), 0) << command.arguments[0];
    std::map<std::string, std::string> right;
    for (const std::string& name : command.outputs) right[name] = contents(work() / name);
    for (double at = 1; !HasFailure(); at = std::max(at + 1, at * stride)) {
      const bool older = tried % 2 == 0;
      set_out(command, older);
      fs::remove(mark());
      const std::string fault =
          kind + " " + std::to_string(static_cast<long>(at)) + " " + std::to_string(action);
      const int code = run_with(fault, command);
      if (!fs::exists(mark())) break;
      ++tried;
      std::string what = fault + ":";
      for (const std::string& word : command.arguments) what += " " + word;
      check(command, older, code, what + (older ? " (older files there)" : ""));
      if (code != 0 || command.arguments[0] == "bench") continue;
      for (const auto& [name, text] : right) {
        EXPECT_EQ(contents(work() / name), text) << what << ": 0, but another " << name;
      }
    }
    return tried;
  }

  int sweep_all(const std::string& kind, int action, double stride = 1) const {
    int tried = 0;
    for (const Command& command : commands()) {
      if (command.draws && (!kDrawsPictures || kind == "malloc")) continue;
      const int here = sweep(command, kind, action, stride);
      if (all_faults()) {
        std::printf("%s %d, %s: %d\n", kind.c_str(), action, command.arguments[0].c_str(), here);
      }
      EXPECT_GT(here, 0) << kind << " " << command.arguments[0];
      tried += here;
    }
    return tried;
  }
};

TEST_F(CliFaults, ACallThatFails) {
  const double stride = all_faults() ? 1 : 1.5;
  sweep_all("open", EACCES);
  sweep_all("write", ENOSPC, stride);
  sweep_all("rename", EIO);
  sweep_all("fsync", EIO);
}

// A file that has replaced an older one is restored when a later file of the set fails.
TEST_F(CliFaults, ARenameThatFailsWhereNamesCannotBeExchanged) {
  ::setenv("ALPHASCOPE_NO_EXCHANGE", "1", 1);
  for (const int action : {EIO, 1000 + SIGTERM}) sweep_all("rename", action);
  ::unsetenv("ALPHASCOPE_NO_EXCHANGE");
}

TEST_F(CliFaults, ASignalAtACall) {
  for (const int signal : {SIGTERM, SIGQUIT}) {
    sweep_all("open", 1000 + signal);
    sweep_all("rename", 1000 + signal);
    if (!all_faults()) continue;
    sweep_all("write", 1000 + signal);
    sweep_all("fsync", 1000 + signal);
  }
}

// One allocation fails, or all from one call on. Calls are sampled, since most of them belong to
// the start of a program, which is not our code.
TEST_F(CliFaults, NoMemory) {
  const double stride = all_faults() ? 1.01 : 1.9;
  for (const int action : {ENOMEM, 0}) sweep_all("malloc", action, stride);
}

}  // namespace
}  // namespace alphascope::testing
