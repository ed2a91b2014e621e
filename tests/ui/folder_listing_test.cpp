#include "ui/panels/folder_listing.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace alphascope {
namespace {

namespace fs = std::filesystem;

class FolderListingTest : public ::testing::Test {
 protected:
  FolderListingTest()
      : folder_(fs::temp_directory_path() / ("alphascope_listing_" + std::to_string(getpid()))) {
    fs::create_directories(folder_ / "Zoo");
    fs::create_directories(folder_ / ".hidden");
    for (const char* name : {"b.PDB", "a.pdb.gz", "notes.txt", ".secret.pdb", "C.crd"}) {
      std::ofstream(folder_ / name) << "12345";
    }
  }
  ~FolderListingTest() override { fs::remove_all(folder_); }
  fs::path folder_;
};

TEST(LooksLikeMolecule, KnowsTheExtensionsPackedOrNot) {
  for (const char* name : {"x.pdb", "x.ENT", "x.cif.gz", "x.xyzr", "x.pqr", "x.xyz", "x.crd.GZ"}) {
    EXPECT_TRUE(looks_like_molecule(name)) << name;
  }
  for (const char* name : {"x.txt", "x.gz", "pdb", "x.pdb.zip", "x"}) {
    EXPECT_FALSE(looks_like_molecule(name)) << name;
  }
}

TEST_F(FolderListingTest, FoldersFirstThenMoleculesByName) {
  const FolderListing listing = list_folder(folder_, false);
  ASSERT_EQ(listing.entries.size(), 4u);
  EXPECT_EQ(listing.entries[0].name, "Zoo");
  EXPECT_TRUE(listing.entries[0].folder);
  EXPECT_EQ(listing.entries[1].name, "a.pdb.gz");
  EXPECT_EQ(listing.entries[1].bytes, 5u);
  EXPECT_EQ(listing.entries[2].name, "b.PDB");
  EXPECT_EQ(listing.entries[3].name, "C.crd");
  EXPECT_EQ(listing.hidden_by_filter, 1u);
}

TEST_F(FolderListingTest, AllFilesOnRequest) {
  EXPECT_EQ(list_folder(folder_, true).entries.size(), 5u);
}

TEST(FolderListing, SaysWhyAFolderCannotBeRead) {
  const FolderListing listing = list_folder("/no/such/folder", false);
  EXPECT_TRUE(listing.entries.empty());
  EXPECT_NE(listing.error.find("No such file"), std::string::npos) << listing.error;
}

TEST(FolderListing, StartsSomewhereThatExists) {
  EXPECT_TRUE(fs::is_directory(sensible_start_folder()));
}

}  // namespace
}  // namespace alphascope
