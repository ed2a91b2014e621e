// From a file to balls: reading, expanding an assembly, selecting and giving radii.
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
  std::shared_ptr<const PreparedBalls> prepared;     // radii before any solvent radius
  std::shared_ptr<const Molecule> deposited;         // as the file has it; may be `molecule` itself
  std::shared_ptr<const MoleculeContents> contents;  // of `molecule`
  std::shared_ptr<const ResidueGroups> residues;     // of its model that is used, or of all
  std::shared_ptr<const TreatedAtoms> treated;       // by options.balls.treated; never null
  std::vector<AssemblyInfo> assemblies;              // of `deposited`
  OpenOptions options;                               // that led here
};

// Throws ReadError; std::invalid_argument for options that the molecule cannot satisfy; Cancelled.
OpenedMolecule open_molecule(const std::filesystem::path& path, const OpenOptions& options,
                             const RunContext& context);

// The same file under other options, without reading it again; only what changes is done anew.
OpenedMolecule reopen_molecule(const OpenedMolecule& opened, const OpenOptions& options,
                               const RunContext& context);

// Whether both are the same atoms of one file that was read once, whatever is chosen of them and
// whatever their residues are treated as.
bool same_atoms(const OpenedMolecule& a, const OpenedMolecule& b);

}  // namespace alphascope
