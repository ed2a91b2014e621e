// SPDX-License-Identifier: GPL-3.0-or-later
// Tests PQR files of alphascope-cli export with gemmi, which reads their PDB columns.
#include <gemmi/pdb.hpp>

#include "core/geometry/ball_set.hpp"
#include "core/read/read_molecule.hpp"
#include "tests/app/cli/cli_fixture.hpp"

namespace alphascope::testing {
namespace {

class ExportGemmi : public Cli {};

TEST_F(ExportGemmi, PqrHasTheColumnsOfPdbFiles) {
  const std::string molecule = ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz";
  const std::string path = (folder_ / "b.pqr").string();
  ASSERT_EQ(run("export -q " + molecule + " --alpha 0 -o '" + path + "'").code, 0);
  const gemmi::Structure read = gemmi::read_pdb_file(path);
  const Molecule balls = read_molecule(path), file = read_molecule(molecule);
  ASSERT_EQ(read.models.size(), 1u);
  std::size_t n = 0;
  for (const gemmi::Chain& chain : read.models[0].chains) {
    for (const gemmi::Residue& residue : chain.residues) {
      for (const gemmi::Atom& atom : residue.atoms) {
        ASSERT_LT(n, balls.atoms.size());
        const Atom& ours = balls.atoms[n++];
        const auto at = [&](std::int32_t units) { return balls.lattice.angstrom(units); };
        EXPECT_EQ(atom.pos.x, at(ours.position.x));
        EXPECT_EQ(atom.pos.y, at(ours.position.y));
        EXPECT_EQ(atom.pos.z, at(ours.position.z));
        EXPECT_EQ(atom.name, balls.text(ours.name));
        EXPECT_EQ(residue.name, balls.text(ours.residue_name));
        EXPECT_EQ(chain.name, balls.text(ours.chain));
        EXPECT_EQ(*residue.seqid.num, ours.residue_number);
      }
    }
  }
  EXPECT_EQ(n, balls.atoms.size());
  EXPECT_GT(n, 4000u);
}

}  // namespace
}  // namespace alphascope::testing
