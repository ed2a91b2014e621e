// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces what a panel remembers of one molecule when another is open.
#pragma once

#include <string>

namespace alphascope {

// If `memory` belongs to another molecule than this one (SHA-256 of its file), replaces it by
// `fresh(memory)`. Returns whether it did.
template <class Memory, class Fresh>
bool reset_for_molecule(Memory& memory, const std::string& molecule, const Fresh& fresh) {
  if (memory.molecule == molecule) return false;
  memory = fresh(memory);
  memory.molecule = molecule;
  return true;
}

template <class Memory>
bool reset_for_molecule(Memory& memory, const std::string& molecule) {
  return reset_for_molecule(memory, molecule, [](const Memory&) { return Memory(); });
}

}  // namespace alphascope
