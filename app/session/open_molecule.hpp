// SPDX-License-Identifier: GPL-3.0-or-later
// Opens a file as balls: reads it, expands an assembly, selects atoms and gives them radii.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "core/document/settings/open_options.hpp"
#include "core/molecule/assembly.hpp"
#include "core/selection/contents.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/selection/residue_groups.hpp"

namespace alphascope {

struct OpenedMolecule {
  std::shared_ptr<const Molecule> molecule;          // with the assembly's copies
  std::shared_ptr<const PreparedBalls> prepared;     // radii without solvent radius
  std::shared_ptr<const Molecule> deposited;         // as in the file; may be `molecule` itself
  std::shared_ptr<const MoleculeContents> contents;  // of `molecule`
  std::shared_ptr<const ResidueGroups> residues;     // of the used model, or of all
  std::shared_ptr<const TreatedAtoms> treated;       // by options.balls.treated; never null
  std::vector<AssemblyInfo> assemblies;              // of `deposited`
  OpenOptions options;                               // the options of this opening
};

// Throws ReadError, Cancelled, and std::invalid_argument for options that the molecule cannot
// satisfy.
OpenedMolecule open_molecule(const std::filesystem::path& path, const OpenOptions& options,
                             const RunContext& context);

// Opens the same file under other options without reading it again. Only changed steps are
// repeated.
OpenedMolecule reopen_molecule(const OpenedMolecule& opened, const OpenOptions& options,
                               const RunContext& context);

// Whether both have the same atoms, from the same reading of a file. The selection and the
// treatment of residues may differ.
bool same_atoms(const OpenedMolecule& a, const OpenedMolecule& b);

}  // namespace alphascope
