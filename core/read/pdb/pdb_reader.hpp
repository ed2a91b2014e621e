// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of PDB files and of AutoDock's PDBQT.
#pragma once

#include "core/read/file_format.hpp"

namespace alphascope {

// Reads ATOM and HETATM records of all models. Atoms between two models, or after the last ENDMDL,
// form a model of their own.
Molecule read_pdb(const ReaderInput& input);

// Reads PDBQT of AutoDock and Vina: PDB records with AutoDock's types. Poses become models.
Molecule read_pdbqt(const ReaderInput& input);

}  // namespace alphascope
