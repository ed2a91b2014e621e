// From a file to balls in one step: reading, expanding an assembly, selecting and giving radii.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/io/read_molecule.hpp"
#include "core/molecule/prepare_balls.hpp"

namespace alphascope {

struct OpenOptions {
  ReadOptions read;
  std::string assembly;  // id of the biological assembly to expand; empty = as deposited
  BallOptions balls;
};

struct OpenedMolecule {
  std::shared_ptr<const Molecule> molecule;
  std::shared_ptr<const PreparedBalls> prepared;  // radii before any solvent radius
};

// Throws ReadError; std::invalid_argument for options that the molecule cannot satisfy; Cancelled.
OpenedMolecule open_molecule(const std::filesystem::path& path, const OpenOptions& options,
                             const RunContext& context);

}  // namespace alphascope
