// The reader of PDB files, and of AutoDock's PDBQT.
#pragma once

#include "core/read/file_format.hpp"

namespace alphascope {

// ATOM and HETATM records of all models. Atoms between two models, or after the last ENDMDL, form a
// model of their own.
Molecule read_pdb(const ReaderInput& input);

// PDBQT of AutoDock and Vina: the same records with AutoDock's types; poses are models.
Molecule read_pdbqt(const ReaderInput& input);

}  // namespace alphascope
