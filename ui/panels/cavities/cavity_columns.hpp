// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of the table of cavities that the page offers, and the order of its rows.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace alphascope {

template <class Row>
struct Column;
struct CavityFilter;
struct CavityPage;
struct CavityRow;
struct KnownCavities;

// A column's place in the table. Its widgets are named by the column's id:
// "cavities.column.volume_sa_angstrom3".
struct CavityPageColumn {
  const Column<CavityRow>* column;
  float width;  // pixels at scale 1; for the name, the least width
  bool shown_first;

  bool is(std::string_view id) const;
};
const std::vector<CavityPageColumn>& cavity_page_columns();  // in the order of the table

bool is_shown(const CavityPage& page, std::string_view id);
std::string cavity_text(const KnownCavities& rows, std::string_view id, std::size_t row);

// Returns the rows that the filter lets through, in its order.
std::vector<std::size_t> ordered_rows(const KnownCavities& rows, const CavityFilter& filter);

}  // namespace alphascope
