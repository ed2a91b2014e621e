// What the panel of cavities remembers between frames. Plain data.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/cavity/cavity_table.hpp"
#include "core/document/reference.hpp"
#include "ui/layer.hpp"

namespace alphascope {

// A cavity as the table shows it.
struct CavityLine {
  std::size_t row = 0;  // of the CavityTable: 0 is CASTp's cavity 1
  bool is_void = false;
  double volume = 0, area = 0, mouth_area = 0;  // Å³, Å²: CASTp's SA sums
  double exact_volume = -1;                     // Å³; negative: not computed yet
  std::size_t mouths = 0, residues = 0;
  std::string name;  // empty until it is needed
  SimplexRef sink;
};

struct CavityMemory {
  std::string molecule;            // SHA-256 of its file
  std::string lining;              // residues of what is chosen; empty: nothing is
  std::vector<SimplexRef> chosen;  // by their deepest sinks, which stay while alpha moves
  int kind = 0;                    // shown: 0 all, 1 voids, 2 pockets
  double least_volume = 0;         // Å³, of those shown
  int sort_column = 0;
  bool descending = false;

  // Of `table`, made anew when that is another one.
  std::shared_ptr<const CavityTable> table;
  std::shared_ptr<const void> exact;
  std::vector<CavityLine> lines;   // by rows
  std::vector<std::size_t> order;  // of the lines that are shown
  bool order_is_old = true;
  std::vector<std::shared_ptr<const Layer>> layers;  // of what is chosen
  Theme theme = Theme::dark;                         // that their colours are for
  bool layers_are_old = true;
};

}  // namespace alphascope
