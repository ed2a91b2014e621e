// SPDX-License-Identifier: GPL-3.0-or-later
// Tests fetching through the real library, from a server of our own that behaves well and badly.
#include "app/session/net_library.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "core/files/atomic_file.hpp"
#include "core/files/read_error.hpp"
#include "core/read/read_molecule.hpp"
#include "tests/support/fetch_server.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class Fetch : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    testing::forget_network_variables();
    server_ = std::make_unique<testing::FetchServer>();
  }
  static void TearDownTestSuite() { server_.reset(); }

  void SetUp() override {
    std::string pattern = (fs::path(::testing::TempDir()) / "alphascope_fetch_XXXXXX").string();
    options_.folder = ::mkdtemp(pattern.data());
    options_.base = server_->address();
    options_.user_agent = "alphascope/test";
    options_.connect_milliseconds = options_.stall_seconds * 1000;
    options_.get = transfer_of_library({ALPHASCOPE_NET_LIBRARY_FILE});
  }
  void TearDown() override { fs::remove_all(options_.folder); }

  FetchedMolecule fetch(const std::string& typed) const {
    return fetch_molecule(molecule_id(typed).value(), options_, context_);
  }

  // The fetch fails with a sentence that has the id and `part`, and nothing is kept.
  void expect_failure(const std::string& typed, const std::string& part) const {
    try {
      fetch(typed);
      ADD_FAILURE() << typed << " was fetched";
    } catch (const ReadError& error) {
      const std::string said = error.what();
      EXPECT_TRUE(said.starts_with(typed + ": ")) << said;
      EXPECT_NE(said.find(part), std::string::npos) << typed << ": " << said;
      EXPECT_FALSE(error.remedy().empty()) << said;
    }
    EXPECT_EQ(files(".cif"), 0) << typed;
    EXPECT_EQ(files(".gz"), 0) << typed;
  }

  int files(const std::string& ending) const {
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(options_.folder)) {
      if (entry.is_regular_file() && entry.path().string().ends_with(ending)) ++count;
    }
    return count;
  }

  static inline std::unique_ptr<testing::FetchServer> server_;
  FetchOptions options_;
  RunContext context_;
};

TEST_F(Fetch, GivesTheFileWithItsAddressAndTime) {
  const FetchedMolecule fetched = fetch("pdb:1god");
  const std::string address = server_->address() + "/download/1GOD.cif.gz";
  EXPECT_EQ(fetched.file, fetched_file_path(options_.folder, address));
  EXPECT_EQ(fetched.from.address, address);
  EXPECT_EQ(fetched.from.time.size(), 20u) << fetched.from.time;
  EXPECT_EQ(read_molecule(fetched.file).atoms.size(), 2u);
  // The long form of the id is the same entry.
  EXPECT_EQ(fetch("pdb:PDB_00001god").file, fetched.file);
  EXPECT_EQ(files(""), 1) << "no temporary file";
}

TEST_F(Fetch, FollowsTheListOfModels) {
  const FetchedMolecule fetched = fetch("AF:p69905");
  EXPECT_EQ(fetched.from.address, server_->address() + "/files/AF-P69905-F1-model_v6.cif");
  EXPECT_EQ(read_molecule(fetched.file).atoms.size(), 2u);
}

TEST_F(Fetch, AsksOnceAndAgainOnRequest) {
  const fs::path file = fetch("pdb:1CNT").file;
  EXPECT_EQ(fetch("pdb:1CNT").file, file);
  options_.again = true;
  EXPECT_THROW(fetch("pdb:1CNT"), ReadError);  // the server now has an error
  EXPECT_TRUE(fs::exists(file)) << "a failure must keep the old file";
  options_.again = false;
  options_.offline = true;
  EXPECT_EQ(fetch("pdb:1CNT").file, file);
}

TEST_F(Fetch, ReplacesAFileThatWasRead) {
  const fs::path file = fetch("pdb:1GOD").file;
  read_molecule(file);
  fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(48));
  const std::string before = fetch("pdb:1GOD").from.time;
  options_.again = true;
  EXPECT_GT(fetch("pdb:1GOD").from.time, before);
}

TEST_F(Fetch, RefusesWhatIsNotTheWholeFile) {
  expect_failure("pdb:1BRK", "broke off before the end of the file");
  expect_failure("pdb:1LEN", "cannot be unpacked");
  expect_failure("pdb:1CUT", "cannot be unpacked");
  expect_failure("pdb:1BIG", "sent more than any such file has");
  expect_failure("pdb:1BMB", "cannot be unpacked (this line is longer than");
  expect_failure("pdb:1PAG", "is not packed with gzip");
  expect_failure("pdb:1PGZ", "is not an mmCIF file");
}

