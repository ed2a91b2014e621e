#include "core/molecule/altlocs.hpp"

#include <gtest/gtest.h>

namespace alphascope {
namespace {

Atom atom(Molecule& m, const char* residue, const char* name, char altloc, float occupancy,
          float b) {
  Atom a;
  a.residue_name = m.names.intern(residue);
  a.name = m.names.intern(name);
  a.altloc = altloc;
  a.occupancy = occupancy;
  a.b_factor = b;
  a.residue_number = 7;
  return a;
}

std::vector<int> kept(const Molecule& m) {
  const std::vector<bool> minor = minor_altlocs(m, 0, m.atoms.size());
  std::vector<int> result;
  for (std::size_t i = 0; i < minor.size(); ++i) {
    if (!minor[i]) result.push_back(static_cast<int>(i));
  }
  return result;
}

TEST(Altlocs, OccupancyThenBFactorThenLetter) {
  Molecule m;
  m.atoms = {atom(m, "SER", "CB", 'A', 0.4f, 1), atom(m, "SER", "CB", 'B', 0.6f, 9)};
  EXPECT_EQ(kept(m), std::vector<int>{1});
  m.atoms = {atom(m, "SER", "CB", 'A', 0.5f, 9), atom(m, "SER", "CB", 'B', 0.5f, 1)};
  EXPECT_EQ(kept(m), std::vector<int>{1});
  m.atoms = {atom(m, "SER", "CB", 'B', 0.5f, 1), atom(m, "SER", "CB", 'A', 0.5f, 1)};
  EXPECT_EQ(kept(m), std::vector<int>{1});
}

TEST(Altlocs, OneLetterPerResidueSoThatConformersDoNotMix) {
  Molecule m;
  m.atoms = {atom(m, "SER", "CA", ' ', 1, 1),     atom(m, "SER", "CB", 'A', 0.6f, 1),
             atom(m, "SER", "CB", 'B', 0.4f, 1),  atom(m, "SER", "OG", 'A', 0.45f, 1),
             atom(m, "SER", "OG", 'B', 0.55f, 1), atom(m, "SER", "HG", 'B', 0.5f, 1)};
  // A has the higher mean; HG exists in B only and stays.
  EXPECT_EQ(kept(m), (std::vector<int>{0, 1, 3, 5}));
}

TEST(Altlocs, AnotherResidueTypeGoesWithItsLetter) {
  Molecule m;
  m.atoms = {atom(m, "SER", "CB", 'A', 0.6f, 1), atom(m, "SER", "OG", 'A', 0.6f, 1),
             atom(m, "THR", "CB", 'B', 0.4f, 1), atom(m, "THR", "CG2", 'B', 0.4f, 1)};
  EXPECT_EQ(kept(m), (std::vector<int>{0, 1}));
}

TEST(Altlocs, BlankCompetesWithALetterOfTheSameName) {
  Molecule m;
  m.atoms = {atom(m, "SER", "CB", ' ', 0.3f, 1), atom(m, "SER", "CB", 'B', 0.7f, 1),
             atom(m, "SER", "CA", ' ', 1, 1), atom(m, "SER", "CA", ' ', 1, 1)};
  // Two blank CA are a fault of the file, not alternatives: both stay and are reported coincident.
  EXPECT_EQ(kept(m), (std::vector<int>{1, 2, 3}));
}

}  // namespace
}  // namespace alphascope
