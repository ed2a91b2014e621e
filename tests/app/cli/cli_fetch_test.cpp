// SPDX-License-Identifier: GPL-3.0-or-later
// Tests ids in place of files on the command line, and the command fetch.
#include <algorithm>
#include <csignal>
#include <memory>

#include "tests/app/cli/cli_fixture.hpp"
#include "tests/support/fetch_server.hpp"

namespace alphascope::testing {
namespace {

class CliFetch : public Cli {
 protected:
  static void SetUpTestSuite() {
    forget_network_variables();
    server_ = std::make_unique<FetchServer>();
  }
  static void TearDownTestSuite() {
    server_.reset();
    forget_network_variables();
  }
  void SetUp() override {
    Cli::SetUp();
    ::unsetenv("ALPHASCOPE_OFFLINE");
    ::setenv("ALPHASCOPE_FETCH_BASE", server_->address().c_str(), 1);
    ::setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
  }

  fs::path fetched(const std::string& path) const {
    return folder_ / "cache/alphascope/http" / (server_->address().substr(7) + path);
  }

  static inline std::unique_ptr<FetchServer> server_;
};

TEST_F(CliFetch, AnIdIsAFile) {
  const Outcome outcome = run("compute pdb:1god --alpha 1 --json -");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "1GOD.cif.gz: used 2 of 2 atoms")) << outcome.err;
  EXPECT_FALSE(contains(outcome.err, "fetching")) << "progress is for terminals";
  const json input = json::parse(outcome.out)["input"];
  EXPECT_EQ(input["file"], fetched("/download/1GOD.cif.gz").string());
  EXPECT_EQ(input["fetched"]["address"], server_->address() + "/download/1GOD.cif.gz");
  EXPECT_EQ(input["fetched"]["time"].get<std::string>().size(), 20u);
  EXPECT_TRUE(compute_json("'" + cube_.string() + "' --alpha 1")["input"]["fetched"].is_null());
  EXPECT_TRUE(contains(run("info pdb:1god").out,
                       "\nfetched     " + server_->address() + "/download/1GOD.cif.gz at 2"));
  const Outcome many = run("info 1god af:P69905 '" + cube_.string() + "' pdb:9zzz --csv - -q");
  EXPECT_EQ(many.code, 3) << "as that of the first file that failed";
  const auto rows = csv_rows(many.out);
  ASSERT_EQ(rows.size(), 3u) << many.err;
  EXPECT_TRUE(contains(rows[0].at("fetched"), "/download/1GOD.cif.gz at 2")) << many.out;
  EXPECT_TRUE(contains(rows[1].at("fetched"), "/files/AF-P69905-F1-model_v6.cif at 2")) << many.out;
  EXPECT_EQ(rows[2].at("fetched"), "");
  EXPECT_TRUE(contains(many.err, "\nalphascope-cli: pdb:9zzz: the PDB has no entry of this id.") ||
              many.err.starts_with("alphascope-cli: pdb:9zzz: the PDB has no entry of this id."))
      << many.err;
}

TEST_F(CliFetch, CommandsTakeIds) {
  const std::string png = (folder_ / "a.png").string();
  std::vector<std::string> commands{"measure pdb:1god --alpha 0",
                                    "export pdb:1god --alpha 1 --as xyzr -o -",
                                    "verify pdb:1god --alpha 1", "bench pdb:1god --alpha 1"};
  if (kDrawsPictures) commands.push_back("screenshot pdb:1god --alpha 1 -o '" + png + "'");
  for (const std::string& command : commands) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.code, 0) << command << "\n" << outcome.err;
  }
}

TEST_F(CliFetch, AFileWins) {
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  fs::copy_file(cube_, "1god");
  const Outcome outcome = run("info 1god");
  fs::current_path(before);
  EXPECT_TRUE(contains(outcome.out, "1god: used 8 of 8 atoms")) << outcome.out << outcome.err;
  EXPECT_FALSE(fs::exists(folder_ / "cache"));
}

