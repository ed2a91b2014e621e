// The section on the molecule: what its rows remember between frames.
#pragma once

#include <string>

namespace alphascope {

struct MoleculeMemory {
  std::string residues_of;   // SHA-256 of the molecule whose list of residues was shown last
  std::string chain_filter;  // part of the names of the chains that are listed
  int radius_editing = -1;   // row of MoleculeInfo::radius_rows whose text is being typed
  std::string radius_typed;
  std::string radius_error;  // why the typed text is no radius
};

}  // namespace alphascope
