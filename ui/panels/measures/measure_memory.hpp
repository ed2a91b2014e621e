// What the page of areas and volumes remembers between frames. Plain data.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/document/measures/measure_rows.hpp"
#include "core/document/reference/reference.hpp"

namespace alphascope {

struct MeasureMemory {
  std::string molecule;  // SHA-256 of its file
  int per = 2;           // components, chains, residues, atoms
  MeasureQuery query;
  bool changes = false;         // derivatives are shown where rows are atoms
  bool copying = false;         // CSV is on its way to the clipboard
  std::vector<AtomRef> chosen;  // first atoms of rows, which stay while alpha moves
  // The last there were: shown grey until the next are there.
  std::shared_ptr<const MeasuredComplex> measured;
  std::shared_ptr<const MeasureRows> rows;
  std::string surface;  // whose area that is
};

}  // namespace alphascope