TEST_F(CliFetch, InvalidIdsAreInvalidUsage) {
  for (const char* id : {"pdb:../../etc", "pdb:1AB%2F", "af:1CRN", "pdb:1ABC-assembly1"}) {
    const Outcome outcome = run("compute '" + std::string(id) + "' --alpha 1");
    EXPECT_EQ(outcome.code, 2) << id;
    EXPECT_TRUE(contains(outcome.err, "is not a valid ")) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
  EXPECT_EQ(run("info pdb:1god --offline --fetch-again").code, 2);
  ::setenv("ALPHASCOPE_FETCH_BASE", "http://example.org", 1);
  const Outcome outcome = run("info pdb:1god");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(contains(outcome.err, "ALPHASCOPE_FETCH_BASE is not an address of this computer"))
      << outcome.err;
  EXPECT_FALSE(fs::exists(folder_ / "cache"));
}

TEST_F(CliFetch, OfflineIsOneClearLine) {
  for (const char* command : {"info pdb:1god --offline", "info 1god --offline"}) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.code, 3);
    EXPECT_TRUE(contains(outcome.err,
                         "it was not fetched before, and nothing is fetched now "
                         "(--offline or ALPHASCOPE_OFFLINE). Fetch it without that"))
        << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
  EXPECT_EQ(run("fetch pdb:1god").code, 0);
  ::setenv("ALPHASCOPE_OFFLINE", "1", 1);
  EXPECT_EQ(run("fetch pdb:1red pdb:1god").out, fetched("/download/1GOD.cif.gz").string() + "\n");
  ::unsetenv("ALPHASCOPE_OFFLINE");
  ::setenv("ALPHASCOPE_NET_LIBRARY", "", 1);
  const Outcome without = run("info pdb:1red");
  ::unsetenv("ALPHASCOPE_NET_LIBRARY");
  EXPECT_EQ(without.code, 3);
  EXPECT_TRUE(contains(without.err, "pdb:1red: this installation cannot fetch files. "))
      << without.err;
  EXPECT_EQ(std::count(without.err.begin(), without.err.end(), '\n'), 1) << without.err;
}

TEST_F(CliFetch, AFolderThatCannotBeMadeIsNamed) {
  ::setenv("XDG_CACHE_HOME", (cube_ / "cache").c_str(), 1);
  const Outcome outcome = run("info pdb:1god");
  EXPECT_EQ(outcome.code, 5);
  EXPECT_TRUE(contains(outcome.err,
                       "pdb:1god: the fetched file cannot be kept. Cannot make the "
                       "folder " +
                           cube_.string()))
      << outcome.err;
}

TEST_F(CliFetch, ASignalLeavesNothing) {
  const fs::path said = folder_ / "said", download = fetched("/download");
  const pid_t process = ::fork();
  if (process == 0) {
    std::signal(SIGINT, SIG_DFL);
    static_cast<void>(!std::freopen(said.c_str(), "w", stderr));
    ::execl(tested_cli().c_str(), "alphascope-cli", "info", "pdb:1slo", nullptr);
    ::_exit(127);
  }
  // The folder is made before the server is asked.
  for (int k = 0; k < 500 && !fs::exists(download); ++k) ::usleep(20'000);
  ::usleep(100'000);
  ::kill(process, SIGINT);
  int status = 0;
  ASSERT_EQ(::waitpid(process, &status, 0), process);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 130) << status;
  EXPECT_EQ(contents(said), "alphascope-cli: cancelled; nothing was written.\n");
  EXPECT_TRUE(fs::is_empty(download));
}

TEST_F(CliFetch, FetchNamesAndCopiesFiles) {
  const std::string file = fetched("/download/1GOD.cif.gz").string();
  Outcome outcome = run("fetch pdb:1god 1god af:p69905");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, file + "\n" + file + "\n" +
                             fetched("/files/AF-P69905-F1-model_v6.cif").string() + "\n");
  const std::string packed = (folder_ / "copy.cif.gz").string();
  const std::string plain = (folder_ / "copy.cif").string();
  outcome = run("fetch pdb:1god -o '" + packed + "'");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(
      contains(outcome.out, "fetched     " + server_->address() + "/download/1GOD.cif.gz at "))
      << outcome.out;
  EXPECT_EQ(contents(packed), contents(file));
  EXPECT_EQ(run("fetch pdb:1god -o '" + plain + "' -q").out, "");
  EXPECT_TRUE(contents(plain).starts_with("data_TEST\n"));
  EXPECT_EQ(run("fetch pdb:1god -o -").out, contents(plain));
  write("copy.cif", "mine");
  outcome = run("fetch pdb:1god -o '" + plain + "'");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(contains(outcome.err, "this file exists. Give another name")) << outcome.err;
  EXPECT_EQ(contents(plain), "mine");
  EXPECT_EQ(run("fetch af:p69905 -o '" + (folder_ / "a.cif.gz").string() + "'").code, 2);
  EXPECT_EQ(run("fetch pdb:1god -o '" + (folder_ / "a.pdb").string() + "'").code, 2);
  EXPECT_EQ(run("fetch cube.xyzr").code, 2);
  EXPECT_EQ(run("fetch pdb:9zzz -o '" + (folder_ / "c.cif").string() + "'").code, 3);
  for (const char* name : {"a.cif.gz", "a.pdb", "c.cif"}) {
    EXPECT_FALSE(fs::exists(folder_ / name)) << name;
  }
}

TEST_F(CliFetch, TheProgramStartsWithoutTheLibrary) {
  const fs::path out = folder_ / "libraries";
  ASSERT_EQ(
      std::system(
          ("LD_TRACE_LOADED_OBJECTS=1 '" + tested_cli() + "' >'" + out.string() + "'").c_str()),
      0);
  EXPECT_FALSE(contains(contents(out), "curl")) << contents(out);
}

}  // namespace
}  // namespace alphascope::testing
