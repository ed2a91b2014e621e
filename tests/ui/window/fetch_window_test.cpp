// SPDX-License-Identifier: GPL-3.0-or-later
// Tests fetching by id in the whole window, through the real library, from a server of our own that
// behaves well and badly.
#include <chrono>
#include <cstdlib>

#include "core/document/fetch/fetch.hpp"
#include "core/files/fetched_file.hpp"
#include "tests/support/fetch_server.hpp"
#include "tests/ui/viewer_fixture.hpp"

namespace alphascope::testing {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class FetchWindow : public ViewerTest {
 protected:
  static void SetUpTestSuite() {
    forget_network_variables();
    server_ = std::make_unique<FetchServer>();
    cache_ = fs::temp_directory_path() / ("alphascope_window_cache_" + std::to_string(getpid()));
    fs::create_directories(cache_);
    ::setenv("ALPHASCOPE_FETCH_BASE", server_->address().c_str(), 1);
    ::setenv("ALPHASCOPE_NET_LIBRARY", ALPHASCOPE_NET_LIBRARY_FILE, 1);
    ::setenv("XDG_CACHE_HOME", cache_.c_str(), 1);
  }
  static void TearDownTestSuite() {
    server_.reset();
    forget_network_variables();
    fs::remove_all(cache_);
  }
  void SetUp() override { fs::remove_all(cache_ / "alphascope"); }

  void restart(ViewerOptions options = {}) {
    viewer_.reset();
    host_ = make_egl_host({1100, 700, 1, "test"});
    options.compare = false;
    options.draw_shots_only = true;
    viewer_ = std::make_unique<Viewer>(*host_, options);
  }
  ViewState& state() { return viewer_->state(); }
  bool has(const char* widget) { return viewer_->widgets().contains(widget); }
  static fs::path kept(const std::string& path) {
    return fetched_file_path(cache_ / "alphascope", server_->address() + path);
  }
  static int kept_files() {
    int count = 0;
    std::error_code none;
    for (const auto& entry : fs::recursive_directory_iterator(cache_ / "alphascope", none)) {
      count += entry.is_regular_file() ? 1 : 0;
    }
    return count;
  }
  const RunningJob* fetching() {
    for (const RunningJob& job : state().jobs) {
      if (job.id == JobId::fetching) return &job;
    }
    return nullptr;
  }
  // Draws frames until the transfer is listed, and so long that its server has answered.
  void begin(const std::string& id) {
    run("file.fetch " + id + "\n");
    const Clock::time_point start = Clock::now();
    while (seconds_since(start) < 0.3 || fetching() == nullptr) {
      viewer_->step(nullptr);
      ASSERT_LT(seconds_since(start), 20);
    }
  }
  std::string provenance(const std::string& key) {
    for (const auto& [name, value] : state().molecule.provenance) {
      if (name == key) return value;
    }
    return {};
  }
  std::vector<Choice> recent_files() {
    return viewer_->commands().find("file.recent")->first_required()->choices();
  }

