// SPDX-License-Identifier: GPL-3.0-or-later
// Tests listings of folders: order, filters and errors.
#include "ui/panels/dialogs/folder_listing.hpp"

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
  const FolderListing listing = list_folder({folder_});
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
  EXPECT_EQ(list_folder({folder_, true}).entries.size(), 5u);
}

TEST_F(FolderListingTest, HiddenOnesOnRequest) {
  const FolderListing listing = list_folder({folder_, false, true});
  ASSERT_EQ(listing.entries.size(), 6u);
  EXPECT_EQ(listing.entries[0].name, ".hidden");
  EXPECT_EQ(listing.entries[2].name, ".secret.pdb");
}

TEST_F(FolderListingTest, CanBeCancelled) {
  CancelToken cancel;
  cancel.cancel();
  EXPECT_THROW(list_folder({folder_}, cancel), Cancelled);
}

TEST_F(FolderListingTest, FindsByTheBeginningOfAName) {
  const FolderListing listing = list_folder({folder_});  // Zoo, a.pdb.gz, b.PDB, C.crd
  EXPECT_EQ(find_entry(listing, "B.p", 0), 2u);
  EXPECT_EQ(find_entry(listing, "z", 2), 0u) << "around the end";
  EXPECT_EQ(find_entry(listing, "c", 3), 3u);
  EXPECT_EQ(find_entry(listing, "nothing", 0), 4u);
  EXPECT_EQ(find_entry({}, "a", 0), 0u);
}

TEST_F(FolderListingTest, SaysWhyAPathCannotBeOpened) {
  EXPECT_EQ(why_not_openable(folder_ / "b.PDB"), "");
  EXPECT_EQ(why_not_openable(folder_ / "no.pdb"),
            "There is no file or folder " + (folder_ / "no.pdb").string() + ".");
  EXPECT_EQ(why_not_openable(folder_ / "none" / "no.pdb"),
            "There is no folder " + (folder_ / "none").string() + ".");
  EXPECT_EQ(why_not_openable("/dev/null"), "/dev/null is not a file.");
  if (geteuid() == 0) return;  // root may read everything
  fs::permissions(folder_ / "b.PDB", fs::perms::none);
  EXPECT_NE(why_not_openable(folder_ / "b.PDB").find("permission"), std::string::npos);
}

TEST(DroppedFiles, TheFirstMoleculeIsOpenedAndAllAreTold) {
  EXPECT_FALSE(choose_dropped({}).opened);
  EXPECT_EQ(choose_dropped({"/a/notes.txt"}).opened, "/a/notes.txt") << "the reader says why not";
  EXPECT_EQ(choose_dropped({"/a/x.pdb"}).note, "");
  const DroppedFiles several = choose_dropped({"/a/notes.txt", "/a/x.pdb", "/b/y.cif.gz"});
  EXPECT_EQ(several.opened, "/a/x.pdb");
  EXPECT_EQ(several.note,
            "Opened: x.pdb\nNot opened: notes.txt (its name is not that of a molecule)\n"
            "Not opened: y.cif.gz\nThe window shows one molecule at a time.");
  std::vector<fs::path> many(20, "/a/z.pdb");
  EXPECT_NE(choose_dropped(many).note.find("and 11 more"), std::string::npos);
}

TEST(FileSize, HasADigitAfterThePoint) {
  EXPECT_EQ(file_size_text(0), "0 bytes");
  EXPECT_EQ(file_size_text(1), "1 byte");
  EXPECT_EQ(file_size_text(999), "999 bytes");
  EXPECT_EQ(file_size_text(1000), "1.0 kB");
  EXPECT_EQ(file_size_text(49'248), "49.2 kB");
  EXPECT_EQ(file_size_text(143'000), "143 kB");
  EXPECT_EQ(file_size_text(999'949), "1.0 MB");
  EXPECT_EQ(file_size_text(1'182'136), "1.2 MB");
  EXPECT_EQ(file_size_text(3'849'670'000), "3.8 GB");
}

TEST(FolderListing, SaysWhyAFolderCannotBeRead) {
  const FolderListing listing = list_folder({"/no/such/folder"});
  EXPECT_TRUE(listing.entries.empty());
  EXPECT_NE(listing.error.find("No such file"), std::string::npos) << listing.error;
}

TEST(FolderListing, StartsSomewhereThatExists) {
  EXPECT_TRUE(fs::is_directory(sensible_start_folder()));
}

}  // namespace
}  // namespace alphascope
