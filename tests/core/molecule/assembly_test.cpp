// SPDX-License-Identifier: GPL-3.0-or-later
// Tests assemblies: operators, products, copies and their names.
#include "core/molecule/assembly.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>

#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

std::vector<SymmetryOperator> operators(std::initializer_list<const char*> ids) {
  std::vector<SymmetryOperator> result;
  for (const char* id : ids) result.push_back({id, {}});
  return result;
}

TEST(Assembly, OperatorExpressions) {
  const auto known = operators({"1", "2", "3", "P", "X0"});
  std::vector<std::vector<std::uint32_t>> factors;
  using Factors = std::vector<std::vector<std::uint32_t>>;
  ASSERT_TRUE(parse_operator_expression("1", known, factors));
  EXPECT_EQ(factors, (Factors{{0}}));
  ASSERT_TRUE(parse_operator_expression("1,3", known, factors));
  EXPECT_EQ(factors, (Factors{{0, 2}}));
  ASSERT_TRUE(parse_operator_expression("(1-3)(P, X0)", known, factors));
  EXPECT_EQ(factors, (Factors{{0, 1, 2}, {3, 4}}));
  ASSERT_TRUE(parse_operator_expression("P(1-2)", known, factors));
  EXPECT_EQ(factors, (Factors{{3}, {0, 1}}));
  for (const char* bad :
       {"", "4", "(1-3", "1-9", "3-1", "()", "1)(", "1--2", "(1-1000000000000)"}) {
    EXPECT_FALSE(parse_operator_expression(bad, known, factors)) << bad;
  }
  std::string many;
  for (int k = 0; k < 40; ++k) many += "(1-3)";
  EXPECT_FALSE(parse_operator_expression(many, known, factors)) << "3^40 copies";
}

constexpr const char* kDimer =
    "REMARK 350 BIOMOLECULE: 1\n"
    "REMARK 350 AUTHOR DETERMINED BIOLOGICAL UNIT: DIMERIC\n"
    "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A,\n"
    "REMARK 350                    AND CHAINS: C\n"
    "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n"
    "REMARK 350   BIOMT1   2  0.000000 -1.000000  0.000000       10.50000\n"
    "REMARK 350   BIOMT2   2  1.000000  0.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   2  0.000000  0.000000  1.000000        0.00000\n"
    "ATOM      1  N   MET A   1       1.000   2.000   3.000  1.00  9.67           N  \n"
    "ATOM      2  N   MET B   1       4.000   2.000   3.000  1.00  9.67           N  \n"
    "ATOM      3  N   MET C   1       5.000   2.000   3.000  1.00  9.67           N  \n";

TEST(Assembly, CopiesChainsOfBiomtRecords) {
  const Molecule m = read_text("a.pdb", kDimer);
  const std::vector<AssemblyInfo> list = list_assemblies(m);
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].id, "1");
  EXPECT_EQ(list[0].details, "DIMERIC");
  EXPECT_EQ(list[0].copies, 2u);
  EXPECT_EQ(list[0].atoms, 4u);
  const Molecule e = expand_assembly(m, "1");
  ASSERT_EQ(e.atoms.size(), 4u);
  EXPECT_EQ(e.assembly_id, "1");
  EXPECT_EQ(e.atoms[2].position, (LatticePoint{8500, 1000, 3000}));
  EXPECT_EQ(e.text(e.atoms[0].chain), "A");
  EXPECT_EQ(e.text(e.atoms[3].chain), "C-2");
  EXPECT_EQ(e.models.size(), 1u);
  EXPECT_EQ(e.rounding_angstrom, 0);
  EXPECT_THROW(expand_assembly(m, "2"), std::invalid_argument);
}

TEST(Assembly, SaysByHowMuchCopiesAreRounded) {
  std::string text = kDimer;
  text.replace(text.find("10.50000"), 8, "10.50025");
  const Molecule e = expand_assembly(read_text("a.pdb", text), "1");
  EXPECT_EQ(e.atoms.at(2).position, (LatticePoint{8500, 1000, 3000}));
  EXPECT_NEAR(e.rounding_angstrom, 0.00025, 1e-9);
}

TEST(Assembly, DamagedRecordsAreNotedAndLeftOut) {
  std::string text = kDimer;
  text.replace(text.find("BIOMT2   2"), 10, "BIOMT3   2");
  const Molecule m = read_text("a.pdb", text);
  EXPECT_TRUE(list_assemblies(m).empty());
  ASSERT_EQ(m.notes.size(), 1u);
  EXPECT_NE(m.notes[0].find("line 9"), std::string::npos) << m.notes[0];
}

