// Biological assemblies: copies of chains under rotations and translations, as files describe them
// (PDB's BIOMT records, mmCIF's pdbx_struct_assembly tables).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/run/cancel_token.hpp"

namespace alphascope {

struct Molecule;

// x' = rotation · x + translation, row by row: three factors, then the translation in Å.
struct SymmetryOperator {
  std::string id;
  std::array<std::array<double, 4>, 3> rows;
  int digits = 0;        // decimal places of the factors as they are printed
  std::size_t line = 0;  // where they begin in the file, from 1
};

enum class OperatorKind : std::uint8_t {
  rotation,
  mirror,    // and a rotation: distances stay, handedness does not, as in a racemate
  no_motion  // singular, stretching or shearing: what it makes of a molecule is none
};
// Judged within what printing leaves of the factors, at least 0.001.
OperatorKind operator_kind(const SymmetryOperator& symmetry_operator);

// The chains of one generator are copied under every product of one operator from each factor,
// the leftmost factor applied last: "(1-5)(61-88)" has two factors and 140 copies.
struct AssemblyGenerator {
  std::vector<std::vector<std::uint32_t>> factors;  // indices into Assemblies::operators
  std::vector<std::string> chains;                  // Atom::label_chain
};

struct Assembly {
  std::string id;
  std::string details;
  std::vector<AssemblyGenerator> generators;
};

// One that the file describes in a way that cannot be followed.
struct RefusedAssembly {
  std::string id;      // empty = all that there may be
  std::string reason;  // "its operator 2 in line 9 is no rotation: …. Remedy"
};

struct Assemblies {
  std::vector<SymmetryOperator> operators;
  std::vector<Assembly> list;
  std::vector<RefusedAssembly> refused;
};

// Takes the assemblies with an operator that is no motion out of the list; what is refused and what
// mirrors is told in the molecule's notes.
void check_operators(Molecule& molecule);

// For an assembly that is not in the list; with a note in the molecule.
void refuse_assembly(Molecule& molecule, std::string id, std::string reason);

struct AssemblyInfo {
  std::string id;
  std::string details;
  std::uint64_t copies = 0;        // operators, summed over the generators
  std::uint64_t atoms = 0;         // of all models, after expansion
  std::uint64_t memory_bytes = 0;  // of the expanded molecule and its balls, about
};

// In the order of the file; empty when it describes none.
std::vector<AssemblyInfo> list_assemblies(const Molecule& molecule);

// The molecule with the copies of an assembly in place of the deposited atoms. The first copy of a
// chain keeps its name, the k-th is called "A-k". New positions are rounded to the molecule's
// lattice (Molecule::rounding_angstrom). Throws std::invalid_argument for an id that is not there
// or was refused, for an assembly without atoms, with more than 4,294,967,295, or beyond the
// lattice; Cancelled; std::bad_alloc.
Molecule expand_assembly(const Molecule& molecule, std::string_view id,
                         const RunContext& context = {});

// "1,2,5-7", "(1-5)(61-88)", "P" as factors. False when it is malformed, names an operator that is
// not in the list, or has more than a million copies.
bool parse_operator_expression(std::string_view text,
                               const std::vector<SymmetryOperator>& operators,
                               std::vector<std::vector<std::uint32_t>>& factors);

}  // namespace alphascope
