// SPDX-License-Identifier: GPL-3.0-or-later
// Tests radii of atoms in every set, with their types and the reasons for a guess.
#include "core/radii/radii_set.hpp"

#include <gtest/gtest.h>

#include "core/geometry/lattice_alpha.hpp"
#include "core/read/read_molecule.hpp"
#include "core/read/user_radii.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

AssignedRadius radius(RadiiSet set, const char* residue, const char* name, const char* element,
                      ResidueKind kind = ResidueKind::polymer,
                      std::shared_ptr<const UserRadii> user = nullptr) {
  Molecule m;
  Atom a;
  a.residue_name = m.names.intern(residue);
  a.name = m.names.intern(name);
  a.element = element_from_symbol(element);
  a.kind = kind;
  m.atoms = {a};
  return RadiiLookup(m, set, user).radius(0);
}

void expect_milli(RadiiSet set, const char* residue, const char* name, const char* element,
                  int milli) {
  const AssignedRadius r = radius(set, residue, name, element);
  EXPECT_EQ(r.microangstrom, milli * 1000) << residue << ' ' << name;
  EXPECT_FALSE(r.guessed) << residue << ' ' << name;
}

TEST(RadiiSets, ValuesOfThePapers) {
  expect_milli(RadiiSet::bondi, "ALA", "CA", "C", 1700);
  expect_milli(RadiiSet::alvarez, "ALA", "CA", "C", 1770);
  expect_milli(RadiiSet::rasmol, "ALA", "CA", "C", 1548);
  expect_milli(RadiiSet::rasmol, "CYS", "SG", "S", 1808);
  const RadiiSet p = RadiiSet::protor;
  expect_milli(p, "ALA", "CA", "C", 1880);
  expect_milli(p, "ALA", "C", "C", 1610);
  expect_milli(p, "ALA", "O", "O", 1420);
  expect_milli(p, "ALA", "OXT", "O", 1460);
  expect_milli(p, "TRP", "CE2", "C", 1610);
  expect_milli(p, "TRP", "CE3", "C", 1760);
  expect_milli(p, "TRP", "CB", "C", 1880);
  expect_milli(p, "HIE", "CD2", "C", 1760);
  expect_milli(p, "ARG", "CZ", "C", 1610);
  expect_milli(p, "PHE", "CZ", "C", 1760);
  expect_milli(p, "GLU", "OE2", "O", 1460);
  expect_milli(p, "LYS", "NZ", "N", 1640);
  expect_milli(p, "MSE", "SE", "Se", 1900);
  expect_milli(p, "DA", "C5'", "C", 1880);
  expect_milli(p, "A", "C2", "C", 1760);
  expect_milli(p, "G", "C2", "C", 1610);
  expect_milli(p, "DT", "C7", "C", 1880);
  expect_milli(p, "DC", "C5", "C", 1760);
  expect_milli(p, "U", "O4", "O", 1420);
  expect_milli(p, "C", "P", "P", 1800);
  expect_milli(p, "HOH", "O", "O", 1460);
  const RadiiSet c = RadiiSet::castp;
  expect_milli(c, "ALA", "CA", "C", 1880);
  expect_milli(c, "ALA", "O", "O", 1420);
  expect_milli(c, "ALA", "OXT", "O", 1400);
  expect_milli(c, "ASP", "OD1", "O", 1400);
  expect_milli(c, "GLU", "OE2", "O", 1400);
  expect_milli(c, "ASN", "OD1", "O", 1420);
  expect_milli(c, "GLN", "OE1", "O", 1420);
  expect_milli(c, "THR", "OG1", "O", 1460);
  expect_milli(c, "C", "P", "P", 1800);
  const RadiiSet n = RadiiSet::naccess;
  expect_milli(n, "LYS", "NZ", "N", 1500);
  expect_milli(n, "LYS", "CE", "C", 1870);
  expect_milli(n, "TYR", "CE1", "C", 1760);
  expect_milli(n, "G", "N9", "N", 1600);
  const RadiiSet a = RadiiSet::amber;
  expect_milli(a, "ALA", "CA", "C", 1908);
  expect_milli(a, "ALA", "H", "H", 600);
  expect_milli(a, "ALA", "HB1", "H", 1487);
  expect_milli(a, "ALA", "1HB", "H", 1487);
  expect_milli(a, "PHE", "HD1", "H", 1459);
  expect_milli(a, "SER", "OG", "O", 1721);
}

TEST(RadiiSets, WhatASetLacksIsMarkedGuessedWithItsSource) {
  EXPECT_TRUE(radius(RadiiSet::protor, "HEM", "CHA", "C").guessed);
  EXPECT_EQ(radius(RadiiSet::bondi, "XXX", "?", "X").microangstrom, 1800000);
  EXPECT_TRUE(radius(RadiiSet::protor, "ALA", "CA", "C", ResidueKind::ligand).guessed);
  EXPECT_TRUE(radius(RadiiSet::protor, "ALA", "CA", "C").source.empty());
  for (const RadiiSetInfo& info : all_radii_sets()) {
    if (info.set <= RadiiSet::file || info.set == RadiiSet::user) continue;
    const AssignedRadius unknown = radius(info.set, "XXX", "?", "X");
    EXPECT_TRUE(unknown.guessed && !unknown.source.empty()) << info.id;
  }
}

