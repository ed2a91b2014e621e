// SPDX-License-Identifier: GPL-3.0-or-later
// Biological assemblies: copies of chains under rotations and translations, as PDB's BIOMT records
// and mmCIF's pdbx_struct_assembly tables describe them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/run/cancel_token.hpp"

namespace alphascope {

struct Molecule;

// x' = rotation · x + translation. Each row has three factors, then the translation in Å.
struct SymmetryOperator {
  std::string id;
  std::array<std::array<double, 4>, 3> rows;
  int digits = 0;        // decimal places of the factors as they are printed
  std::size_t line = 0;  // line of the file where it begins, counted from 1
};

enum class OperatorKind : std::uint8_t {
  rotation,
  // A reflection, possibly with a rotation: distances stay, handedness changes, as in a racemate.
  mirror,
  no_motion  // singular, stretching or shearing, so no motion of a molecule
};
// The tolerance is the rounding of the printed factors, at least 0.001.
OperatorKind operator_kind(const SymmetryOperator& symmetry_operator);

// A generator copies its chains under every product of one operator from each factor. The leftmost
// factor is applied last. "(1-5)(61-88)" has two factors and 140 copies.
struct AssemblyGenerator {
  std::vector<std::vector<std::uint32_t>> factors;  // indices into Assemblies::operators
  std::vector<std::string> chains;                  // as Atom::label_chain
};

struct Assembly {
  std::string id;
  std::string details;
  std::vector<AssemblyGenerator> generators;
};

// An assembly whose description in the file cannot be followed.
struct RefusedAssembly {
  std::string id;      // empty: all assemblies of the file
  std::string reason;  // "its operator 2 in line 9 is no rotation: …. Remedy"
};

struct Assemblies {
  std::vector<SymmetryOperator> operators;
  std::vector<Assembly> list;
  std::vector<RefusedAssembly> refused;
};

// Removes assemblies with an operator that is no motion from the list. The molecule's notes name
// removed assemblies and mirrors.
void check_operators(Molecule& molecule);

// Notes that an assembly is refused, in `refused` and in the molecule's notes.
void refuse_assembly(Molecule& molecule, std::string id, std::string reason);

struct AssemblyInfo {
  std::string id;
  std::string details;
  std::uint64_t copies = 0;        // number of operators, summed over the generators
  std::uint64_t atoms = 0;         // of all models, after expansion
  std::uint64_t memory_bytes = 0;  // approximate, for the expanded molecule and its balls
};

// In the order of the file; empty if it describes no assemblies.
std::vector<AssemblyInfo> list_assemblies(const Molecule& molecule);

// The molecule with the copies of an assembly in place of the deposited atoms. The first copy of a
// chain keeps its name; the k-th is called "A-k". New positions are rounded to the molecule's
// lattice (Molecule::rounding_angstrom). Throws std::invalid_argument for an unknown or refused id.
// Throws the same if the assembly has no atoms, has more than 4,294,967,295, or reaches beyond the
// lattice. Throws Cancelled and std::bad_alloc.
Molecule expand_assembly(const Molecule& molecule, std::string_view id,
                         const RunContext& context = {});

// Parses "1,2,5-7", "(1-5)(61-88)" or "P" into factors. Returns false if the text is malformed,
// names an unknown operator, or has more than a million copies.
bool parse_operator_expression(std::string_view text,
                               const std::vector<SymmetryOperator>& operators,
                               std::vector<std::vector<std::uint32_t>>& factors);

}  // namespace alphascope
