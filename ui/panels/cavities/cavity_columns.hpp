// The columns of the table of cavities: titles, what they mean, what is in them.
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
  const char* id;     // of its widgets: "cavities.column.volume"
  const char* title;  // with its unit
  const char* help;   // one sentence or two
  float width;        // pixels at scale 1; the least one of the name
  bool shown_first;
};
std::span<const CavityColumnSpec> cavity_columns();  // in the order of CavityColumn

// What rows are sorted by; less than all others where it is not known yet. Of a name: nothing.
double cavity_value(const CavityRows& rows, CavityColumn column, std::size_t row);

// As it is shown; "…" where it is not known yet. Of rank, kind and name: nothing.
std::string cavity_text(const CavityRows& rows, CavityColumn column, std::size_t row);

// Rows that the filter shows, in its order.
std::vector<std::size_t> ordered_rows(const CavityRows& rows, const CavityFilter& filter);

}  // namespace alphascope
