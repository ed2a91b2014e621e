// SPDX-License-Identifier: GPL-3.0-or-later
// Tests scripts for ChimeraX and PyMOL. Names in a file never become commands.
#include "core/write/viewer_script.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <sstream>

#include "core/geometry/lattice_alpha.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

constexpr const char* kNames =
    "data_x\nloop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n"
    "_atom_site.label_atom_id\n_atom_site.label_comp_id\n_atom_site.label_asym_id\n"
    "_atom_site.label_seq_id\n_atom_site.pdbx_PDB_ins_code\n_atom_site.Cartn_x\n"
    "_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.auth_asym_id\n"
    "ATOM 1 C CA ALA A 1 ; 0.0 0.0 0.0 A\n"
    "ATOM 2 C CB ALA A 1 B 1.0 0.0 0.0 A\n"
    "ATOM 3 N 'N; close' ALA A 2 ? 3.0 0.0 0.0 A\n"
    "ATOM 4 O O ALA 'A; close all' 3 ? 0.0 3.0 0.0 'A; close all'\n"
    "ATOM 5 O \"O5'\" ALA B 4 ? 0.0 0.0 3.0 B\n";

TEST(ViewerScript, OnlyPlainNamesAreNamed) {
  const Molecule molecule = read_text("names.cif", kNames);
  ASSERT_EQ(molecule.atoms.size(), 5u);
  ViewerScript script{&molecule, "/tmp/a b;c.cif", {}, {}, {}, {{"title", "x; close all \\"}}};
  script.cavities.push_back({1, {255, 0, 0}, std::vector<std::size_t>(5)});
  std::iota(script.cavities[0].lining.begin(), script.cavities[0].lining.end(), std::size_t{0});
  const std::string chimerax = chimerax_script(script);
  EXPECT_NE(chimerax.find("\nname cavity1 #1/A:1B@CB/B:4@O5'\n"), chimerax.npos) << chimerax;
  EXPECT_NE(chimerax.find("\nopen '/tmp/a b;c.cif' id 1\n"), chimerax.npos) << chimerax;
  for (const std::string& text : {chimerax, pymol_script(script)}) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_TRUE(line.starts_with("#") || line.find("close") == line.npos) << line;
      EXPECT_FALSE(line.ends_with("\\")) << line;
    }
  }
  // PyMOL runs the text behind a semicolon as a command, except in Python's comments.
  EXPECT_TRUE(pymol_script(script).starts_with("python\n# title x; close all"));
}

}  // namespace
}  // namespace alphascope
