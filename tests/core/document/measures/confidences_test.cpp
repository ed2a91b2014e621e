// SPDX-License-Identifier: GPL-3.0-or-later
// Tests confidences (pLDDT) of predicted models, which files store as B factors. Legends, labels
// and JSON call them confidences.
#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "core/document/export/record_json.hpp"
#include "core/document/measures/paint_balls.hpp"
#include "core/document/reference/atom_labels.hpp"
#include "core/document/reference/reference.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

constexpr const char* kAtoms =
    "ATOM      1  N   SER A   1       1.000   2.000   3.000  1.00 91.29           N  \n"
    "ATOM      2  CA  SER A   1       2.000   2.000   3.000  1.00 40.00           C  \n"
    "ATOM      3  C   SER A   1       3.000   2.000   6.000                       C  \n";
constexpr const char* kCif =
    "data_A\nloop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n"
    "_atom_site.label_atom_id\n_atom_site.label_comp_id\n_atom_site.label_asym_id\n"
    "_atom_site.label_seq_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
    "_atom_site.B_iso_or_equiv\nATOM 1 N N SER A 1 1.0 2.0 3.0 91.29\n"
    "ATOM 2 C CA SER A 1 2.0 2.0 3.0 40.0\nATOM 3 C C SER A 1 3.0 2.0 6.0 ?\n";

struct File {
  const char* name;
  std::string text;
  bool predicted;
};

std::vector<File> files() {
  const std::string pdb = kAtoms, cif = kCif;
  return {
      {"a.pdb", "TITLE     ALPHAFOLD MONOMER V2.0 PREDICTION FOR ALBUMIN (P02768)\n" + pdb, true},
      {"a.pdb", "TITLE     ESMFOLD V1 PREDICTION FOR INPUT\n" + pdb, true},
      {"a.pdb", "REMARK   1 ALPHAFOLD DATA, COPYRIGHT (2021) DEEPMIND\n" + pdb, true},
      {"a.pdb", "REMARK   3 B-FACTORS ARE PLDDT\n" + pdb, true},
      {"a.cif", cif + "#\nloop_\n_ma_qa_metric.id\n_ma_qa_metric.name\n1 pLDDT\n", true},
      {"a.cif", cif + "#\n_ma_qa_metric.name pLDDT\n", true},
      {"a.pdb", pdb, false},
      {"a.cif", cif, false},
      {"a.cif", cif + "#\n_ma_qa_metric.name PAE\n", false}};
}

struct Opened {
  std::shared_ptr<const Molecule> molecule;
  std::shared_ptr<const PreparedBalls> prepared;
};

Opened open(const File& file) {
  auto molecule = std::make_shared<const Molecule>(read_text(file.name, file.text));
  return {molecule, std::make_shared<const PreparedBalls>(prepare_balls(*molecule))};
}

TEST(ConfidenceNames, HaveTheirNameInTheLegend) {
  for (const File& file : files()) {
    const Opened opened = open(file);
    const PaintedMolecule of{*opened.molecule, opened.prepared->atom_of_ball};
    const PaintedBalls painted = paint_balls(of, {.by = ColourBy::b_factor});
    ASSERT_TRUE(painted.key) << file.text;
    EXPECT_EQ(painted.key->title, file.predicted ? "pLDDT (confidence)" : "B factor (Å²)")
        << file.text;
    ASSERT_EQ(painted.key->categories.size(), 1u);
    EXPECT_EQ(painted.key->categories[0].name,
              file.predicted ? "no pLDDT in the file" : "no B factor in the file");
    // Colours follow the values, whatever their name.
    EXPECT_NE(painted.colours[0], painted.colours[1]);
    EXPECT_EQ(painted.colours[2], kNoValueColour);
    const PaintedBalls elements = paint_balls(of, {.by = ColourBy::element});
    EXPECT_EQ(elements.key->title.find("pLDDT"), std::string::npos);
  }
}

TEST(ConfidenceNames, HaveTheirNameInLabels) {
  for (const File& file : files()) {
    const Opened opened = open(file);
    const BallReferences references{opened.molecule, opened.prepared};
    const auto labels = placed_labels(references, {{LabelText::b_factor, AtomSet({{0, 0, 0}})}},
                                      [](std::size_t) { return true; });
    ASSERT_EQ(labels.size(), 1u) << file.text;
    EXPECT_EQ(labels[0].text, file.predicted ? "91.3 pLDDT" : "91.3 Å²") << file.text;
  }
}

TEST(ConfidenceNames, HaveTheirNameInJson) {
  for (const File& file : files()) {
    const Opened opened = open(file);
    const Json json = input_json({opened.molecule, opened.prepared, {}, {}});
    EXPECT_EQ(json.value("b_factors", "none"), file.predicted ? "pLDDT" : "none");
    std::string notes;
    for (const Json& note : json["notes"]) notes += note.get<std::string>() + "\n";
    EXPECT_EQ(notes.find("confidences (pLDDT, high is good)") != std::string::npos, file.predicted);
  }
}

// Displacements beyond 100 Å² are no confidences, whatever the title.
TEST(ConfidenceNames, AreFromZeroToAHundred) {
  std::string text = "TITLE     ALPHAFOLD MONOMER V2.0 PREDICTION FOR X\n" + std::string(kAtoms);
  EXPECT_TRUE(read_text("a.pdb", text).has_confidences);
  text.replace(text.find(" 91.29"), 6, "100.00");
  EXPECT_TRUE(read_text("a.pdb", text).has_confidences);
  text.replace(text.find("100.00"), 6, "100.01");
  EXPECT_FALSE(read_text("a.pdb", text).has_confidences);
  text.replace(text.find("100.01"), 6, " -0.01");
  EXPECT_FALSE(read_text("a.pdb", text).has_confidences);
}

}  // namespace
}  // namespace alphascope