  static inline std::unique_ptr<FetchServer> server_;
  static inline fs::path cache_;
};

TEST_F(FetchWindow, TheDialogFetchesAndOpens) {
  run("key ctrl+shift+f\nframes 3\n");
  EXPECT_TRUE(has("fetch.help"));
  run("type 1god\nframes 3\n");
  EXPECT_TRUE(has("fetch.ready"));
  EXPECT_TRUE(has("fetch.server"));
  run("click fetch.ok\nwait-idle\n");
  EXPECT_EQ(state().error, "");
  EXPECT_EQ(state().molecule.name, "1GOD.cif.gz");
  EXPECT_EQ(state().molecule.balls, 2u);
  EXPECT_FALSE(state().fetch.show);
  const std::string from = provenance("Fetched");
  EXPECT_TRUE(from.starts_with(server_->address() + "/download/1GOD.cif.gz at 2")) << from;
  // The list of recent files has the id, and no dialog begins in the folder of fetched files.
  EXPECT_EQ(recent_files().at(0).title, "pdb:1GOD");
  EXPECT_EQ(state().browser.folder.string().find(cache_.string()), std::string::npos);
  run("key ctrl+shift+s\nframes 3\n");
  EXPECT_EQ(state().dialogs.session_path.find(cache_.string()), std::string::npos)
      << state().dialogs.session_path;
  run("key esc\nframes 2\nkey esc\nframes 2\nkey ctrl+shift+f\nframes 3\ntype pdb_00001GOD\nframes "
      "3\n");
  EXPECT_TRUE(has("fetch.before")) << "the long id is the same entry";
}

TEST_F(FetchWindow, AModelIsFetchedByItsAccession) {
  run("file.fetch af:p69905\nwait-idle\n");
  EXPECT_EQ(state().error, "");
  EXPECT_EQ(state().molecule.name, "AF-P69905-F1-model_v6.cif");
  EXPECT_EQ(recent_files().at(0).title, "af:P69905");
}

TEST_F(FetchWindow, ASlowTransferBlocksNothingAndEndsSoonAfterACancel) {
  // On a busy machine a thread may wait for its turn, so the best of three tries counts.
  double late = 1, longest = 1;
  for (int tries = 0; tries < 3 && (late > 0.1 || longest > 0.1); ++tries) {
    begin("1slo");
    longest = 0;
    for (const Clock::time_point start = Clock::now(); seconds_since(start) < 0.5;) {
      const Clock::time_point before = Clock::now();
      viewer_->step(nullptr);
      longest = std::max(longest, seconds_since(before));
    }
    ASSERT_NE(fetching(), nullptr);
    EXPECT_EQ(fetching()->title, "Fetching pdb:1SLO");
    EXPECT_TRUE(viewer_->busy()) << "scripts wait for the file";
    const Clock::time_point cancelled = Clock::now();
    run("key esc\n");
    while (viewer_->busy() && seconds_since(cancelled) < 20) viewer_->step(nullptr);
    late = seconds_since(cancelled);
  }
  EXPECT_LT(late, 0.1);
  EXPECT_LT(longest, 0.1);
  EXPECT_EQ(state().notice.text(), "Fetching pdb:1SLO was cancelled.");
  EXPECT_FALSE(state().molecule.loaded);
  EXPECT_EQ(kept_files(), 0);
}

TEST_F(FetchWindow, AFailureIsToldAndLeavesTheMolecule) {
  open_crambin();
  const std::pair<const char*, const char*> cases[] = {
      {"pdb:1BRK", "broke off before the end of the file"},
      {"pdb:9ZZZ", "the PDB has no entry of this id. Check the id."},
      {"pdb:1PAG", "is not packed with gzip"},
      {"af:Q99999", "AlphaFold DB has no model of this accession"}};
  for (const auto& [id, why] : cases) {
    run("file.fetch " + std::string(id) + "\nwait-idle\nframes 2\n");
    EXPECT_EQ(state().error_title, std::string(id) + " cannot be fetched");
    EXPECT_NE(state().error.find(why), std::string::npos) << state().error;
    EXPECT_EQ(state().error.find("no such file"), std::string::npos) << state().error;
    run("click error.ok\nframes 2\n");
    EXPECT_EQ(state().error, "");
  }
  EXPECT_EQ(state().molecule.name, "1crn.pdb");
  EXPECT_EQ(kept_files(), 0);
}

TEST_F(FetchWindow, OfflineOnlyFilesFetchedBeforeAreOpened) {
  run("file.fetch 1god\nwait-idle\n");
  ViewerOptions offline;
  offline.offline = true;
  restart(offline);
  run("key ctrl+shift+f\nframes 3\ntype 1cnt\nframes 3\n");
  EXPECT_TRUE(has("fetch.offline"));
  run("click fetch.ok\nwait-idle\n");
  EXPECT_FALSE(state().molecule.loaded);
  EXPECT_TRUE(state().fetch.show) << "the button is off";
  run("click fetch.id\nkey ctrl+a\ntype 1god\nframes 3\n");
  EXPECT_TRUE(has("fetch.before"));
  run("key enter\nwait-idle\n");
  EXPECT_EQ(state().molecule.name, "1GOD.cif.gz");
  run("file.fetch 1cnt\nwait-idle\n");
  EXPECT_NE(state().error.find("nothing is fetched now (--offline"), std::string::npos)
      << state().error;
}

TEST_F(FetchWindow, NothingButAnIdIsAsked) {
  const Commands& commands = viewer_->commands();
  for (const char* hostile : {"pdb:../../etc/passwd", "pdb:1ab%2f", "af:P69905/..", "../1god",
                              "http://example.org/1GOD.cif.gz", "1god\n", "pdb:", "x y"}) {
    const Outcome outcome = commands.run("file.fetch", {hostile});
    if (std::string(hostile) == "1god\n") {
      EXPECT_TRUE(outcome.done()) << "blanks around an id are left out";
      run("wait-idle\n");
      fs::remove_all(cache_ / "alphascope");
      continue;
    }
    EXPECT_EQ(outcome.state, Outcome::State::refused) << hostile;
    EXPECT_NE(outcome.why.find("not a valid "), std::string::npos) << outcome.why;
    EXPECT_EQ(outcome.why.find("--assembly"), std::string::npos) << outcome.why;
  }
  EXPECT_EQ(commands.run("file.fetch", {"P69905"}).why,
            "This is an accession of UniProt. Its model is af:P69905.");
  run("key ctrl+shift+f\nframes 3\ntype pdb:../../x\nframes 3\n");
  EXPECT_TRUE(has("fetch.fault"));
  run("key enter\nclick fetch.ok\nwait-idle\n");
  EXPECT_TRUE(state().fetch.show);
  EXPECT_EQ(kept_files(), 0);
}

TEST_F(FetchWindow, AWrongIdIsCorrectedAtOnceAfterEnter) {
  run("key ctrl+shift+f\nframes 3\ntype 1go\nframes 3\nkey enter\nframes 3\n");
  EXPECT_TRUE(state().fetch.show);
  EXPECT_TRUE(has("fetch.fault"));
  run("type d\nframes 3\n");
  EXPECT_EQ(state().fetch.field.text, "1god");
  run("key enter\nwait-idle\n");
  EXPECT_FALSE(state().fetch.show);
  EXPECT_EQ(state().molecule.name, "1GOD.cif.gz");
}

TEST_F(FetchWindow, TheLatestRequestWins) {
  begin("1slo");
  run("open " + crambin().string() + "\nwait-idle\n");
  EXPECT_EQ(state().molecule.name, "1crn.pdb");
  EXPECT_EQ(state().notice.text(), "");
  begin("1slo");
  run("file.fetch 1god\nwait-idle\n");
  EXPECT_EQ(state().molecule.name, "1GOD.cif.gz");
  EXPECT_EQ(state().error, "");
}

TEST_F(FetchWindow, TheProgramTakesAnIdInPlaceOfAFile) {
  const auto parsed = [](std::vector<const char*> words) {
    words.insert(words.begin(), "alphascope");
    return parse_options(static_cast<int>(words.size()), words.data());
  };
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  ParsedOptions options = parsed({"1god", "--fetch-again"});
  ASSERT_TRUE(options.options.id);
  EXPECT_EQ(options.options.id->text(), "pdb:1GOD");
  EXPECT_FALSE(options.options.file);
  std::ofstream("1god") << "x";
  EXPECT_FALSE(parsed({"1god"}).options.id) << "a file of that name wins";
  EXPECT_EQ(parsed({"1god"}).options.file, "1god");
  fs::current_path(before);
  EXPECT_EQ(parsed({"pdb:../x"}).exit_code, 2);
  EXPECT_EQ(parsed({"1god", "--offline", "--fetch-again"}).exit_code, 2);
  restart(options.options);
  run("wait-idle\n");
  EXPECT_EQ(state().molecule.name, "1GOD.cif.gz");
  // --fetch-again asks the server although the file is there; this one answers only once.
  restart(parsed({"1cnt"}).options);
  run("wait-idle\n");
  EXPECT_EQ(state().error, "");
  restart(parsed({"1cnt", "--fetch-again"}).options);
  run("wait-idle\n");
  EXPECT_NE(state().error.find("answered with the error 500"), std::string::npos) << state().error;
  restart(parsed({"1cnt"}).options);
  run("wait-idle\n");
  EXPECT_EQ(state().molecule.name, "1CNT.cif.gz") << "a failure keeps the old file";
}

TEST_F(FetchWindow, AWrongBaseAddressIsTold) {
  ::setenv("ALPHASCOPE_FETCH_BASE", "http://example.org", 1);
  restart();
  ::setenv("ALPHASCOPE_FETCH_BASE", server_->address().c_str(), 1);
  run("file.fetch 1god\nwait-idle\n");
  EXPECT_NE(state().error.find("ALPHASCOPE_FETCH_BASE is not an address"), std::string::npos);
  EXPECT_FALSE(state().molecule.loaded);
}

TEST_F(FetchWindow, ASessionFetchesItsMoleculeAgain) {
  const std::string session = (folder_ / "s.json").string();
  run("file.fetch 1god\nwait-idle\nalpha.set 2\nfile.save_session " + session + "\nwait-idle\n");
  EXPECT_EQ(state().error, "");
  fs::remove_all(cache_ / "alphascope");
  restart();
  run("file.open_session " + session + "\nwait-idle\nframes 3\n");
  ASSERT_TRUE(state().session_problem.has_value());
  EXPECT_EQ(state().session_problem->id, "pdb:1GOD");
  run("click session.fetch\nwait-idle\n");
  EXPECT_FALSE(state().session_problem.has_value());
  EXPECT_EQ(state().molecule.name, "1GOD.cif.gz");
  EXPECT_EQ(state().settings.request.alpha_angstrom2, 2);
  EXPECT_EQ(state().drop_note, "");
  // A failure leaves the question open.
  fs::remove_all(cache_ / "alphascope");
  ViewerOptions offline;
  offline.offline = true;
  restart(offline);
  run("file.open_session " + session + "\nwait-idle\nframes 3\nclick session.fetch\nwait-idle\n");
  EXPECT_EQ(state().error_title, "pdb:1GOD cannot be fetched");
  EXPECT_TRUE(state().session_problem.has_value());
}

TEST_F(FetchWindow, ARecentEntryIsFetchedAgain) {
  run("file.fetch 1god\nwait-idle\n");
  fs::remove(kept("/download/1GOD.cif.gz"));
  open_crambin();
  const std::string file = recent_files().at(1).id;
  EXPECT_EQ(file, kept("/download/1GOD.cif.gz").string());
  run("file.recent \"" + file + "\"\nwait-idle\n");
  EXPECT_EQ(state().error, "");
  EXPECT_EQ(state().molecule.name, "1GOD.cif.gz");
}

}  // namespace
}  // namespace alphascope::testing