// kDimer with another matrix for its second operator. The first row is in line 8.
std::string dimer_with(const char* row1, const char* row2, const char* row3) {
  std::string text = kDimer;
  const char* const rows[] = {row1, row2, row3};
  for (int k = 0; k < 3; ++k) {
    const std::string label = "BIOMT" + std::to_string(k + 1) + "   2";
    const std::size_t at = text.find(label) + label.size();
    text.replace(at, text.find('\n', at) - at, std::string("  ") + rows[k] + "  0.0");
  }
  return text;
}

std::string why_not(const Molecule& m, const char* id) {
  try {
    expand_assembly(m, id);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Assembly, MatricesThatAreNoRotationAreRefusedWithTheirLine) {
  const struct {
    const char *row1, *row2, *row3, *said;
  } cases[] = {{"1 0 0", "0 1 0", "0 0 0", "is singular"},
               {"0 0 0", "0 0 0", "0 0 0", "is singular"},
               {"2 0 0", "0 2 0", "0 0 2", "stretches or shears"},
               {"1.1 0 0", "0 1.1 0", "0 0 1.1", "stretches or shears"},
               {"1.01 0 0", "0 1.01 0", "0 0 1.01", "stretches or shears"},
               {"1 0.10 0", "0 1 0", "0 0 1", "stretches or shears"},
               {"1 0.002000 0", "0 1 0", "0 0 1", "stretches or shears"},
               {"1e300 0 0", "0 1e300 0", "0 0 1e300", "stretches or shears"}};
  for (const auto& c : cases) {
    const Molecule m = read_text("a.pdb", dimer_with(c.row1, c.row2, c.row3));
    EXPECT_TRUE(list_assemblies(m).empty()) << c.row1;
    EXPECT_EQ(m.atoms.size(), 3u) << "the molecule as deposited can be used";
    const std::string reason = why_not(m, "1");
    EXPECT_NE(reason.find("operator 2 in line 8"), std::string::npos) << reason;
    EXPECT_NE(reason.find(c.said), std::string::npos) << reason;
    EXPECT_NE(reason.find("fetch the file again"), std::string::npos) << reason;
    ASSERT_EQ(m.notes.size(), 1u);
    EXPECT_NE(m.notes[0].find("Assembly 1 is left out: its operator 2"), std::string::npos);
  }
}

TEST(Assembly, RotationsMayBePrintedWithFewDigits) {
  const char* const kRows[][3] = {{"0.5 -0.9 0", "0.9 0.5 0", "0 0 1"},
                                  {"0.50 -0.87 0", "0.87 0.50 0", "0 0 1"},
                                  {"0.500000 -0.866025 0", "0.866025 0.500000 0", "0 0 1"},
                                  {"0.500000 -0.866 0", "0.866 0.500000 0", "0 0 1"}};
  for (const auto& rows : kRows) {
    const Molecule m = read_text("a.pdb", dimer_with(rows[0], rows[1], rows[2]));
    EXPECT_EQ(list_assemblies(m).size(), 1u) << rows[0];
    EXPECT_TRUE(m.notes.empty()) << m.notes[0];
  }
}

TEST(Assembly, MirrorsAreMadeAndTold) {
  const Molecule m = read_text("a.pdb", dimer_with("-1 0 0", "0 -1 0", "0 0 -1"));
  EXPECT_EQ(expand_assembly(m, "1").atoms[2].position, (LatticePoint{-1000, -2000, -3000}));
  ASSERT_EQ(m.notes.size(), 1u);
  EXPECT_NE(m.notes[0].find("operator 2 in line 8 is a reflection"), std::string::npos)
      << m.notes[0];
}

TEST(Assembly, OnlyAssembliesThatUseAMatrixAreRefusedForIt) {
  const std::string text =
      "data_x\nloop_\n_pdbx_struct_assembly_gen.assembly_id\n"
      "_pdbx_struct_assembly_gen.oper_expression\n_pdbx_struct_assembly_gen.asym_id_list\n"
      "1 1 A\n2 1,2 A\n3 1,9 A\n"
      "loop_\n_pdbx_struct_oper_list.id\n"
      "_pdbx_struct_oper_list.matrix[1][1]\n_pdbx_struct_oper_list.matrix[1][2]\n"
      "_pdbx_struct_oper_list.matrix[1][3]\n_pdbx_struct_oper_list.vector[1]\n"
      "_pdbx_struct_oper_list.matrix[2][1]\n_pdbx_struct_oper_list.matrix[2][2]\n"
      "_pdbx_struct_oper_list.matrix[2][3]\n_pdbx_struct_oper_list.vector[2]\n"
      "_pdbx_struct_oper_list.matrix[3][1]\n_pdbx_struct_oper_list.matrix[3][2]\n"
      "_pdbx_struct_oper_list.matrix[3][3]\n_pdbx_struct_oper_list.vector[3]\n"
      "1 1 0 0 0 0 1 0 0 0 0 1 0\n2 1 0 0 0 0 1 0 0 0 0 3 0\n"
      "loop_\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_asym_id\n"
      "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n1 C A 1 2 3\n";
  const Molecule m = read_text("a.cif", text);
  ASSERT_EQ(list_assemblies(m).size(), 1u);
  EXPECT_EQ(why_not(m, "1"), "");
  EXPECT_NE(why_not(m, "2").find("operator 2 in line 24 is not a rotation"), std::string::npos)
      << why_not(m, "2");
  EXPECT_NE(why_not(m, "3").find("\"1,9\" in line 8 are not all described"), std::string::npos)
      << why_not(m, "3");
  EXPECT_NE(why_not(m, "4").find("there is no assembly 4: the file has 1"), std::string::npos);
}

// The right operator moves first. It adds 10 Å in x. Then 90° about z takes (11, 0, 0) to (0, 11,
// 0).
TEST(Assembly, OfAProductTheLastOperatorMovesFirst) {
  const std::string text =
      "data_x\nloop_\n_pdbx_struct_assembly_gen.assembly_id\n"
      "_pdbx_struct_assembly_gen.oper_expression\n_pdbx_struct_assembly_gen.asym_id_list\n"
      "1 (1)(2) A\n2 (2)(1) A\n3 (1,2)(1,2) A\n"
      "loop_\n_pdbx_struct_oper_list.id\n"
      "_pdbx_struct_oper_list.matrix[1][1]\n_pdbx_struct_oper_list.matrix[1][2]\n"
      "_pdbx_struct_oper_list.matrix[1][3]\n_pdbx_struct_oper_list.vector[1]\n"
      "_pdbx_struct_oper_list.matrix[2][1]\n_pdbx_struct_oper_list.matrix[2][2]\n"
      "_pdbx_struct_oper_list.matrix[2][3]\n_pdbx_struct_oper_list.vector[2]\n"
      "_pdbx_struct_oper_list.matrix[3][1]\n_pdbx_struct_oper_list.matrix[3][2]\n"
      "_pdbx_struct_oper_list.matrix[3][3]\n_pdbx_struct_oper_list.vector[3]\n"
      "1 0 -1 0 0 1 0 0 0 0 0 1 0\n2 1 0 0 10 0 1 0 0 0 0 1 0\n"
      "loop_\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_asym_id\n"
      "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n1 C A 1 0 0\n";
  const Molecule m = read_text("a.cif", text);
  const auto places = [&](const char* id) {
    std::vector<LatticePoint> result;
    for (const Atom& atom : expand_assembly(m, id).atoms) result.push_back(atom.position);
    return result;
  };
  using Points = std::vector<LatticePoint>;
  EXPECT_EQ(places("1"), (Points{{0, 11000, 0}}));
  EXPECT_EQ(places("2"), (Points{{10000, 1000, 0}}));
  // The last factor varies fastest.
  EXPECT_EQ(places("3"), (Points{{-1000, 0, 0}, {0, 11000, 0}, {10000, 1000, 0}, {21000, 0, 0}}));
}

// A file that holds an assembly already has chains with the names of copies.
TEST(Assembly, CopiesGetNamesThatAreFree) {
  const auto file = [](const std::string& chains) {
    std::string text =
        "data_x\nloop_\n_pdbx_struct_assembly_gen.assembly_id\n"
        "_pdbx_struct_assembly_gen.oper_expression\n_pdbx_struct_assembly_gen.asym_id_list\n"
        "1 1,2 A\nloop_\n_pdbx_struct_oper_list.id\n";
    for (const char* row : {"1", "2", "3"}) {
      for (const char* column : {"1", "2", "3"}) {
        text += "_pdbx_struct_oper_list.matrix[" + std::string(row) + "][" + column + "]\n";
      }
      text += "_pdbx_struct_oper_list.vector[" + std::string(row) + "]\n";
    }
    text +=
        "1 1 0 0 0 0 1 0 0 0 0 1 0\n2 1 0 0 50 0 1 0 0 0 0 1 0\n"
        "loop_\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_asym_id\n"
        "_atom_site.auth_asym_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
        "1 C A A 1 2 3\n";
    int number = 1;
    std::istringstream names(chains);
    for (std::string name; names >> name;) {
      const std::string n = std::to_string(++number);
      text += n + " C L" + n + " " + name + " " + n + "0 2 3\n";
    }
    return read_text("a.cif", text);
  };
  const auto second_copy = [](const Molecule& m) {
    EXPECT_EQ(m.atoms.size(), 2u);
    EXPECT_EQ(m.text(m.atoms.front().chain), "A");
    return std::string(m.text(m.atoms.back().chain));
  };
  const auto says = [](const Molecule& m, const std::string& name) {
    return std::any_of(m.notes.begin(), m.notes.end(), [&](const std::string& note) {
      return note.find(name) != std::string::npos;
    });
  };
  EXPECT_EQ(second_copy(expand_assembly(file(""), "1")), "A-2");
  EXPECT_EQ(second_copy(expand_assembly(file("B-2 A-3 A_2"), "1")), "A-2");
  const Molecule m = expand_assembly(file("A-2"), "1");
  EXPECT_EQ(second_copy(m), "A_2");
  EXPECT_TRUE(says(m, "A_2")) << "that it has another name is said";
  EXPECT_EQ(second_copy(expand_assembly(file("A-2 A_2"), "1")), "A__2");
  EXPECT_EQ(second_copy(expand_assembly(file("A__2 A_2 A-2"), "1")), "A___2");
}

TEST(Assembly, ExpandsTheCapsidsToTheirKnownSizes) {
  ALPHASCOPE_NEED_TEST_DATA();
  const struct {
    const char *file, *id;
    std::size_t atoms;
  } cases[] = {{"ladder/2buk.pdb", "1", 95280},     {"ladder/1f2n.pdb.gz", "1", 283800},
               {"ladder/1ihm.pdb.gz", "1", 677040}, {"ladder/3j6r.pdb.gz", "1", 1032840},
               {"ladder/1rb8.pdb.gz", "1", 306720}, {"ladder/1m4x.cif.gz", "2", 271404},
               {"ladder/1m4x.cif.gz", "5", 290790}, {"ladder/1m4x.cif.gz", "6", 639738},
               {"ladder/1m4x.cif.gz", "3", 1357020}};
  for (const auto& c : cases) {
    const Molecule m = read_molecule(test_data(c.file));
    EXPECT_EQ(expand_assembly(m, c.id).atoms.size(), c.atoms) << c.file << ' ' << c.id;
  }
  const std::vector<AssemblyInfo> list =
      list_assemblies(read_molecule(test_data("ladder/1m4x.cif.gz")));
  ASSERT_EQ(list.size(), 7u);
  EXPECT_EQ(list[0].copies, 1680u);
  EXPECT_EQ(list[0].atoms, 16284240u);
  EXPECT_LT(list[0].memory_bytes, std::uint64_t{3} << 30);
}

TEST(Assembly, AgreesWithTheDerivedCapsidOf2buk) {
  ALPHASCOPE_NEED_TEST_DATA();
  const Molecule expanded = expand_assembly(read_molecule(test_data("ladder/2buk.pdb")), "1");
  const Molecule derived = read_molecule(test_data("ladder/2buk-assembly1.cif.gz"));
  ASSERT_EQ(expanded.atoms.size(), derived.atoms.size());
  std::size_t differing = 0;
  for (std::size_t i = 0; i < derived.atoms.size(); ++i) {
    const LatticePoint &a = expanded.atoms[i].position, &b = derived.atoms[i].position;
    differing += a != b;
    ASSERT_LE(std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z), 3) << i;
  }
  EXPECT_EQ(differing, 0u) << "positions on a tie of rounding";
  const PreparedBalls a = prepare_balls(expanded), b = prepare_balls(derived);
  EXPECT_TRUE(a.balls->centres == b.balls->centres);
  EXPECT_TRUE(a.balls->radii == b.balls->radii);
  EXPECT_EQ(summary(a.report), summary(b.report));
}

TEST(Assembly, KcsaTetramerIsTheThesisFile) {
  ALPHASCOPE_NEED_TEST_DATA();
  const Molecule tetramer = expand_assembly(read_molecule(test_data("thesis/1k4c.pdb.gz")), "1");
  const Molecule thesis = read_molecule(test_data("thesis/1k4c.crd.gz"));
  BallOptions protein;
  protein.ligands = protein.ions = false;
  protein.radii = RadiiSet::rasmol;
  EXPECT_EQ(prepare_balls(tetramer, protein).report.used, thesis.atoms.size());
}

}  // namespace
}  // namespace alphascope
