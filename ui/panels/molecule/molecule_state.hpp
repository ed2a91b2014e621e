// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the section on the molecule between frames.
#pragma once

#include <string>

namespace alphascope {

struct MoleculeState {
  std::string residues_of;   // SHA-256 of the molecule whose residues were listed last
  std::string chain_filter;  // chains whose names contain this text are listed
  int radius_editing = -1;   // row of MoleculeInfo::radius_rows in which the user types; −1: none
  std::string radius_typed;
  std::string radius_error;  // why the typed text is not a valid radius
};

}  // namespace alphascope
