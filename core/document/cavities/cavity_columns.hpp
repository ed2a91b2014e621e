// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of the table of cavities, for window, command line, CSV, JSON and docs.
#pragma once

#include <cstddef>
#include <span>

namespace alphascope {

template <class Row>
struct Column;
struct CavityFacts;
struct KnownCavities;

// A row of the table. The window has no `facts`: it shows no column of the request.
struct CavityRow {
  const KnownCavities& of;
  std::size_t row = 0;
  const CavityFacts* facts = nullptr;
  // The id of the same cavity with the first radii and solvent radius. It is the cavity's own id if
  // there are no others; 0: there is no such cavity.
  std::size_t first_id = 0;
};

// In the order of the CSV. The provenance follows there.
std::span<const Column<CavityRow>> cavity_columns();

}  // namespace alphascope