TEST(RadiiSets, MetalsAreIonsWhereTheSetIsMadeForBiomolecules) {
  for (const RadiiSet set :
       {RadiiSet::protor, RadiiSet::castp, RadiiSet::naccess, RadiiSet::rasmol}) {
    const AssignedRadius iron = radius(set, "HEM", "FE", "Fe", ResidueKind::ligand);
    EXPECT_EQ(iron.microangstrom, 610000);
    EXPECT_TRUE(iron.guessed);
    EXPECT_EQ(iron.source, "ionic radius, Shannon 1976");
    EXPECT_EQ(radius(set, "CA", "CA", "Ca", ResidueKind::ion).microangstrom, 1000000);
    EXPECT_EQ(radius(set, "ZN", "ZN", "Zn", ResidueKind::ion).microangstrom, 740000);
    EXPECT_EQ(radius(set, "CL", "CL", "Cl", ResidueKind::ion).microangstrom, 1810000);
    EXPECT_EQ(radius(set, "LIG", "CL1", "Cl", ResidueKind::ligand).microangstrom, 1750000)
        << "chlorine of a molecule is no chloride";
  }
  // AMBER has radii for its own ions, but none for iron.
  EXPECT_EQ(radius(RadiiSet::amber, "CA", "CA", "Ca", ResidueKind::ion).microangstrom, 1713000);
  EXPECT_FALSE(radius(RadiiSet::amber, "CA", "CA", "Ca", ResidueKind::ion).guessed);
  EXPECT_EQ(radius(RadiiSet::amber, "HEM", "FE", "Fe").microangstrom, 610000);
}

TEST(RadiiSets, MetalsAreAtomsInTheVanDerWaalsSets) {
  const AssignedRadius zinc = radius(RadiiSet::bondi, "ZN", "ZN", "Zn", ResidueKind::ion);
  EXPECT_EQ(zinc.microangstrom, 1390000);
  EXPECT_FALSE(zinc.guessed);
  const AssignedRadius calcium = radius(RadiiSet::bondi, "CA", "CA", "Ca", ResidueKind::ion);
  EXPECT_EQ(calcium.microangstrom, 2310000);
  EXPECT_EQ(calcium.source, "Mantina 2009");
  EXPECT_EQ(radius(RadiiSet::bondi, "HEM", "FE", "Fe").microangstrom, 2000000);
  EXPECT_EQ(radius(RadiiSet::alvarez, "HEM", "FE", "Fe").microangstrom, 2440000);
  EXPECT_FALSE(radius(RadiiSet::alvarez, "HEM", "FE", "Fe").guessed);
}

TEST(RadiiSets, EverySetHasANameACitationAndAPositiveRadiusForEveryElement) {
  for (const RadiiSetInfo& info : all_radii_sets()) {
    EXPECT_EQ(&radii_set_info(info.set), &info);
    RadiiSet found{};
    EXPECT_TRUE(find_radii_set(info.id, found));
    EXPECT_EQ(found, info.set);
    if (info.set <= RadiiSet::file || info.set == RadiiSet::user) continue;
    EXPECT_GT(info.citation.size(), 20u);
    for (int z = 0; z <= kHeaviestElement; ++z) {
      Molecule m;
      Atom a;
      a.element = static_cast<Element>(z);
      m.atoms = {a};
      EXPECT_GT(RadiiLookup(m, info.set, nullptr).radius(0).microangstrom, 440000) << info.id << z;
    }
  }
  RadiiSet none{};
  EXPECT_FALSE(find_radii_set("bond", none));
}

TEST(RadiiSets, UnitedAtomSetsDropHydrogensUnlessTold) {
  const Molecule m = read_text(
      "a.pdb",
      "ATOM      1  CA  ALA A   1      27.340  24.430   2.614  1.00  9.67           C  \n"
      "ATOM      2  HA  ALA A   1      26.340  24.430   2.614  1.00  9.67           H  \n");
  EXPECT_EQ(prepare_balls(m).report.radii, RadiiSet::bondi) << "there are hydrogens";
  EXPECT_EQ(prepare_balls(m).report.used, 2u);
  BallOptions options;
  options.radii = RadiiSet::protor;
  EXPECT_EQ(prepare_balls(m, options).report.dropped_hydrogens, 1u);
  EXPECT_EQ(prepare_balls(m, options).balls->radii, std::vector<std::int32_t>{1880});
  options.hydrogens = HydrogenRule::keep;
  EXPECT_EQ(prepare_balls(m, options).report.used, 2u);
}

TEST(UserRadii, FirstFittingRuleCounts) {
  const TemporaryFile file("r.txt", "# mine\nC 1.7\nANY CB 1.9  # beta\nALA CB 1.95\nX 1.0\n\n");
  const auto table = read_user_radii(file.path());
  EXPECT_EQ(radius(RadiiSet::user, "ALA", "CB", "C", ResidueKind::polymer, table).microangstrom,
            1950000);
  EXPECT_EQ(radius(RadiiSet::user, "GLY", "CB", "C", ResidueKind::polymer, table).microangstrom,
            1900000);
  EXPECT_EQ(radius(RadiiSet::user, "GLY", "CA", "C", ResidueKind::polymer, table).microangstrom,
            1700000);
  EXPECT_EQ(radius(RadiiSet::user, "GLY", "?", "X", ResidueKind::polymer, table).microangstrom,
            1000000);
  EXPECT_TRUE(radius(RadiiSet::user, "GLY", "N", "N", ResidueKind::polymer, table).guessed);
}

TEST(UserRadii, RefusesWithTheLine) {
  for (const char* text :
       {"C 1.7\nC 1.8\n", "C 1.7\nALA CB 0\n", "C 1.7\nQq 1.0\n", "C 1.7\nC\n",
        "C 1.7\nALA CB C 1.9\n", "C 1.7\nN nan\n", "C 1.7\nN 61\n", "C 1.7\nN 1.5000001\n"}) {
    const TemporaryFile file("r.txt", text);
    try {
      read_user_radii(file.path());
      ADD_FAILURE() << text;
    } catch (const ReadError& error) {
      EXPECT_EQ(error.line(), 2u) << text;
    }
  }
}

}  // namespace
}  // namespace alphascope
