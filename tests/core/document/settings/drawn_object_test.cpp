// SPDX-License-Identifier: GPL-3.0-or-later
// Tests objects as text, and those of a molecule that is opened.
#include "core/document/settings/drawn_object.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/read/read_molecule.hpp"
#include "core/selection/contents.hpp"

namespace alphascope {
namespace {

TEST(DrawnObject, TextsAreReadAndWritten) {
  for (const char* text :
       {"cartoon", "sticks:ligand", "cartoon,secondary,40%:chain A,B", "points,#ff8800",
        "balls_and_sticks,chain,hidden:within 5 of ligand", "sticks,5%,hidden"}) {
    const ObjectWords words = read_object(text);
    EXPECT_EQ(words.error, "") << text;
    EXPECT_EQ(object_text(words.object), text);
  }
  const DrawnObject object = read_object(" cartoon , 40% ,secondary: chain A ").object;
  EXPECT_EQ(object.kind, ObjectKind::cartoon);
  EXPECT_EQ(object.colour, ObjectColour::secondary);
  EXPECT_FLOAT_EQ(object.opacity, 0.4F);
  EXPECT_EQ(object.atoms, "chain A");
  EXPECT_TRUE(object.shown);
  EXPECT_EQ(object_title(object), "Cartoon of chain A");
}

TEST(DrawnObject, KindsHaveTheirUsualColours) {
  EXPECT_EQ(read_object("cartoon").object.colour, ObjectColour::chain);
  EXPECT_EQ(read_object("sticks").object.colour, ObjectColour::element);
}

TEST(DrawnObject, FaultsNameTheRemedy) {
  EXPECT_NE(read_object("ribbon").error.find("Write cartoon, sticks"), std::string::npos);
  EXPECT_NE(read_object("").error.find("is no object"), std::string::npos);
  for (const char* text : {"cartoon,blue", "cartoon,0%", "cartoon,4%", "cartoon,101%",
                           "cartoon,4x%", "cartoon,", "cartoon,nan%", "cartoon,#12345"}) {
    EXPECT_NE(read_object(text).error.find("5% to 100%"), std::string::npos) << text;
  }
  EXPECT_NE(read_object("sticks:chain").error, "");
}

TEST(DrawnObject, ListsAreSeparatedBySemicolons) {
  EXPECT_TRUE(read_objects("none").objects.empty());
  EXPECT_TRUE(read_objects("  ").objects.empty());
  const ObjectListWords list = read_objects("cartoon; sticks:ligand");
  ASSERT_EQ(list.objects.size(), 2u);
  EXPECT_EQ(objects_text(list.objects), "cartoon; sticks:ligand");
  EXPECT_EQ(objects_text({}), "none");
  EXPECT_NE(read_objects("cartoon; bad").error, "");
  std::string many = "cartoon";
  for (std::size_t i = 0; i < kMostObjects; ++i) many += ";cartoon";
  EXPECT_NE(read_objects(many).error.find("at most 32"), std::string::npos);
}

MoleculeContents sample(const char* file) {
  return contents_of(
      read_molecule(std::filesystem::path(ALPHASCOPE_SOURCE_DIR) / "resources/molecules" / file));
}

TEST(DrawnObject, AProteinOpensWithACartoonAndItsLigands) {
  EXPECT_EQ(objects_text(usual_objects(sample("4hhb.pdb.gz"))), "cartoon; sticks:ligand");
  EXPECT_EQ(objects_text(usual_objects(sample("1crn.pdb"))), "cartoon");
  EXPECT_TRUE(usual_objects(MoleculeContents()).empty());
  MoleculeContents points;  // of a list of points, without residues
  points.kinds[static_cast<std::size_t>(ResidueKind::polymer)] = 5;
  EXPECT_TRUE(usual_objects(points).empty());
}

}  // namespace
}  // namespace alphascope
