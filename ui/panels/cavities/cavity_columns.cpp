// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses columns for the page, and sorts rows by a column. The columns themselves are in
// core/document/cavities/cavity_columns.cpp.
#include "ui/panels/cavities/cavity_columns.hpp"

#include <algorithm>
#include <cstdint>

#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_columns.hpp"
#include "core/document/cavities/cavity_contents.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/cavities/known_cavities.hpp"
#include "core/document/tables/cell_value.hpp"
#include "core/document/tables/column.hpp"
#include "ui/panels/cavities/cavity_page.hpp"

namespace alphascope {
namespace {

struct Place {
  const char* id;
  float width;
  bool shown_first;
};

constexpr Place kPlaces[] = {{"id", 34, true},
                             {"kind", 100, true},
                             {"volume_sa_angstrom3", 68, true},
                             {"volume_sa_clipped_angstrom3", 68, true},
                             {"area_sa_angstrom2", 72, true},
                             {"volume_ms_angstrom3", 76, false},
                             {"area_ms_angstrom2", 80, false},
                             {"mouths", 58, true},
                             {"mouth_area_angstrom2", 64, false},
                             {"lining_residues", 62, true},
                             {"polar_lining_percent", 58, false},
                             {"depth_angstrom", 58, true},
                             {"born_alpha_angstrom2", 66, false},
                             {"gone_alpha_angstrom2", 66, false},
                             {"bottleneck_angstrom", 94, false},
                             {"holds", 60, true},
                             {"name", 200, false}};

std::vector<CavityPageColumn> placed_columns() {
  std::vector<CavityPageColumn> columns;
  for (const Place& place : kPlaces) {
    columns.push_back({&column_of(cavity_columns(), place.id), place.width, place.shown_first});
  }
  return columns;
}

// Returns the value by which rows are sorted.
CellValue sort_value(const KnownCavities& rows, const CavityPageColumn& by, std::size_t row) {
  if (by.is("holds") && rows.contents) {
    return static_cast<std::uint64_t>(rows.contents->of[rows.table().order[row]].size());
  }
  return by.column->value({rows, row});
}

}  // namespace

bool CavityFilter::shows(const CavityLine& line) const {
  const bool of_kind = kind == 0 || (kind == 1) == line.is_void;
  return of_kind &&
         (least_volume_angstrom3 == 0 || line.volume_sa_angstrom3 >= least_volume_angstrom3);
}

bool CavityPageColumn::is(std::string_view id) const {
  return column->id == id;
}

const std::vector<CavityPageColumn>& cavity_page_columns() {
  static const std::vector<CavityPageColumn> columns = placed_columns();
  return columns;
}

bool is_shown(const CavityPage& page, std::string_view id) {
  const auto& columns = cavity_page_columns();
  const auto at = std::find_if(columns.begin(), columns.end(),
                               [&](const CavityPageColumn& column) { return column.is(id); });
  return page.columns.at(static_cast<std::size_t>(at - columns.begin()));
}

std::string cavity_text(const KnownCavities& rows, std::string_view id, std::size_t row) {
  return column_of(cavity_columns(), id).shown_text({rows, row});
}

std::vector<std::size_t> ordered_rows(const KnownCavities& rows, const CavityFilter& filter) {
  const CavityPageColumn& by = cavity_page_columns()[static_cast<std::size_t>(filter.sort_column)];
  // Rows are sorted by name through their sinks: sinks have the order of atoms in the file, and
  // names are made of these atoms.
  const bool by_name = by.is("name");
  std::vector<std::size_t> order;
  std::vector<CellValue> values(rows.size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (!filter.shows(rows.lines->of[row])) continue;
    order.push_back(row);
    if (!by_name) values[row] = sort_value(rows, by, row);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (filter.descending) std::swap(a, b);
    return by_name ? rows.table().sink(a) < rows.table().sink(b) : values[a] < values[b];
  });
  return order;
}

}  // namespace alphascope
