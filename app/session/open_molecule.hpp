// From a file to balls: reading, expanding an assembly, selecting and giving radii.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/io/read_molecule.hpp"
#include "core/molecule/contents.hpp"
#include "core/molecule/prepare_balls.hpp"

namespace alphascope {

struct OpenOptions {
  ReadOptions read;
  std::string assembly;  // id of the biological assembly to expand; empty = as deposited
  BallOptions balls;
  // Read when the radii of a user's table are asked for and `balls` holds none.
  std::filesystem::path radii_table;
  friend bool operator==(const OpenOptions& a, const OpenOptions& b) {
    return a.read == b.read && a.assembly == b.assembly && a.balls == b.balls &&
           a.radii_table == b.radii_table;
  }
};

// Without what was chosen for one file: assembly, model, chains, expression and radii set by hand.
OpenOptions for_another_file(const OpenOptions& options);

struct OpenedMolecule {
  std::shared_ptr<const Molecule> molecule;          // with the assembly's copies
  std::shared_ptr<const PreparedBalls> prepared;     // radii before any solvent radius
  std::shared_ptr<const Molecule> deposited;         // as the file has it; may be `molecule` itself
  std::shared_ptr<const MoleculeContents> contents;  // of `molecule`
  std::vector<AssemblyInfo> assemblies;              // of `deposited`
  OpenOptions options;                               // that led here
};

// Throws ReadError; std::invalid_argument for options that the molecule cannot satisfy; Cancelled.
OpenedMolecule open_molecule(const std::filesystem::path& path, const OpenOptions& options,
                             const RunContext& context);

// The same file under other options, without reading it again; only what changes is done anew.
OpenedMolecule reopen_molecule(const OpenedMolecule& opened, const OpenOptions& options,
                               const RunContext& context);

}  // namespace alphascope
