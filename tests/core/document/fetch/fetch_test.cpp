// SPDX-License-Identifier: GPL-3.0-or-later
// Tests addresses and the folder of fetched files. Transfers are tested with the library that makes
// them (tests/app/session/net_library_test.cpp).
#include "core/document/fetch/fetch.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace alphascope {
namespace {

namespace fs = std::filesystem;

TEST(FetchAddress, IsLoopback) {
  for (const char* address : {"http://127.0.0.1", "http://127.0.0.1:80", "https://localhost:1/a:b",
                              "http://[::1]:80/x", "http://[::1]"}) {
    EXPECT_TRUE(is_loopback(address)) << address;
  }
  for (const char* address :
       {"", "127.0.0.1", "ftp://127.0.0.1", "http://127.0.0.1.example.org", "http://example.org",
        "http://localhost@example.org", "http://localhost:80@example.org", "http://127.0.0.2",
        "http://localhost:x", "http://[::1", "http://[::2]:80", "file:///etc"}) {
    EXPECT_FALSE(is_loopback(address)) << address;
  }
}

TEST(FetchAddress, OfThePublicServersIsSafe) {
  std::string asked;
  FetchOptions options;
  options.folder = fs::path(::testing::TempDir()) / "alphascope_addresses";
  options.get = [&](const TransferRequest& request, const RunContext&) {
    asked = request.address;
    return TransferAnswer{.end = TransferEnd::answered, .status = 404};
  };
  const auto address = [&](const char* typed) {
    EXPECT_ANY_THROW(fetch_molecule(*molecule_id(typed), options, {}));
    return asked;
  };
  EXPECT_EQ(address("1crn"), "https://files.rcsb.org/download/1CRN.cif.gz");
  EXPECT_EQ(address("pdb:pdb_10001crn"), "https://files.rcsb.org/download/pdb_10001crn.cif.gz");
  EXPECT_EQ(address("af:p69905"), "https://alphafold.ebi.ac.uk/api/prediction/P69905");
  // A redirect to this computer or away from https is followed for a test's server only.
  options.get = [](const TransferRequest&, const RunContext&) {
    return TransferAnswer{
        .end = TransferEnd::answered, .status = 302, .redirect = "http://127.0.0.1/x"};
  };
  try {
    fetch_molecule(*molecule_id("1crn"), options, {});
    ADD_FAILURE();
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find("not https"), std::string::npos) << error.what();
  }
  fs::remove_all(options.folder);
}

TEST(FetchOptions, ComeFromTheEnvironment) {
  ::setenv("ALPHASCOPE_FETCH_BASE", "http://127.0.0.1:8080", 1);
  ::setenv("ALPHASCOPE_OFFLINE", "1", 1);
  ::setenv("XDG_CACHE_HOME", "/some/cache", 1);
  EXPECT_EQ(fetch_options_of_environment().base, "http://127.0.0.1:8080");
  EXPECT_TRUE(fetch_options_of_environment().offline);
  EXPECT_EQ(fetch_options_of_environment().folder, "/some/cache/alphascope");
  ::setenv("ALPHASCOPE_OFFLINE", "0", 1);
  EXPECT_FALSE(fetch_options_of_environment().offline);
  for (const char* base : {"http://example.org", "http://127.0.0.1:80/path", "127.0.0.1"}) {
    ::setenv("ALPHASCOPE_FETCH_BASE", base, 1);
    EXPECT_THROW(fetch_options_of_environment(), std::invalid_argument) << base;
  }
  ::unsetenv("ALPHASCOPE_FETCH_BASE");
  ::unsetenv("ALPHASCOPE_OFFLINE");
  ::setenv("XDG_CACHE_HOME", "relative", 1);
  const std::string home = std::getenv("HOME") != nullptr ? std::getenv("HOME") : "";
  ::setenv("HOME", "/home/somebody", 1);
  EXPECT_EQ(fetched_files_folder(), "/home/somebody/.cache/alphascope");
  ::unsetenv("HOME");
  EXPECT_EQ(fetched_files_folder(), "");
  ::unsetenv("XDG_CACHE_HOME");
  if (!home.empty()) ::setenv("HOME", home.c_str(), 1);
}

