// SPDX-License-Identifier: GPL-3.0-or-later
// Tests which texts are ids, and that no other text becomes part of an address.
#include "core/document/fetch/molecule_id.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace alphascope {
namespace {

namespace fs = std::filesystem;

std::string id_in(const std::string& typed) {
  const auto id = molecule_id(typed);
  return id ? id->text() : "";
}

TEST(MoleculeId, IsReadInAnyCase) {
  EXPECT_EQ(id_in("pdb:1CRN"), "pdb:1CRN");
  EXPECT_EQ(id_in("PDB:4hhB"), "pdb:4HHB");
  EXPECT_EQ(id_in("1crn"), "pdb:1CRN");
  EXPECT_TRUE(molecule_id("1crn")->without_name);
  EXPECT_FALSE(molecule_id("pdb:1crn")->without_name);
  EXPECT_EQ(molecule_id("pdb:1crn")->typed, "pdb:1crn");
  EXPECT_EQ(id_in("pdb:pdb_00001crn"), "pdb:1CRN");
  EXPECT_EQ(id_in("PDB_00001CRN"), "pdb:1CRN");
  EXPECT_EQ(id_in("pdb:PDB_10001CRN"), "pdb:pdb_10001crn");
  EXPECT_EQ(id_in("pdb_00000crn"), "pdb:pdb_00000crn");  // no id of four characters
  EXPECT_EQ(id_in("af:P69905"), "af:P69905");
  EXPECT_EQ(id_in("AF:p69905"), "af:P69905");
  EXPECT_EQ(id_in("af:A0A023GPI8"), "af:A0A023GPI8");
}

TEST(MoleculeId, OtherTextsAreNamesOfFiles) {
  for (const char* name : {"", "-", "1crn.pdb", "crn1", "0crn", "1cr", "1crnn", "1cr n", "1cr\n",
                           "P69905", "pdb", "a/1crn", "1cr/", "1cr.", "pdb_1crn", "pdb_00001crnx",
                           "pdbx_0001crn", "1c\xC3\xA9", "AF-P69905-F1"}) {
    EXPECT_EQ(molecule_id(name), std::nullopt) << name;
  }
}

TEST(MoleculeId, NothingElseIsTakenAfterAnArchive) {
  const std::string nul("pdb:1CR\0", 8), longest = "pdb:" + std::string(100'000, '1');
  for (const std::string& typed : {std::string("pdb:"),
                                   std::string("pdb:../../etc"),
                                   std::string("pdb:1AB%2F"),
                                   std::string("pdb:1ABC/"),
                                   std::string("pdb:1ABC\n"),
                                   std::string("pdb: 1ABC"),
                                   std::string("pdb:1AB?"),
                                   std::string("pdb:1AB#"),
                                   std::string("pdb:1AB\xC3\xA9"),
                                   std::string("pdb:1ABC-assembly1"),
                                   std::string("pdb:\xEF\xBC\x91"
                                               "ABC"),
                                   nul,
                                   longest,
                                   std::string("pdb:pdb_0000../."),
                                   std::string("pdb:P69905"),
                                   std::string("af:"),
                                   std::string("af:1CRN"),
                                   std::string("af:P69905-2"),
                                   std::string("af:P6990%"),
                                   std::string("af:../P69905"),
                                   std::string("af:P69905\n"),
                                   std::string("af:A0A023GPI"),
                                   std::string("af:O6990X")}) {
    try {
      molecule_id(typed);
      ADD_FAILURE() << typed;
    } catch (const InvalidId& error) {
      const std::string said = error.what();
      EXPECT_TRUE(error.rule.starts_with("The part after ")) << error.rule;
      EXPECT_EQ(error.rule.find("--"), error.rule.npos) << "options are for the command line";
      EXPECT_NE(said.find("is not a valid "), said.npos) << said;
      EXPECT_EQ(said.find('\n'), said.npos) << said;
      EXPECT_LT(said.size(), 400u);
    }
  }
}

TEST(MoleculeId, AFileWins) {
  const fs::path folder = fs::path(::testing::TempDir()) / "alphascope_ids";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const fs::path before = fs::current_path();
  fs::current_path(folder);
  EXPECT_TRUE(molecule_id_unless_file("1crn"));
  std::ofstream("1crn") << "x";
  std::ofstream("pdb:nothing") << "x";
  EXPECT_FALSE(molecule_id_unless_file("1crn"));
  EXPECT_FALSE(molecule_id_unless_file("pdb:nothing"));
  fs::create_symlink("missing", "2crn");
  EXPECT_FALSE(molecule_id_unless_file("2crn"));
  fs::create_directory("3crn");
  EXPECT_FALSE(molecule_id_unless_file("3crn"));
  EXPECT_THROW(molecule_id_unless_file("pdb:" + std::string(5000, 'x')), std::invalid_argument);
  fs::current_path(before);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace alphascope