TEST_F(Fetch, SaysWhatTheServerAnswered) {
  expect_failure("pdb:9ZZZ", "the PDB has no entry of this id. Check the id.");
  expect_failure("pdb:pdb_10001abc", "the PDB has no entry of this id");
  expect_failure("9zzz", "there is no such file, and pdb:9ZZZ cannot be fetched: the PDB has no");
  expect_failure("pdb:1ERR", "answered with the error 500");
  expect_failure("pdb:1MNY", "asks for fewer requests (429)");
  expect_failure("af:Q99999", "AlphaFold DB has no model of this accession");
  expect_failure("af:P00001", "an answer that is not a list of models");
  expect_failure("af:P00002", "names no model of this accession on its own server");
  expect_failure("af:P00003", "an answer that is not a list of models");
  expect_failure("af:P00004", "names no model of this accession on its own server");
  expect_failure("af:P00005", "names no model of this accession on its own server");
  expect_failure("af:P00006", "an answer that is not a list of models");
  expect_failure("af:P00007", "an answer that is not a list of models");
}

TEST_F(Fetch, FollowsSafeRedirectsOnly) {
  EXPECT_EQ(read_molecule(fetch("pdb:1RED").file).atoms.size(), 2u);
  fs::remove_all(options_.folder);
  fs::create_directory(options_.folder);
  expect_failure("pdb:1HTP", "redirects to an address that is not https");
  expect_failure("pdb:1FIL", "redirects to an address that is not https");
  expect_failure("pdb:1LOP", "redirects again and again");
}

TEST_F(Fetch, ChecksCertificates) {
  if (server_->tls_address().empty()) GTEST_SKIP() << "openssl is not installed";
  expect_failure("pdb:1TLS", "is not safe (");
  options_.base = server_->tls_address();
  expect_failure("pdb:1GOD", "is not safe (");
}

TEST_F(Fetch, EndsWhenNothingArrives) {
  options_.stall_seconds = 1;
  const auto start = Clock::now();
  expect_failure("pdb:1SLO", "sent nearly nothing for 1 s");
  EXPECT_LT(seconds_since(start), 10);
}

TEST_F(Fetch, EndsSoonAfterACancel) {
  // On a busy machine a thread may wait for its turn, so the best of three tries counts.
  double late = 1;
  std::string stage;
  for (int tries = 0; tries < 3 && late > 0.1; ++tries) {
    Clock::time_point cancelled;
    context_ = {};
    context_.progress = [&](std::string_view said, double) { stage = said; };
    std::thread other([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
      cancelled = Clock::now();
      context_.cancel.cancel();
    });
    EXPECT_THROW(fetch("pdb:1SLO"), Cancelled);
    const Clock::time_point end = Clock::now();
    other.join();
    late = std::chrono::duration<double>(end - cancelled).count();
  }
  EXPECT_LT(late, 0.1);
  EXPECT_EQ(stage, "fetching pdb:1SLO");
  EXPECT_EQ(files(""), 0);
}

TEST_F(Fetch, SaysThatThereIsNoConnection) {
  options_.base = "http://127.0.0.1:1";
  expect_failure("pdb:1GOD", "127.0.0.1:1 cannot be reached (");
  options_.base = "";
  ::setenv("https_proxy", "http://127.0.0.1:1", 1);
  expect_failure("pdb:1GOD", "files.rcsb.org cannot be reached (");
  expect_failure("af:P69905", "alphafold.ebi.ac.uk cannot be reached (");
  ::unsetenv("https_proxy");
  options_.offline = true;
  expect_failure("pdb:1GOD", "it was not fetched before, and nothing is fetched now (--offline");
}

TEST_F(Fetch, GoesThroughTheProxy) {
  options_.base = "http://localhost:1";
  ::setenv("http_proxy", server_->address().c_str(), 1);
  EXPECT_EQ(fetch("pdb:1PRX").from.address, "http://localhost:1/download/1PRX.cif.gz");
  ::unsetenv("http_proxy");
}

TEST_F(Fetch, SaysThatTheFileCannotBeKept) {
  const fs::path folder = options_.folder;
  std::ofstream(folder / "file") << "no folder";
  options_.folder = folder / "file" / "alphascope";
  try {
    fetch("pdb:1GOD");
    ADD_FAILURE();
  } catch (const WriteError& error) {
    const std::string said = error.what();
    EXPECT_TRUE(said.starts_with("pdb:1GOD: the fetched file cannot be kept. ")) << said;
    EXPECT_NE(said.find("XDG_CACHE_HOME can name another folder than "), said.npos) << said;
  }
  options_.folder = "";
  try {
    fetch("pdb:1GOD");
    ADD_FAILURE();
  } catch (const ReadError& error) {
    EXPECT_NE(std::string(error.what()).find("neither XDG_CACHE_HOME nor HOME names one"),
              std::string::npos);
  }
  options_.folder = folder;
}

TEST_F(Fetch, SaysThatTheLibraryIsMissing) {
  options_.get = transfer_of_library({"/nonexistent/alphascope-net.so"});
  expect_failure("pdb:1GOD",
                 "this installation cannot fetch files. No network library was found. Install");
  options_.get = transfer_of_library({ALPHASCOPE_FOREIGN_LIBRARY});
  expect_failure("pdb:1GOD", "is not a network library of Alphascope");
}

}  // namespace
}  // namespace alphascope