TEST(FetchedFile, TellsItsAddress) {
  const fs::path folder = fs::path(::testing::TempDir()) / "alphascope_fetched";
  const std::string address = "https://files.rcsb.org/download/1CRN.cif.gz";
  const fs::path file = fetched_file_path(folder, address);
  EXPECT_EQ(file, folder / "https/files.rcsb.org/download/1CRN.cif.gz");
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "x";
  std::ofstream(folder / "other") << "x";
  ASSERT_TRUE(fetched_from(file, folder));
  EXPECT_EQ(fetched_from(file, folder)->address, address);
  EXPECT_EQ(
      fetched_from(folder / "x" / ".." / "https" / "files.rcsb.org" / "download" / "1CRN.cif.gz",
                   folder)
          ->address,
      address);
  EXPECT_FALSE(fetched_from(folder / "other", folder));
  EXPECT_FALSE(fetched_from(folder / "https/missing", folder));
  EXPECT_FALSE(fetched_from("/etc/passwd", folder));
  EXPECT_FALSE(fetched_from(file, {}));
  fs::remove_all(folder);
}

TEST(FetchedFile, TellsItsId) {
  const auto id = [](const std::string& path) {
    const auto found = id_of_fetched(path);
    return found ? found->text() : std::string();
  };
  const std::string folder = "/home/somebody/.cache/alphascope/";
  EXPECT_EQ(id(folder + "https/files.rcsb.org/download/1CRN.cif.gz"), "pdb:1CRN");
  EXPECT_EQ(id(folder + "https/files.rcsb.org/download/pdb_10001crn.cif.gz"), "pdb:pdb_10001crn");
  EXPECT_EQ(id(folder + "https/alphafold.ebi.ac.uk/files/AF-P69905-F1-model_v6.cif"), "af:P69905");
  EXPECT_EQ(id(folder + "http/127.0.0.1:80/download/1CRN.cif.gz"), "pdb:1CRN");
  for (const char* other :
       {"https/files.rcsb.org/download/1crn.cif.gz", "https/files.rcsb.org/download/1CRN.cif",
        "https/files.rcsb.org/download/crambin.cif.gz", "https/files.rcsb.org/other/1CRN.cif.gz",
        "https/files.example.org/download/1CRN.cif.gz", "http/files.rcsb.org/download/1CRN.cif.gz",
        "https/alphafold.ebi.ac.uk/files/AF-P69905-F2-model_v6.cif",
        "https/alphafold.ebi.ac.uk/files/AF-", "https/alphafold.ebi.ac.uk/files/AF-P69905",
        "https/alphafold.ebi.ac.uk/api/prediction/P69905", "1CRN.cif.gz", ""}) {
    EXPECT_EQ(id(folder + other), "") << other;
  }
  EXPECT_EQ(id("1CRN.cif.gz"), "");
  EXPECT_EQ(id("/"), "");
}

TEST(FetchedFile, IsFoundAgainWithoutAServer) {
  FetchOptions options;
  options.folder = fs::path(::testing::TempDir()) / "alphascope_fetched_before";
  options.again = true;  // which is for the next transfer only
  options.get = [](const TransferRequest&, const RunContext&) -> TransferAnswer {
    throw std::logic_error("a server is asked");
  };
  fs::remove_all(options.folder);
  const MoleculeId pdb = *molecule_id("1crn"), alphafold = *molecule_id("af:P69905");
  EXPECT_FALSE(fetched_before(pdb, options).has_value());
  EXPECT_FALSE(fetched_before(alphafold, options).has_value());
  const auto keep = [&](const std::string& address, const std::string& text) {
    const fs::path file = fetched_file_path(options.folder, address);
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
    return file;
  };
  const fs::path entry = keep("https://files.rcsb.org/download/1CRN.cif.gz", "any");
  const std::string address = server_for(alphafold, options) + "/files/AF-P69905-F1-model_v6.cif";
  keep(server_for(alphafold, options) + "/api/prediction/P69905",
       "[{\"cifUrl\": \"" + address + "\"}]");
  EXPECT_FALSE(fetched_before(alphafold, options).has_value())
      << "only the list of models is there";
  const fs::path model = keep(address, "any");
  ASSERT_TRUE(fetched_before(pdb, options).has_value());
  EXPECT_EQ(fetched_before(pdb, options)->file, entry);
  EXPECT_EQ(fetched_before(pdb, options)->from.time.size(), 20u);
  ASSERT_TRUE(fetched_before(alphafold, options).has_value());
  EXPECT_EQ(fetched_before(alphafold, options)->file, model);
  fs::remove_all(options.folder);
}

}  // namespace
}  // namespace alphascope
