// What a page remembers of one molecule ends with the next.
#pragma once

#include <string>

namespace alphascope {

// Where `memory` is of another molecule than this one (SHA-256 of its file), what `fresh` makes of
// it takes its place. True: it did.
template <class Memory, class Fresh>
bool begin_anew(Memory& memory, const std::string& molecule, const Fresh& fresh) {
  if (memory.molecule == molecule) return false;
  memory = fresh(memory);
  memory.molecule = molecule;
  return true;
}

template <class Memory>
bool begin_anew(Memory& memory, const std::string& molecule) {
  return begin_anew(memory, molecule, [](const Memory&) { return Memory(); });
}

}  // namespace alphascope
