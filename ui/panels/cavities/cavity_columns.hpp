// The columns of the table of cavities: their titles, their help, and the values of their cells.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "ui/panels/cavities/cavity_page.hpp"

namespace alphascope {

enum class CavityColumn : std::uint8_t {
  rank,
  kind,
  volume,
  exact,
  area,
  ms_volume,
  ms_area,
  mouths,
  mouth_area,
  residues,
  depth,
  born,
  gone,
  bottleneck,
  holds,
  name
};

struct CavityColumnSpec {
  CavityColumn column;
  const char* id;     // part of its widgets' names: "cavities.column.volume"
  const char* title;  // with its unit
  const char* help;   // one sentence or two
  float width;        // pixels at scale 1; for the name, the least width
  bool shown_first;
};
std::span<const CavityColumnSpec> cavity_columns();  // in the order of CavityColumn

// Returns the value by which rows are sorted. Unknown values are less than all others. Names are
// not sorted by it.
double cavity_value(const CavityRows& rows, CavityColumn column, std::size_t row);

// Returns the text of a cell; "…" while its value is unknown. Rank, kind and name have no such
// text.
std::string cavity_text(const CavityRows& rows, CavityColumn column, std::size_t row);

// Returns the rows that the filter lets through, in its order.
std::vector<std::size_t> ordered_rows(const CavityRows& rows, const CavityFilter& filter);

}  // namespace alphascope
